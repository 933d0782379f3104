// The octree of the entity being edited, in the same words as the baked one, changed only where
// voxels changed. It may keep holes (free lists) and an origin of its own: drawing outside the old
// root adds a level instead of rebuilding. canonical() == bake() of the same voxels, bit for bit.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/model/voxel_grid.h"
#include "core/svo/octree.h"

namespace voxprite {

// A run of elements [first, first + count) of an array.
struct ArrayRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

// What the GPU's copy must be told; merged runs, ascending.
struct OctreeChanges {
    bool everything = false;  // arrays were replaced: upload all
    std::vector<ArrayRange> nodes;
    std::vector<ArrayRange> payloads;
    void clear() { *this = {}; }
    [[nodiscard]] bool any() const { return everything || !nodes.empty() || !payloads.empty(); }
};

class LiveOctree {
  public:
    struct Edit {
        glm::ivec3 voxel{0};  // entity space
        std::uint8_t material = 0;
    };

    // Starts over from voxels. Fails as bake() does; then the octree is left as it was.
    [[nodiscard]] Status rebuild(const VoxelGrid& voxels);
    // Sets single voxels. Fails (and changes nothing) when the edits would stretch the octree
    // beyond 65,536 voxels an edge or kMaxOctreeNodes nodes.
    [[nodiscard]] Status apply(std::span<const Edit> edits);

    [[nodiscard]] std::uint8_t at(glm::ivec3 entityVoxel) const;
    [[nodiscard]] std::uint64_t solidCount() const { return solidCount_; }

    // For casting and upload: voxel (0,0,0) of the view is bounds.min, the entity's bounds as the
    // caller knows them (the union of all frames). Valid until the next change.
    [[nodiscard]] OctreeView view(const IBox& bounds) const;
    [[nodiscard]] Result<Octree> canonical(const IBox& bounds) const;

    // What changed since the last call; the caller uploads it.
    [[nodiscard]] OctreeChanges takeChanges();
    // Bytes held: nodes, payloads, free lists.
    [[nodiscard]] std::size_t bytes() const;

  private:
    std::vector<std::uint32_t> nodes_{0};
    std::vector<std::uint64_t> payloads_;
    int maxDepth_ = 1;
    glm::ivec3 origin_{0};  // entity space of tree (0,0,0)
    std::uint64_t solidCount_ = 0;
    // Blocks of k sibling nodes that are free, by k; and free payloads.
    std::vector<std::vector<std::uint32_t>> freeBlocks_{9};
    std::vector<std::uint32_t> freePayloads_;
    OctreeChanges changes_;
};

}  // namespace voxprite
