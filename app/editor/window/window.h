// The window: GLFW and its OpenGL context, owned. Its callbacks only fill the input queue.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>

#include "app/editor/window/input.h"
#include "core/base/image.h"
#include "core/base/result.h"

namespace voxprite::editor {

enum class CursorShape : std::uint8_t { arrow, text, hand, resizeHorizontal, resizeVertical };

class Window {
  public:
    // `sizePx` at content scale 1. The context is current on the calling thread from then on.
    [[nodiscard]] static Result<Window> open(const std::string& title, glm::ivec2 sizePx,
                                             std::optional<double> contentScale);
    ~Window();
    Window(Window&&) noexcept;
    Window& operator=(Window&&) noexcept;

    [[nodiscard]] glm::ivec2 framebufferPx() const;
    [[nodiscard]] double contentScale() const;
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
