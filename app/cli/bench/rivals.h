// Other ways to cast a ray and to bake an octree, to measure ours against.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "app/cli/bench/ray.h"
#include "core/base/result.h"
#include "core/model/voxel_grid.h"
#include "core/svo/octree.h"

namespace voxprite::bench {

// Every solid voxel of an octree, those of one small cube after those of another.
void forEachSolid(const OctreeView& octree,
                  const std::function<void(glm::ivec3 voxel, std::uint8_t material)>& body);

// Every voxel a byte, walked cell by cell (Amanatides & Woo 1987).
class DenseGrid {
  public:
    static constexpr std::uint64_t kMaxVoxels = std::uint64_t{1} << 28;
    // The size of the octree must hold at most kMaxVoxels.
    explicit DenseGrid(const OctreeView& octree);
    [[nodiscard]] std::uint8_t cast(const Ray& ray) const;  // the material hit, 0 for none

  private:
    glm::ivec3 size_;
    std::vector<std::uint8_t> voxels_;
};

// The octree, entered anew from its root for every node that the ray passes (after the restart
// method of Foley & Sugerman 2005 for k-d trees).
[[nodiscard]] std::uint8_t castByRestart(const OctreeView& octree, const Ray& ray);

// The canonical octree by inserting every solid voxel from the root, each new node allocated by
// itself, collapsing the tree and writing it out breadth first.
[[nodiscard]] Result<Octree> bakeNaively(const VoxelGrid& voxels);

}  // namespace voxprite::bench
