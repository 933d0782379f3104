#include "app/editor/settings/scene_settings.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace voxprite::editor {

using Json = nlohmann::json;

Json toJson(const SceneSettings& settings) {
    const CopySettings& copies = settings.copies;
    Json extras = Json::array();
    for (const ExtraModelChoice& extra : settings.extras) {
        extras.push_back({{"file", extra.file.string()}, {"used", extra.used}});
    }
    return {{"pattern", static_cast<int>(copies.pattern)},
            {"copies", copies.count},
            {"spacing", copies.spacing},
            {"turned", copies.turned},
            {"seed", copies.seed},
            {"edited_used", copies.editedUsed},
            {"extras", extras},
            {"pace", settings.pace},
            {"every_frame", settings.everyFrame},
            {"picture_scale", settings.pictureScale},
            {"compared", settings.comparison.cells},
            {"sigmas", settings.comparison.sigmas}};
}

SceneSettings sceneSettingsFrom(const Json& json) {
    SceneSettings settings;
    CopySettings& copies = settings.copies;
    copies.pattern = static_cast<CopyPattern>(std::clamp(json.value("pattern", 0), 0, 3));
    copies.count = std::clamp(json.value("copies", copies.count), 1, kMostCopies);
    copies.spacing = std::clamp(json.value("spacing", copies.spacing), kLeastSpacing, kMostSpacing);
    copies.turned = json.value("turned", copies.turned);
    copies.seed = json.value("seed", copies.seed);
    copies.editedUsed = json.value("edited_used", copies.editedUsed);
    for (const Json& extra : json.value("extras", Json::array())) {
        settings.extras.push_back({extra.value("file", std::string()), extra.value("used", true)});
    }
    settings.pace = std::clamp(json.value("pace", settings.pace), 0.0, 10.0);
    settings.everyFrame = json.value("every_frame", settings.everyFrame);
    settings.pictureScale =
        std::clamp(json.value("picture_scale", settings.pictureScale), 1, kMostPictureScale);
    SigmaComparison& comparison = settings.comparison;
    const int cells = json.value("compared", 0);
    comparison.cells = cells == 2 || cells == 4 ? cells : 0;
    comparison.sigmas = json.value("sigmas", comparison.sigmas);
    for (double& sigma : comparison.sigmas) sigma = std::clamp(sigma, 1.0 / 64.0, 64.0);
    return settings;
}

}  // namespace voxprite::editor
