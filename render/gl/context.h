// A GL 4.5 core context: headless through EGL, or loading the entry points of a window's context.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace voxprite::gl {

// What the driver said through KHR_debug with high severity since the last call, the first hundred;
// tests fail on any.
[[nodiscard]] std::vector<std::string> takeSevereMessages();

struct DriverInfo {
    std::string vendor, renderer, version;
};
[[nodiscard]] DriverInfo driverInfo();

// Loads GL through `getProcAddress` for the context that is current, checks the version, sets the
// conventions that all passes rely on (reversed depth: glClipControl zero to one; no dithering) and
// installs the debug callback. For the editor's window.
using GetProcAddress = void (*(*)(const char* name))();
[[nodiscard]] Status loadCurrent(GetProcAddress getProcAddress);

// Surfaceless, on the first EGL device that works; software is fine. The error says what was tried
// and which package to install. Current on the calling thread while it lives.
class HeadlessContext {
  public:
    [[nodiscard]] static Result<HeadlessContext> create();
    ~HeadlessContext();
    HeadlessContext(HeadlessContext&&) noexcept;
    HeadlessContext& operator=(HeadlessContext&&) noexcept;

  private:
    struct Impl;
    explicit HeadlessContext(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace voxprite::gl
