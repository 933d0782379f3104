// The sprite view: the entity as the game shows it, in a small game scene, with the handles of its
// proxy box; alone or among copies, at one sigma or at several side by side, by all that it can be
// drawn by, or by two settings that are flipped between.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/editor/views/error_heat.h"
#include "app/editor/views/gizmo.h"
#include "app/editor/views/level_library.h"
#include "app/editor/views/representation_cells.h"
#include "app/editor/views/scene_representations.h"
#include "app/editor/views/sigma_cells.h"
#include "app/editor/views/sprite_scene.h"
#include "app/editor/views/view_canvas.h"
#include "app/editor/window/image_clipboard.h"
#include "core/base/image.h"
#include "core/base/result.h"
#include "render/gl/timer_query.h"
#include "render/overlay.h"
#include "render/scene_renderer.h"

namespace voxprite::editor {

class SpriteViewport {
  public:
    [[nodiscard]] static Result<SpriteViewport> create();  // needs the window's GL context

    void show(Ui& ui, ImVec2 min, ImVec2 size);
    // The picture of the first frames (first_pictures.h), in place of render().
    void renderFirst(const Session& session);
    // Draws the picture again if anything in it changed; true when it did.
    [[nodiscard]] Result<bool> render(const Session& session, const GpuOctree& octree,
                                      const EditorSettings& settings);
    // Something moves by itself, or is to be drawn without need.
    [[nodiscard]] bool animates(const EditorSettings& settings) const;

    [[nodiscard]] OrbitCamera& camera() { return camera_; }
    [[nodiscard]] CameraTurn& turn() { return turn_; }
    [[nodiscard]] bool turns() const { return turn_.running(); }
    void frameModel(const Session& session);
    void frameScene(const Session& session);  // the model with all copies
    // As far away as lets a virtual pixel cover so many pixels of the screen.
    void toGameDistance(const Session& session, double screenPxPerPx);
    // Another document: nothing of the last one's views is remembered.
    void forget() {
        // Their frames stay: the user interface may have been told to show them.
        for (SpriteCell& cell : cells_) cell.forget();
        cellB_.forget();
        library_->clear();
        heat_->clear();
        compared_.clear();
        gizmo_ = {};
        shown_.reset();
    }

    // The sprite as it shows, see spritePicture(): B's where B shows alone, else that of the
    // settings in force. Stand-ins (snapshots, coarser octrees, clusters) are drawn on the screen
    // only: the picture is the exact sprite that they stand for.
    [[nodiscard]] Result<Image> picture(const Session& session,
                                        const EditorSettings& settings) const;
    [[nodiscard]] ImageClipboard& clipboard() { return clipboard_; }

    [[nodiscard]] const SceneStats& stats() const { return figures_.stats; }
    [[nodiscard]] const SceneFigures& figures() const { return figures_; }
    [[nodiscard]] const RepresentationCells& compared() const { return compared_; }
    [[nodiscard]] const ErrorHeat& heat() const { return *heat_; }
    // A script waits for the error map; an artist never does.
    void finishWork() { heat_->wait(); }
    // What went wrong since the last call, to be told.
    [[nodiscard]] std::vector<Error> takeProblems() { return std::exchange(problems_, {}); }

  private:
    explicit SpriteViewport(SceneRenderer scene) : renderer_(std::move(scene)) {}
    void showAlone(Ui& ui, ViewInput& input);
    void showCells(Ui& ui, ViewInput& input);
    void showRepresentations(Ui& ui, ViewInput& input);
    // A and B (sprite_viewport_sides.cpp): B's picture over A's, the bar between them, and what
    // they are.
    void showSides(Ui& ui);
    void drawWipeBar(Ui& ui);
    [[nodiscard]] bool showsSides(const TradeSettings& settings) const {
        return areas_.size() == 1 && settings.showsB();
    }
    [[nodiscard]] Status renderB(const Session& session, const GpuOctree& octree,
                                 const EditorSettings& settings);
    [[nodiscard]] bool wantsHeat(const Session& session, const EditorSettings& settings) const;
    [[nodiscard]] Status followHeat(const Session& session, const GpuOctree& octree,
                                    const EditorSettings& settings);
    void useGizmo(Ui& ui, const ViewInput& input, const Camera& camera);
    void drawAnchor(Ui& ui, const Camera& camera, const PlacedEntity& placed);
    // A history for each entity.
    void prepare(SpriteCell& cell);
    void followLevels(const Session& session, const GpuOctree& octree,
                      const EditorSettings& settings);
    [[nodiscard]] Result<bool> renderScene(const Session& session, const GpuOctree& octree,
                                           const EditorSettings& settings);
    [[nodiscard]] Result<bool> renderCompared(const Session& session, const GpuOctree& octree,
                                              const RepresentationSettings& settings);
    [[nodiscard]] Status renderCell(SpriteCell& cell, Frame& frame, const Session& session,
                                    const GpuOctree& octree, const EditorSettings& settings,
                                    const GameProfile& profile);
    // The size of one cell, and the history of the entity in the cell that is in force.
    [[nodiscard]] glm::ivec2 cellPx() const;
    [[nodiscard]] ViewHistory history(const SceneSettings& settings) const;

    struct Shown {
        std::uint64_t octree = 0;
        std::uint64_t session = 0;
        std::uint64_t scene = 0;
        OrbitCamera camera;
        glm::ivec2 sizePx{0};
        std::size_t cells = 1;
        float scale = 1.0f;  // of the gaps between them, and of lines
        ViewSettings view;
        SigmaComparison comparison;
        RepresentationSettings representations;
        std::uint64_t library = 0;
        std::optional<trade::Setting> b;  // when it shows, too
        SideShown side = SideShown::a;
        bool operator==(const Shown&) const = default;
    };

    SceneRenderer renderer_;
    Overlay overlay_;
    ViewCanvas canvas_;
    OrbitCamera camera_;
    CameraTurn turn_;
    SpriteScene scene_;
    std::vector<CellArea> areas_{CellArea{}};
    std::vector<SpriteCell> cells_;
    SpriteCell cellB_;
    ViewSet viewsB_;
    std::string viewsBName_;
    std::optional<trade::Setting> reference_;  // what errors are against
    SceneRepresentations representations_;
    RepresentationCells compared_;
    glm::ivec2 comparedPx_{1};  // without the row below
    int gapPx_ = 2;
    float scale_ = 1.0f;  // of the user interface
    // Apart, so that this can be moved while the library builds.
    std::unique_ptr<LevelLibrary> library_ = std::make_unique<LevelLibrary>();
    std::unique_ptr<ErrorHeat> heat_ = std::make_unique<ErrorHeat>();
    gl::TimerQuery timer_;
    SceneFigures figures_;
    std::chrono::steady_clock::time_point drawnAt_;
    bool postponed_ = false;
    Gizmo gizmo_;
    std::uint64_t gizmoKey_ = 0;
    ImageClipboard clipboard_;
    std::vector<Error> problems_;
    std::optional<Shown> shown_;
};

}  // namespace voxprite::editor
