// Pictures on the CPU: the integer caster for sprites, and the same walk for perspective rays.
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "app/cli/render_shot.h"
#include "app/cli/stopwatch.h"
#include "core/base/parallel.h"
#include "core/sprite/voxel_placement.h"

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
    const OctreeView octree = shot.octree.view();
    const RaycastOptions depth{.maxDepth = shot.octreeDepth};
    const FaceShader faces(octree, faceLights({}, voxelFromWorldAxes, shot.profile.light).rays);
    const VoxelPlacement placement = voxelPlacement(shot.placed);
    Image image(shot.camera.viewportPx.x, shot.camera.viewportPx.y, shot.background);
    std::vector<float> depths(image.pixels.size(), 0.0f);
    parallelFor(image.height, 0, [&](int firstRow, int lastRow) {
        PaletteShader shader(shot.palette);
        for (int y = firstRow; y < lastRow; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const Camera::Ray ray = shot.camera.rayThrough(glm::dvec2(x, y) + 0.5);
                const glm::dvec3 direction = voxelFromWorldAxes * ray.direction;
                const RaycastHit hit =
                    raycast(octree, placement, {ray.origin, ray.direction}, depth);
                if (!hit.hit) continue;
                const glm::dvec3 fromEye =
                    ray.origin - shot.camera.eyeMetres + ray.direction * hit.t;
                depths[static_cast<std::size_t>(&image.at(x, y) - image.pixels.data())] =
                    shot.camera.reversedDepth(glm::dot(fromEye, shot.camera.forward));
                const FaceLights lights = faceLights(glm::ivec3(glm::sign(direction)),
                                                     voxelFromWorldAxes, shot.profile.light);
                const int side = direction[hit.axis] < 0.0 ? 1 : -1;
                const FaceShade shade = faces.shadeOf({hit.voxel, hit.axis, side});
                const std::uint8_t light8 = lights.of(hit.axis, shade);
                image.at(x, y) = shader.inLight(light8, shot.profile.shading)[hit.value];
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
