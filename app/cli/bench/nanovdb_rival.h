// NanoVDB, cast through as that library does it. Nothing of its headers shows here.
#pragma once

#include <cstdint>
#include <memory>

#include "app/cli/bench/ray.h"
#include "core/svo/octree.h"

namespace voxprite::bench {

// NanoVDB's hierarchical DDA (Museth 2021) over a grid of 32-bit values. Its own `firstActive`
// steps a whole voxel past each crossing and so through thin walls (openvdb #1500, #2009); the walk
// here is the same but for the cell behind a crossing, whose coordinate on the axis crossed is
// counted and not rounded, and those on the others are kept inside the cell's neighbour.
class NanoVdbRival {
  public:
    explicit NanoVdbRival(const OctreeView& octree);
    ~NanoVdbRival();
    NanoVdbRival(const NanoVdbRival&) = delete;
    NanoVdbRival& operator=(const NanoVdbRival&) = delete;

    // One for each thread: it remembers the nodes it was in.
    class Caster {
      public:
        explicit Caster(const NanoVdbRival& rival);
        ~Caster();
        Caster(const Caster&) = delete;
        Caster& operator=(const Caster&) = delete;
        [[nodiscard]] std::uint8_t cast(const Ray& ray);  // the material hit, 0 for none

      private:
        struct State;
        std::unique_ptr<State> state_;
    };

  private:
    struct Grid;
    std::unique_ptr<Grid> grid_;
};

}  // namespace voxprite::bench
