#include "app/editor/session/trade_moves.h"

#include "app/trade/choice.h"
#include "core/edit/make_action.h"

namespace voxprite::editor {

std::string titleOf(const trade::Setting& setting, const std::optional<trade::Setting>& reference) {
    if (!reference) return trade::describe(setting, trade::Setting{});
    if (setting == *reference) return "the reference";
    return trade::describe(setting, *reference);
}

std::optional<Action> profileStep(const Session& session, const trade::Setting& setting,
                                  const std::string& title) {
    const GameProfile& before = session.profile();
    const GameProfile after = trade::profileWith(before, setting);
    if (after == before || !validate(after)) return std::nullopt;
    return makeAction("Settings: " + title, ProfileEdit{before, after});
}

const trade::Point* cheapestWithinMyError(const TradeStudy& study, const TradeSettings& settings) {
    const trade::Curve& curve = study.curve();
    const auto found = trade::cheapestWithin(
        curve, settings.errorBudget, {settings.yardstick, settings.cost, settings.profileOnly});
    return found ? &curve.points[*found] : nullptr;
}

}  // namespace voxprite::editor
