// Sprite buffers of the CPU and of OpenGL, pixel by pixel.
#include <cmath>
#include <cstdint>

#include "app/cli/conformance/stability.h"
#include "app/cli/conformance/subjects.h"
#include "render/gl/context.h"
#include "render/gpu_octree.h"
#include "render/scene_renderer.h"

namespace voxprite::conformance {
namespace {

// Keeps software drawing quick.
constexpr std::int64_t kMostPixels = 60'000;

}  // namespace

Sweep sweepGpu() {
    Sweep sweep{"gpu", "exact views and those turned by 1e-7 and 1e-2 rad, sigma 0.5 ... 16"};
    const Result<gl::HeadlessContext> context = gl::HeadlessContext::create();
    if (!context) {
        sweep.notRun = context.error().describe();
        return sweep;
    }
    Result<SceneRenderer> renderer = SceneRenderer::create();
    if (!renderer) {
        sweep.count(false, renderer.error().describe());
        return sweep;
    }
    sweep.what += ", on " + gl::driverInfo().renderer;
    const double isometric = std::atan(std::sqrt(0.5)) * 57.29577951308232;
    double differing = 0.0;
    double compared = 0.0;
    for (const Subject& subject :
         {letters(), figure(), noise(32), solidBox({1, 1, 1}), solidBox({1, 1, 256})}) {
        GpuOctree octree;
        octree.upload(subject.octree.view());
        for (const OrbitAngles angles :
             {OrbitAngles{0, 0, 0}, {90, 0, 0}, {0, 90, 0}, {45, 0, 0}, {45, isometric, 0}})
            for (const double turn : {0.0, 1e-7, 1e-2})
                for (const double sigma : {0.5, 1.5, 4.0, 16.0}) {
                    const OrthoView view = turned(orthoView(angles, sigma), turn);
                    const LatticeView lattice = quantised(view, subject.octree.size);
                    if (std::int64_t{lattice.size.x} * lattice.size.y > kMostPixels) continue;
                    const SpriteBuffer cpu = cast(subject.octree, lattice);
                    const auto gpu = renderer->castBuffer(octree, lattice, LitPalette{},
                                                          SpriteMode::spriteBuffer);
                    sweep.count(gpu && gpu->ids.size() == cpu.ids.size(), subject.name);
                    if (!gpu || gpu->ids.size() != cpu.ids.size()) continue;
                    for (std::size_t at = 0; at < cpu.ids.size(); ++at)
                        differing +=
                            cpu.ids[at] != gpu->ids[at] || cpu.colours[at] != gpu->colours[at]
                                ? 1.0
                                : 0.0;
                    compared += static_cast<double>(cpu.ids.size());
                }
    }
    sweep.figures = {
        {"differing", "pixels that differ between CPU and OpenGL", differing, 0.0, "pixels"},
        {"compared", "pixels compared", compared, std::numeric_limits<double>::infinity(),
         "pixels"}};
    return sweep;
}

}  // namespace voxprite::conformance
