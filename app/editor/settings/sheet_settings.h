// What the sprite sheet dialog was last told, kept between runs; and what that asks for.
#pragma once

#include <cstdint>
#include <string>

#include "core/base/result.h"
#include "core/model/game_profile.h"
#include "core/sheet/sheet.h"

namespace voxprite::editor {

enum class TurntableKind : std::uint8_t { png, gif };
enum class SheetOutline : std::uint8_t { asInGame, on, off };

struct SheetSettings {
    int directions = 8;
    double firstYawDegrees = 0.0;
    std::string pitches = "30";  // degrees, separated by commas
    std::string frames;          // "0,2,5-9"; empty: all
    double sigma = 0.0;          // 0: the game's
    SheetOutline outline = SheetOutline::asInGame;
    bool variants = true;  // a picture for each palette variant, too
    bool trim = true;
    int paddingPx = 1;
    int largestEdgePx = 8192;
    bool normals = false;
    bool depths = false;
    bool indices = false;
    bool turntable = false;
    TurntableKind turntableKind = TurntableKind::png;
    int turntableMilliseconds = 80;
    int magnify = 4;  // of the turntable
    bool operator==(const SheetSettings&) const = default;
};

// Fails when a list cannot be read; makeSheet() says what else is wrong.
[[nodiscard]] Result<SheetOptions> sheetOptions(const SheetSettings& settings);
// The game's, but for what the settings say.
[[nodiscard]] GameProfile sheetProfile(const SheetSettings& settings, GameProfile profile);

}  // namespace voxprite::editor
