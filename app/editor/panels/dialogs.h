// The small dialogs: what to do with unsaved changes, an error that must be read, about.
#pragma once

#include <string>
#include <vector>

#include "app/editor/panels/ui.h"

namespace voxprite::editor {

enum class UnsavedAnswer : std::uint8_t { none, save, discard, cancel };

// "OpenGL", "4.5 (Core Profile) Mesa 22.3.6"
struct AboutLine {
    std::string name;
    std::string value;
};

class Dialogs {
  public:
    void askUnsaved() { unsaved_ = true; }
    void showError(std::string text) { error_ = std::move(text); }
    void showAbout(std::vector<AboutLine> lines) { about_ = std::move(lines); }
    // "unsaved", "error", "about" or nothing.
    [[nodiscard]] std::string openName() const;
    // Draws what is open; the answer of the frame in which the question was answered.
    [[nodiscard]] UnsavedAnswer draw(Ui& ui);

  private:
    [[nodiscard]] UnsavedAnswer drawUnsaved(Ui& ui);
    void drawError(Ui& ui);
    void drawAbout(Ui& ui);

    bool unsaved_ = false;
    std::string error_;
    std::vector<AboutLine> about_;
};

}  // namespace voxprite::editor
