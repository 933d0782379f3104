#include "app/editor/tools/face_tool.h"

#include <algorithm>
#include <cmath>

#include "app/editor/tools/tool_marks.h"
#include "core/edit/make_action.h"

namespace voxprite::editor {

Result<FaceTool::Face> FaceTool::faceAt(const ToolContext& context, EditMode mode,
                                        const Pick& pick) {
    if (pick.ground) return fail("There is no face here");
    // What is pulled out belongs to what was hit, also when attaching.
    const EditMode aimed = mode == EditMode::attach ? EditMode::paint : mode;
    const Result<EditTarget> target = EditTarget::at(context.session, aimed, pick);
    if (!target) return Failure(target.error());
    Face face{*target, pick, {}, target->directionToModel(pick.normal), {}};
    Result<VoxelSet> found =
        faceRegion(target->voxels(context.session), target->toModel(pick.voxel), face.normal,
                   context.settings.options.region());
    if (!found) return Failure(found.error());
    face.voxels = std::move(*found);
    if (face.voxels.empty()) return fail("This face touches another object");
    face.box = target->modelFromEntity().inverse().applyToBox(face.voxels.bounds());
    return face;
}

Result<VoxelPatch> FaceTool::patchOf(const ToolContext& context, const Face& face, EditMode mode,
                                     int layers) const {
    if (mode == EditMode::paint) {
        return face.target.patch(context.session, face.voxels, mode, context.settings);
    }
    std::vector<MovedFace> faces;
    for (const Placement& image : imagesOf(face.target.symmetry(context.settings.options))) {
        VoxelSet voxels = face.voxels;
        if (image != Placement{}) {
            voxels = VoxelSet();
            face.voxels.forEach([&](glm::ivec3 v) { voxels.insert(image.applyToVoxel(v)); });
        }
        faces.push_back({std::move(voxels), image.rotation.apply(face.normal)});
    }
    return patchFaces(context.session.document(), face.target.model(), faces, layers, std::nullopt,
                      face.target.limits(context.session, mode, context.settings.options));
}

ToolResult FaceTool::update(const ToolContext& context) {
    ToolResult result;
    const ToolInput& input = context.input;
    hot_ = false;
    if (pulled_ && !pulled_->dragging) {
        const std::array<Handle, 1> handle{arrow()};
        hot_ = input.hovered && pulled_->mode != EditMode::paint &&
               handleAt(handle, context.camera, input.pointerPx, context.scale * 1.4f) == 0;
        if (input.pressed && hot_) {
            const auto at =
                alongAxis(context.camera.rayThrough(input.pointerPx), handle[0].at, handle[0].axis);
            pulled_->dragging = at.has_value();
            pulled_->grabbed = at.value_or(0.0);
            pulled_->layersBefore = pulled_->layers;
        } else if (input.pressed) {
            result.action = confirm(context.session);
            startsNext_ = true;
            return result;
        }
    }
    if (!pulled_ && (input.pressed || startsNext_) && context.pick) begin(context, result);
    startsNext_ = false;
    if (!pulled_) {
        showHover(context, result);
        return result;
    }
    if (pulled_->dragging) {
        drag(context);
        if (!input.held) pulled_->dragging = false;
    }
    make(context, result);
    // Nothing more can be said about a colour.
    if (pulled_->mode == EditMode::paint && !input.held) result.action = confirm(context.session);
    return result;
}

void FaceTool::begin(const ToolContext& context, ToolResult& result) {
    const EditMode mode = context.mode();
    Result<Face> face = faceAt(context, mode, *context.pick);
    if (!face) {
        result.refusal = face.error().message;
        return;
    }
    context.session.setActiveNode(face->target.node());
    const int axis = face->pick.axis();
    const auto at = alongAxis(context.camera.rayThrough(context.input.pointerPx),
                              glm::dvec3(face->pick.voxel) + 0.5, axis);
    pulled_ = Pulled();
    pulled_->face = std::move(*face);
    pulled_->mode = mode;
    pulled_->grabbed = at.value_or(0.0);
    // A click is one layer, the way of the mode.
    pulled_->layers = mode == EditMode::erase ? -1 : 1;
    made_.reset();
    aim_.reset();
    hovered_.reset();
}

void FaceTool::drag(const ToolContext& context) {
    const Pick& pick = pulled_->face.pick;
    const int axis = pick.axis();
    const auto at = alongAxis(context.camera.rayThrough(context.input.pointerPx),
                              glm::dvec3(pick.voxel) + 0.5, axis);
    if (!at || pulled_->mode == EditMode::paint) return;
    const double way = (*at - pulled_->grabbed) * pick.normal[axis];
    const int layers =
        pulled_->layersBefore + static_cast<int>(std::round(std::clamp(way, double(-kMaxFaceLayers),
                                                                       double(kMaxFaceLayers))));
    // A shaking hand leaves a click a click; once it moved, every way is the hand's.
    pulled_->moved = pulled_->moved || layers != pulled_->layersBefore;
    if (pulled_->moved) pulled_->layers = std::clamp(layers, -kMaxFaceLayers, kMaxFaceLayers);
}

void FaceTool::make(const ToolContext& context, ToolResult& result) {
    Aim now = context.aim();
    now.pick.reset();
    now.mode = pulled_->mode;
    if (made_ == now && madeLayers_ == pulled_->layers) return;
    made_ = now;
    madeLayers_ = pulled_->layers;
    patch_ = {pulled_->face.target.model(), {}};
    if (pulled_->layers != 0 || pulled_->mode == EditMode::paint) {
        Result<VoxelPatch> patch = patchOf(context, pulled_->face, pulled_->mode, pulled_->layers);
        if (patch) {
            patch_ = std::move(*patch);
        } else {
            result.refusal = patch.error().message;
        }
    }
    result.preview = {patch_};
}

void FaceTool::showHover(const ToolContext& context, ToolResult& result) {
    const Aim aim = context.aim();
    if (aim_ == aim) return;
    // Another voxel of the same face: nothing changes.
    if (hovered_ && aim_ && aim.pick && aim.pick->normal == hovered_->pick.normal) {
        Aim elsewhere = aim;
        elsewhere.pick = aim_->pick;
        if (elsewhere == *aim_ &&
            hovered_->voxels.contains(hovered_->target.toModel(aim.pick->voxel)) &&
            context.session.nodeAt(aim.pick->voxel) == hovered_->target.node()) {
            aim_ = aim;
            return;
        }
    }
    aim_ = aim;
    hovered_.reset();
    result.preview.emplace();
    if (!aim.pick) return;
    Result<Face> face = faceAt(context, aim.mode, *aim.pick);
    if (!face) return;
    hovered_ = std::move(*face);
    const int layers = aim.mode == EditMode::erase ? -1 : 1;
    if (Result<VoxelPatch> patch = patchOf(context, *hovered_, aim.mode, layers)) {
        result.preview->push_back(std::move(*patch));
    }
}

std::optional<Action> FaceTool::confirm(Session& /*session*/) {
    if (!pulled_) return std::nullopt;
    std::optional<Action> action;
    if (!patch_.changes.empty()) {
        const bool paints = pulled_->mode == EditMode::paint;
        action = makeAction(paints                ? "Paint face"
                            : pulled_->layers > 0 ? "Extrude face"
                                                  : "Push face",
                            std::move(patch_));
    }
    cancel();
    return action;
}

void FaceTool::cancel() {
    pulled_.reset();
    patch_ = {};
    made_.reset();
    hovered_.reset();
    aim_.reset();
    startsNext_ = false;
}

Handle FaceTool::arrow() const {
    const Pick& pick = pulled_->face.pick;
    const int axis = pick.axis();
    const IBox& box = pulled_->face.box;
    glm::dvec3 at = glm::dvec3(box.min + box.max) * 0.5;
    at[axis] = pick.facePlane() + pick.normal[axis] * pulled_->layers;
    return {at, axis};
}

std::vector<ToolFigure> FaceTool::figures() const {
    if (!pulled_ || pulled_->mode == EditMode::paint) return {};
    return {{"Layers", pulled_->layers, -kMaxFaceLayers, kMaxFaceLayers}};
}

void FaceTool::setFigure(std::size_t index, int value) {
    if (pulled_ && index == 0) {
        pulled_->layers = std::clamp(value, -kMaxFaceLayers, kMaxFaceLayers);
    }
}

std::string FaceTool::sizeText() const {
    if (!pulled_ || pulled_->mode == EditMode::paint) return {};
    return (pulled_->layers > 0 ? "+" : "") + std::to_string(pulled_->layers);
}

void FaceTool::draw(const ToolContext& context, const ViewDrawing& drawing,
                    const Theme& theme) const {
    if (!pulled_) {
        if (!hovered_) return;
        const ImU32 colour = colourOf(theme, context.mode());
        // The face as it will be.
        IBox box = hovered_->box;
        const int axis = hovered_->pick.axis();
        const EditMode mode = context.mode();
        if (mode == EditMode::attach) {
            box.min[axis] += hovered_->pick.normal[axis];
            box.max[axis] += hovered_->pick.normal[axis];
        }
        drawing.box(box, withAlpha(colour, 0.9f), theme.px(1.5f));
        return;
    }
    const Handle handle = arrow();
    const Pick& pick = pulled_->face.pick;
    glm::dvec3 foot = handle.at;
    foot[handle.axis] = pick.facePlane();
    const ImU32 colour = pulled_->layers < 0 ? theme.danger : theme.accent;
    if (pulled_->mode == EditMode::paint) return;
    drawing.line(worldFromVoxel(foot), worldFromVoxel(handle.at), colour, theme.px(2));
    drawHandles({&handle, 1}, hot_ || pulled_->dragging ? 0 : -1, drawing, theme);
    if (const auto at = drawing.project(worldFromVoxel(handle.at))) {
        drawing.label(theme, {at->x + theme.px(14), at->y - theme.px(12)}, sizeText().c_str());
    }
}

}  // namespace voxprite::editor
