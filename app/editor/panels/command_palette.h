// Every command by a few letters of its name.
#pragma once

#include <array>

#include "app/editor/panels/ui.h"

namespace voxprite::editor {

class CommandPalette {
  public:
    void open();
    [[nodiscard]] bool isOpen() const { return open_; }
    void draw(Ui& ui);

  private:
    void drawList(Ui& ui);

    bool open_ = false;
    std::array<char, 64> query_{};
    int chosen_ = 0;  // row of the list
};

// Of all commands those whose name, or menu and name, match; the nearest first. Nothing typed: all.
[[nodiscard]] std::vector<const Command*> commandsMatching(std::string_view query);

}  // namespace voxprite::editor
