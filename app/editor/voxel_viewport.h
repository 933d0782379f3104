// The edit view: the voxels in perspective, and the tools that change them.
#pragma once

#include <optional>

#include "app/editor/picking.h"
#include "app/editor/stroke.h"
#include "app/editor/view_canvas.h"
#include "core/base/result.h"
#include "render/voxel_view.h"

namespace voxprite::editor {

class VoxelViewport {
  public:
    [[nodiscard]] static Result<VoxelViewport> create();  // needs the window's GL context

    // The user interface; edits go to ui.edits, the reason why a tool does nothing to `refusal`.
    void show(Ui& ui, ImVec2 min, ImVec2 size, std::string& refusal);
    // Draws the picture again if anything in it changed; true when it did.
    bool render(const Session& session, const GpuOctree& octree, const EditorSettings& settings);

    [[nodiscard]] OrbitCamera& camera() { return camera_; }
    void frameModel(const Session& session);
    [[nodiscard]] const std::optional<Pick>& hovered() const { return hovered_; }
    void cancelStroke() { stroke_.reset(); }

  private:
    explicit VoxelViewport(VoxelView view) : view_(std::move(view)) {}
    void useTool(Ui& ui, const ViewInput& input, const Camera& camera, std::string& refusal);
    void beginTool(Ui& ui, const Pick& pick, std::string& refusal);
    void pickColour(Ui& ui, const Pick& pick) const;
    void pickAnchor(Ui& ui, const Pick& pick) const;
    void drawHover(Ui& ui, const Camera& camera);
    void drawStroke(Ui& ui, const Camera& camera);

    // Everything that the picture depends on.
    struct Shown {
        std::uint64_t octree = 0;
        std::uint64_t model = 0;
        OrbitCamera camera;
        glm::ivec2 sizePx{0};
        bool edges = false;
        bool ground = false;
        ThemeKind theme = ThemeKind::dark;
        Light light;
        bool operator==(const Shown&) const = default;
    };

    VoxelView view_;
    ViewCanvas canvas_;
    OrbitCamera camera_;
    std::optional<Stroke> stroke_;
    std::optional<Pick> hovered_;
    std::optional<Shown> shown_;
};

}  // namespace voxprite::editor
