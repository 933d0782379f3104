#include "app/editor/session/sheet_maker.h"

#include <algorithm>
#include <glm/vec4.hpp>
#include <utility>

namespace voxprite::editor {
namespace {

constexpr std::chrono::milliseconds kPreviewRest{150};

Result<Sheet> madeWith(const SheetRequest& request, JobProgress& progress) {
    return makeSheet(
        *request.document, request.profile, request.options,
        [&](int done, int all) {
            progress.enter(std::to_string(done) + " of " + std::to_string(all) + " sprites",
                           static_cast<double>(done) / all);
        },
        progress.stopToken());
}

// Each pixel the mean of `factor` squared.
Image shrunk(const Image& image, int factor) {
    if (factor == 1) return image;
    Image small((image.width + factor - 1) / factor, (image.height + factor - 1) / factor);
    for (int y = 0; y < small.height; ++y) {
        for (int x = 0; x < small.width; ++x) {
            glm::ivec4 sum(0);
            const int right = std::min((x + 1) * factor, image.width);
            const int bottom = std::min((y + 1) * factor, image.height);
            for (int j = y * factor; j < bottom; ++j) {
                for (int i = x * factor; i < right; ++i) {
                    const Rgba8 pixel = image.at(i, j);
                    // Weighed by alpha: what is transparent has no colour.
                    sum += glm::ivec4(glm::ivec3(pixel) * int{pixel.w}, pixel.w);
                }
            }
            const int weight = std::max(sum.w, 1);
            small.at(x, y) =
                Rgba8(sum.x / weight, sum.y / weight, sum.z / weight, sum.w / (factor * factor));
        }
    }
    return small;
}

SheetMaker::Made make(const SheetRequest& request, JobProgress& progress) {
    SheetMaker::Made made{request, nullptr, {}, {}};
    Result<Sheet> sheet = madeWith(request, progress);
    if (!sheet) {
        made.problem = sheet.error().describe();
        return made;
    }
    for (const SheetPicture& picture : sheet->pictures) {
        const int edge = std::max(picture.image.width, picture.image.height);
        made.shown.push_back(shrunk(picture.image, (edge - 1) / SheetMaker::kShownEdge + 1));
    }
    made.sheet = std::make_shared<const Sheet>(std::move(*sheet));
    return made;
}

}  // namespace

void SheetMaker::ask(SheetRequest request) {
    job_.cancel();
    wanted_ = std::move(request);
    asked_ = std::chrono::steady_clock::now();
}

void SheetMaker::drop() {
    job_.cancel();
    wanted_.reset();
    made_.reset();
}

void SheetMaker::begin() {
    job_.start("Sprite sheet",
               [this, request = *std::exchange(wanted_, {})](JobProgress& progress) {
                   const auto made = std::make_shared<const Made>(make(request, progress));
                   return BackgroundJob::Done([this, made] { made_ = made; });
               });
}

bool SheetMaker::update() {
    if (wanted_ && std::chrono::steady_clock::now() - asked_ >= kPreviewRest) begin();
    return job_.finish();
}

void SheetMaker::finish() {
    if (wanted_) begin();
    job_.wait();
}

Result<std::size_t> writeSheet(const SheetExport& asked, JobProgress& progress) {
    std::shared_ptr<const Sheet> sheet = asked.sheet;
    if (!sheet) {
        Result<Sheet> made = madeWith(asked.request, progress);
        if (!made) return Failure(made.error());
        sheet = std::make_shared<const Sheet>(std::move(*made));
    }
    progress.enter("Writing", 0.0);
    const SheetRequest& request = asked.request;
    const Result<std::vector<SheetFile>> files = sheetFiles(
        *sheet, *request.document, request.profile, request.options, asked.output, asked.turntable);
    if (!files) return Failure(files.error());
    if (progress.stopToken().stop_requested()) return fail("cancelled");
    // Whatever is replaced has been agreed to.
    if (Status written = writeSheetFiles(*files, true); !written) return Failure(written.error());
    return files->size();
}

}  // namespace voxprite::editor
