// Where things are on screen, for whoever drives the editor from outside: tests find a widget by
// its name instead of by a guess. Costs nothing unless it was asked for.
#pragma once

#include <imgui.h>

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace voxprite::editor {

class LayoutProbe {
  public:
    explicit LayoutProbe(std::optional<std::filesystem::path> path) : path_(std::move(path)) {}

    [[nodiscard]] bool wanted() const { return path_.has_value(); }
    void mark(std::string_view name, ImVec2 min, ImVec2 max);
    // The widget just made.
    void markItem(std::string_view name);
    // Writes {"items": {name: [x0, y0, x1, y1]}, "state": {...}} when it is not what was written
    // before, and starts over.
    [[nodiscard]] Status endFrame(const nlohmann::json& state);

  private:
    std::optional<std::filesystem::path> path_;
    std::map<std::string, ImVec4, std::less<>> items_;
    std::string written_;
};

}  // namespace voxprite::editor
