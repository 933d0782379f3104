// The editor's settings as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/editor/settings/settings.h"

namespace voxprite::editor {

[[nodiscard]] nlohmann::json jsonOf(const EditorSettings& settings);
// What is missing or out of its range keeps its default; throws nlohmann's exceptions for values of
// another type.
[[nodiscard]] EditorSettings settingsFrom(const nlohmann::json& json);

}  // namespace voxprite::editor
