// Recorded input as JSON lines, each with the frame (from 0) in which it happens:
//   {"frame": 3, "move": [640, 400]}            framebuffer pixels
//   {"frame": 4, "button": "left", "down": true}   left, right, middle
//   {"frame": 5, "wheel": [0, 1]}
//   {"frame": 6, "key": "z", "down": true}      names as keyName() gives them
//   {"frame": 7, "text": "hut"}
//   {"frame": 8, "drop": ["a.vox"]}
//   {"frame": 9, "screenshot": "a.png"}         what that frame showed
//   {"frame": 9, "mark": "select all"}          what --frame-times calls the frames from here on
//   {"frame": 10, "quit": true}                 at once, without a question
// A missing frame is that of the line before; frames never go back. Sixty of them are a second for
// all that goes by time.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/editor/window/input.h"
#include "core/base/result.h"

namespace voxprite::editor {

inline constexpr double kScriptFramesPerSecond = 60.0;

struct ScriptScreenshot {
    std::filesystem::path path;
};
struct ScriptMark {
    std::string name;
};
struct ScriptQuit {};

struct ScriptLine {
    long long frame = 0;
    std::variant<InputEvent, ScriptScreenshot, ScriptMark, ScriptQuit> what;
};

// Errors name the line.
[[nodiscard]] Result<std::vector<ScriptLine>> readPlayScript(std::string_view text);
// Under which frames what happens is recorded: the replay waits as long between two clicks as the
// hand did, and whatever came in frames of their own does so again.
class ScriptFrames {
  public:
    // For the next frame in which something happens, so many seconds after the first of all.
    [[nodiscard]] long long next(double seconds);

  private:
    long long last_ = -1;
};

// One line, without its end; empty for what a script cannot hold.
[[nodiscard]] std::string writeScriptLine(long long frame, const InputEvent& event);

}  // namespace voxprite::editor
