// What each command's state is: can it be used, is it on.
#include "app/editor/panels/panels.h"

namespace voxprite::editor {

bool isEnabled(CommandId id, const Session& session) {
    switch (id) {
        case CommandId::undo:
            return session.history().canUndo();
        case CommandId::redo:
            return session.history().canRedo();
        case CommandId::duplicateObject:
        case CommandId::deleteObject:
            return session.activeNode() > 0;
        case CommandId::saveProfile:
            return session.profilePath().has_value() && session.profileUnsaved();
        default:
            return true;
    }
}

bool isOn(CommandId id, const EditorSettings& settings) {
    const ToolSettings& tool = settings.tool;
    const ViewSettings& view = settings.view;
    switch (id) {
        case CommandId::attach:
            return tool.tool == Tool::attach;
        case CommandId::erase:
            return tool.tool == Tool::erase;
        case CommandId::paint:
            return tool.tool == Tool::paint;
        case CommandId::pickColour:
            return tool.tool == Tool::pickColour;
        case CommandId::pickAnchor:
            return tool.tool == Tool::pickAnchor;
        case CommandId::shapeVoxel:
            return tool.shape == BrushShape::voxel;
        case CommandId::shapeBox:
            return tool.shape == BrushShape::box;
        case CommandId::gizmoMove:
            return tool.gizmo == GizmoKind::move;
        case CommandId::gizmoRotate:
            return tool.gizmo == GizmoKind::rotate;
        case CommandId::gizmoScale:
            return tool.gizmo == GizmoKind::scale;
        case CommandId::toggleEdges:
            return view.voxelEdges;
        case CommandId::toggleEditGround:
            return view.editGround;
        case CommandId::toggleProxyBox:
            return view.proxyBox;
        case CommandId::toggleAnchorMarker:
            return view.anchorMarker;
        case CommandId::toggleGroundGrid:
            return view.groundGrid;
        case CommandId::toggleShadow:
            return view.shadow;
        case CommandId::toggleLockCameras:
            return view.lockCameras;
        case CommandId::themeDark:
            return settings.window.theme == ThemeKind::dark;
        case CommandId::themeLight:
            return settings.window.theme == ThemeKind::light;
        default:
            return false;
    }
}

}  // namespace voxprite::editor
