// Pictures on the CPU: the integer caster for sprites, and the same walk for perspective rays.
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "app/cli/render_shot.h"
#include "app/cli/stopwatch.h"
#include "core/base/parallel.h"
#include "core/trace/lattice_caster.h"

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

// The voxels themselves, one eye ray through each pixel's centre.
Image perspectiveImage(const Shot& shot) {
    const glm::dmat3 voxelFromWorldAxes = glm::transpose(shot.placed.worldFromVoxelAxes);
    const glm::dvec3 towardLight = voxelFromWorldAxes * shot.profile.light.towardLight;
    const OctreeView octree = shot.octree.view();
    Image image(shot.camera.viewportPx.x, shot.camera.viewportPx.y, shot.background);
    std::vector<float> depths(image.pixels.size(), 0.0f);
    parallelFor(image.height, 0, [&](int firstRow, int lastRow) {
        PaletteShader shader(shot.palette);
        for (int y = firstRow; y < lastRow; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const Camera::Ray ray = shot.camera.rayThrough(glm::dvec2(x, y) + 0.5);
                const glm::dvec3 direction = voxelFromWorldAxes * ray.direction;
                const glm::dvec3 eye = voxelFromWorldAxes *
                                           (ray.origin - shot.placed.anchorMetres) /
                                           shot.placed.metresPerVoxel() +
                                       shot.placed.anchor;
                const auto [hit, t] = castPerspective(octree, eye, direction);
                if (hit.material == 0) continue;
                const glm::dvec3 fromEye = ray.origin - shot.camera.eyeMetres +
                                           ray.direction * (t * shot.placed.metresPerVoxel());
                depths[static_cast<std::size_t>(&image.at(x, y) - image.pixels.data())] =
                    shot.camera.reversedDepth(glm::dot(fromEye, shot.camera.forward));
                const auto light8 = faceLight(glm::ivec3(glm::sign(direction)), towardLight,
                                              shot.profile.light.ambient);
                image.at(x, y) =
                    shader.inLight(light8[hit.faceAxis], shot.profile.shading)[hit.material];
            }
        }
    });
    if (shot.ground) drawGround(*shot.ground, shot.camera, depths, image);
    return image;
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
