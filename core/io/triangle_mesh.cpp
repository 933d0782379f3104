#include "core/io/triangle_mesh.h"

#include <algorithm>
#include <cmath>

#include "core/base/srgb.h"

namespace voxprite {
namespace {

// The texel at `coordinate` (1 is the picture's far edge) of `count` along an axis.
int texelAt(double coordinate, TextureWrap wrap, int count) {
    switch (wrap) {
        case TextureWrap::clamp:
            break;
        case TextureWrap::repeat:
            coordinate -= std::floor(coordinate);
            break;
        case TextureWrap::mirror:
            coordinate -= 2.0 * std::floor(coordinate / 2.0);
            if (coordinate > 1.0) coordinate = 2.0 - coordinate;
            break;
    }
    const double texel = std::floor(coordinate * count);
    return static_cast<int>(std::clamp(texel, 0.0, static_cast<double>(count - 1)));
}

}  // namespace

std::optional<Rgba8> colourAt(const TriangleMesh& mesh, const MeshTriangle& triangle,
                              const glm::dvec3& weights) {
    const MeshMaterial& material = mesh.materials[triangle.material];
    // Pulled in a little from the edges, where a texture is about to begin anew, or another part of
    // it lies beside.
    constexpr double kPull = 1e-4;
    const glm::dvec3 w = weights * (1.0 - kPull) + kPull / 3.0;
    glm::dvec4 light = material.colour;
    glm::dvec4 colour(0.0);
    glm::dvec2 uv(0.0);
    for (int k = 0; k < 3; ++k) {
        const MeshCorner& corner = triangle.corners[static_cast<std::size_t>(k)];
        colour += w[k] * glm::dvec4(corner.colour);
        uv += w[k] * glm::dvec2(corner.uv);
    }
    // Equal corners leave no rounding behind.
    const auto& corners = triangle.corners;
    if (corners[0].colour == corners[1].colour && corners[0].colour == corners[2].colour) {
        colour = glm::dvec4(corners[0].colour);
    }
    light *= colour;
    if (material.texture >= 0) {
        const Image& image = mesh.textures[static_cast<std::size_t>(material.texture)];
        const Rgba8 texel = image.at(texelAt(uv.x, material.wrapU, image.width),
                                     texelAt(uv.y, material.wrapV, image.height));
        light *= glm::dvec4(linearFromSrgb(texel.x), linearFromSrgb(texel.y),
                            linearFromSrgb(texel.z), texel.w / 255.0);
    }
    if (light.w < material.leastAlpha) return std::nullopt;
    return Rgba8(srgbFromLinear(light.x), srgbFromLinear(light.y), srgbFromLinear(light.z), 255);
}

}  // namespace voxprite
