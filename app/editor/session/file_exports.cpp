// The file flow's exports: what leaves the editor without becoming the document's file.
#include "app/editor/panels/toasts.h"
#include "app/editor/session/file_flow.h"
#include "core/base/file.h"
#include "core/edit/unused_models.h"
#include "core/io/formats.h"
#include "core/io/svo_set.h"

namespace voxprite::editor {

void FileFlow::exportOctree() {
    const Document& document = context_.session.document();
    const int models = static_cast<int>(document.models.size()) - unusedModels(document);
    std::vector<std::string> ways;
    if (models > 1) ways = {"All as one sprite", "Each model by itself"};
    browse({.title = "Export the octree for the game's runtime",
            .button = "Export",
            .saving = true,
            .extensions = {".svo"},
            .name = context_.session.stem() + ".svo",
            .ways = std::move(ways),
            .losses =
                [this](const std::filesystem::path& path) {
                    if (browser_.way() == 0) return lossesAt(path);
                    return std::vector<std::string>{
                        ".svo holds each model by itself: placements, frames and sockets are left "
                        "out"};
                }},
           [this](CommandContext&, const std::filesystem::path& path) {
               if (browser_.way() == 1) return exportModelsTo(path);
               exportTo(path);
           });
}

void FileFlow::exportSheet(SheetExport asked) {
    const std::string name = asked.output.filename().string();
    const auto shared = std::make_shared<const SheetExport>(std::move(asked));
    const auto writing = [this, shared, name](JobProgress& progress) -> BackgroundJob::Done {
        const std::stop_token stop = progress.stopToken();
        const Result<std::size_t> written = writeSheet(*shared, progress);
        return [this, written, stop, name] {
            const Status done = written ? Status() : Failure(written.error());
            if (tellWritten(done, stop)) {
                context_.toasts.info("Exported " + name + " and " + std::to_string(*written - 1) +
                                     (*written == 2 ? " file beside it" : " files beside it"));
            }
        };
    };
    static_cast<void>(tell(work("Exporting " + name, writing), {}));
}

void FileFlow::exportTo(const std::filesystem::path& path) {
    const std::string name = path.filename().string();
    write("Exporting " + name, path, [this, path, name] {
        tellLosses(path);
        context_.toasts.info("Exported and verified " + name);
    });
}

void FileFlow::exportModelsTo(const std::filesystem::path& path) {
    const std::string name = path.filename().string();
    const auto writing = [this, path, name, document = context_.session.snapshot(),
                          profile = context_.session.profile(), stem = context_.session.stem()](
                             JobProgress& progress) -> BackgroundJob::Done {
        progress.enter("Writing", 0.0);
        const Document shown = withoutUnusedModels(*document);
        const std::vector<SetMember> members = modelsOneByOne(shown, profile, stem);
        const Result<Bytes> bytes = exportSvoSet(members);
        const std::stop_token stop = progress.stopToken();
        Status done;
        if (!bytes) {
            done = Failure(bytes.error());
        } else if (stop.stop_requested()) {
            done = fail("cancelled");
        } else {
            done = writeFileAtomically(path, *bytes);
        }
        return [this, path, name, done, stop, count = members.size()] {
            if (!tellWritten(inFile(Status(done), path.string()), stop)) return;
            context_.toasts.info("Exported and verified " + std::to_string(count) + " models as " +
                                 name);
        };
    };
    static_cast<void>(tell(work("Exporting " + name, writing), {}));
}

std::vector<std::string> FileFlow::lossesAt(const std::filesystem::path& path) const {
    const Result<Format> format = formatOf(path);
    if (!format) return {};
    return lossesOf(context_.session.document(), *format);
}

void FileFlow::tellLosses(const std::filesystem::path& path) {
    for (std::string& loss : lossesAt(path)) context_.toasts.info(std::move(loss));
}

}  // namespace voxprite::editor
