// One way to draw a model, as a point of the axes that speed is traded for accuracy on.
//
// This room (app/trade) measures what such choices cost and gain:
//   setting.h   a point of the axes; the settings along each axis
//   figures.h   what was measured of it: errors against each yardstick, costs with their spread
//   meter.h     measures one setting of one model, on any thread; makes its pictures
//   choice.h    the Pareto front, the cheapest within an error, the most accurate within a time
// The command line (`voxprite trade`) and the editor's trade panel use the same.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/billboard/snapshot.h"
#include "core/lod/representation.h"
#include "core/model/game_profile.h"

namespace voxprite::trade {

// How a ray finds its voxel. The second is kept as a rival alone: a walk in 32-bit floats.
enum class Walk : std::uint8_t { lattice, fp32 };

struct Setting {
    // What a game profile holds.
    double sigma = 4.0;
    SpriteMode mode = SpriteMode::spriteBuffer;
    double viewStepDegrees = 0.0;
    ProxyShape proxy = ProxyShape::quad;
    Registration registration = Registration::modelCentre;
    double occlusion = 0.0;
    double shadow = 0.0;
    // What a scene chooses for an entity.
    Representation drawnBy = Representation::sprite;
    std::string viewSet = "canonical26";  // of snapshots, as ViewSet::named has it
    SnapshotKind snapshotKind = SnapshotKind::sprite;
    int snapshotPx = kUsualSnapshotPx;  // kind seed: their resolution; sprites have sigma's
    int coarseLevels = 0;               // coarse: levels of the octree left out, 1 ...
    double clusterBudgetPx = 1.0;       // clusters: screen pixels that a surface may be off
    Walk walk = Walk::lattice;

    bool operator==(const Setting&) const = default;
};

// The exact sprite by the profile's own choices.
[[nodiscard]] Setting settingOf(const GameProfile& profile);
// `profile` with what a profile holds of the setting; everything else as it was.
[[nodiscard]] GameProfile profileWith(GameProfile profile, const Setting& setting);
// Does a profile say all of it? Then writing profileWith() makes the game draw this setting.
[[nodiscard]] bool fitsProfile(const Setting& setting);

// What differs from the game's own, for people: "sigma 2, views every 5°"; "as the game has it".
[[nodiscard]] std::string describe(const Setting& setting, const Setting& game);

// Along an axis one thing differs from the game's own setting; `mixed` pairs sigma with the view
// step.
enum class Axis : std::uint8_t {
    game,  // its own setting alone
    sigma,
    mode,
    viewStep,
    proxy,
    registration,
    light,      // occlusion and shadow left out
    snapshots,  // views and resolution
    levels,     // of the octree
    clusters,   // their budget in pixels
    walk,
    mixed
};
inline constexpr int kAxes = 12;
[[nodiscard]] const char* nameOf(Axis axis);   // "view_step", for files
[[nodiscard]] const char* titleOf(Axis axis);  // "View step", for people

struct AxisSetting {
    Axis axis = Axis::game;
    Setting setting;
    bool operator==(const AxisSetting&) const = default;
};

// How much of each axis is measured.
enum class Effort : std::uint8_t { quick, full };

// The settings of those axes, none twice; the game's own comes first when it is asked for. Of
// `levels` as many as the model offers (mostCoarseLevels). Light is left out step by step from what
// the profile has; without any there, that axis is empty.
[[nodiscard]] std::vector<AxisSetting> settingsAlong(std::span<const Axis> axes,
                                                     const GameProfile& profile,
                                                     int mostCoarseLevels, Effort effort);
[[nodiscard]] std::vector<Axis> allAxes();

}  // namespace voxprite::trade
