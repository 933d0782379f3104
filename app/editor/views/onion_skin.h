// The frames before and after the one being edited, as octrees for the edit view.
#pragma once

#include <array>
#include <vector>

#include "app/editor/session/session.h"
#include "render/gpu_octree.h"

namespace voxprite::editor {

class OnionSkin {
  public:
    struct Ghost {
        const GpuOctree* octree;
        Rgba8 tint;
    };
    // Octrees of the document's own bounds, which a preview leaves as they are; brought up to date
    // with the session where a frame shows something else than before. Empty when it is switched
    // off, or there is but one frame. Needs the window's GL context. Fails when a frame is too
    // large for an octree.
    [[nodiscard]] Result<std::vector<Ghost>> ghosts(const Session& session, bool on);

  private:
    // A frame on the GPU, and what it was made from.
    struct Skin {
        GpuOctree octree;
        std::vector<std::uint64_t> source;
    };
    [[nodiscard]] Status show(const Session& session, int frame, Skin& skin);

    std::array<Skin, 2> skins_;
};

}  // namespace voxprite::editor
