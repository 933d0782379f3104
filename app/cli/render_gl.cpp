// Pictures by OpenGL, headless.
#include "app/cli/render_shot.h"
#include "app/cli/stopwatch.h"
#include "render/frame.h"
#include "render/gl/context.h"
#include "render/gpu_octree.h"
#include "render/scene_renderer.h"
#include "render/voxel_view.h"

namespace voxprite::cli {
namespace {

// The view's own backdrop is the editor's: what no voxel covers (depth 0, the far end) is given the
// background that was asked for.
Result<Image> drawVoxels(const Shot& shot, const GpuOctree& octree) {
    Result<VoxelView> view = VoxelView::create();
    if (!view) return Failure(view.error());
    VoxelViewOptions options;
    options.edges = false;
    options.occlusion = VoxelOcclusion::off;
    options.spriteLight = true;
    options.shading = shot.profile.shading;
    options.ground = false;
    options.light = shot.profile.light;
    options.maxDepth = shot.octreeDepth;
    if (Status fits = Frame::checkSize(shot.camera.viewportPx); !fits) {
        return Failure(fits.error());
    }
    Frame frame(shot.camera.viewportPx);
    view->draw(frame, octree, shot.palette, shot.placed, shot.camera, options);
    Image image = frame.readColour();
    const std::vector<float> depths = frame.readDepth();
    for (std::size_t k = 0; k < depths.size(); ++k) {
        if (depths[k] == 0.0f) image.pixels[k] = shot.background;
    }
    if (shot.ground) drawGround(*shot.ground, shot.camera, depths, image);
    return image;
}

Result<Image> drawScene(const Shot& shot, const GpuOctree& octree, SceneRenderer& renderer,
                        SpriteMode mode) {
    Scene scene;
    scene.entities.push_back({&octree, &shot.palette, shot.placed, nullptr});
    if (shot.mode == RenderMode::billboard) {
        scene.entities.back().representation = Representation::snapshot;
        scene.entities.back().views = &shot.snapshots.views;
    }
    scene.background = shot.background;
    scene.ground = shot.ground;
    Frame frame(shot.camera.viewportPx);
    const Result<SceneStats> stats = renderer.draw(frame, scene, shot.camera, shot.profile, mode);
    if (!stats) return Failure(stats.error());
    return frame.readColour();
}

}  // namespace

Result<Drawn> drawOnGl(const Shot& shot, RenderMode mode, bool wantImage, Times& times) {
    Stopwatch watch;
    const Result<gl::HeadlessContext> context = gl::HeadlessContext::create();
    if (!context) return Failure(context.error());
    Drawn drawn;
    drawn.driver = gl::driverInfo().renderer + ", " + gl::driverInfo().version;
    if (mode == RenderMode::clusters) {
        Result<Drawn> clusters = drawClusters(shot, times);
        if (clusters) clusters->driver = drawn.driver;
        return clusters;
    }
    GpuOctree octree;
    octree.upload(shot.octree.view());
    if (mode == RenderMode::voxels) {
        times.emplace_back("start", watch.lapMilliseconds());
        if (wantImage) {
            Result<Image> image = drawVoxels(shot, octree);
            if (!image) return Failure(image.error());
            drawn.image = std::move(*image);
        }
        times.emplace_back("draw", watch.lapMilliseconds());
        return drawn;
    }
    Result<SceneRenderer> renderer = SceneRenderer::create();
    if (!renderer) return Failure(renderer.error());
    times.emplace_back("start", watch.lapMilliseconds());

    const SpriteMode spriteMode =
        mode == RenderMode::singlePass ? SpriteMode::singlePass : SpriteMode::spriteBuffer;
    Result<SpriteBuffer> buffer = renderer->castBuffer(octree, shot.lattice, shot.lit, spriteMode);
    if (!buffer) return Failure(buffer.error());
    drawn.buffer = std::move(*buffer);
    times.emplace_back("cast", watch.lapMilliseconds());
    if (!wantImage) return drawn;
    if (shot.latticeGiven) {
        drawn.image = drawn.buffer->image();
        return drawn;
    }
    Result<Image> image = drawScene(shot, octree, *renderer, spriteMode);
    if (!image) return Failure(image.error());
    drawn.image = std::move(*image);
    times.emplace_back("draw", watch.lapMilliseconds());
    return drawn;
}

}  // namespace voxprite::cli
