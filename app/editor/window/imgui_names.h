// Textures and colours, as the user interface names them.
#pragma once

#include <imgui.h>

#include <cstdint>

#include "core/base/image.h"

namespace voxprite::editor {

// Dear ImGui passes on a pointer that its OpenGL backend reads as the texture's number.
[[nodiscard]] inline ImTextureID imguiTexture(std::uint32_t texture) {
    const auto number = static_cast<std::uintptr_t>(texture);
    return reinterpret_cast<ImTextureID>(number);  // NOLINT(performance-no-int-to-ptr): see above
}

[[nodiscard]] inline ImU32 toImU32(Rgba8 colour) {
    return IM_COL32(colour.x, colour.y, colour.z, colour.w);
}

}  // namespace voxprite::editor
