// The object that a tool edits. Tools aim in entity space, where the artist sees things; objects
// are edited in model space. This is the way from the one to the other, and every edit goes along
// it, so that symmetry and limits hold for all tools alike.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "app/editor/session/session.h"
#include "app/editor/settings/settings.h"
#include "app/editor/views/picking.h"
#include "core/edit/patches.h"

namespace voxprite::editor {

class EditTarget {
  public:
    // Attaching goes to the active object, erasing and painting to the one that was hit. Fails when
    // nothing can be edited there: no object, or a hidden or locked one.
    [[nodiscard]] static Result<EditTarget> at(const Session& session, EditMode mode,
                                               const Pick& pick);

    // The same for a certain object, which may be gone.
    [[nodiscard]] static Result<EditTarget> of(const Session& session, int node);

    [[nodiscard]] int node() const { return node_; }
    [[nodiscard]] int model() const { return model_; }
    [[nodiscard]] const Placement& modelFromEntity() const { return modelFromEntity_; }
    [[nodiscard]] glm::ivec3 toModel(glm::ivec3 entityVoxel) const {
        return modelFromEntity_.applyToVoxel(entityVoxel);
    }
    [[nodiscard]] glm::ivec3 directionToModel(glm::ivec3 direction) const {
        return modelFromEntity_.rotation.apply(direction);
    }
    [[nodiscard]] int axisToModel(int axis) const;
    [[nodiscard]] const VoxelGrid& voxels(const Session& session) const;

    // The options' symmetry and limits, in model space. The selection limits what takes away and
    // paints, if the artist wants that; there is nothing to attach in solid voxels.
    [[nodiscard]] Symmetry symmetry(const ToolOptions& options) const;
    [[nodiscard]] EditLimits limits(const Session& session, EditMode mode,
                                    const ToolOptions& options) const;

    // Patches of model-space voxels with all their mirror images, inside the limits.
    [[nodiscard]] VoxelPatch patch(const Session& session, std::span<const glm::ivec3> positions,
                                   EditMode mode, const ToolSettings& settings) const;
    [[nodiscard]] Result<VoxelPatch> patch(const Session& session, const VoxelSet& set,
                                           EditMode mode, const ToolSettings& settings) const;

    // The same for so many voxels that nobody should wait for them: a function of the document
    // alone, of which `voxels` finds those of the model.
    using FindVoxels = std::function<Result<VoxelSet>(const VoxelGrid& model)>;
    [[nodiscard]] MakePatches later(const Session& session, FindVoxels voxels, EditMode mode,
                                    const ToolSettings& settings) const;

  private:
    int node_ = -1;
    int model_ = 0;
    Placement modelFromEntity_;
};

// "Attach", "Erase", "Paint"; with a noun "Attach box".
[[nodiscard]] std::string labelOf(EditMode mode, const char* noun = nullptr);

}  // namespace voxprite::editor
