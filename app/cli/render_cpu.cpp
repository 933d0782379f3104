// Pictures on the CPU: the integer caster for sprites, and the same walk for perspective rays.
#include "app/cli/render_shot.h"
#include "app/cli/stopwatch.h"
#include "core/sprite/perspective_picture.h"

namespace voxprite::cli {
namespace {

Image compositeSprite(const Shot& shot, const SpriteBuffer& buffer) {
    std::vector<CompositeSprite> sprites;
    std::vector<float> depths;
    if (shot.view) {
        sprites.push_back({&*shot.view, &buffer, nullptr});
        if (shot.profile.depth == DepthRule::perPixel) {
            depths = pixelDepths(*shot.view, shot.octree.view(), buffer);
            sprites.back().depthMetres = &depths;
        }
    }
    return composite(sprites, shot.camera, shot.background, shot.ground);
}

Image perspectiveImage(const Shot& shot) {
    PerspectivePicture picture =
        perspectivePicture(shot.octree.view(), shot.palette, shot.placed, shot.profile.light,
                           shot.profile.shading, shot.camera, shot.background, shot.octreeDepth);
    if (shot.ground) drawGround(*shot.ground, shot.camera, picture.reversedDepths, picture.image);
    return std::move(picture.image);
}

}  // namespace

Result<Drawn> drawOnCpu(const Shot& shot, RenderMode mode, bool wantImage, Times& times) {
    Drawn drawn;
    Stopwatch watch;
    if (mode == RenderMode::voxels) {
        if (wantImage) drawn.image = perspectiveImage(shot);
        times.emplace_back("draw", watch.lapMilliseconds());
        return drawn;
    }
    // The modes differ in where a ray is cast, not in what it hits: here they are one.
    drawn.buffer = castSprite(shot.octree.view(), shot.lattice, shot.lit);
    times.emplace_back("cast", watch.lapMilliseconds());
    if (wantImage) {
        drawn.image =
            shot.latticeGiven ? drawn.buffer->image() : compositeSprite(shot, *drawn.buffer);
        times.emplace_back("draw", watch.lapMilliseconds());
    }
    return drawn;
}

}  // namespace voxprite::cli
