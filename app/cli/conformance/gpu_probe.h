// What OpenGL makes of the cases of a sweep: sprite buffers against the processor's, and frames on
// a screen.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "app/cli/conformance/subjects.h"
#include "render/frame.h"
#include "render/gl/context.h"
#include "render/gpu_octree.h"
#include "render/scene_renderer.h"

namespace voxprite::conformance {

class GpuProbe {
  public:
    GpuProbe();
    // Why nothing is compared or drawn here; empty where OpenGL works.
    [[nodiscard]] const std::string& missing() const { return missing_; }

    // Casts a window of the buffer, somewhere in it, by the processor and by both modes of OpenGL.
    void compareWindow(const Subject& subject, const LatticeView& lattice);
    // The same for all of the buffer, by sprite buffers.
    void compareWhole(const Subject& subject, const LatticeView& lattice);
    // Draws a small frame by both modes and by the processor; at most one virtual pixel a voxel.
    void draw(const Subject& subject, const PlacedEntity& entity, Camera camera,
              GameProfile profile);

    // Pixels are those compared; the others count pixels that are wrong.
    struct Buffers {
        int buffers = 0;
        std::uint64_t pixels = 0;
        std::uint64_t differing = 0;
    };
    struct Screens {
        int frames = 0;
        std::uint64_t pixels = 0;       // that show the sprite
        std::uint64_t modesDiffer = 0;  // between sprite buffers and single pass
        // A depth that is no number from 0 to 1, or a colour that nothing in the scene has.
        std::uint64_t notANumber = 0;
        std::uint64_t unlikeProcessor = 0;
    };
    [[nodiscard]] const Buffers& windows() const { return windows_; }
    [[nodiscard]] const Buffers& wholes() const { return wholes_; }
    [[nodiscard]] const Screens& screens() const { return screens_; }
    [[nodiscard]] const std::string& firstFailure() const { return firstFailure_; }

  private:
    const GpuOctree& uploaded(const Subject& subject);
    void compare(const Subject& subject, const LatticeView& lattice, SpriteMode mode,
                 Buffers& sums);
    [[nodiscard]] std::optional<Image> drawn(const Scene& scene, const Camera& camera,
                                             const GameProfile& profile, SpriteMode mode,
                                             const LitPalette& lit);
    void failed(const std::string& what);

    std::string missing_;
    std::optional<gl::HeadlessContext> context_;  // outlives all that is made in it
    std::unique_ptr<SceneRenderer> renderer_;
    std::unique_ptr<Frame> frame_;
    std::map<std::string, GpuOctree> octrees_;  // by the subject's name
    Palette palette_ = Palette::standard();
    Sequence random_{23};
    Buffers windows_, wholes_;
    Screens screens_;
    std::string firstFailure_;
};

}  // namespace voxprite::conformance
