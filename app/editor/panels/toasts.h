// Short messages that come and go by themselves, at the bottom of the views.
#pragma once

#include <string>
#include <vector>

#include "app/editor/window/theme.h"

namespace voxprite::editor {

class Toasts {
  public:
    void info(std::string text) { add(std::move(text), false); }
    void error(std::string text) { add(std::move(text), true); }
    // `bottomCentre` of the area they rise from.
    void draw(const Theme& theme, ImVec2 bottomCentre, float maxWidth);
    [[nodiscard]] bool any() const { return !toasts_.empty(); }
    // The newest one's text, for tests.
    [[nodiscard]] std::string newest() const {
        return toasts_.empty() ? std::string() : toasts_.back().text;
    }

  private:
    struct Toast {
        std::string text;
        bool isError = false;
        double untilSeconds = 0.0;
    };
    void add(std::string text, bool isError);
    std::vector<Toast> toasts_;
};

}  // namespace voxprite::editor
