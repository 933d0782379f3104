#include "app/editor/settings/sheet_settings.h"

#include "core/sheet/sheet_files.h"

namespace voxprite::editor {

Result<SheetOptions> sheetOptions(const SheetSettings& settings) {
    SheetOptions options;
    options.directions = settings.directions;
    options.firstYawDegrees = settings.firstYawDegrees;
    const auto pitches = numbersFromList(settings.pitches);
    if (!pitches) return fail("Pitches are degrees, separated by commas: 30, 60");
    options.pitchesDegrees = *pitches;
    if (settings.frames.find_first_not_of(' ') != std::string::npos) {
        options.frames = framesFromList(settings.frames);
        if (!options.frames) return fail("Frames are numbers from 0 and ranges: 0, 2, 5-9");
    }
    if (!settings.variants) options.variants.emplace();
    options.trim = settings.trim;
    options.paddingPx = settings.paddingPx;
    options.largestEdgePx = settings.largestEdgePx;
    options.normals = settings.normals;
    options.depths = settings.depths;
    options.indices = settings.indices;
    return options;
}

GameProfile sheetProfile(const SheetSettings& settings, GameProfile profile) {
    if (settings.sigma > 0.0) profile.sigma = settings.sigma;
    if (settings.outline != SheetOutline::asInGame) {
        profile.outline.enabled = settings.outline == SheetOutline::on;
    }
    return profile;
}

}  // namespace voxprite::editor
