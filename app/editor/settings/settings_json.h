// The editor's settings as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/editor/settings/settings.h"

namespace voxprite::editor {

[[nodiscard]] nlohmann::json jsonOf(const EditorSettings& settings);
// What is missing, out of its range or of another type keeps its default; one value of another type
// takes all of the scene, or of the trade, with it. Throws nlohmann's exceptions for what is no
// object.
[[nodiscard]] EditorSettings settingsFrom(const nlohmann::json& json);

}  // namespace voxprite::editor
