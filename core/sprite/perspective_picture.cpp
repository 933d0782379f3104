#include "core/sprite/perspective_picture.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/base/parallel.h"
#include "core/sprite/lit_palette.h"
#include "core/sprite/sprite_buffer.h"
#include "core/sprite/voxel_placement.h"

namespace voxprite {

PerspectivePicture perspectivePicture(const OctreeView& octree, const Palette& palette,
                                      const PlacedEntity& placed, const Light& light,
                                      Shading shading, const Camera& camera, Rgba8 background,
                                      int maxDepth, int threads) {
    const glm::dmat3 voxelFromWorldAxes = glm::transpose(placed.worldFromVoxelAxes);
    const RaycastOptions depth{.maxDepth = maxDepth};
    const FaceShader faces(octree, faceLights({}, voxelFromWorldAxes, light).rays);
    const VoxelPlacement placement = voxelPlacement(placed);
    PerspectivePicture picture;
    picture.image = Image(camera.viewportPx.x, camera.viewportPx.y, background);
    picture.ids.assign(picture.image.pixels.size(), kIdEmpty);
    picture.reversedDepths.assign(picture.image.pixels.size(), 0.0f);
    parallelFor(picture.image.height, threads, [&](int firstRow, int lastRow) {
        PaletteShader shader(palette);
        std::size_t at =
            static_cast<std::size_t>(firstRow) * static_cast<std::size_t>(picture.image.width);
        for (int y = firstRow; y < lastRow; ++y) {
            for (int x = 0; x < picture.image.width; ++x, ++at) {
                const Camera::Ray ray = camera.rayThrough(glm::dvec2(x, y) + 0.5);
                const RaycastHit hit =
                    raycast(octree, placement, {ray.origin, ray.direction}, depth);
                if (!hit.hit) continue;
                const glm::dvec3 direction = voxelFromWorldAxes * ray.direction;
                const glm::dvec3 fromEye = ray.origin - camera.eyeMetres + ray.direction * hit.t;
                picture.reversedDepths[at] =
                    camera.reversedDepth(glm::dot(fromEye, camera.forward));
                const FaceLights lights =
                    faceLights(glm::ivec3(glm::sign(direction)), voxelFromWorldAxes, light);
                const int side = direction[hit.axis] < 0.0 ? 1 : -1;
                const FaceShade shade = faces.shadeOf({hit.voxel, hit.axis, side});
                const std::uint8_t light8 = lights.of(hit.axis, shade);
                picture.image.pixels[at] = shader.inLight(light8, shading)[hit.value];
                picture.ids[at] = voxelId(hit.voxel, octree.size);
            }
        }
    });
    return picture;
}

}  // namespace voxprite
