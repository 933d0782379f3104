// The octree that the views show: the document's, with the coming edit in it. It is kept beside the
// document's own, so that showing an edit before it is made costs the voxels that differ and no
// more, and what tools aim at stays as it was.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/box.h"
#include "core/svo/live_octree.h"

namespace voxprite::editor {

class ShownOctree {
  public:
    // Another document, or another frame of it: shown as it is.
    void reset(const LiveOctree& document);
    // `document` has been edited; the preview, if there was one, ends.
    void follow(const LiveOctree& document, std::span<const LiveOctree::Edit> edits);
    // Shows `edits` (entity space, any order, no voxel twice unless with one material) in place of
    // the last preview. Fails, showing no preview, when an octree could not hold them.
    [[nodiscard]] Status preview(const LiveOctree& document, std::vector<LiveOctree::Edit> edits);
    // Shows this one instead, which somebody has made with a coming edit of very many voxels in it;
    // `filled` is around those that the edit fills.
    void show(LiveOctree octree, const IBox& filled);

    [[nodiscard]] const LiveOctree& octree() const { return another_ ? *another_ : octree_; }
    [[nodiscard]] bool previews() const { return another_ || !previewed_.empty(); }
    // Around the voxels that the preview fills.
    [[nodiscard]] const IBox& filled() const { return filled_; }
    [[nodiscard]] OctreeChanges takeChanges();

  private:
    void endAnother();

    LiveOctree octree_;
    // What show() was given. The octree above waits behind it, still the document's: to copy that
    // one again would take longer than a hand should wait.
    std::optional<LiveOctree> another_;
    bool isReplaced_ = false;                  // since changes were last taken
    std::vector<LiveOctree::Edit> previewed_;  // ascending voxels, none twice
    IBox filled_;
};

}  // namespace voxprite::editor
