#include "app/editor/file_flow.h"

#include "app/editor/toasts.h"

namespace voxprite::editor {
namespace {

const std::vector<std::string> kModelExtensions{".voxprite", ".vox", ".svo"};
const std::vector<std::string> kProfileExtensions{".json"};

std::string stemOf(const Session& session) {
    return session.path() ? session.title() : "untitled";
}

}  // namespace

void FileFlow::open(const std::filesystem::path& file) {
    waitingFile_ = file;
    unlessUnsaved(Waiting::openFile);
}

void FileFlow::save() {
    if (!context_.session.hasNativePath()) return saveAs();
    saveTo(*context_.session.path());
}

void FileFlow::saveAs() {
    browse({.title = "Save as",
            .button = "Save",
            .saving = true,
            .extensions = {".voxprite", ".vox"},
            .name = stemOf(context_.session) + ".voxprite"},
           [this](CommandContext&, const std::filesystem::path& path) { saveTo(path); });
}

void FileFlow::exportOctree() {
    browse({.title = "Export the octree for the game's runtime",
            .button = "Export",
            .saving = true,
            .extensions = {".svo"},
            .name = stemOf(context_.session) + ".svo"},
           [this](CommandContext& c, const std::filesystem::path& path) {
               tell(c.session.saveAs(path), "Exported and verified " + path.filename().string());
           });
}

void FileFlow::openProfile() {
    browse({.title = "Open a game profile", .button = "Open", .extensions = kProfileExtensions},
           [this](CommandContext& c, const std::filesystem::path& path) {
               tell(c.session.openProfile(path), "Game profile " + path.filename().string());
           });
}

void FileFlow::saveProfile() {
    const auto& path = context_.session.profilePath();
    if (!path) return saveProfileAs();
    context_.report(context_.session.saveProfile(*path));
}

void FileFlow::saveProfileAs() {
    const auto& path = context_.session.profilePath();
    browse({.title = "Save the game profile",
            .button = "Save",
            .saving = true,
            .extensions = kProfileExtensions,
            .name = path ? path->filename().string() : "game-profile.json"},
           [this](CommandContext& c, const std::filesystem::path& chosen) {
               tell(c.session.saveProfile(chosen), "Saved " + chosen.filename().string());
           });
}

void FileFlow::browse(FileBrowser::Request request, Chosen chosen) {
    if (request.folder.empty()) request.folder = context_.settings.window.folder;
    chosen_ = std::move(chosen);
    browser_.open(std::move(request));
}

void FileFlow::draw(Ui& ui) {
    const UnsavedAnswer answer = context_.dialogs.draw(ui);
    if (answer != UnsavedAnswer::none) afterUnsavedQuestion(answer);
    if (const auto path = browser_.draw(ui)) {
        context_.settings.window.folder = path->parent_path();
        // What was chosen may ask for another file.
        const Chosen chosen = std::exchange(chosen_, {});
        chosen(context_, *path);
    }
}

void FileFlow::unlessUnsaved(Waiting what) {
    waiting_ = what;
    if (context_.session.unsaved()) {
        context_.dialogs.askUnsaved();
    } else {
        goOn();
    }
}

void FileFlow::afterUnsavedQuestion(UnsavedAnswer answer) {
    switch (answer) {
        case UnsavedAnswer::save:
            return save();  // goes on once it has been saved
        case UnsavedAnswer::discard:
            return goOn();
        case UnsavedAnswer::cancel:
        case UnsavedAnswer::none:
            waiting_ = Waiting::none;
    }
}

void FileFlow::goOn() {
    switch (std::exchange(waiting_, Waiting::none)) {
        case Waiting::none:
            return;
        case Waiting::startNew:
            context_.report(context_.session.startNew());
            replaced_ = true;
            return;
        case Waiting::openDialog:
            return browse(
                {.title = "Open a model", .button = "Open", .extensions = kModelExtensions},
                [this](CommandContext&, const std::filesystem::path& path) { openNow(path); });
        case Waiting::openFile:
            return openNow(waitingFile_);
        case Waiting::quit:
            quits_ = true;
    }
}

void FileFlow::openNow(const std::filesystem::path& path) {
    if (!tell(context_.session.open(path), {})) return;
    context_.settings.remember(path);
    replaced_ = true;
    for (const std::string& warning : context_.session.warnings()) context_.toasts.info(warning);
}

void FileFlow::saveTo(const std::filesystem::path& path) {
    if (!tell(context_.session.saveAs(path), "Saved " + path.filename().string())) return;
    context_.settings.remember(path);
    // A .vox file is an export: the document is as unsaved as it was.
    if (!context_.session.unsaved()) goOn();
}

bool FileFlow::tell(const Status& done, const std::string& news) {
    if (!done) {
        waiting_ = Waiting::none;
        context_.dialogs.showError(done.error().describe());
        return false;
    }
    if (!news.empty()) context_.toasts.info(news);
    return true;
}

}  // namespace voxprite::editor
