#include "app/editor/settings/scene_settings.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/model/game_profile.h"
#include "core/sprite/view_set.h"

namespace voxprite::editor {

using Json = nlohmann::json;

namespace {

Json toJson(const RepresentationSettings& settings) {
    return {{"rule", static_cast<int>(settings.rule)},
            {"error_budget", settings.errorBudget},
            {"coarser_levels", settings.coarserLevels},
            {"views", settings.views},
            {"cluster_budget_px", settings.clusterBudgetPx},
            {"tint", settings.tint},
            {"compared", settings.compared},
            {"compared_size_px", settings.comparedSizePx}};
}

RepresentationSettings representationSettingsFrom(const Json& json) {
    RepresentationSettings settings;
    settings.rule = static_cast<DrawRule>(std::clamp(json.value("rule", 0), 0, 4));
    settings.errorBudget = std::clamp(json.value("error_budget", settings.errorBudget),
                                      kLeastErrorBudget, kMostErrorBudget);
    settings.coarserLevels =
        std::clamp(json.value("coarser_levels", settings.coarserLevels), 1, kMostCoarserLevels);
    const std::string views = json.value("views", settings.views);
    if (ViewSet::named(views)) settings.views = views;
    settings.clusterBudgetPx = std::clamp(json.value("cluster_budget_px", settings.clusterBudgetPx),
                                          0.0, kMostClusterBudgetPx);
    settings.tint = json.value("tint", settings.tint);
    settings.compared = json.value("compared", settings.compared);
    settings.comparedSizePx = std::clamp(json.value("compared_size_px", settings.comparedSizePx),
                                         kLeastComparedPx, kMostComparedPx);
    return settings;
}

}  // namespace

void SceneSettings::add(const ExtraModelChoice& extra) {
    std::erase_if(extras, [&](const auto& old) { return old.names(extra) && !old.used; });
    if (std::ranges::none_of(extras, [&](const auto& old) { return old.names(extra); })) {
        extras.push_back(extra);
    }
    if (copies.pattern == CopyPattern::none) copies.pattern = CopyPattern::crowd;
}

Json toJson(const SceneSettings& settings) {
    const CopySettings& copies = settings.copies;
    Json extras = Json::array();
    for (const ExtraModelChoice& extra : settings.extras) {
        Json& json = extras.emplace_back();
        json = {{"file", extra.file.string()}, {"used", extra.used}};
        if (extra.entity) json["entity"] = *extra.entity;
        if (extra.entity) json["entity_name"] = extra.entityName;
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
            {"sigmas", settings.comparison.sigmas},
            {"representations", toJson(settings.representations)}};
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
        ExtraModelChoice& choice = settings.extras.emplace_back();
        choice.file = extra.value("file", std::string());
        choice.used = extra.value("used", true);
        if (!extra.contains("entity")) continue;
        choice.entity = extra.value("entity", std::size_t{0});
        choice.entityName = extra.value("entity_name", std::string());
    }
    settings.pace = std::clamp(json.value("pace", settings.pace), 0.0, 10.0);
    settings.everyFrame = json.value("every_frame", settings.everyFrame);
    settings.pictureScale =
        std::clamp(json.value("picture_scale", settings.pictureScale), 1, kMostPictureScale);
    SigmaComparison& comparison = settings.comparison;
    const int cells = json.value("compared", 0);
    comparison.cells = cells == 2 || cells == 4 ? cells : 0;
    comparison.sigmas = json.value("sigmas", comparison.sigmas);
    for (double& sigma : comparison.sigmas) sigma = std::clamp(sigma, kLeastSigma, kMostSigma);
    settings.representations =
        representationSettingsFrom(json.value("representations", Json::object()));
    if (comparison.on()) settings.representations.compared = false;
    return settings;
}

}  // namespace voxprite::editor
