#include "app/editor/session/shown_octree.h"

#include <algorithm>
#include <utility>

namespace voxprite::editor {
namespace {

using Edit = LiveOctree::Edit;

bool comesBefore(glm::ivec3 a, glm::ivec3 b) {
    if (a.x != b.x) return a.x < b.x;
    return a.y != b.y ? a.y < b.y : a.z < b.z;
}

bool editComesBefore(const Edit& a, const Edit& b) {
    return comesBefore(a.voxel, b.voxel);
}

void sortOnce(std::vector<Edit>& edits) {
    if (!std::ranges::is_sorted(edits, editComesBefore)) std::ranges::sort(edits, editComesBefore);
    const auto sameVoxel = [](const Edit& a, const Edit& b) { return a.voxel == b.voxel; };
    edits.erase(std::unique(edits.begin(), edits.end(), sameVoxel), edits.end());
}

// What leads from showing `before` to showing `after`; what only `before` has goes back to the
// document.
std::vector<Edit> difference(const LiveOctree& document, const std::vector<Edit>& before,
                             const std::vector<Edit>& after) {
    std::vector<Edit> edits;
    auto next = after.begin();
    for (const Edit& old : before) {
        while (next != after.end() && comesBefore(next->voxel, old.voxel)) edits.push_back(*next++);
        if (next == after.end() || next->voxel != old.voxel) {
            edits.push_back({old.voxel, document.at(old.voxel)});
        } else {
            if (next->material != old.material) edits.push_back(*next);
            ++next;
        }
    }
    edits.insert(edits.end(), next, after.end());
    return edits;
}

}  // namespace

void ShownOctree::reset(const LiveOctree& document) {
    octree_ = document;
    another_.reset();
    isReplaced_ = true;
    previewed_.clear();
    filled_ = {};
}

void ShownOctree::show(LiveOctree octree, const IBox& filled) {
    another_ = std::move(octree);
    isReplaced_ = true;
    filled_ = filled;
}

void ShownOctree::endAnother() {
    if (!another_) return;
    another_.reset();
    isReplaced_ = true;
}

OctreeChanges ShownOctree::takeChanges() {
    OctreeChanges changes = another_ ? another_->takeChanges() : octree_.takeChanges();
    // A copy knows nothing of what was shown before it.
    if (std::exchange(isReplaced_, false)) changes.everything = true;
    return changes;
}

void ShownOctree::follow(const LiveOctree& document, std::span<const Edit> edits) {
    endAnother();
    if (previewed_.empty()) {
        // The document's octree holds these voxels, but this one's may have more holes.
        if (!octree_.apply(edits)) reset(document);
        return;
    }
    // What was previewed is often what was then done: nothing is left to change.
    std::vector<Edit> stale;
    stale.reserve(previewed_.size() + edits.size());
    const auto add = [&](glm::ivec3 voxel) {
        const std::uint8_t material = document.at(voxel);
        if (octree_.at(voxel) != material) stale.push_back({voxel, material});
    };
    for (const Edit& edit : previewed_) add(edit.voxel);
    for (const Edit& edit : edits) add(edit.voxel);
    previewed_.clear();
    filled_ = {};
    if (!octree_.apply(stale)) reset(document);
}

Status ShownOctree::preview(const LiveOctree& document, std::vector<Edit> edits) {
    endAnother();
    sortOnce(edits);
    if (Status shown = octree_.apply(difference(document, previewed_, edits)); !shown) {
        follow(document, {});
        return shown;
    }
    previewed_ = std::move(edits);
    filled_ = {};
    for (const Edit& edit : previewed_) {
        if (edit.material != 0) filled_ = filled_.united(IBox::around(edit.voxel, edit.voxel));
    }
    return {};
}

}  // namespace voxprite::editor
