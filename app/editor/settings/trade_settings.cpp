#include "app/editor/settings/trade_settings.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/trade/choice.h"
#include "core/sprite/view_set.h"

namespace voxprite::editor {

using Json = nlohmann::json;

namespace {

template <class Enum>
Enum choiceFrom(const Json& json, const char* name, Enum usual, Enum last) {
    const int number = json.value(name, static_cast<int>(usual));
    return number >= 0 && number <= static_cast<int>(last) ? static_cast<Enum>(number) : usual;
}

Json written(const trade::Setting& setting) {
    return {{"sigma", setting.sigma},
            {"mode", static_cast<int>(setting.mode)},
            {"view_step", setting.viewStepDegrees},
            {"proxy", static_cast<int>(setting.proxy)},
            {"registration", static_cast<int>(setting.registration)},
            {"occlusion", setting.occlusion},
            {"shadow", setting.shadow},
            {"drawn_by", static_cast<int>(setting.drawnBy)},
            {"view_set", setting.viewSet},
            {"coarse_levels", setting.coarseLevels},
            {"cluster_budget_px", setting.clusterBudgetPx}};
}

// Nothing for what no profile takes, or the view cannot show.
std::optional<trade::Setting> settingFrom(const Json& json) {
    trade::Setting setting;
    setting.sigma = json.value("sigma", setting.sigma);
    setting.mode = choiceFrom(json, "mode", setting.mode, SpriteMode::singlePass);
    setting.viewStepDegrees = json.value("view_step", setting.viewStepDegrees);
    setting.proxy = choiceFrom(json, "proxy", setting.proxy, ProxyShape::box);
    setting.registration =
        choiceFrom(json, "registration", setting.registration, Registration::anchor);
    setting.occlusion = json.value("occlusion", setting.occlusion);
    setting.shadow = json.value("shadow", setting.shadow);
    setting.drawnBy = choiceFrom(json, "drawn_by", setting.drawnBy, Representation::coarse);
    setting.viewSet = json.value("view_set", setting.viewSet);
    setting.coarseLevels = json.value("coarse_levels", setting.coarseLevels);
    setting.clusterBudgetPx = json.value("cluster_budget_px", setting.clusterBudgetPx);
    const bool coarse = setting.drawnBy == Representation::coarse;
    const bool good = validate(trade::profileWith(GameProfile{}, setting)) &&
                      ViewSet::named(setting.viewSet) && setting.clusterBudgetPx >= 0.0 &&
                      setting.clusterBudgetPx <= kMostClusterBudgetPx &&
                      setting.coarseLevels >= (coarse ? 1 : 0) &&
                      setting.coarseLevels <= (coarse ? kMostCoarserLevels : 0);
    if (!good) return std::nullopt;
    return setting;
}

}  // namespace

trade::Setting settingInForce(const GameProfile& profile,
                              const RepresentationSettings& representations) {
    trade::Setting setting = trade::settingOf(profile);
    const std::optional<RepresentationChoice> forced = representations.forced();
    if (!forced) return setting;
    setting.drawnBy = forced->kind;
    // What nothing is drawn by makes no difference: settings that look alike are alike.
    if (setting.drawnBy == Representation::snapshot) setting.viewSet = representations.views;
    if (setting.drawnBy == Representation::coarse) setting.coarseLevels = forced->levels;
    if (setting.drawnBy == Representation::clusters) {
        setting.clusterBudgetPx = representations.clusterBudgetPx;
    }
    return setting;
}

RepresentationSettings representationsWith(RepresentationSettings representations,
                                           const trade::Setting& setting) {
    switch (setting.drawnBy) {
        case Representation::sprite:
            // Automatic draws exact sprites, too; a rule that does not must go.
            if (representations.forced() != RepresentationChoice{} && representations.forced()) {
                representations.rule = DrawRule::exact;
            }
            break;
        case Representation::snapshot:
            representations.rule = DrawRule::snapshot;
            representations.views = setting.viewSet;
            break;
        case Representation::clusters:
            representations.rule = DrawRule::clusters;
            representations.clusterBudgetPx = setting.clusterBudgetPx;
            break;
        case Representation::coarse:
            representations.rule = DrawRule::coarse;
            representations.coarserLevels = setting.coarseLevels;
            break;
    }
    return representations;
}

RepresentationChoice choiceOf(const trade::Setting& setting) {
    return {setting.drawnBy, setting.drawnBy == Representation::coarse ? setting.coarseLevels : 0};
}

bool canBeShown(const trade::Setting& setting) {
    if (setting.walk != trade::Walk::lattice) return false;
    if (setting.drawnBy == Representation::coarse) {
        return setting.coarseLevels <= kMostCoarserLevels;
    }
    return setting.drawnBy != Representation::snapshot ||
           setting.snapshotKind == SnapshotKind::sprite;
}

Json toJson(const TradeSettings& settings) {
    Json saved = Json::array();
    for (const SavedSetting& each : settings.saved) {
        saved.push_back({{"name", each.name}, {"setting", written(each.setting)}});
    }
    Json json{{"yardstick", static_cast<int>(settings.yardstick)},
              {"cost", static_cast<int>(settings.cost)},
              {"error_budget", settings.errorBudget},
              {"profile_only", settings.profileOnly},
              {"wipe", settings.wipe},
              {"saved", std::move(saved)},
              {"heat_yardstick", static_cast<int>(settings.heatYardstick)}};
    if (settings.b) json["b"] = written(*settings.b);
    return json;
}

// What was shown over the view is not shown again: the view starts as the game looks.
TradeSettings tradeSettingsFrom(const Json& json) {
    TradeSettings settings;
    settings.yardstick =
        choiceFrom(json, "yardstick", settings.yardstick, trade::Yardstick::perspective);
    settings.cost = choiceFrom(json, "cost", settings.cost, trade::Cost::rays);
    settings.errorBudget = std::clamp(json.value("error_budget", settings.errorBudget),
                                      kLeastTradeError, kMostTradeError);
    settings.profileOnly = json.value("profile_only", settings.profileOnly);
    settings.wipe = std::clamp(json.value("wipe", settings.wipe), 0.0, 1.0);
    settings.heatYardstick =
        choiceFrom(json, "heat_yardstick", settings.heatYardstick, HeatYardstick::perspective);
    if (json.contains("b")) settings.b = settingFrom(json.at("b"));
    for (const Json& each : json.value("saved", Json::array())) {
        const auto setting = settingFrom(each.value("setting", Json::object()));
        if (!setting || settings.saved.size() == kMostSavedSettings) continue;
        settings.saved.push_back({each.value("name", std::string()), *setting});
    }
    return settings;
}

}  // namespace voxprite::editor
