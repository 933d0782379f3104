#include <algorithm>
#include <cmath>

#include "app/editor/tools/edit_target.h"
#include "app/editor/tools/select_tools.h"
#include "app/editor/tools/tool_marks.h"

namespace voxprite::editor {

SelectMode selectModeOf(const ToolInput& input) {
    if (!input.shift) return SelectMode::replace;
    return input.alt ? SelectMode::remove : SelectMode::add;
}

ToolResult SelectBoxTool::update(const ToolContext& context) {
    ToolResult result;
    const ToolInput& input = context.input;
    VoxelSelection& selection = context.session.selection();
    if (box_ && !holds(context.session)) box_.reset();
    hot_ = -1;
    // With Shift another box is meant, even where a handle is.
    if (box_ && box_->handle == kSettled && input.hovered && !input.shift) {
        const std::vector<Handle> all = handles();
        hot_ = handleAt(all, context.camera, input.pointerPx, context.scale);
    }
    if (input.pressed) {
        if (hot_ >= 0) {
            box_->handle = hot_;
        } else {
            begin(context, result);
        }
    } else if (box_ && box_->handle >= 0) {
        hot_ = box_->handle;
        dragHandle(context);
    } else if (box_ && box_->handle == kSpanning && context.pick) {
        box_->box = IBox::around(box_->first, context.pick->voxel);
    }
    if (box_) {
        const bool clicked = box_->box == IBox::around(box_->first, box_->first);
        if (input.released && box_->onGround && clicked) {
            if (box_->mode == SelectMode::replace) selection.clear();
            box_.reset();
            return result;
        }
        if (input.released) box_->handle = kSettled;
        if (box_->selected != box_->box) select(context.session);
    }
    return result;
}

// Something else selected meanwhile, or the object gone or elsewhere: the box is history.
bool SelectBoxTool::holds(const Session& session) const {
    if (session.selection().revision() != box_->revision) return false;
    const Result<EditTarget> target = EditTarget::of(session, box_->node);
    return target && target->model() == box_->model &&
           target->modelFromEntity() == box_->modelFromEntity;
}

void SelectBoxTool::begin(const ToolContext& context, ToolResult& result) {
    box_.reset();
    VoxelSelection& selection = context.session.selection();
    const SelectMode mode = selectModeOf(context.input);
    if (!context.pick) {
        if (mode == SelectMode::replace) selection.clear();
        return;
    }
    const Pick& pick = *context.pick;
    const Result<EditTarget> target =
        EditTarget::at(context.session, pick.ground ? EditMode::attach : EditMode::paint, pick);
    if (!target) {
        result.refusal = target.error().message;
        return;
    }
    context.session.setActiveNode(target->node());
    box_ = Spanned();
    box_->node = target->node();
    box_->model = target->model();
    box_->modelFromEntity = target->modelFromEntity();
    box_->onGround = pick.ground;
    box_->first = pick.ground ? pick.attachTo() : pick.voxel;
    box_->box = IBox::around(box_->first, box_->first);
    box_->mode = mode;
    if (selection.node() == box_->node && selection.model() == box_->model) {
        box_->before = selection.voxels();
    }
    box_->revision = selection.revision();
}

void SelectBoxTool::dragHandle(const ToolContext& context) {
    const std::vector<Handle> all = handles();
    const Handle& handle = all[static_cast<std::size_t>(box_->handle)];
    const auto at =
        alongAxis(context.camera.rayThrough(context.input.pointerPx), handle.at, handle.axis);
    if (!at) return;
    const double reach = kMaxCoordinate;
    const int plane = static_cast<int>(std::lround(std::clamp(*at, -reach, reach)));
    const int axis = handle.axis;
    if (box_->handle % 2 == 0) {
        box_->box.min[axis] = std::min(plane, box_->box.max[axis] - 1);
    } else {
        box_->box.max[axis] = std::max(plane, box_->box.min[axis] + 1);
    }
}

void SelectBoxTool::select(Session& session) {
    const auto& voxels = session.document().models[static_cast<std::size_t>(box_->model)].voxels;
    const VoxelSet inside = selectBox(voxels, box_->modelFromEntity.applyToBox(box_->box));
    session.selection().select(box_->node, box_->model, combined(box_->before, inside, box_->mode));
    box_->selected = box_->box;
    box_->revision = session.selection().revision();
}

std::optional<Action> SelectBoxTool::confirm(Session& /*session*/) {
    if (box_) box_->handle = kSettled;
    return std::nullopt;
}

// In the middle of each face: -x, +x, -y and so on.
std::vector<Handle> SelectBoxTool::handles() const {
    std::vector<Handle> all;
    const glm::dvec3 min(box_->box.min), max(box_->box.max);
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {min[axis], max[axis]}) {
            glm::dvec3 at = (min + max) * 0.5;
            at[axis] = side;
            all.push_back({at, axis});
        }
    }
    return all;
}

std::vector<ToolFigure> SelectBoxTool::figures() const {
    if (!box_) return {};
    const glm::ivec3 size = box_->box.size();
    const int greatest = 2 * kMaxCoordinate;
    return {{"Width", size.x, 1, greatest},
            {"Depth", size.y, 1, greatest},
            {"Height", size.z, 1, greatest}};
}

void SelectBoxTool::setFigure(std::size_t index, int value) {
    if (!box_) return;
    const int axis = static_cast<int>(index);
    box_->box.max[axis] = std::min(box_->box.min[axis] + std::max(value, 1), kMaxCoordinate + 1);
}

std::string SelectBoxTool::sizeText() const {
    return box_ ? editor::sizeText(box_->box.size()) : std::string();
}

void SelectBoxTool::draw(const ToolContext& context, const ViewDrawing& drawing,
                         const Theme& theme) const {
    if (!box_) {
        if (context.pick && !context.pick->ground) {
            markFace(drawing, theme, *context.pick, EditMode::paint);
        }
        return;
    }
    drawing.box(box_->box, withAlpha(theme.accent, 0.9f), theme.px(1.5f));
    markSize(drawing, theme, box_->box);
    if (box_->handle != kSpanning) drawHandles(handles(), hot_, drawing, theme);
}

}  // namespace voxprite::editor
