// What the artist looks at while weighing speed against accuracy: two settings A and B, and the
// errors of what shows. Nothing of it is part of a document or of the game.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/settings/representation_settings.h"
#include "app/trade/setting.h"

namespace voxprite::trade {

enum class Yardstick : std::uint8_t;  // app/trade/figures.h
enum class Cost : std::uint8_t;       // app/trade/choice.h

}  // namespace voxprite::trade

namespace voxprite::editor {

// What the sprite view shows of A, the settings in force, and B, those they are held against.
enum class SideShown : std::uint8_t {
    a,
    b,
    both  // A on the left of a bar, B on its right
};

// What the error map compares the sprite with.
enum class HeatYardstick : std::uint8_t {
    exactView,   // the exact sprite of the very view, at its own sigma: no view step, no stand-in
    reference,   // the exact sprite by the reference, which is what the curve is measured against
    perspective  // the voxels themselves, in perspective: what the style leaves out, too
};

inline constexpr double kLeastTradeError = 0.001, kMostTradeError = 0.8;
inline constexpr std::size_t kMostSavedSettings = 32;

struct SavedSetting {
    std::string name{};
    trade::Setting setting;
    bool operator==(const SavedSetting&) const = default;
};

struct TradeSettings {
    // The axes of the plot.
    trade::Yardstick yardstick{};  // sprite
    trade::Cost cost{1};           // rays: they do not tremble
    double errorBudget = 0.1;      // "my error", FLIP
    bool profileOnly = true;       // of what is chosen within it: what a game profile can say

    std::optional<trade::Setting> b;
    SideShown side = SideShown::a;
    double wipe = 0.5;  // where the bar is, a share of the view's width, 0 ... 1
    std::vector<SavedSetting> saved;

    bool heat = false;
    HeatYardstick heatYardstick = HeatYardstick::exactView;
    bool operator==(const TradeSettings&) const = default;

    [[nodiscard]] bool showsB() const { return b.has_value() && side != SideShown::a; }
};

// What shows now, as a setting: the profile's part, and what the scene is told to draw by (with the
// rule `automatic`, which decides for each entity anew, the exact sprite).
[[nodiscard]] trade::Setting settingInForce(const GameProfile& profile,
                                            const RepresentationSettings& representations);
// What a scene draws its entities by, of a setting: the rest is the profile's (profileWith()).
[[nodiscard]] RepresentationSettings representationsWith(RepresentationSettings representations,
                                                         const trade::Setting& setting);
[[nodiscard]] RepresentationChoice choiceOf(const trade::Setting& setting);
// Can the sprite view show it? Not what only the bench and the command line draw: floats that walk,
// snapshots in perspective.
[[nodiscard]] bool canBeShown(const trade::Setting& setting);

[[nodiscard]] nlohmann::json toJson(const TradeSettings& settings);
// Defaults for what is missing; settings that a profile would not take are left out.
[[nodiscard]] TradeSettings tradeSettingsFrom(const nlohmann::json& json);

}  // namespace voxprite::editor
