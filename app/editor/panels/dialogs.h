// The small dialogs: what to do with unsaved changes, an error that must be read, about.
#pragma once

#include <string>

#include "app/editor/ui.h"

namespace voxprite::editor {

enum class UnsavedAnswer : std::uint8_t { none, save, discard, cancel };

class Dialogs {
  public:
    void askUnsaved() { unsaved_ = true; }
    void showError(std::string text) { error_ = std::move(text); }
    void showAbout(std::string driver) {
        about_ = true;
        driver_ = std::move(driver);
    }
    // "unsaved", "error", "about" or nothing.
    [[nodiscard]] std::string openName() const;
    // Draws what is open; the answer of the frame in which the question was answered.
    [[nodiscard]] UnsavedAnswer draw(Ui& ui);

  private:
    [[nodiscard]] UnsavedAnswer drawUnsaved(Ui& ui);
    void drawError(Ui& ui);
    void drawAbout(Ui& ui);

    bool unsaved_ = false;
    bool about_ = false;
    std::string error_;
    std::string driver_;
};

}  // namespace voxprite::editor
