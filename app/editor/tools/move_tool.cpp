#include "app/editor/tools/move_tool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>

#include "app/editor/session/selection_edits.h"
#include "app/editor/tools/guides.h"
#include "app/editor/tools/tool_marks.h"
#include "app/editor/window/imgui_names.h"

namespace voxprite::editor {
namespace {

constexpr double kArrowPx = 84.0;

glm::dvec3 middleOf(const IBox& box) {
    return (glm::dvec3(box.min) + glm::dvec3(box.max)) * 0.5;
}

// The face of the box that the ray meets, as if it were a voxel's.
std::optional<Pick> pickBox(const IBox& box, const Camera::Ray& ray) {
    const glm::dvec3 eye = voxelFromWorld(ray.origin);
    const glm::dvec3 direction = voxelFromWorld(ray.direction);
    for (int axis = 0; axis < 3; ++axis) {
        const bool down = direction[axis] < 0.0;
        const int plane = down ? box.max[axis] : box.min[axis];
        if (down ? eye[axis] < plane : eye[axis] > plane) continue;
        const auto at = meetPlane(ray, axis, plane);
        if (!at) continue;
        glm::ivec3 voxel(glm::floor(*at));
        voxel[axis] = down ? plane - 1 : plane;
        if (!box.contains(voxel)) continue;
        Pick pick{voxel, glm::ivec3(0)};
        pick.normal[axis] = down ? 1 : -1;
        return pick;
    }
    return std::nullopt;
}

void drawArrow(const ViewDrawing& drawing, const Theme& theme, glm::dvec3 from, glm::dvec3 to,
               ImU32 colour, bool hot) {
    const auto a = drawing.project(worldFromVoxel(from)), b = drawing.project(worldFromVoxel(to));
    if (!a || !b) return;
    const ImVec2 d(b->x - a->x, b->y - a->y);
    const float length = std::hypot(d.x, d.y);
    if (length < theme.px(4)) return;
    const ImVec2 along(d.x / length, d.y / length), across(-along.y, along.x);
    const float head = theme.px(hot ? 14 : 12), half = theme.px(hot ? 7 : 6);
    const ImVec2 neck(b->x - along.x * head, b->y - along.y * head);
    drawing.list().AddLine(*a, neck, IM_COL32(16, 17, 19, 160), theme.px(hot ? 5.5f : 4.5f));
    drawing.list().AddLine(*a, neck, colour, theme.px(hot ? 3.5f : 2.5f));
    drawing.list().AddTriangleFilled(*b, {neck.x + across.x * half, neck.y + across.y * half},
                                     {neck.x - across.x * half, neck.y - across.y * half}, colour);
}

}  // namespace

ToolResult MoveTool::update(const ToolContext& context) {
    ToolResult result;
    VoxelSelection& selection = context.session.selection();
    const ToolInput& input = context.input;
    if (floats_ && !selection.floating() && kind_ != Floating::Kind::move) {
        // What it was taken for is done.
        context.settings.tool = context.settings.before;
    }
    if (typed_ && selection.floating()) {
        selection.changeFloating(
            [index = typed_->first, value = typed_->second](Floating& floating) {
                if (floating.kind != Floating::Kind::move || index == 3) {
                    floating.amount = std::clamp(value, 1, Floating::greatestAmount(floating.kind));
                } else {
                    glm::ivec3 to = floating.bounds().min;
                    to[static_cast<int>(index)] = floating.home[static_cast<int>(index)] + value;
                    floating.moveTo(to);
                }
            });
    }
    typed_.reset();
    hot_ = -1;
    if (drag_) {
        if (!drag_->plane) hot_ = drag_->axis;
        drag(context);
        if (input.released) drag_.reset();
    } else if (input.hovered && !box_.empty() && (!floats_ || kind_ == Floating::Kind::move)) {
        hot_ = handleAt(arrows(context.camera, context.scale), context.camera, input.pointerPx,
                        context.scale * 1.4f);
    }
    if (input.pressed) press(context, result);
    if (!result.action) look(context, result);
    return result;
}

bool MoveTool::holds(const Session& session, glm::ivec3 entityVoxel) const {
    if (floats_) return floating_.get(entityVoxel) != 0;
    const Result<Chosen> chosen = chosenVoxels(session);
    return chosen &&
           chosen->voxels.contains(chosen->entityFromModel.inverse().applyToVoxel(entityVoxel));
}

void MoveTool::press(const ToolContext& context, ToolResult& result) {
    Session& session = context.session;
    const Camera::Ray ray = context.camera.rayThrough(context.input.pointerPx);
    Drag drag;
    if (hot_ >= 0) {
        const glm::dvec3 middle = middleOf(box_);
        const auto at = alongAxis(ray, middle, hot_);
        if (!at) return;
        drag.axis = hot_;
        drag.grabbed = middle;
        drag.grabbed[hot_] = *at;
    } else {
        // What is seen, and not what lies in the document under it.
        const auto hit = floats_ && floating_.empty()
                             ? pickBox(box_, ray)
                             : pick(session.shownOctree(), session.shownBounds(), ray);
        const bool onBox = hit && floats_ && floating_.empty();
        if (!hit || hit->ground || (!onBox && !holds(session, hit->voxel))) {
            if (floats_) result.action = confirm(session);
            return;
        }
        drag.axis = hit->axis();
        drag.plane = true;
        drag.facePlane = hit->facePlane();
        const auto at = meetPlane(ray, drag.axis, drag.facePlane);
        if (!at) return;
        drag.grabbed = *at;
    }
    if (!floats_) {
        const Status lifted = lift(session, context.settings, Floating::Kind::move);
        if (!lifted) {
            result.refusal = lifted.error().message;
            return;
        }
    }
    const auto& floating = session.selection().floating();
    if (!floating || floating->kind != Floating::Kind::move) return;
    drag.min = floating->bounds().min;
    drag_ = drag;
}

void MoveTool::drag(const ToolContext& context) {
    const Camera::Ray ray = context.camera.rayThrough(context.input.pointerPx);
    glm::dvec3 by(0.0);
    if (drag_->plane) {
        const auto at = meetPlane(ray, drag_->axis, drag_->facePlane);
        if (!at) return;
        by = *at - drag_->grabbed;
        by[drag_->axis] = 0.0;
    } else {
        const auto at = alongAxis(ray, drag_->grabbed, drag_->axis);
        if (!at) return;
        by[drag_->axis] = *at - drag_->grabbed[drag_->axis];
    }
    const double reach = kMaxCoordinate;
    const glm::ivec3 to =
        drag_->min + glm::ivec3(glm::round(glm::clamp(by, glm::dvec3(-reach), glm::dvec3(reach))));
    VoxelSelection& selection = context.session.selection();
    if (!selection.floating() || selection.floating()->bounds().min == to) return;
    selection.changeFloating([&](Floating& floating) { floating.moveTo(to); });
}

void MoveTool::look(const ToolContext& context, ToolResult& result) {
    const Session& session = context.session;
    const auto& floating = session.selection().floating();
    const Seen now{session.selection().revision(), session.revision(), session.activeNode()};
    if (seen_ == now) return;
    seen_ = now;
    floats_ = floating.has_value();
    result.preview.emplace();
    box_ = {};
    if (!floating) {
        floating_.clear();
        if (const Result<Chosen> chosen = chosenVoxels(session)) {
            box_ = chosen->entityFromModel.applyToBox(chosen->voxels.bounds());
        }
        return;
    }
    kind_ = floating->kind;
    amount_ = floating->amount;
    box_ = floating->bounds();
    moved_ = box_.min - floating->home;
    if (floating->isLarge()) {
        // Outlined at once; to show it in place on every move would make the pointer stick.
        floating_.clear();
        result.largePreview = [](const Session& shown) -> MakePatches {
            const auto inAir = std::make_shared<const Floating>(*shown.selection().floating());
            return [inAir](const Document& document) { return onePatch(inAir->patch(document)); };
        };
        return;
    }
    const Result<VoxelClip> made = floating->made();
    Result<VoxelPatch> patch = floating->patch(session.document());
    if (!made || !patch) {
        result.refusal = made ? patch.error().message : made.error().message;
        return;
    }
    floating_ = made->placed();
    result.preview->push_back(std::move(*patch));
}

std::optional<Action> MoveTool::confirm(Session& session) {
    drag_.reset();
    Result<std::optional<Action>> action = putDown(session);
    if (action) return std::move(*action);
    // It cannot lie there: it goes back to where it was.
    session.selection().setFloating(std::nullopt);
    return std::nullopt;
}

void MoveTool::cancel() {
    drag_.reset();
    typed_.reset();
    seen_.reset();
}

std::array<Handle, 3> MoveTool::arrows(const Camera& camera, float scale) const {
    const glm::dvec3 middle = middleOf(box_);
    const double depth = std::max(camera.project(worldFromVoxel(middle)).depthMetres, 1e-3);
    const double length = camera.metresPerScreenPx(depth) * kArrowPx * static_cast<double>(scale);
    std::array<Handle, 3> handles{};
    for (int axis = 0; axis < 3; ++axis) {
        Handle& handle = handles[static_cast<std::size_t>(axis)];
        handle = {middle, axis};
        handle.at[axis] += length;
    }
    return handles;
}

std::vector<ToolFigure> MoveTool::figures() const {
    if (!floats_) return {};
    const int most = Floating::greatestAmount(kind_);
    switch (kind_) {
        case Floating::Kind::move:
            return {{"X", moved_.x, -kMaxCoordinate, kMaxCoordinate},
                    {"Y", moved_.y, -kMaxCoordinate, kMaxCoordinate},
                    {"Z", moved_.z, -kMaxCoordinate, kMaxCoordinate},
                    {"Scale", amount_, 1, most}};
        case Floating::Kind::hollow:
            return {{"Wall", amount_, 1, most}};
        case Floating::Kind::smooth:
            return {{"Passes", amount_, 1, most}};
        default:
            return {{"Layers", amount_, 1, most}};
    }
}

std::string MoveTool::sizeText() const {
    return floats_ ? editor::sizeText(box_.size()) : std::string();
}

void MoveTool::draw(const ToolContext& context, const ViewDrawing& drawing,
                    const Theme& theme) const {
    if (box_.empty() || (floats_ && kind_ != Floating::Kind::move)) return;
    drawing.box(box_, withAlpha(theme.accent, floats_ ? 0.95f : 0.5f), theme.px(1.5f));
    const auto handles = arrows(context.camera, context.scale);
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        drawArrow(drawing, theme, middleOf(box_), handles[i].at, toImU32(kAxisColours[i]),
                  hot_ == axis);
    }
    if (floats_) markSize(drawing, theme, box_);
}

}  // namespace voxprite::editor
