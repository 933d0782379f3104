// The list of views that are kept under a name.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "app/editor/panels/ui.h"
#include "app/editor/views/camera_bookmarks.h"

namespace voxprite::editor {

class SavedCameras {
  public:
    void open() { open_ = true; }
    [[nodiscard]] bool isOpen() const { return open_; }
    // `now` is kept when that is asked for. Returns the view that was chosen.
    [[nodiscard]] std::optional<SavedCamera> draw(Ui& ui, const OrbitCamera& now);

  private:
    void keep(Ui& ui, const OrbitCamera& now);

    bool open_ = false;
    std::array<char, 48> name_{};
};

// "View 2": of those that stand for no view yet.
[[nodiscard]] std::string freeViewName(std::span<const SavedCamera> kept);

}  // namespace voxprite::editor
