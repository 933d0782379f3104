// The octree of the entity being edited, in the same words as the baked one, changed only where
// voxels changed. It may keep holes (free lists) and an origin of its own: drawing outside the old
// root adds a level instead of rebuilding. canonical() == bake() of the same voxels, bit for bit.
//
// Between edits the tree is collapsed as a baked one is and its root is no larger than needed, so
// casting through it costs the same. An edit touches one path from the root: O(depth), and at most
// eight words are copied on each level of it.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "core/model/voxel_grid.h"
#include "core/svo/node_pool.h"
#include "core/svo/octree.h"

namespace voxprite {

class LiveOctree {
  public:
    struct Edit {
        glm::ivec3 voxel{0};  // entity space
        std::uint8_t material = 0;
    };

    // With a limit on the length of the node array, holes included.
    explicit LiveOctree(std::uint32_t maxNodes = kMaxOctreeNodes) : maxNodes_(maxNodes) {}

    // Starts over from voxels. Fails as bake() does, and beyond the limit; then the octree is left
    // as it was.
    [[nodiscard]] Status rebuild(const VoxelGrid& voxels);
    // Sets single voxels, one after another (the last of several for one voxel wins). Fails, and
    // changes nothing, when the edits would stretch the octree beyond 65,536 voxels an edge or to
    // within a path of the limit on nodes, or when a voxel to be filled lies beyond kMaxCoordinate.
    [[nodiscard]] Status apply(std::span<const Edit> edits);

    [[nodiscard]] std::uint8_t at(glm::ivec3 entityVoxel) const;
    [[nodiscard]] std::uint64_t solidCount() const { return solidCount_; }
    // The tight box around the solid voxels, in entity space. O(nodes).
    [[nodiscard]] IBox solidBounds() const;

    // For casting and upload: voxel (0,0,0) of the view is bounds.min, the entity's bounds as the
    // caller knows them (the union of all frames). Valid until the next change.
    [[nodiscard]] OctreeView view(const IBox& bounds) const;
    // What bake(voxels, bounds) gives, read from the tree itself.
    [[nodiscard]] Result<Octree> canonical(const IBox& bounds) const;

    // What changed since the last call; the caller uploads it.
    [[nodiscard]] OctreeChanges takeChanges() { return pool_.takeChanges(); }
    // Bytes in use: nodes, payloads, free lists.
    [[nodiscard]] std::size_t bytes() const { return pool_.bytes(); }

  private:
    [[nodiscard]] OctreeView wholeTree() const;
    [[nodiscard]] IBox rootBox() const;
    // Takes the arrays over, if the limit allows.
    [[nodiscard]] Status adopt(Result<Octree> octree);
    void clear();
    // Closes the holes if the array has no room left for so many nodes more.
    [[nodiscard]] Status makeRoom(std::size_t nodes);

    // Makes the root hold the box, all or nothing.
    [[nodiscard]] Status reach(const IBox& box);
    void addLevel(glm::ivec3 oldRootCorner);
    void dropNeedlessLevels();

    void set(glm::ivec3 tree, std::uint8_t material);
    // Replaces a node by eight (uniform) or one (empty) that mean the same.
    void split(std::uint32_t index, unsigned octant);
    void insertChild(std::uint32_t parent, unsigned octant);
    // Carries an emptied or uniform node upward as far as it changes its parents.
    void collapse(std::span<const std::uint32_t> path, glm::ivec3 tree);

    std::uint32_t maxNodes_;
    NodePool pool_;
    int maxDepth_ = 1;
    glm::ivec3 origin_{0};  // entity space of tree (0,0,0)
    std::uint64_t solidCount_ = 0;
};

}  // namespace voxprite
