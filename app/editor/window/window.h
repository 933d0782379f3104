// The window: GLFW and its OpenGL context, owned. Its callbacks only fill the input queue.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>

#include "app/editor/window/input.h"
#include "app/editor/window/window_place.h"
#include "core/base/image.h"
#include "core/base/result.h"

namespace voxprite::editor {

enum class CursorShape : std::uint8_t { arrow, text, hand, resizeHorizontal, resizeVertical };

class Window {
  public:
    // As `place` says, on a display that is there and no larger than it. The context is current on
    // the calling thread from then on.
    [[nodiscard]] static Result<Window> open(const std::string& title, const WindowPlace& place,
                                             std::optional<double> contentScale);
    ~Window();
    Window(Window&&) noexcept;
    Window& operator=(Window&&) noexcept;

    [[nodiscard]] glm::ivec2 framebufferPx() const;
    [[nodiscard]] double contentScale() const;
    // Where it is now. Of a maximised window the place is `before`, which it returns to.
    [[nodiscard]] WindowPlace place(const WindowPlace& before) const;
    [[nodiscard]] static double seconds();  // a clock that only runs forward

    // Collects what happened; waits for it up to `waitSeconds` (0: not at all).
    void pollEvents(double waitSeconds);
    [[nodiscard]] InputQueue& input();
    [[nodiscard]] bool takeCloseRequest();

    void setTitle(const std::string& title);
    void setCursor(CursorShape shape);
    [[nodiscard]] std::string clipboard() const;
    void setClipboard(const std::string& text);
    void swapBuffers();
    // What was drawn since the last swap.
    [[nodiscard]] Image readBackBuffer() const;

  private:
    struct Impl;
    explicit Window(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace voxprite::editor
