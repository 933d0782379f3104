#include "app/editor/stroke.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/edit/make_action.h"

namespace voxprite::editor {
namespace {

// A ray that grazes the face's plane would reach for the horizon.
constexpr int kMaxBoxEdge = 1024;

const char* nameOf(EditMode mode) {
    switch (mode) {
        case EditMode::attach:
            return "Attach";
        case EditMode::erase:
            return "Erase";
        case EditMode::paint:
            return "Paint";
    }
    return "";
}

std::string objectName(const Document& document, int node) {
    const std::string& name = document.nodes[static_cast<std::size_t>(node)].name;
    return name.empty() ? "The object" : "\"" + name + "\"";
}

}  // namespace

Stroke::Stroke(const Session& session, const Brush& brush, const Pick& start, Instance target)
    : brush_(brush),
      start_(start),
      target_(target),
      octree_(session.octree()),
      bounds_(session.bounds()),
      corner_(cellOf(start)) {}

Result<Stroke> Stroke::begin(Session& session, const Brush& brush, const Pick& start) {
    if (brush.mode != EditMode::attach) {
        if (start.ground) return fail("There is no voxel here");
        session.setActiveNode(session.nodeAt(start.voxel));
    }
    const int node = session.activeNode();
    if (node < 0) return fail("There is no object to edit: add one first");
    if (session.document().nodes[static_cast<std::size_t>(node)].locked) {
        return fail(objectName(session.document(), node) + " is locked");
    }
    const std::optional<Instance> target = session.activeInstance();
    if (!target) return fail(objectName(session.document(), node) + " is hidden");
    Stroke stroke(session, brush, start, *target);
    stroke.mergeKey_ = session.newMergeKey();
    return stroke;
}

glm::ivec3 Stroke::cellOf(const Pick& pick) const {
    return brush_.mode == EditMode::attach ? pick.attachTo() : pick.voxel;
}

Action Stroke::actionOf(VoxelPatch patch) const {
    return makeAction(nameOf(brush_.mode), std::move(patch), mergeKey_);
}

void Stroke::stretchBox(const Camera::Ray& ray) {
    const int axis = start_.axis();
    const auto hit = meetPlane(ray, axis, start_.facePlane());
    if (!hit) return;
    const glm::ivec3 anchor = cellOf(start_);
    for (const int other : {(axis + 1) % 3, (axis + 2) % 3}) {
        const double cell = std::floor((*hit)[other]);
        corner_[other] =
            static_cast<int>(std::clamp(cell, static_cast<double>(anchor[other] - kMaxBoxEdge),
                                        static_cast<double>(anchor[other] + kMaxBoxEdge)));
    }
}

std::optional<glm::ivec3> Stroke::target(const Session& session, const Camera::Ray& ray) const {
    const auto found = pick(octree_, bounds_, ray);
    if (!found) return std::nullopt;
    if (brush_.mode != EditMode::attach) {
        // Where another object covers this one, or nothing is left, there is nothing to do.
        if (found->ground || session.nodeAt(found->voxel) != target_.node) return std::nullopt;
    }
    return target_.entityFromModel.inverse().applyToVoxel(cellOf(*found));
}

std::optional<Action> Stroke::drag(const Session& session, const Camera& camera,
                                   std::span<const glm::dvec2> pathPx) {
    if (pathPx.empty()) return std::nullopt;
    if (brush_.shape == BrushShape::box) {
        stretchBox(camera.rayThrough(pathPx.back()));
        return std::nullopt;
    }
    std::vector<glm::ivec3> positions;
    const auto sample = [&](glm::dvec2 atPx) {
        const auto position = target(session, camera.rayThrough(atPx));
        if (!position || (!positions.empty() && positions.back() == *position)) return;
        positions.push_back(*position);
    };
    sample(pathPx.front());
    for (std::size_t i = 1; i < pathPx.size(); ++i) {
        const glm::dvec2 step = pathPx[i] - pathPx[i - 1];
        const int samples = std::max(1, static_cast<int>(std::ceil(glm::length(step))));
        for (int s = 1; s <= samples; ++s) sample(pathPx[i - 1] + step * (double(s) / samples));
    }
    VoxelPatch patch =
        patchVoxels(session.document(), target_.model, positions, brush_.mode, brush_.colour);
    if (patch.changes.empty()) return std::nullopt;
    return actionOf(std::move(patch));
}

void Stroke::deepen(int layers) {
    depth_ = std::clamp(depth_ + layers, 1, kMaxBoxEdge);
}

std::optional<IBox> Stroke::box() const {
    if (brush_.shape != BrushShape::box) return std::nullopt;
    const int axis = start_.axis();
    const int outward = brush_.mode == EditMode::attach ? 1 : -1;
    glm::ivec3 far = corner_;
    far[axis] += start_.normal[axis] * outward * (depth_ - 1);
    return IBox::around(cellOf(start_), far);
}

std::optional<Action> Stroke::finish(const Session& session) const {
    const std::optional<IBox> area = box();
    if (!area) return std::nullopt;
    const IBox inModel = target_.entityFromModel.inverse().applyToBox(*area);
    VoxelPatch patch =
        patchBox(session.document(), target_.model, inModel, brush_.mode, brush_.colour);
    if (patch.changes.empty()) return std::nullopt;
    return actionOf(std::move(patch));
}

}  // namespace voxprite::editor
