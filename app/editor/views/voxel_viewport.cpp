#include "app/editor/views/voxel_viewport.h"

#include <array>
#include <glm/geometric.hpp>
#include <utility>

#include "app/editor/tools/guides.h"
#include "app/editor/views/backdrop.h"
#include "app/editor/views/first_pictures.h"
#include "app/editor/views/socket_markers.h"
#include "app/editor/views/view_drawing.h"

namespace voxprite::editor {
namespace {

// What an empty document shows of the ground, in voxels.
constexpr IBox kEmptyShownBox{{-12, -12, 0}, {12, 12, 12}};

const char* modeName(EditMode mode) {
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

std::array<glm::dvec3, 8> boundsCorners(const IBox& bounds) {
    std::array<glm::dvec3, 8> corners{};
    for (std::size_t o = 0; o < corners.size(); ++o) {
        corners[o] = worldFromVoxel({(o & 1) != 0 ? bounds.max.x : bounds.min.x,
                                     (o & 2) != 0 ? bounds.max.y : bounds.min.y,
                                     (o & 4) != 0 ? bounds.max.z : bounds.min.z});
    }
    return corners;
}

// What the hand holds, or what it can do next.
std::string hintOf(const ToolSettings& settings, EditMode mode, bool busy) {
    if (busy) return "Enter to keep, Esc to drop";
    switch (settings.tool) {
        case ToolKind::pickColour:
            return "Click a voxel for its colour";
        case ToolKind::anchor:
            return "Click a voxel for the anchor; Shift: its face";
        case ToolKind::socket:
            return "Click for a socket; Shift: on the face";
        case ToolKind::laser:
            return "Laser";
        case ToolKind::stamp:
            return "Stamp";
        case ToolKind::selectBox:
        case ToolKind::selectRectangle:
        case ToolKind::wand:
            return "Select; Shift adds, Shift+Alt removes";
        case ToolKind::move:
            return "Drag voxels or an arrow; arrow keys";
        default:
            return modeName(mode);
    }
}

}  // namespace

Result<VoxelViewport> VoxelViewport::create() {
    Result<VoxelView> view = VoxelView::create();
    if (!view) return Failure(view.error());
    return VoxelViewport(std::move(*view));
}

void VoxelViewport::frameModel(const Session& session) {
    const IBox& bounds = session.bounds();
    frameBox(bounds.empty() ? kEmptyShownBox : bounds);
}

void VoxelViewport::frameBox(const IBox& box) {
    camera_.frame(boundsCorners(box), 0.2, canvas_.sizePx());
}

void VoxelViewport::show(Ui& ui, ImVec2 min, ImVec2 size, bool edits, std::string& refusal) {
    ViewInput input = canvas_.begin(ui, "view.edit", min, size);
    scale_ = ui.theme.scale;
    const ImGuiIO& io = ImGui::GetIO();
    turn_.advance(camera_, static_cast<double>(io.DeltaTime));
    canvas_.useViewCube(ui, input, camera_, turn_);
    ToolInput hand;
    hand.pointerPx = input.pointerPx;
    hand.pathPx = input.pathPx;
    hand.hovered = input.hovered && !input.moving;
    hand.pressed = input.pressed;
    hand.held = input.held;
    hand.released = input.released;
    hand.shift = io.KeyShift;
    hand.control = io.KeyCtrl;
    hand.alt = io.KeyAlt;
    if (tools_.wantsWheel()) hand.wheel = std::exchange(input.wheel, 0.0);
    ViewCanvas::navigate(input, camera_);
    const Camera camera = camera_.camera(input.sizePx);
    hovered_.reset();
    if (hand.hovered) {
        hovered_ =
            pick(ui.session.octree(), ui.session.bounds(), camera.rayThrough(input.pointerPx));
    }
    const ToolContext context{ui.session, ui.settings.tool, camera, hand, hovered_, ui.theme.scale};
    if (edits) useTools(ui, context, refusal);
    drawSocketsOverVoxels(ui, ViewDrawing(canvas_, camera));
    tools_.draw(context, ViewDrawing(canvas_, camera), ui.theme);
    canvas_.drawViewCube(ui, camera_);
    std::string hint = hintOf(ui.settings.tool, context.mode(), tools_.busy());
    const auto& floating = ui.session.selection().floating();
    if (floating) hint = floating->label + ": Enter to keep, Esc to drop";
    canvas_.caption(ui, "Edit", hint, canvas_.beforeViewCube(ui.theme));
    canvas_.end();
}

void VoxelViewport::useTools(Ui& ui, const ToolContext& context, std::string& refusal) {
    ToolBox::Outcome outcome = tools_.update(context, ImGui::GetIO().KeyAlt);
    for (Action& action : outcome.actions) ui.edits.push(std::move(action));
    refusal = std::move(outcome.refusal);
    if (const Tool* tool = tools_.tool()) ui.figures.strokeSize = tool->sizeText();
}

void VoxelViewport::follow(const Session& session, const EditorSettings& settings) {
    // A frame that does not fit is not shown; the frames that the artist edits are.
    ghosts_ = onion_.ghosts(session, settings.view.onionSkin && !settings.view.playing)
                  .value_or(std::vector<OnionSkin::Ghost>());
    marked_ = selection_->follow(session);
    clusters_->follow(session, settings.view.drawBy);
}

void VoxelViewport::renderFirst(const Session& session, const EditorSettings& settings) {
    canvas_.frame().set(
        firstVoxelPicture(session, camera_.camera(canvas_.sizePx()),
                          backdropColours(settings.view.backdrop, settings.window.theme)));
}

bool VoxelViewport::render(const Session& session, const GpuOctree& octree,
                           const EditorSettings& settings) {
    // Of the tools' options the guides alone are in the picture.
    const ToolOptions& options = settings.tool.options;
    ToolOptions guides;
    guides.symmetry = options.symmetry;
    guides.limited = options.limited;
    guides.limits = options.limits;
    const Camera camera = camera_.camera(canvas_.sizePx());
    const PlacedEntity placed = session.placedForEditing();
    const double radiusPx = placed.radiusMetres() / camera.metresPerScreenPx(glm::distance(
                                                        camera.eyeMetres, placed.centreMetres()));
    const GpuClusters* mesh = clusters_->toDraw(session, octree, settings.view.drawBy, radiusPx);
    Shown wanted{octree.revision(),
                 session.modelRevision(),
                 camera_,
                 canvas_.sizePx(),
                 settings.view,
                 settings.window.theme,
                 session.profile().light,
                 session.bounds(),
                 guides,
                 {},
                 marked_,
                 mesh == nullptr ? 0 : mesh->revision()};
    for (const OnionSkin::Ghost& ghost : ghosts_) wanted.ghosts.push_back(ghost.octree->revision());
    if (shown_ == wanted) {
        // The hand rests.
        warms_ = view_.prepareMarks(octree, placed, camera);
        return false;
    }
    VoxelViewOptions look;
    look.edges = wanted.view.voxelEdges;
    look.ground = wanted.view.editGround;
    look.occlusion = wanted.view.occlusion;
    look.shadow = wanted.view.sunShadow;
    look.light = wanted.light;
    const BackdropColours behind = backdropColours(wanted.view.backdrop, wanted.theme);
    look.backgroundTop = behind.top;
    look.backgroundBottom = behind.bottom;
    look.clusters = mesh;
    // What is drawn onto the voxels' own surface must not be hidden by a coarser one.
    const bool exact = wanted.marked != 0 || !ghosts_.empty();
    look.clusterBudgetPx = exact ? 0.0 : wanted.view.clusterBudgetPx;
    look.tintLevels = wanted.view.tintClusters;
    clusters_->beginFrame(mesh, radiusPx);
    view_.draw(canvas_.frame(), octree, session.shownPalette(), session.placedForEditing(), camera,
               look);
    clusters_->endFrame();
    for (const OnionSkin::Ghost& ghost : ghosts_) {
        view_.drawGhost(canvas_.frame(), *ghost.octree, session.shownPalette(),
                        Session::placedForEditing(session.bounds()), camera, look, ghost.tint);
    }
    selection_->draw(view_, canvas_.frame(), camera, scale_);
    OverlayShapes shapes = guidesOf(guides, wanted.bounds, scale_);
    if (wanted.view.boundsBox && !wanted.bounds.empty()) {
        shapes.addBox(boundsCorners(wanted.bounds), behind.ink, 1.5f * scale_);
    }
    if (!shapes.lines.empty()) {
        overlay_.draw(canvas_.frame(), shapes, camera, OverlayDepth::faintBehind);
    }
    shown_ = wanted;
    return true;
}

}  // namespace voxprite::editor
