// What the sample models are painted with: ramps of a shared palette and a few solid shapes.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/model/document.h"

namespace voxprite::samples {

// Six shades each, dark to light, hue-shifted the way pixel artists do it.
enum class Ramp : std::uint8_t {
    stone,
    steel,
    skin,
    hair,
    wood,
    bark,
    leaf,
    grass,
    roof,
    plaster,
    red,
    blue,
    gold,
    glass,
    soil,
    blossom,
    ink,
    count
};
inline constexpr int kShades = 6;

[[nodiscard]] std::uint8_t shade(Ramp ramp, int step);  // step 0 (darkest) ... 5, clamped
[[nodiscard]] Palette samplePalette();

// A voxel's own random number in [0, 1): the same on every machine.
[[nodiscard]] double grain(glm::ivec3 v, std::uint32_t seed = 1);

// What colour a voxel gets; 0 leaves it as it is.
using Paint = std::function<std::uint8_t(glm::ivec3 v)>;
// `step` of the ramp, with a few voxels one step lighter or darker.
[[nodiscard]] Paint grained(Ramp ramp, int step, double amount = 0.25, std::uint32_t seed = 1);
[[nodiscard]] Paint plain(Ramp ramp, int step);

class Brush {
  public:
    explicit Brush(VoxelGrid& grid) : grid_(&grid) {}
    // Both corners included.
    void box(glm::ivec3 a, glm::ivec3 b, const Paint& paint);
    void box(glm::ivec3 a, glm::ivec3 b, std::uint8_t colour);
    void erase(glm::ivec3 a, glm::ivec3 b);
    // Voxels whose centre lies inside; centre and radii in continuous voxel space.
    void ellipsoid(glm::dvec3 centre, glm::dvec3 radii, const Paint& paint);
    // Upright; from z0 to z1 included, the radius going from r0 to r1.
    void cone(glm::dvec2 centre, int z0, int z1, double r0, double r1, const Paint& paint);
    // A round limb between two points.
    void limb(glm::dvec3 a, glm::dvec3 b, double radiusA, double radiusB, const Paint& paint);
    void dot(glm::ivec3 v, std::uint8_t colour);
    // Recolours voxels that are there.
    void repaint(glm::ivec3 a, glm::ivec3 b, const Paint& paint);

  private:
    void put(glm::ivec3 v, std::uint8_t colour);
    VoxelGrid* grid_;
};

// A document whose one object, `name`, shows `grid`, in the sample palette.
[[nodiscard]] Document documentOf(std::string name, VoxelGrid grid);

[[nodiscard]] VoxelGrid knight(int step = 0);  // step 0..3 of a walk
[[nodiscard]] VoxelGrid oak();
[[nodiscard]] VoxelGrid cottage();
[[nodiscard]] VoxelGrid truck();
[[nodiscard]] VoxelGrid letterCube();
[[nodiscard]] VoxelGrid fence();
[[nodiscard]] VoxelGrid meadow();

}  // namespace voxprite::samples
