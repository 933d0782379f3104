#include "app/editor/tools/select_tools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/editor/tools/edit_target.h"
#include "app/editor/tools/tool_marks.h"
#include "core/edit/regions.h"

namespace voxprite::editor {
namespace {

// Rays that look what is in sight; a large rectangle is looked at every few pixels.
constexpr double kMostRays = 250'000.0;
constexpr double kClickPx = 3.0;

struct Rectangle {
    glm::dvec2 min{0.0}, max{0.0};  // pixels of the view
};

// The half spaces around what the rectangle shows; `inModel` takes voxels to the camera's world.
std::array<HalfSpace, 4> sidesOf(const Rectangle& rectangle, const Camera& camera,
                                 const Placement& entityFromModel) {
    const std::array<glm::dvec2, 4> corners{rectangle.min,
                                            {rectangle.max.x, rectangle.min.y},
                                            rectangle.max,
                                            {rectangle.min.x, rectangle.max.y}};
    // Continuous space turns as directions do; so do normals.
    const SignedPermutation modelFromEntity = entityFromModel.rotation.inverse();
    const glm::dvec3 moved(entityFromModel.translation);
    const auto turned = [&](glm::dvec3 v) {
        glm::dvec3 result(0.0);
        for (std::size_t i = 0; i < 3; ++i) {
            result[static_cast<int>(i)] = modelFromEntity.sign[i] * v[modelFromEntity.axis[i]];
        }
        return result;
    };
    std::array<HalfSpace, 4> sides;
    for (std::size_t i = 0; i < 4; ++i) {
        const Camera::Ray a = camera.rayThrough(corners[i]);
        const Camera::Ray b = camera.rayThrough(corners[(i + 1) % 4]);
        const glm::dvec3 origin = voxelFromWorld(a.origin);
        // Along the rays, and from the one to the other.
        const glm::dvec3 across =
            voxelFromWorld(b.origin + b.direction) - voxelFromWorld(a.origin + a.direction);
        const glm::dvec3 inward = glm::cross(voxelFromWorld(a.direction), across);
        const glm::dvec3 normal = turned(inward);
        sides[i] = {normal, glm::dot(normal, turned(origin - moved))};
    }
    return sides;
}

// The solid voxels of the object that the rectangle's rays meet first.
VoxelSet inSight(const ToolContext& context, const EditTarget& target, const Rectangle& rectangle) {
    const Session& session = context.session;
    const glm::dvec2 size = rectangle.max - rectangle.min;
    const double step = std::max(1.0, std::sqrt(size.x * size.y / kMostRays));
    VoxelSet seen;
    for (double y = rectangle.min.y + 0.5; y < rectangle.max.y; y += step) {
        for (double x = rectangle.min.x + 0.5; x < rectangle.max.x; x += step) {
            const auto hit =
                pick(session.octree(), session.bounds(), context.camera.rayThrough({x, y}));
            if (hit && !hit->ground) seen.insert(target.toModel(hit->voxel));
        }
    }
    // What another object shows there is none of it.
    return stillSolid(target.voxels(session), std::move(seen));
}

Result<VoxelSet> regionUnder(const ToolContext& context, const EditTarget& target,
                             std::size_t maxBlocks) {
    return connectedRegion(target.voxels(context.session), target.toModel(context.pick->voxel),
                           context.settings.options.region(), maxBlocks);
}

}  // namespace

ToolResult SelectRectangleTool::update(const ToolContext& context) {
    ToolResult result;
    const ToolInput& input = context.input;
    endPx_ = input.pointerPx;
    if (input.pressed) start_ = Start{input.pointerPx, selectModeOf(input)};
    if (!start_ || !input.released) return result;
    const Start start = *start_;
    start_.reset();
    VoxelSelection& selection = context.session.selection();
    const Rectangle rectangle{glm::min(start.px, endPx_), glm::max(start.px, endPx_)};
    const glm::dvec2 size = rectangle.max - rectangle.min;
    if (std::max(size.x, size.y) <= kClickPx * static_cast<double>(context.scale)) {
        if (start.mode == SelectMode::replace) selection.clear();
        return result;
    }
    const bool goesOn = start.mode != SelectMode::replace && !selection.empty();
    const int node = goesOn ? selection.node() : context.session.activeNode();
    const Result<EditTarget> target = EditTarget::of(context.session, node);
    if (!target) {
        result.refusal = target.error().message;
        return result;
    }
    VoxelSet chosen =
        context.settings.options.inSight
            ? inSight(context, *target, rectangle)
            : selectInside(target->voxels(context.session),
                           sidesOf(rectangle, context.camera, target->modelFromEntity().inverse()));
    selection.select(target->node(), target->model(), std::move(chosen), start.mode);
    return result;
}

void SelectRectangleTool::draw(const ToolContext& /*context*/, const ViewDrawing& drawing,
                               const Theme& theme) const {
    if (!start_) return;
    const ImVec2 a = drawing.toWindow(start_->px), b = drawing.toWindow(endPx_);
    const ImVec2 min(std::min(a.x, b.x), std::min(a.y, b.y));
    const ImVec2 max(std::max(a.x, b.x), std::max(a.y, b.y));
    drawing.list().AddRectFilled(min, max, withAlpha(theme.accent, 0.12f));
    drawing.list().AddRect(min, max, withAlpha(theme.accent, 0.95f), 0.0f, 0, theme.px(1.5f));
}

ToolResult WandTool::update(const ToolContext& context) {
    ToolResult result;
    const SelectMode mode = selectModeOf(context.input);
    VoxelSelection& selection = context.session.selection();
    const bool onVoxel = context.pick && !context.pick->ground;
    if (context.input.pressed && !onVoxel) {
        if (mode == SelectMode::replace) selection.clear();
        return result;
    }
    look(context);
    if (!context.input.pressed) return result;
    const Result<EditTarget> target =
        EditTarget::at(context.session, EditMode::paint, *context.pick);
    if (!target) {
        result.refusal = target.error().message;
        return result;
    }
    Result<VoxelSet> region = regionUnder(context, *target, kMaxRegionBlocks);
    if (!region) {
        result.refusal = region.error().message;
        return result;
    }
    context.session.setActiveNode(target->node());
    selection.select(target->node(), target->model(), std::move(*region), mode);
    return result;
}

bool WandTool::isStillOn(const Session& session, const Aim& aim) const {
    if (!shown_ || !aim.pick || aim.pick->ground || !aim_->differsInPickAlone(aim)) return false;
    return session.nodeAt(aim.pick->voxel) == shown_->node &&
           shown_->voxels.contains(shown_->modelFromEntity.applyToVoxel(aim.pick->voxel));
}

void WandTool::look(const ToolContext& context) {
    const Aim aim = context.aim();
    if (aim_ == aim) return;
    const bool same = isStillOn(context.session, aim);
    aim_ = aim;
    if (same) return;
    shown_.reset();
    if (!aim.pick || aim.pick->ground) return;
    const Result<EditTarget> target = EditTarget::at(context.session, EditMode::paint, *aim.pick);
    if (!target) return;
    Result<VoxelSet> region = regionUnder(context, *target, kQuickRegionBlocks);
    if (!region) return;
    const IBox box = target->modelFromEntity().inverse().applyToBox(region->bounds());
    shown_ = Shown{target->node(), target->modelFromEntity(), std::move(*region), box};
}

void WandTool::draw(const ToolContext& context, const ViewDrawing& drawing,
                    const Theme& theme) const {
    if (!context.pick || context.pick->ground) return;
    markFace(drawing, theme, *context.pick, EditMode::paint);
    if (shown_) drawing.box(shown_->box, withAlpha(theme.accent, 0.8f), theme.px(1.5f));
}

}  // namespace voxprite::editor
