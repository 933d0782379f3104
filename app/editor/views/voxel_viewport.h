// The edit view: the voxels in perspective, and the tools that change them.
#pragma once

#include <memory>
#include <optional>

#include "app/editor/tools/tool_box.h"
#include "app/editor/views/onion_skin.h"
#include "app/editor/views/picking.h"
#include "app/editor/views/selection_picture.h"
#include "app/editor/views/view_canvas.h"
#include "app/editor/views/voxel_clusters.h"
#include "core/base/result.h"
#include "render/overlay.h"
#include "render/voxel_view.h"

namespace voxprite::editor {

class VoxelViewport {
  public:
    [[nodiscard]] static Result<VoxelViewport> create();  // needs the window's GL context

    // The user interface; edits go to ui.edits, the reason why a tool does nothing to `refusal`.
    // Tools rest while nothing may be edited.
    void show(Ui& ui, ImVec2 min, ImVec2 size, bool edits, std::string& refusal);
    // Brings what is drawn over the model up to date with the session; before render().
    void follow(const Session& session, const EditorSettings& settings);
    // The picture of the first frames (first_pictures.h), in place of render().
    void renderFirst(const Session& session, const EditorSettings& settings);
    // Draws the picture again if anything in it changed; true when it did.
    bool render(const Session& session, const GpuOctree& octree, const EditorSettings& settings);

    [[nodiscard]] OrbitCamera& camera() { return camera_; }
    [[nodiscard]] CameraTurn& turn() { return turn_; }
    // A mesh, or the marks of what is selected, are on their way, and the picture waits for them.
    [[nodiscard]] bool prepares() const {
        return clusters_->pending() || selection_->prepares() || warms_;
    }
    // For scripts, which do one thing after another: what the hand has asked for is there.
    void finishWork(Session& session) {
        tools_.finishPreview(session);
        selection_->finish();
    }
    [[nodiscard]] bool turns() const { return turn_.running(); }
    void frameModel(const Session& session);
    // So that a box of entity space fills the view.
    void frameBox(const IBox& box);
    [[nodiscard]] const std::optional<Pick>& hovered() const { return hovered_; }
    // The tool in hand, for its options.
    [[nodiscard]] ToolBox& tools() { return tools_; }
    [[nodiscard]] const ToolBox& tools() const { return tools_; }

  private:
    explicit VoxelViewport(VoxelView view)
        : view_(std::move(view)),
          selection_(std::make_unique<SelectionPicture>()),
          clusters_(std::make_unique<VoxelClusters>()) {}
    void useTools(Ui& ui, const ToolContext& context, std::string& refusal);

    // Everything that the picture depends on.
    struct Shown {
        std::uint64_t octree = 0;
        std::uint64_t model = 0;
        OrbitCamera camera;
        glm::ivec2 sizePx{0};
        ViewSettings view;
        ThemeKind theme = ThemeKind::dark;
        Light light;
        IBox bounds;
        ToolOptions guides;
        std::vector<std::uint64_t> ghosts;  // revisions of their octrees
        std::uint64_t marked = 0;           // that of what is selected
        std::uint64_t clusters = 0;         // that of the mesh; 0: rays
        bool operator==(const Shown&) const = default;
    };

    VoxelView view_;
    Overlay overlay_;
    ViewCanvas canvas_;
    OrbitCamera camera_;
    CameraTurn turn_;
    ToolBox tools_;
    OnionSkin onion_;
    // The work of these in the background points to them.
    std::unique_ptr<SelectionPicture> selection_;
    std::unique_ptr<VoxelClusters> clusters_;
    std::vector<OnionSkin::Ghost> ghosts_;
    std::uint64_t marked_ = 0;  // changes with what is selected; 0: nothing
    std::optional<Pick> hovered_;
    float scale_ = 1.0f;  // device pixels a pixel
    std::optional<Shown> shown_;
    bool warms_ = false;  // there is more to prepare of what will be drawn later
};

}  // namespace voxprite::editor
