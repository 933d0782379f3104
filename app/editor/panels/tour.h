// The window explained on one screen: shown at the first start, and again from the Help menu.
#pragma once

#include "app/editor/panels/layout.h"
#include "app/editor/panels/ui.h"

namespace voxprite::editor {

class Tour {
  public:
    void open() { open_ = true; }
    [[nodiscard]] bool isOpen() const { return open_; }
    void draw(Ui& ui, const Layout& layout);

  private:
    bool open_ = false;
};

}  // namespace voxprite::editor
