#include "app/editor/tools/brush_path.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>

namespace voxprite::editor {
namespace {

// Do two voxels hit one after another lie on one surface, so that the brush was drawn between them?
// Where they do not, the pointer jumped over an edge to something behind it.
bool joined(const Pick& a, const Pick& b) {
    if (a.normal == b.normal && a.facePlane() == b.facePlane()) return true;
    const glm::ivec3 step = b.voxel - a.voxel;
    return std::max({std::abs(step.x), std::abs(step.y), std::abs(step.z)}) <= 1 &&
           a.normal == b.normal;
}

}  // namespace

void alongPath(std::span<const glm::dvec2> pathPx,
               const std::function<void(glm::dvec2 px)>& visit) {
    if (pathPx.empty()) return;
    visit(pathPx.front());
    for (std::size_t i = 1; i < pathPx.size(); ++i) {
        const glm::dvec2 way = pathPx[i] - pathPx[i - 1];
        const int steps = static_cast<int>(std::ceil(glm::length(way)));
        for (int s = 1; s <= steps; ++s) visit(pathPx[i - 1] + way * (double(s) / steps));
    }
}

BrushTip tipOn(const Pick& pick, const ToolOptions& options) {
    return {options.tip, options.tipEdge, pick.axis()};
}

glm::ivec3 tipPlace(const BrushTip& tip, const Pick& pick, EditMode mode) {
    glm::ivec3 place = mode == EditMode::attach ? pick.attachTo() : pick.voxel;
    if (tip.shape != TipShape::cube || mode == EditMode::paint) return place;
    const int axis = pick.axis();
    const IBox box = tipBox(tip, place);
    const int away = mode == EditMode::attach ? pick.normal[axis] : -pick.normal[axis];
    place[axis] += away > 0 ? place[axis] - box.min[axis] : place[axis] - (box.max[axis] - 1);
    return place;
}

std::vector<glm::ivec3> BrushPath::extend(const Session& session, const Camera& camera,
                                          std::span<const glm::dvec2> pathPx) {
    std::vector<glm::ivec3> fresh;
    alongPath(pathPx, [&](glm::dvec2 px) {
        const auto found = pick(session.octree(), session.bounds(), camera.rayThrough(px));
        if (found && last_ == found) return;
        // Where another object covers this one, or nothing is left, there is nothing to do.
        const bool misses =
            !found || (mode_ != EditMode::attach &&
                       (found->ground || session.nodeAt(found->voxel) != target_.node()));
        if (misses) {
            last_.reset();
        } else {
            step(session, *found, fresh);
        }
    });
    return fresh;
}

void BrushPath::step(const Session& session, const Pick& pick, std::vector<glm::ivec3>& fresh) {
    const BrushTip tip = tipOn(pick, options_);
    auto& trail = trails_[static_cast<std::size_t>(pick.axis())];
    if (!trail) trail.emplace(tip);
    const bool draws = last_ && joined(*last_, pick);
    const glm::ivec3 place = tipPlace(tip, pick, mode_);
    std::vector<glm::ivec3> reached = draws ? trail->lineTo(place) : trail->startAt(place);
    last_ = pick;
    if (mode_ == EditMode::attach && pick.ground) {
        // The ground is firm.
        const int floor = session.bounds().empty() ? 0 : session.bounds().min.z;
        std::erase_if(reached, [&](glm::ivec3 v) { return v.z < floor; });
    }
    for (glm::ivec3& voxel : reached) voxel = target_.toModel(voxel);
    fresh.insert(fresh.end(), reached.begin(), reached.end());
}

}  // namespace voxprite::editor
