#include "app/editor/voxel_viewport.h"

#include <array>
#include <cstdio>

#include "app/editor/view_drawing.h"

namespace voxprite::editor {
namespace {

// What an empty document shows of the ground, in voxels.
constexpr IBox kEmptyShown{{-12, -12, 0}, {12, 12, 12}};

BrushShape shapeOf(ToolKind tool) {
    return tool == ToolKind::box ? BrushShape::box : BrushShape::voxel;
}

std::string toolName(const ToolSettings& tool) {
    if (tool.tool == ToolKind::pickColour) return "Click a voxel for its colour";
    if (tool.tool == ToolKind::anchor) return "Click a voxel for the anchor; Shift: its face";
    const bool box = shapeOf(tool.tool) == BrushShape::box;
    switch (tool.mode) {
        case EditMode::attach:
            return box ? "Attach boxes" : "Attach";
        case EditMode::erase:
            return box ? "Erase boxes" : "Erase";
        case EditMode::paint:
            return box ? "Paint boxes" : "Paint";
    }
    return {};
}

}  // namespace

Result<VoxelViewport> VoxelViewport::create() {
    Result<VoxelView> view = VoxelView::create();
    if (!view) return Failure(view.error());
    return VoxelViewport(std::move(*view));
}

void VoxelViewport::frameModel(const Session& session) {
    const IBox& bounds = session.bounds();
    const IBox shown = bounds.empty() ? kEmptyShown : bounds;
    std::vector<glm::dvec3> corners;
    for (int o = 0; o < 8; ++o) {
        corners.push_back(worldFromVoxel({(o & 1) != 0 ? shown.max.x : shown.min.x,
                                          (o & 2) != 0 ? shown.max.y : shown.min.y,
                                          (o & 4) != 0 ? shown.max.z : shown.min.z}));
    }
    camera_.frame(corners, 0.2, canvas_.sizePx());
}

void VoxelViewport::show(Ui& ui, ImVec2 min, ImVec2 size, std::string& refusal) {
    ViewInput input = canvas_.begin(ui, "view.edit", min, size);
    const bool drawsBox = stroke_ && stroke_->box();
    if (drawsBox && input.wheel != 0.0) {
        stroke_->deepen(input.wheel > 0.0 ? 1 : -1);
        input.wheel = 0.0;
    }
    ViewCanvas::navigate(input, camera_);
    const Camera camera = camera_.camera(input.sizePx);
    hovered_.reset();
    if (input.hovered && !input.moving) {
        hovered_ =
            pick(ui.session.octree(), ui.session.bounds(), camera.rayThrough(input.pointerPx));
    }
    useTool(ui, input, camera, refusal);
    if (stroke_) {
        drawStroke(ui, camera);
    } else {
        drawHover(ui, camera);
    }
    canvas_.caption(ui, "Edit", toolName(ui.settings.tool));
    canvas_.end();
}

void VoxelViewport::useTool(Ui& ui, const ViewInput& input, const Camera& camera,
                            std::string& refusal) {
    if (input.pressed && hovered_) {
        beginTool(ui, *hovered_, refusal);
        if (stroke_) {
            const std::array at{input.pointerPx};
            if (auto action = stroke_->drag(ui.session, camera, at)) {
                ui.edits.push(std::move(*action));
            }
        }
    } else if (stroke_) {
        if (auto action = stroke_->drag(ui.session, camera, input.pathPx)) {
            ui.edits.push(std::move(*action));
        }
        if (input.released) {
            if (auto action = stroke_->finish(ui.session)) ui.edits.push(std::move(*action));
            stroke_.reset();
        } else if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
            stroke_.reset();
        }
    }
}

void VoxelViewport::beginTool(Ui& ui, const Pick& pick, std::string& refusal) {
    ToolSettings& tool = ui.settings.tool;
    if (ImGui::GetIO().KeyAlt) return pickColour(ui, pick);
    if (tool.isForOneClick()) {
        if (pick.ground) return;
        if (tool.tool == ToolKind::pickColour) pickColour(ui, pick);
        if (tool.tool == ToolKind::anchor) pickAnchor(ui, pick);
        tool.tool = tool.before;
        return;
    }
    Result<Stroke> stroke =
        Stroke::begin(ui.session, {tool.mode, shapeOf(tool.tool), tool.colour}, pick);
    if (stroke) {
        stroke_ = std::move(*stroke);
    } else {
        refusal = stroke.error().message;
    }
}

void VoxelViewport::pickColour(Ui& ui, const Pick& pick) const {
    const std::uint8_t colour = ui.session.octree().at(pick.voxel);
    if (colour != 0) ui.settings.tool.colour = colour;
}

void VoxelViewport::pickAnchor(Ui& ui, const Pick& pick) const {
    const Entity& before = ui.session.document().entity;
    Entity after = before;
    glm::dvec3 anchor = glm::dvec3(pick.voxel) + 0.5;
    if (ImGui::GetIO().KeyShift) anchor += glm::dvec3(pick.normal) * 0.5;
    after.anchorVoxels = anchor;
    ui.edits.push("Set anchor", EntityEdit{before, after}, false);
}

void VoxelViewport::drawHover(Ui& ui, const Camera& camera) {
    if (!hovered_) return;
    const Theme& theme = ui.theme;
    const ToolSettings& tool = ui.settings.tool;
    const bool picking = tool.isForOneClick() || ImGui::GetIO().KeyAlt;
    if (hovered_->ground && (picking || tool.mode != EditMode::attach)) return;
    const ViewDrawing draw(canvas_, camera);
    const ImU32 colour = tool.mode == EditMode::erase && !picking ? theme.danger : theme.accent;
    const bool attaches = tool.mode == EditMode::attach && !picking;
    const glm::ivec3 cell = attaches ? hovered_->attachTo() : hovered_->voxel;
    draw.face(faceCorners(*hovered_), withAlpha(colour, 0.35f));
    draw.box(IBox::around(cell, cell), withAlpha(colour, 0.9f), theme.px(1.5f));
}

void VoxelViewport::drawStroke(Ui& ui, const Camera& camera) {
    const auto box = stroke_->box();
    if (!box) return;
    const Theme& theme = ui.theme;
    const ImU32 colour = stroke_->brush().mode == EditMode::erase ? theme.danger : theme.accent;
    const ViewDrawing draw(canvas_, camera);
    draw.boxFaces(*box, withAlpha(colour, 0.18f));
    draw.box(*box, colour, theme.px(2));
    const glm::ivec3 size = box->size();
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), "%d × %d × %d", size.x, size.y, size.z);
    ui.figures.strokeSize = text.data();
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    draw.label(theme, {mouse.x + theme.px(16), mouse.y + theme.px(12)}, text.data());
}

bool VoxelViewport::render(const Session& session, const GpuOctree& octree,
                           const EditorSettings& settings) {
    const Shown wanted{octree.revision(),     session.modelRevision(),  camera_,
                       canvas_.sizePx(),      settings.view.voxelEdges, settings.view.editGround,
                       settings.window.theme, session.profile().light};
    if (shown_ == wanted) return false;
    VoxelViewOptions options;
    options.edges = wanted.edges;
    options.ground = wanted.ground;
    options.light = wanted.light;
    if (wanted.theme == ThemeKind::light) {
        options.backgroundTop = Rgba8(214, 217, 222, 255);
        options.backgroundBottom = Rgba8(176, 180, 188, 255);
    }
    view_.draw(canvas_.frame(), octree, session.document().palette, session.placedForEditing(),
               camera_.camera(wanted.sizePx), options);
    shown_ = wanted;
    return true;
}

}  // namespace voxprite::editor
