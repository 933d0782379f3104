// The small dialogs: what to do with unsaved changes, or with a file that another program has
// changed meanwhile, an error that must be read, about.
#pragma once

#include <string>
#include <vector>

#include "app/editor/panels/ui.h"

namespace voxprite::editor {

enum class UnsavedAnswer : std::uint8_t { none, save, discard, cancel };

enum class ChangedAnswer : std::uint8_t { none, replace, saveAs, cancel };

// Of the frame in which a question was answered.
struct Answers {
    UnsavedAnswer unsaved = UnsavedAnswer::none;
    ChangedAnswer changed = ChangedAnswer::none;
};

// "OpenGL", "4.5 (Core Profile) Mesa 22.3.6"
struct AboutLine {
    std::string name;
    std::string value;
};

class Dialogs {
  public:
    // `what` has changes that are in no file yet: "hut", in quotes, or the game profile.
    void askUnsaved(std::string question, std::string what) {
        question_ = std::move(question);
        unsaved_ = std::move(what);
    }
    // The file that is to be saved, by its name.
    void askChanged(std::string file) { changed_ = std::move(file); }
    void showError(std::string text) { error_ = std::move(text); }
    void showAbout(std::vector<AboutLine> lines) { about_ = std::move(lines); }
    // "unsaved", "changed", "error", "about" or nothing.
    [[nodiscard]] std::string openName() const;
    [[nodiscard]] Answers draw(Ui& ui);  // what is open

  private:
    [[nodiscard]] UnsavedAnswer drawUnsaved(Ui& ui);
    [[nodiscard]] ChangedAnswer drawChanged(Ui& ui);
    void drawError(Ui& ui);
    void drawAbout(Ui& ui);

    std::string question_;
    std::string unsaved_;
    std::string changed_;
    std::string error_;
    std::vector<AboutLine> about_;
};

}  // namespace voxprite::editor
