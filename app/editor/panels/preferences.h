// What the artist sets once: looks, habits of the mouse, keys.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "app/editor/panels/ui.h"

namespace voxprite::editor {

class Preferences {
  public:
    enum class Page : std::uint8_t { general, keys };
    void open(Page page);
    [[nodiscard]] bool isOpen() const { return open_; }
    void draw(Ui& ui);

  private:
    void drawTabs(Ui& ui);
    void drawGeneral(Ui& ui);
    void drawKeys(Ui& ui);
    void drawKeyRow(Ui& ui, const Command& command);
    void drawChord(Ui& ui, const Command& command, std::size_t slot, float width);
    // The chord pressed this frame for the slot that waits for one.
    void listen(Ui& ui);

    bool open_ = false;
    Page page_ = Page::general;
    std::array<char, 64> search_{};
    // The key that is being bound anew.
    struct Listening {
        CommandId command;
        std::size_t slot;
    };
    std::optional<Listening> listening_;
};

}  // namespace voxprite::editor
