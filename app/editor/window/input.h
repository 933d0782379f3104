// Input as data: what the window system says becomes events in a queue, and one frame takes a few
// of them. Recorded scripts fill the same queue, so that a replay goes the same way.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voxprite::editor {

enum class InputKind : std::uint8_t {
    move,    // position
    leave,   // the pointer left the window
    button,  // code 0 left, 1 right, 2 middle; down
    wheel,   // position: notches to the right and up
    key,     // code as GLFW counts keys; down
    text,    // code: a Unicode code point
    drop     // files
};

struct InputEvent {
    InputKind kind = InputKind::move;
    glm::dvec2 position{0.0};  // framebuffer pixels from the window's top left corner
    int code = 0;
    bool down = false;
    std::vector<std::filesystem::path> files{};
    double seconds = 0.0;  // when it arrived; see Window::seconds()
};

class InputQueue {
  public:
    void push(InputEvent event) { events_.push_back(std::move(event)); }
    [[nodiscard]] bool empty() const { return events_.empty(); }
    // The events of one frame, in order. A user interface looks at the state once a frame, so a
    // frame ends before anything that would undo or move what it has not yet seen: after a button
    // changed, before one is released that was dragged in this frame, before a key changes a second
    // time, and before one is released that may belong to another just pressed (Ctrl of Ctrl+Z).
    [[nodiscard]] std::vector<InputEvent> takeFrame();

  private:
    std::deque<InputEvent> events_;
};

// "left_control", "a", "f5", ...; nothing for keys without a name.
[[nodiscard]] std::optional<std::string_view> keyName(int key);
[[nodiscard]] std::optional<int> keyNamed(std::string_view name);
// As people read it: "-", "A", "Page Up"; empty for keys without a name.
[[nodiscard]] std::string keyLabel(int key);
inline constexpr int kLastKey = 348;  // keys are numbered up to it

}  // namespace voxprite::editor
