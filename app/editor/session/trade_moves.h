// What is done with settings that were weighed: put into force, chosen within a budget.
#pragma once

#include <optional>
#include <string>

#include "app/editor/session/session.h"
#include "app/editor/session/trade_study.h"
#include "app/editor/settings/settings.h"

namespace voxprite::editor {

// Settings in people's words: what differs from the reference, or that it is the reference.
[[nodiscard]] std::string titleOf(const trade::Setting& setting,
                                  const std::optional<trade::Setting>& reference);

// The one step that makes the profile's part of a setting the game's; nothing when it is already.
[[nodiscard]] std::optional<Action> profileStep(const Session& session,
                                                const trade::Setting& setting,
                                                const std::string& title);

// The cheapest of the curve within the artist's error; null when there is none (yet).
[[nodiscard]] const trade::Point* cheapestWithinMyError(const TradeStudy& study,
                                                        const TradeSettings& settings);

}  // namespace voxprite::editor
