#include "core/sprite/perspective_picture.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <memory>

#include "core/sprite/lit_palette.h"
#include "core/sprite/sprite_buffer.h"
#include "core/sprite/voxel_placement.h"
#include "core/trace/ray_packet.h"

namespace voxprite {

PerspectivePicture perspectivePicture(const OctreeView& octree, const Palette& palette,
                                      const PlacedEntity& placed, const Light& light,
                                      Shading shading, const Camera& camera, Rgba8 background,
                                      int maxDepth, int threads) {
    const glm::dmat3 voxelFromWorldAxes = glm::transpose(placed.worldFromVoxelAxes);
    const FaceShader faces(octree, faceLights({}, voxelFromWorldAxes, light).rays);
    const VoxelPlacement placement = voxelPlacement(placed);
    PerspectivePicture picture;
    picture.image = Image(camera.viewportPx.x, camera.viewportPx.y, background);
    picture.ids.assign(picture.image.pixels.size(), kIdEmpty);
    picture.reversedDepths.assign(picture.image.pixels.size(), 0.0f);
    const auto worldRay = [&](glm::ivec2 pixel) {
        return camera.rayThrough(glm::dvec2(pixel) + 0.5);
    };
    raycastPicture(
        octree, camera.viewportPx, maxDepth, threads,
        [&](glm::ivec2 pixel) {
            const Camera::Ray ray = worldRay(pixel);
            return voxelRay(placement, {ray.origin, ray.direction});
        },
        [&] {
            const auto shader = std::make_shared<PaletteShader>(palette);
            return [&, shader](glm::ivec2 pixel, const Ray& voxelRay, const RaycastHit& hit) {
                const auto at = static_cast<std::size_t>(pixel.y) *
                                    static_cast<std::size_t>(picture.image.width) +
                                static_cast<std::size_t>(pixel.x);
                const Camera::Ray ray = worldRay(pixel);
                const glm::dvec3 fromEye = ray.origin - camera.eyeMetres +
                                           ray.direction * (hit.t * placement.metresPerVoxel);
                picture.reversedDepths[at] =
                    camera.reversedDepth(glm::dot(fromEye, camera.forward));
                const FaceLights lights = faceLights(glm::ivec3(glm::sign(voxelRay.direction)),
                                                     voxelFromWorldAxes, light);
                const int side = hit.normal[hit.axis] > 0.0 ? 1 : -1;
                const FaceShade shade = faces.shadeOf({hit.voxel, hit.axis, side});
                const std::uint8_t light8 = lights.of(hit.axis, shade);
                picture.image.pixels[at] = shader->inLight(light8, shading)[hit.value];
                picture.ids[at] = voxelId(hit.voxel, octree.size);
            };
        });
    return picture;
}

}  // namespace voxprite
