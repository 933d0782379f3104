// The sprite view: the entity as the game shows it, in a small game scene, with the handles of its
// proxy box.
#pragma once

#include <optional>

#include "app/editor/gizmo.h"
#include "app/editor/view_canvas.h"
#include "core/base/result.h"
#include "render/overlay.h"
#include "render/scene_renderer.h"

namespace voxprite::editor {

class SpriteViewport {
  public:
    [[nodiscard]] static Result<SpriteViewport> create();  // needs the window's GL context

    void show(Ui& ui, ImVec2 min, ImVec2 size);
    // Draws the picture again if anything in it changed; true when it did.
    [[nodiscard]] Result<bool> render(const Session& session, const GpuOctree& octree,
                                      const EditorSettings& settings);

    [[nodiscard]] OrbitCamera& camera() { return camera_; }
    void frameModel(const Session& session);
    // Another document: nothing of the last one's views is remembered.
    void forget() { history_ = {}; }
    [[nodiscard]] const SceneStats& stats() const { return stats_; }

  private:
    SpriteViewport(SceneRenderer scene, Overlay overlay)
        : renderer_(std::move(scene)), overlay_(std::move(overlay)) {}
    void useGizmo(Ui& ui, const ViewInput& input, const Camera& camera);
    void drawAnchor(Ui& ui, const Camera& camera, const PlacedEntity& placed);

    struct Shown {
        std::uint64_t octree = 0;
        std::uint64_t session = 0;
        OrbitCamera camera;
        glm::ivec2 sizePx{0};
        ViewSettings view;
        bool operator==(const Shown&) const = default;
    };

    SceneRenderer renderer_;
    Overlay overlay_;
    ViewCanvas canvas_;
    OrbitCamera camera_;
    ViewHistory history_;
    SceneStats stats_;
    Gizmo gizmo_;
    std::uint64_t gizmoKey_ = 0;
    std::optional<Shown> shown_;
};

}  // namespace voxprite::editor
