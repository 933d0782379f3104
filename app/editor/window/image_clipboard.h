// Holds a picture for other programs to paste: the X11 selection CLIPBOARD with the target
// image/png. The window system asks its owner for the bytes whenever somebody pastes, so a thread
// with a connection of its own answers as long as this lives; what was copied goes with it, unless
// the desktop has a clipboard manager, which fetches a copy.
#pragma once

#include <memory>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace voxprite::editor {

class ImageClipboard {
  public:
    ImageClipboard();
    ~ImageClipboard();
    ImageClipboard(ImageClipboard&&) noexcept;
    ImageClipboard& operator=(ImageClipboard&&) noexcept;

    // Fails without an X11 display, or when the picture is larger than one transfer may be.
    [[nodiscard]] Status copyPng(Bytes png);

  private:
    class Owner;
    std::unique_ptr<Owner> owner_;
};

}  // namespace voxprite::editor
