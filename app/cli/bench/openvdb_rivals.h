// OpenVDB, to measure casting, the bake and the update against. The bench alone loads it, from a
// library of its own (libvoxprite_rivals.so), so that no other command waits for OpenVDB's symbols.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>

#include "app/cli/bench/ray.h"
#include "core/base/result.h"

namespace voxprite::bench {

// OpenVDB's VolumeRayIntersector (Museth 2014), which finds the leaf nodes along a ray, and its DDA
// from voxel to voxel inside them.
class OpenVdbVolume {
  public:
    virtual ~OpenVdbVolume() = default;
    // All of them before the first caster is made.
    virtual void set(glm::ivec3 voxel, std::uint8_t material) = 0;

    // One for each thread: it remembers the nodes it was in. The volume outlives it.
    class Caster {
      public:
        virtual ~Caster() = default;
        [[nodiscard]] virtual std::uint8_t cast(
            const Ray& ray) = 0;  // the material hit, 0 for none
    };
    [[nodiscard]] virtual std::unique_ptr<Caster> caster() = 0;
};

// Voxels in OpenVDB's usual tree (5-4-3), which is the only one that NanoVDB takes. Values are 16
// bits wide, the narrowest integer that NanoVDB knows.
class OpenVdbGrid {
  public:
    virtual ~OpenVdbGrid() = default;
    // Sets a voxel through an accessor that remembers where the last one was.
    virtual void set(glm::ivec3 voxel, std::uint8_t material) = 0;

    class NanoVdb {
      public:
        virtual ~NanoVdb() = default;
        [[nodiscard]] virtual int get(glm::ivec3 voxel) const = 0;
    };
    // Converts all of it, on all cores, without the statistics and the checksum that are optional.
    // Throws what NanoVDB throws.
    [[nodiscard]] virtual std::unique_ptr<NanoVdb> toNanoVdb() const = 0;
};

class OpenVdbRivals {
  public:
    virtual ~OpenVdbRivals() = default;
    // `size`: rays are clipped to [0, size].
    [[nodiscard]] virtual std::unique_ptr<OpenVdbVolume> volume(glm::ivec3 size) const = 0;
    [[nodiscard]] virtual std::unique_ptr<OpenVdbGrid> grid() const = 0;
};
// Fails where the library cannot be loaded.
[[nodiscard]] Result<const OpenVdbRivals*> openVdbRivals();

}  // namespace voxprite::bench
