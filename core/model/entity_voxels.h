// The entity of a document, frame by frame: which models lie where, and what voxel that makes.
// Placements are resolved here and nowhere else.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/model/document.h"

namespace voxprite {

// One visible object of one frame.
struct Instance {
    int node = 0;   // index into Document::nodes
    int model = 0;  // index into Document::models
    Placement entityFromModel;
};

// Frames of the document: one more than the last key of any node; at least 1.
[[nodiscard]] int frameCount(const Document& document);

// What holds in one frame: the last key not after it (before the first key that one), in tracks
// that do not loop or glide.
[[nodiscard]] Placement placementAt(const SceneNode& node, int frame);
[[nodiscard]] int modelAt(const SceneNode& object, int frame);
[[nodiscard]] glm::dvec3 positionAt(const Socket& socket, int frame);

// The instances of `frame` in drawing order (a later one wins where voxels overlap). Hidden nodes,
// what lies under them, and hidden layers are left out, unless includeHidden.
[[nodiscard]] std::vector<Instance> instancesOf(const Document& document, int frame,
                                                bool includeHidden = false);

// Does the node glide, with keys far enough apart for anything to lie between them?
[[nodiscard]] bool movesBetweenKeys(const SceneNode& node);

// The tight bounds of one frame, and of the union of all frames (the entity's bounds: centre,
// anchor and octree origin belong to these, so that nothing slides). Empty when there is no voxel.
[[nodiscard]] IBox frameBounds(const Document& document, int frame);
[[nodiscard]] IBox entityBounds(const Document& document);

// The tight bounds of a node and all under it, hidden or not, in the space of its parent. Empty
// when there is no voxel.
[[nodiscard]] IBox nodeBounds(const Document& document, int node, int frame);

// The anchor in force: the entity's own, or the bottom centre of `bounds` (the origin if empty).
[[nodiscard]] glm::dvec3 anchorVoxels(const Entity& entity, const IBox& bounds);

// The visible objects of one frame baked together, later ones winning.
[[nodiscard]] VoxelGrid flatten(const Document& document, int frame);

// Reads single voxels of the flattened frame without flattening it. Must not outlive the document;
// voxels may change between reads, the scene graph may not.
class EntitySampler {
  public:
    EntitySampler(const Document& document, int frame);
    [[nodiscard]] std::uint8_t at(glm::ivec3 entityVoxel) const;
    [[nodiscard]] const std::vector<Instance>& instances() const { return instances_; }

  private:
    const Document* document_;
    std::vector<Instance> instances_;
    std::vector<Placement> modelFromEntity_;
};

}  // namespace voxprite
