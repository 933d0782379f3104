// The longest frames of the stretches of a run, by name, as `edit --play --frame-times` writes
// them:
//   [{"mark": "select all", "own_ms": 12.1, "work_ms": 9.0, "upload_ms": 3.1, "draw_ms": 20.5,
//     "present_ms": 1.2}, ...]
// Processor time of the window's thread alone (frame_clock.h), so that the figures mean the same on
// a loaded machine: `own` is the editor's, of one frame; the rest need not be of one frame, and
// `draw` and `present` are what the driver does on this thread.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/editor/window/frame_clock.h"
#include "core/base/result.h"

namespace voxprite::editor {

class FrameReport {
  public:
    // What came before belongs to the stretch before.
    void begin(std::string name, FrameClock& clock);
    // The stretch that goes on ends here.
    [[nodiscard]] Status write(const std::filesystem::path& path, FrameClock& clock);

  private:
    struct Stretch {
        std::string name;
        FrameClock clock;
    };
    std::string name_;  // of the stretch that goes on; empty before the first
    std::vector<Stretch> stretches_;
};

}  // namespace voxprite::editor
