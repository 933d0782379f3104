#include "app/editor/views/sprite_export.h"

#include "app/editor/panels/toasts.h"
#include "app/editor/views/sprite_viewport.h"
#include "core/io/png.h"

namespace voxprite::editor {
namespace {

namespace fs = std::filesystem;

fs::path freeName(const CommandContext& context) {
    std::error_code ignored;
    fs::path folder = context.settings.window.folder;
    if (context.session.path()) folder = context.session.path()->parent_path();
    if (folder.empty()) folder = fs::current_path(ignored);
    fs::path file = folder / (context.session.title() + ".png");
    for (int number = 2; fs::exists(file, ignored); ++number) {
        file = folder / (context.session.title() + "-" + std::to_string(number) + ".png");
    }
    return file;
}

std::string sizeOf(const Image& image) {
    return std::to_string(image.width) + " × " + std::to_string(image.height) + " pixels";
}

// Of two sides, which one it is.
std::string sideOf(const TradeSettings& trade) {
    if (!trade.showsB()) return {};
    return trade.side == SideShown::b ? " of B" : " of A";
}

}  // namespace

void saveSpritePicture(CommandContext& context) {
    const Result<Image> picture = context.spriteView.picture(context.session, context.settings);
    if (!picture) return context.toasts.error(picture.error().describe());
    const fs::path file = freeName(context);
    if (const Status saved = writePngFile(file, *picture); !saved) return context.report(saved);
    context.toasts.info("Saved " + file.filename().string() + sideOf(context.settings.trade) +
                        ", " + sizeOf(*picture));
}

void copySpritePicture(CommandContext& context) {
    const Result<Image> picture = context.spriteView.picture(context.session, context.settings);
    if (!picture) return context.toasts.error(picture.error().describe());
    Result<Bytes> png = writePng(*picture);
    if (!png) return context.toasts.error(png.error().describe());
    const Status copied = context.spriteView.clipboard().copyPng(std::move(*png));
    if (!copied) return context.report(copied);
    context.toasts.info("Copied the sprite" + sideOf(context.settings.trade) + ", " +
                        sizeOf(*picture));
}

}  // namespace voxprite::editor
