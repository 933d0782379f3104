#include "app/editor/tools/shape_tool.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "app/editor/tools/tool_marks.h"
#include "core/edit/make_action.h"
#include "core/edit/shapes.h"
#include "core/edit/transforms.h"

namespace voxprite::editor {
namespace {

glm::ivec3 cellOf(const Pick& pick, EditMode mode) {
    return mode == EditMode::attach ? pick.attachTo() : pick.voxel;
}

int edgeOf(int first, int last) {
    return std::abs(last - first) + 1;
}

// A ray that grazes the face's plane would reach for the horizon.
int clampedCell(double at, int first) {
    const double reach = kMaxShapeEdge - 1;
    return static_cast<int>(std::clamp(std::floor(at), first - reach, first + reach));
}

}  // namespace

const char* ShapeTool::noun() const {
    switch (kind_) {
        case ToolKind::line:
            return "line";
        case ToolKind::sphere:
            return "sphere";
        case ToolKind::ellipse:
            return "ellipsoid";
        case ToolKind::cylinder:
            return "cylinder";
        default:
            return "box";
    }
}

ToolResult ShapeTool::update(const ToolContext& context) {
    ToolResult result;
    const ToolInput& input = context.input;
    hot_ = -1;
    if (shape_ && !shape_->spanning) {
        const auto all = handles();
        if (shape_->handle < 0 && input.hovered) {
            hot_ = handleAt(all, context.camera, input.pointerPx, context.scale);
        }
        if (input.pressed && hot_ >= 0) {
            shape_->handle = hot_;
        } else if (input.pressed) {
            result.action = confirm(context.session);
            startsNext_ = true;
            return result;
        }
    }
    const bool begins = input.pressed || startsNext_;
    if (!shape_ && begins && context.pick) begin(context, *context.pick, result);
    startsNext_ = false;
    if (!shape_) {
        showHover(context, result);
        return result;
    }
    if (shape_->spanning) {
        if (!input.pressed && !input.pathPx.empty()) span(context);
        if (input.wheel != 0.0) deepen(input.wheel > 0.0 ? 1 : -1);
        if (!input.held) shape_->spanning = false;
    } else if (shape_->handle >= 0) {
        hot_ = shape_->handle;
        dragHandle(context);
        if (!input.held) shape_->handle = -1;
    }
    make(context, result);
    return result;
}

void ShapeTool::begin(const ToolContext& context, const Pick& pick, ToolResult& result) {
    const EditMode mode = context.mode();
    const Result<EditTarget> target = EditTarget::at(context.session, mode, pick);
    if (!target) {
        result.refusal = target.error().message;
        return;
    }
    context.session.setActiveNode(target->node());
    shape_ = Pending();
    shape_->target = *target;
    shape_->mode = mode;
    shape_->chosenMode = context.settings.mode;
    shape_->start = pick;
    shape_->first = shape_->last = cellOf(pick, mode);
    const int axis = pick.axis();
    shape_->grows[axis] = mode == EditMode::attach ? pick.normal[axis] : -pick.normal[axis];
    hovered_.reset();
    made_.reset();
}

void ShapeTool::span(const ToolContext& context) {
    if (kind_ == ToolKind::line) return spanLine(context);
    const int axis = shape_->start.axis();
    const auto hit = meetPlane(context.camera.rayThrough(context.input.pointerPx), axis,
                               shape_->start.facePlane());
    if (!hit) return;
    int longest = 1, shortest = kMaxShapeEdge;
    for (const int other : {(axis + 1) % 3, (axis + 2) % 3}) {
        shape_->last[other] = clampedCell((*hit)[other], shape_->first[other]);
        shape_->grows[other] = shape_->last[other] < shape_->first[other] ? -1 : 1;
        const int edge = edgeOf(shape_->first[other], shape_->last[other]);
        longest = std::max(longest, edge);
        shortest = std::min(shortest, edge);
    }
    if (kind_ == ToolKind::sphere) {
        makeRegular(longest);
    } else if (kind_ == ToolKind::ellipse && !shape_->deepened) {
        resize(axis, shortest);
    }
}

void ShapeTool::spanLine(const ToolContext& context) {
    const Camera::Ray ray = context.camera.rayThrough(context.input.pointerPx);
    if (context.pick) {
        shape_->last = cellOf(*context.pick, shape_->mode);
        return;
    }
    const int axis = shape_->start.axis();
    const auto hit = meetPlane(ray, axis, shape_->start.facePlane());
    if (!hit) return;
    shape_->last[axis] = shape_->first[axis];
    for (const int other : {(axis + 1) % 3, (axis + 2) % 3}) {
        shape_->last[other] = clampedCell((*hit)[other], shape_->first[other]);
    }
}

void ShapeTool::deepen(int layers) {
    if (kind_ == ToolKind::line || kind_ == ToolKind::sphere) return;
    const int axis = shape_->start.axis();
    shape_->deepened = true;
    resize(axis, edgeOf(shape_->first[axis], shape_->last[axis]) + layers);
}

void ShapeTool::resize(int axis, int edge) {
    edge = std::clamp(edge, 1, kMaxShapeEdge);
    if (kind_ == ToolKind::sphere) return makeRegular(edge);
    shape_->last[axis] = shape_->first[axis] + shape_->grows[axis] * (edge - 1);
}

void ShapeTool::makeRegular(int edge) {
    shape_->last = shape_->first + shape_->grows * (std::clamp(edge, 1, kMaxShapeEdge) - 1);
}

void ShapeTool::dragHandle(const ToolContext& context) {
    const Camera::Ray ray = context.camera.rayThrough(context.input.pointerPx);
    if (kind_ == ToolKind::line) {
        // An end goes where the pointer is on the model; in the open it keeps its height.
        glm::ivec3& end = shape_->handle == 0 ? shape_->first : shape_->last;
        if (context.pick) {
            end = cellOf(*context.pick, shape_->mode);
        } else if (const auto hit = meetPlane(ray, 2, end.z)) {
            end.x = clampedCell(hit->x, end.x);
            end.y = clampedCell(hit->y, end.y);
        }
        return;
    }
    const Handle handle = handles()[static_cast<std::size_t>(shape_->handle)];
    const auto at = alongAxis(ray, handle.at, handle.axis);
    if (!at) return;
    // Handles 0 ... 2 move the low side of an axis, 3 ... 5 the high one; the other side stays.
    const int axis = handle.axis;
    const IBox box = shape_->box();
    const bool high = shape_->handle >= 3;
    const int side = static_cast<int>(std::round(std::clamp(
        *at, box.min[axis] - double(kMaxShapeEdge), box.max[axis] + double(kMaxShapeEdge))));
    const int edge = std::max(1, high ? side - box.min[axis] : box.max[axis] - side);
    if ((shape_->grows[axis] > 0) != high) {
        std::swap(shape_->first[axis], shape_->last[axis]);
        shape_->grows[axis] = high ? 1 : -1;
    }
    resize(axis, edge);
}

std::vector<Handle> ShapeTool::handles() const {
    if (kind_ == ToolKind::line) {
        return {{glm::dvec3(shape_->first) + 0.5, 2}, {glm::dvec3(shape_->last) + 0.5, 2}};
    }
    const IBox box = shape_->box();
    const glm::dvec3 middle = glm::dvec3(box.min + box.max) * 0.5;
    std::vector<Handle> handles;
    for (const glm::ivec3 side : {box.min, box.max}) {
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 at = middle;
            at[axis] = side[axis];
            handles.push_back({at, axis});
        }
    }
    return handles;
}

EditTarget::FindVoxels ShapeTool::voxels(const ToolOptions& options) const {
    const EditTarget& target = shape_->target;
    if (kind_ == ToolKind::line) {
        // An even tip is not its own mirror image: drawn where the artist sees it, then turned.
        const BrushTip tip{options.tip, options.tipEdge, shape_->start.axis()};
        return [tip, first = shape_->first, last = shape_->last,
                modelFromEntity = target.modelFromEntity()](const VoxelGrid&) -> Result<VoxelSet> {
            Result<VoxelSet> line = lineVoxels(tip, first, last);
            if (!line) return line;
            return transformed(*line, modelFromEntity);
        };
    }
    Shape shape;
    shape.kind = kind_ == ToolKind::box        ? ShapeKind::box
                 : kind_ == ToolKind::cylinder ? ShapeKind::cylinder
                                               : ShapeKind::ellipsoid;
    shape.box = target.modelFromEntity().applyToBox(shape_->box());
    shape.axis = target.axisToModel(shape_->start.axis());
    shape.hollow = options.hollow;
    return [shape](const VoxelGrid&) { return shapeVoxels(shape); };
}

bool ShapeTool::isLarge() const {
    const glm::ivec3 size = shape_->box().size();
    const auto voxels = static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y) *
                        static_cast<std::uint64_t>(size.z);
    return kind_ != ToolKind::line && voxels > kLongStepVoxels;
}

void ShapeTool::make(const ToolContext& context, ToolResult& result) {
    if (context.settings.mode != shape_->chosenMode) {
        shape_->mode = shape_->chosenMode = context.settings.mode;
    }
    const Made now{shape_->first, shape_->last, shape_->mode, context.settings,
                   context.session.revision()};
    if (made_ == now) return;
    made_ = now;
    patch_ = {shape_->target.model(), {}};
    later_ = shape_->target.later(context.session, voxels(context.settings.options), shape_->mode,
                                  context.settings);
    result.preview.emplace();
    if (isLarge()) {
        result.largePreview = [make = later_](const Session&) { return make; };
        return;
    }
    Result<std::vector<VoxelPatch>> made = std::exchange(later_, {})(context.session.document());
    if (!made) {
        result.refusal = made.error().message;
        return;
    }
    patch_ = std::move(made->front());
    result.preview->push_back(patch_);
}

void ShapeTool::showHover(const ToolContext& context, ToolResult& result) {
    const Aim aim = context.aim();
    if (hovered_ == aim) return;
    hovered_ = aim;
    result.preview.emplace();
    if (!aim.pick) return;
    const Result<EditTarget> target = EditTarget::at(context.session, aim.mode, *aim.pick);
    if (!target) return;
    const glm::ivec3 voxel = target->toModel(cellOf(*aim.pick, aim.mode));
    result.preview->push_back(
        target->patch(context.session, {&voxel, 1}, aim.mode, context.settings));
}

std::optional<Action> ShapeTool::confirm(Session& /*session*/) {
    if (!shape_) return std::nullopt;
    std::optional<Action> action;
    if (later_) {
        action = makeActionLater(labelOf(shape_->mode, noun()), std::move(later_));
    } else if (!patch_.changes.empty()) {
        action = makeAction(labelOf(shape_->mode, noun()), std::move(patch_));
    }
    cancel();
    return action;
}

void ShapeTool::cancel() {
    shape_.reset();
    patch_ = {};
    later_ = {};
    made_.reset();
    hovered_.reset();
    startsNext_ = false;
}

std::vector<ToolFigure> ShapeTool::figures() const {
    if (!shape_) return {};
    if (kind_ == ToolKind::line) {
        const glm::ivec3 way = shape_->last - shape_->first;
        constexpr int kReach = kMaxShapeEdge - 1;
        return {{"X", way.x, -kReach, kReach},
                {"Y", way.y, -kReach, kReach},
                {"Z", way.z, -kReach, kReach}};
    }
    const glm::ivec3 size = shape_->box().size();
    if (kind_ == ToolKind::sphere) return {{"Diameter", size.x, 1, kMaxShapeEdge}};
    return {{"X", size.x, 1, kMaxShapeEdge},
            {"Y", size.y, 1, kMaxShapeEdge},
            {"Z", size.z, 1, kMaxShapeEdge}};
}

void ShapeTool::setFigure(std::size_t index, int value) {
    if (!shape_ || index > 2) return;
    const int axis = static_cast<int>(index);
    if (kind_ == ToolKind::line) {
        shape_->last[axis] = shape_->first[axis] + value;
    } else {
        shape_->deepened = true;
        resize(axis, value);
    }
}

std::string ShapeTool::sizeText() const {
    return shape_ ? editor::sizeText(shape_->box().size()) : std::string();
}

void ShapeTool::draw(const ToolContext& context, const ViewDrawing& drawing,
                     const Theme& theme) const {
    if (!shape_) {
        if (!context.pick) return;
        const EditMode mode = context.mode();
        if (mode != EditMode::attach && context.pick->ground) return;
        const glm::ivec3 cell = cellOf(*context.pick, mode);
        markFace(drawing, theme, *context.pick, mode);
        drawing.box(IBox::around(cell, cell), withAlpha(colourOf(theme, mode), 0.9f),
                    theme.px(1.5f));
        return;
    }
    const ImU32 colour = colourOf(theme, shape_->mode);
    if (kind_ == ToolKind::line) {
        drawing.line(worldFromVoxel(glm::dvec3(shape_->first) + 0.5),
                     worldFromVoxel(glm::dvec3(shape_->last) + 0.5), colour, theme.px(2));
    } else {
        drawing.box(shape_->box(), colour, theme.px(1.5f));
    }
    markSize(drawing, theme, shape_->box());
    if (!shape_->spanning) drawHandles(handles(), hot_, drawing, theme);
}

}  // namespace voxprite::editor
