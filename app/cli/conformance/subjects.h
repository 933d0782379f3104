// Models made in code, placed before a camera: what the seed's reading and ours are compared on.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "core/model/document.h"
#include "core/sprite/sprite_buffer.h"
#include "core/sprite/sprite_view.h"
#include "core/svo/octree.h"

namespace voxprite::conformance {

struct Subject {
    std::string name;
    VoxelGrid voxels;  // what the octree was baked from
    Octree octree;
    Entity entity;

    // The entity stands so that the model's centre lies at `centreMetres`.
    [[nodiscard]] PlacedEntity centredAt(glm::dvec3 centreMetres, const GameProfile& profile) const;
};

// Every voxel of a box of `size`, by a rule (0 is empty). Sizes are small: baking cannot fail.
[[nodiscard]] Subject subjectFrom(std::string name, glm::ivec3 size,
                                  const std::function<std::uint8_t(glm::ivec3)>& material);
[[nodiscard]] Subject solidBox(glm::ivec3 size);
[[nodiscard]] Subject cube32();         // solid
[[nodiscard]] Subject figure();         // legs, body, arms and head: 32 x 16 x 64
[[nodiscard]] Subject vehicle();        // chassis, wheels and cabin: 16 x 40 x 18
[[nodiscard]] Subject slab();           // solid, 64 x 64 x 8
[[nodiscard]] Subject letters();        // an F, an R and a P on three faces: 6 x 6 x 8
[[nodiscard]] Subject noise(int edge);  // 3 in 100 voxels are solid

// The default profile without minification: the sigma that is asked for is the one in force.
[[nodiscard]] GameProfile plainProfile();
// A camera that looks at the world's origin, 45 degrees high.
[[nodiscard]] Camera orbit(double yawDegrees, double pitchDegrees, double distanceMetres,
                           int viewportPx = 512);
// `view` turned by a small angle about the model's vertical axis.
[[nodiscard]] OrthoView turned(const OrthoView& view, double radians);
// The view of an orbit, in voxel space.
[[nodiscard]] OrthoView orthoView(const OrbitAngles& angles, double sigma);

// viewSprite where the subject is known to be seen; throws std::logic_error when it is not.
[[nodiscard]] SpriteView seen(const PlacedEntity& entity, const Camera& camera,
                              const GameProfile& profile, ViewHistory* history = nullptr);
[[nodiscard]] LatticeView quantised(const OrthoView& view, glm::ivec3 modelSize);
[[nodiscard]] SpriteBuffer cast(const Octree& octree, const LatticeView& lattice);

// A sequence of numbers that is the same on every machine (SplitMix64; Steele, Lea & Flood 2014).
class Sequence {
  public:
    explicit Sequence(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next();
    double unit();  // 0 <= x < 1
    double between(double from, double to);

  private:
    std::uint64_t state_;
};

inline constexpr double kTinyTurnRadians = 1e-7;  // of a view, to see what it changes

}  // namespace voxprite::conformance
