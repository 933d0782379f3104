#include "app/editor/tools/edit_target.h"

namespace voxprite::editor {
namespace {

std::string objectName(const Document& document, int node) {
    const std::string& name = document.nodes[static_cast<std::size_t>(node)].name;
    return name.empty() ? "The object" : "\"" + name + "\"";
}

}  // namespace

Result<EditTarget> EditTarget::at(const Session& session, EditMode mode, const Pick& pick) {
    int node = session.activeNode();
    if (mode != EditMode::attach) {
        if (pick.ground) return fail("There is no voxel here");
        node = session.nodeAt(pick.voxel);
    }
    return of(session, node);
}

Result<EditTarget> EditTarget::of(const Session& session, int node) {
    const auto& nodes = session.document().nodes;
    if (node < 0 || static_cast<std::size_t>(node) >= nodes.size()) {
        return fail("There is no object to edit: add one first");
    }
    for (int up = node; up >= 0; up = nodes[static_cast<std::size_t>(up)].parent) {
        if (nodes[static_cast<std::size_t>(up)].locked) {
            return fail(objectName(session.document(), up) + " is locked");
        }
    }
    for (const Instance& instance : session.instances()) {
        if (instance.node != node) continue;
        EditTarget target;
        target.node_ = node;
        target.model_ = instance.model;
        target.modelFromEntity_ = instance.entityFromModel.inverse();
        return target;
    }
    return fail(objectName(session.document(), node) + " is hidden");
}

int EditTarget::axisToModel(int axis) const {
    glm::ivec3 direction(0);
    direction[axis] = 1;
    const glm::ivec3 turned = directionToModel(direction);
    return turned.x != 0 ? 0 : turned.y != 0 ? 1 : 2;
}

const VoxelGrid& EditTarget::voxels(const Session& session) const {
    return session.document().models[static_cast<std::size_t>(model_)].voxels;
}

Symmetry EditTarget::symmetry(const ToolOptions& options) const {
    Symmetry inModel;
    for (int axis = 0; axis < 3; ++axis) {
        const int from = modelFromEntity_.rotation.axis[static_cast<std::size_t>(axis)];
        const int sign =
            modelFromEntity_.rotation.sign[static_cast<std::size_t>(axis)] < 0 ? -1 : 1;
        inModel.on[static_cast<std::size_t>(axis)] =
            options.symmetry.on[static_cast<std::size_t>(from)];
        inModel.planeDoubled[axis] =
            sign * options.symmetry.planeDoubled[from] + 2 * modelFromEntity_.translation[axis];
    }
    return inModel;
}

EditLimits EditTarget::limits(const Session& session, EditMode mode,
                              const ToolOptions& options) const {
    EditLimits limits;
    if (options.limited) limits.box = modelFromEntity_.applyToBox(options.limits);
    const VoxelSelection& selection = session.selection();
    if (options.insideSelection && mode != EditMode::attach && !selection.empty() &&
        selection.model() == model_) {
        limits.only = &selection.voxels();
    }
    return limits;
}

VoxelPatch EditTarget::patch(const Session& session, std::span<const glm::ivec3> positions,
                             EditMode mode, const ToolSettings& settings) const {
    return patchVoxels(session.document(), model_, mirrored(positions, symmetry(settings.options)),
                       mode, settings.colour, limits(session, mode, settings.options));
}

Result<VoxelPatch> EditTarget::patch(const Session& session, const VoxelSet& set, EditMode mode,
                                     const ToolSettings& settings) const {
    const Symmetry images = symmetry(settings.options);
    const EditLimits inside = limits(session, mode, settings.options);
    if (!images.any()) {
        return patchSet(session.document(), model_, set, mode, settings.colour, inside);
    }
    return patchSet(session.document(), model_, mirrored(set, images), mode, settings.colour,
                    inside);
}

MakePatches EditTarget::later(const Session& session, FindVoxels voxels, EditMode mode,
                              const ToolSettings& settings) const {
    const EditLimits now = limits(session, mode, settings.options);
    const auto only = now.only != nullptr ? session.selection().sharedVoxels() : nullptr;
    return [voxels = std::move(voxels), model = model_, images = symmetry(settings.options),
            box = now.box, only, mode, colour = settings.colour](const Document& document) {
        const VoxelGrid& grid = document.models[static_cast<std::size_t>(model)].voxels;
        Result<VoxelSet> set = voxels(grid);
        if (!set) return Result<std::vector<VoxelPatch>>(Failure(set.error()));
        const EditLimits inside{box, only.get()};
        return onePatch(patchSet(document, model, images.any() ? mirrored(*set, images) : *set,
                                 mode, colour, inside));
    };
}

std::string labelOf(EditMode mode, const char* noun) {
    std::string label;
    switch (mode) {
        case EditMode::attach:
            label = "Attach";
            break;
        case EditMode::erase:
            label = "Erase";
            break;
        case EditMode::paint:
            label = "Paint";
            break;
    }
    return noun == nullptr ? label : label + " " + noun;
}

}  // namespace voxprite::editor
