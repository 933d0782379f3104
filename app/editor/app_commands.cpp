// What commands do: the one place where a menu entry, a button or a key becomes a change.
#include <algorithm>

#include "app/editor/app.h"
#include "app/editor/scene_edits.h"
#include "render/gl/context.h"

namespace voxprite::editor {
namespace {

const std::vector<std::string> kModelExtensions{".voxprite", ".vox", ".svo"};
const std::vector<std::string> kProfileExtensions{".json"};

}  // namespace

void App::report(const Status& status) {
    if (!status) toasts_.error(status.error().describe());
}

void App::run(CommandId id) {
    using enum CommandId;
    switch (id) {
        case undo:
            voxels_.cancelStroke();
            return report(session_.undo());
        case redo:
            voxels_.cancelStroke();
            return report(session_.redo());
        case addObject:
        case duplicateObject:
        case deleteObject:
            return runSceneCommand(id);
        case frameModel:
            return App::frameModel();
        case viewFront:
            return look(0, 0);
        case viewRight:
            return look(90, 0);
        case viewTop:
            return look(0, 90);
        case about: {
            const gl::DriverInfo driver = gl::driverInfo();
            return dialogs_.showAbout(driver.renderer + "\nOpenGL " + driver.version);
        }
        default:
            runFileCommand(id);
            runToggle(id);
    }
}

void App::runFileCommand(CommandId id) {
    using enum CommandId;
    switch (id) {
        case newFile:
            return unlessUnsaved(Waiting::startNew);
        case open:
            return unlessUnsaved(Waiting::openDialog);
        case save:
            return saveOrAsk();
        case saveAs:
            return browse(Browsing::saveAs);
        case exportOctree:
            return browse(Browsing::exportOctree);
        case openProfile:
            return browse(Browsing::openProfile);
        case saveProfile:
            if (!session_.profilePath()) return browse(Browsing::saveProfile);
            return report(session_.saveProfile(*session_.profilePath()));
        case saveProfileAs:
            return browse(Browsing::saveProfile);
        case quit:
            return unlessUnsaved(Waiting::quit);
        default:
            return;
    }
}

void App::runSceneCommand(CommandId id) {
    const Document& document = session_.document();
    const int active = session_.activeNode();
    if (id == CommandId::addObject) {
        const std::string name = "Object " + std::to_string(document.nodes.size());
        report(session_.perform(editor::addObject(document, name)));
        session_.setActiveNode(static_cast<int>(document.nodes.size()) - 1);
    } else if (active > 0 && id == CommandId::duplicateObject) {
        report(session_.perform(editor::duplicateObject(document, active)));
        session_.setActiveNode(static_cast<int>(document.nodes.size()) - 1);
    } else if (active > 0 && id == CommandId::deleteObject) {
        report(session_.perform(editor::deleteNode(document, active)));
    }
}

void App::runToggle(CommandId id) {
    using enum CommandId;
    ToolSettings& tool = settings_.tool;
    ViewSettings& view = settings_.view;
    const auto choose = [&](Tool chosen) {
        const bool once = tool.tool == Tool::pickColour || tool.tool == Tool::pickAnchor;
        if (!once) tool.before = tool.tool;
        tool.tool = chosen;
    };
    const auto gizmo = [&](GizmoKind kind) {
        tool.gizmo = tool.gizmo == kind ? GizmoKind::none : kind;
    };
    const auto flip = [](bool& flag) { flag = !flag; };
    switch (id) {
        case attach:
            return choose(Tool::attach);
        case erase:
            return choose(Tool::erase);
        case paint:
            return choose(Tool::paint);
        case pickColour:
            return choose(Tool::pickColour);
        case pickAnchor:
            return choose(Tool::pickAnchor);
        case shapeVoxel:
            tool.shape = BrushShape::voxel;
            return;
        case shapeBox:
            tool.shape = BrushShape::box;
            return;
        case gizmoMove:
            return gizmo(GizmoKind::move);
        case gizmoRotate:
            return gizmo(GizmoKind::rotate);
        case gizmoScale:
            return gizmo(GizmoKind::scale);
        case toggleEdges:
            return flip(view.voxelEdges);
        case toggleEditGround:
            return flip(view.editGround);
        case toggleProxyBox:
            return flip(view.proxyBox);
        case toggleAnchorMarker:
            return flip(view.anchorMarker);
        case toggleGroundGrid:
            return flip(view.groundGrid);
        case toggleShadow:
            return flip(view.shadow);
        case toggleLockCameras:
            return flip(view.lockCameras);
        case themeDark:
            settings_.window.theme = ThemeKind::dark;
            return;
        case themeLight:
            settings_.window.theme = ThemeKind::light;
            return;
        default:
            return;
    }
}

void App::frameModel() {
    voxels_.frameModel(session_);
    sprite_.frameModel(session_);
}

void App::look(double yawDegrees, double pitchDegrees) {
    for (OrbitCamera* camera : {&voxels_.camera(), &sprite_.camera()}) {
        camera->yawDegrees = yawDegrees;
        camera->pitchDegrees = pitchDegrees;
    }
}

Status App::openAtStart(const std::filesystem::path& file) {
    Status opened = session_.open(file);
    if (opened) settings_.remember(file);
    return opened;
}

Status App::openProfileAtStart(const std::filesystem::path& file) {
    return session_.openProfile(file);
}

void App::requestOpen(const std::filesystem::path& file) {
    waitingFile_ = file;
    unlessUnsaved(Waiting::openFile);
}

void App::requestQuit() {
    unlessUnsaved(Waiting::quit);
}

void App::unlessUnsaved(Waiting what) {
    waiting_ = what;
    if (session_.unsaved()) {
        dialogs_.askUnsaved();
    } else {
        continueAfterSaving();
    }
}

void App::afterUnsavedQuestion(UnsavedAnswer answer) {
    switch (answer) {
        case UnsavedAnswer::save:
            return saveOrAsk();  // goes on once it has been saved
        case UnsavedAnswer::discard:
            return continueAfterSaving();
        case UnsavedAnswer::cancel:
        case UnsavedAnswer::none:
            waiting_ = Waiting::none;
    }
}

void App::continueAfterSaving() {
    switch (std::exchange(waiting_, Waiting::none)) {
        case Waiting::none:
            return;
        case Waiting::startNew:
            report(session_.startNew());
            sprite_.forget();
            framed_ = false;
            return;
        case Waiting::openDialog:
            return browse(Browsing::open);
        case Waiting::openFile:
            return openNow(waitingFile_);
        case Waiting::quit:
            quits_ = true;
    }
}

void App::openNow(const std::filesystem::path& path) {
    voxels_.cancelStroke();
    if (Status opened = session_.open(path); !opened) {
        dialogs_.showError(opened.error().describe());
        return;
    }
    settings_.remember(path);
    sprite_.forget();
    framed_ = false;
    figures_.editMilliseconds.reset();
    for (const std::string& warning : session_.warnings()) toasts_.info(warning);
}

void App::saveOrAsk() {
    if (!session_.hasNativePath()) return browse(Browsing::saveAs);
    if (Status saved = session_.saveAs(*session_.path()); !saved) {
        waiting_ = Waiting::none;
        return dialogs_.showError(saved.error().describe());
    }
    toasts_.info("Saved " + session_.path()->filename().string());
    continueAfterSaving();
}

void App::browse(Browsing what) {
    browsing_ = what;
    FileBrowser::Request request;
    request.folder = settings_.window.folder;
    const std::string name = session_.path() ? session_.title() : "untitled";
    switch (what) {
        case Browsing::open:
            request.title = "Open a model";
            request.button = "Open";
            request.extensions = kModelExtensions;
            break;
        case Browsing::saveAs:
            request.title = "Save as";
            request.button = "Save";
            request.saving = true;
            request.extensions = {".voxprite", ".vox"};
            request.name = name + ".voxprite";
            break;
        case Browsing::exportOctree:
            request.title = "Export the octree for the game's runtime";
            request.button = "Export";
            request.saving = true;
            request.extensions = {".svo"};
            request.name = name + ".svo";
            break;
        case Browsing::openProfile:
            request.title = "Open a game profile";
            request.button = "Open";
            request.extensions = kProfileExtensions;
            break;
        case Browsing::saveProfile:
            request.title = "Save the game profile";
            request.button = "Save";
            request.saving = true;
            request.extensions = kProfileExtensions;
            request.name = session_.profilePath() ? session_.profilePath()->filename().string()
                                                  : "game-profile.json";
            break;
    }
    browser_.open(std::move(request));
}

void App::browserChose(const std::filesystem::path& path) {
    settings_.window.folder = path.parent_path();
    Status done;
    std::string news;
    switch (browsing_) {
        case Browsing::open:
            return openNow(path);
        case Browsing::saveAs:
            done = session_.saveAs(path);
            news = "Saved ";
            break;
        case Browsing::exportOctree:
            done = session_.saveAs(path);
            news = "Exported and verified ";
            break;
        case Browsing::openProfile:
            done = session_.openProfile(path);
            news = "Game profile ";
            break;
        case Browsing::saveProfile:
            done = session_.saveProfile(path);
            news = "Saved ";
            break;
    }
    if (!done) {
        waiting_ = Waiting::none;
        return dialogs_.showError(done.error().describe());
    }
    toasts_.info(news + path.filename().string());
    if (browsing_ != Browsing::saveAs) return;
    settings_.remember(path);
    if (!session_.unsaved()) continueAfterSaving();
}

}  // namespace voxprite::editor
