// The game profile as JSON: one file shared by all models of a game.
//
// Every field of GameProfile by its name; enumerations as snake_case strings ("toward_entity").
// A missing field keeps its default; an unknown one, a wrong type or a value out of range is an
// error that names the line or the field. "voxprite_profile": 1 marks the file and its version.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/model/game_profile.h"

namespace voxprite {

[[nodiscard]] Result<GameProfile> readProfile(std::string_view json);
[[nodiscard]] std::string writeProfile(const GameProfile& profile);
[[nodiscard]] Result<GameProfile> readProfileFile(const std::filesystem::path& path);
[[nodiscard]] Status writeProfileFile(const std::filesystem::path& path,
                                      const GameProfile& profile);

// The names used in JSON and on the command line.
[[nodiscard]] const char* nameOf(ViewRule value);
[[nodiscard]] const char* nameOf(Registration value);
[[nodiscard]] const char* nameOf(ProxyShape value);
[[nodiscard]] const char* nameOf(DepthRule value);
[[nodiscard]] const char* nameOf(SpriteMode value);
[[nodiscard]] const char* nameOf(Shading value);
[[nodiscard]] Result<ViewRule> viewRuleNamed(std::string_view name);
[[nodiscard]] Result<Registration> registrationNamed(std::string_view name);
[[nodiscard]] Result<ProxyShape> proxyShapeNamed(std::string_view name);
[[nodiscard]] Result<DepthRule> depthRuleNamed(std::string_view name);
[[nodiscard]] Result<SpriteMode> spriteModeNamed(std::string_view name);
[[nodiscard]] Result<Shading> shadingNamed(std::string_view name);

}  // namespace voxprite
