// Fills by a click. The bucket recolours (or erases) what is connected to the voxel; the plane fill
// closes an outline: it fills the empty part of a layer that voxels enclose, and in the other modes
// paints or erases the face that was hit.
#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include "app/editor/tools/edit_target.h"
#include "app/editor/tools/tool.h"

namespace voxprite::editor {

class FillTool final : public Tool {
  public:
    enum class Kind : std::uint8_t { connected, plane };
    explicit FillTool(Kind kind) : kind_(kind) {}

    [[nodiscard]] ToolResult update(const ToolContext& context) override;
    void draw(const ToolContext& context, const ViewDrawing& drawing,
              const Theme& theme) const override;
    void cancel() override;

  private:
    [[nodiscard]] EditMode modeOf(const ToolContext& context) const;
    // What the region is of a model, as a function of that alone; `maxBlocks` as regions.h has it.
    using Region = std::function<Result<VoxelSet>(const VoxelGrid& model, std::size_t maxBlocks)>;
    [[nodiscard]] Region region(const ToolContext& context, const EditTarget& target,
                                const Pick& pick) const;
    [[nodiscard]] Action actionOf(const ToolContext& context, const EditTarget& target,
                                  EditMode mode) const;
    // Is the pointer on another voxel of the region that is shown, and nothing else new?
    [[nodiscard]] bool isStillOn(const Session& session, const Aim& aim) const;
    void show(const ToolContext& context, ToolResult& result);

    // What the pointer is on, without mirror images.
    struct Shown {
        int node = -1;
        Placement modelFromEntity;
        Region region;
        // Those of the region, model space, as soon as somebody has found them: of a large region,
        // whoever works out the preview behind the window.
        std::shared_ptr<std::atomic<std::shared_ptr<const VoxelSet>>> voxels;
        IBox box;  // around them, entity space
        bool isLarge = false;

        [[nodiscard]] EditTarget::FindVoxels find() const;
    };

    Kind kind_;
    std::optional<Aim> aim_;
    std::optional<Shown> shown_;
};

}  // namespace voxprite::editor
