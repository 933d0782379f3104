#include "app/editor/session/selection_edits.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include "app/editor/panels/number_text.h"
#include "app/editor/tools/edit_target.h"
#include "core/edit/clip_colours.h"
#include "core/edit/free_name.h"
#include "core/edit/make_action.h"
#include "core/edit/regions.h"
#include "core/edit/reshape.h"
#include "core/edit/scene_edits.h"
#include "core/edit/transforms.h"

namespace voxprite::editor {
namespace {

const char* const kSelectedElsewhere = "What is selected does not show in this frame";

const VoxelGrid& gridOf(const Session& session, int model) {
    return session.document().models[static_cast<std::size_t>(model)].voxels;
}

std::string colourCount(int count) {
    return std::to_string(count) + (count == 1 ? " colour" : " colours");
}

std::string voxelCount(std::uint64_t count) {
    return grouped(count) + (count == 1 ? " voxel" : " voxels");
}

using MakePatch = std::function<Result<VoxelPatch>(const Document&)>;

// An edit of so many voxels: of few it is made here and now.
Result<Action> editOf(const Session& session, std::string label, std::uint64_t voxels,
                      const MakePatch& make) {
    if (voxels <= kLongStepVoxels) {
        Result<VoxelPatch> patch = make(session.document());
        if (!patch) return Failure(patch.error());
        return makeAction(std::move(label), std::move(*patch));
    }
    return makeActionLater(std::move(label),
                           [make](const Document& document) { return onePatch(make(document)); });
}

MakePatch patchOfSet(int model, VoxelSet set, EditMode mode, std::uint8_t colour) {
    const auto shared = std::make_shared<const VoxelSet>(std::move(set));
    return
        [=](const Document& document) { return patchSet(document, model, *shared, mode, colour); };
}

// As it looks on screen.
VoxelClip clipOf(const Session& session, const Chosen& chosen) {
    const VoxelGrid& grid = gridOf(session, chosen.model);
    // All of it is much sooner copied as it is.
    VoxelClip clip = chosen.voxels.count() == grid.solidCount() ? VoxelClip{grid, {}}
                                                                : copyVoxels(grid, chosen.voxels);
    clip.modelFromClip = chosen.entityFromModel;
    return clip;
}

Floating inAir(const Session& session, const Chosen& chosen, const char* label) {
    Floating floating;
    floating.label = label;
    floating.node = chosen.node;
    floating.model = chosen.model;
    floating.entityFromModel = chosen.entityFromModel;
    floating.clip = clipOf(session, chosen);
    floating.home = floating.bounds().min;
    return floating;
}

const char* labelOf(Floating::Kind kind) {
    switch (kind) {
        case Floating::Kind::move:
            return "Move voxels";
        case Floating::Kind::hollow:
            return "Hollow out";
        case Floating::Kind::dilate:
            return "Dilate";
        case Floating::Kind::erode:
            return "Erode";
        case Floating::Kind::smooth:
            return "Smooth";
    }
    return "";
}

}  // namespace

Result<Chosen> chosenVoxels(const Session& session) {
    const VoxelSelection& selection = session.selection();
    const int node = selection.empty() ? session.activeNode() : selection.node();
    const Result<EditTarget> target = EditTarget::of(session, node);
    if (!target) return Failure(target.error());
    const bool selected = !selection.empty();
    // Never the whole object in place of what the artist has chosen of it.
    if (selected && selection.model() != target->model()) return fail(kSelectedElsewhere);
    Chosen chosen{node, target->model(), target->modelFromEntity().inverse(),
                  selected ? selection.voxels() : selectAll(target->voxels(session)), selected};
    if (chosen.voxels.empty()) return fail("The object is empty");
    return chosen;
}

bool selectionShows(const Session& session) {
    const VoxelSelection& selection = session.selection();
    return !selection.empty() &&
           std::ranges::any_of(session.instances(), [&](const Instance& instance) {
               return instance.node == selection.node() && instance.model == selection.model();
           });
}

Status selectEverything(Session& session) {
    const Result<EditTarget> target = EditTarget::of(session, session.activeNode());
    if (!target) return Failure(target.error());
    session.selection().select(target->node(), target->model(), selectAll(target->voxels(session)));
    return {};
}

Status invertSelection(Session& session) {
    const VoxelSelection& selection = session.selection();
    if (selection.empty()) return selectEverything(session);
    if (!selectionShows(session)) return fail(kSelectedElsewhere);
    const int node = selection.node(), model = selection.model();
    session.selection().select(node, model, inverted(gridOf(session, model), selection.voxels()));
    return {};
}

Status selectColour(Session& session, std::uint8_t colour) {
    const Result<EditTarget> target = EditTarget::of(session, session.activeNode());
    if (!target) return Failure(target.error());
    VoxelSet found = voxelsOfColour(target->voxels(session), colour);
    if (found.empty()) return fail("No voxel of the object has this colour");
    session.selection().select(target->node(), target->model(), std::move(found));
    return {};
}

Status copySelection(Session& session) {
    const Result<Chosen> chosen = chosenVoxels(session);
    if (!chosen) return Failure(chosen.error());
    session.setClip(clipOf(session, *chosen));
    return {};
}

Status lift(Session& session, const ToolSettings& settings, Floating::Kind kind) {
    Result<Chosen> chosen = chosenVoxels(session);
    if (!chosen) return Failure(chosen.error());
    Floating floating = inAir(session, *chosen, labelOf(kind));
    floating.kind = kind;
    floating.selects = chosen->selected;
    floating.from = std::move(chosen->voxels);
    // What is moved goes where it is taken; what grows stays within the artist's limits.
    if (kind != Floating::Kind::move && settings.options.limited) {
        floating.limits = settings.options.limits;
    }
    session.selection().setFloating(std::move(floating));
    return {};
}

bool clipFits(const Session& session) {
    const auto& [clip, palette] = session.fitted();
    if (!clip || *palette == session.document().palette) return true;
    return matchColours(clip->voxels, *palette, session.document()).isIdentity();
}

Status fitClip(Session& session, std::string& said) {
    if (!session.clip() || clipFits(session)) return {};
    const auto& [copied, palette] = session.copied();
    const ColourMatch match = matchColours(copied->voxels, *palette, session.document());
    VoxelClip clip{recoloured(copied->voxels, match.indexOf), copied->modelFromClip};
    if (match.added > 0) {
        said = colourCount(match.added) + " added to the palette";
        Status added = session.perform(
            makeAction("Add " + colourCount(match.added),
                       PaletteEdit{Boxed(session.document().palette), Boxed(match.palette)}));
        if (!added) return added;
    }
    if (match.approximated > 0) {
        said += (said.empty() ? "" : "; ") + std::string("the palette is full: ") +
                colourCount(match.approximated) + " became the nearest there is";
    }
    session.setFittedClip(std::move(clip));
    return {};
}

Status pasteClip(Session& session) {
    if (!session.clip()) return fail("Copy something first");
    const Result<EditTarget> target = EditTarget::of(session, session.activeNode());
    if (!target) return Failure(target.error());
    Floating floating;
    floating.label = "Paste";
    floating.node = target->node();
    floating.model = target->model();
    floating.entityFromModel = target->modelFromEntity().inverse();
    floating.clip = *session.clip();
    floating.home = floating.bounds().min;
    session.selection().setFloating(std::move(floating));
    return {};
}

Status duplicateSelection(Session& session) {
    const Result<Chosen> chosen = chosenVoxels(session);
    if (!chosen) return Failure(chosen.error());
    Floating floating = inAir(session, *chosen, "Duplicate voxels");
    floating.moveBy({floating.bounds().size().x, 0, 0});
    session.selection().setFloating(std::move(floating));
    return {};
}

namespace {

Action land(Session& session) {
    VoxelSelection& selection = session.selection();
    // It floats until the action has been carried out.
    const auto patch = [&selection](const Document& document) -> Result<VoxelPatch> {
        if (!selection.floating()) return fail("Nothing is in the air any more");
        return selection.floating()->patch(document);
    };
    Action action = makeActionLater(selection.floating()->label, [patch](const Document& document) {
        return onePatch(patch(document));
    });
    session.setActiveNode(selection.floating()->node);
    selection.landWithNextStep();
    return action;
}

}  // namespace

Result<std::optional<Action>> putDown(Session& session) {
    if (!session.selection().floating()) return std::optional<Action>();
    if (session.selection().floating()->isLarge()) return std::optional<Action>(land(session));
    const Floating floating = *session.selection().floating();
    Result<VoxelPatch> patch = floating.patch(session.document());
    if (!patch) return Failure(patch.error());
    session.selection().setFloating(std::nullopt);
    if (patch->changes.empty()) return std::optional<Action>();
    if (floating.selects) {
        Result<VoxelSet> footprint = floating.footprint();
        if (!footprint) return Failure(footprint.error());
        session.selection().selectWithNextStep(floating.node, floating.model,
                                               std::move(*footprint));
    }
    session.setActiveNode(floating.node);
    return std::optional<Action>(makeAction(floating.label, std::move(*patch)));
}

Result<Action> deleteSelection(const Session& session, const char* verb) {
    const Result<Chosen> chosen = chosenVoxels(session);
    if (!chosen) return Failure(chosen.error());
    const std::uint64_t count = chosen->voxels.count();
    return editOf(session, verb + (" " + voxelCount(count)), count,
                  patchOfSet(chosen->model, chosen->voxels, EditMode::erase, 0));
}

Result<Action> recolourSelection(const Session& session, std::uint8_t colour) {
    const Result<Chosen> chosen = chosenVoxels(session);
    if (!chosen) return Failure(chosen.error());
    const std::uint64_t count = chosen->voxels.count();
    return editOf(session, "Recolour " + voxelCount(count), count,
                  patchOfSet(chosen->model, chosen->voxels, EditMode::paint, colour));
}

Result<Action> cropToSelection(const Session& session) {
    const Result<Chosen> chosen = chosenVoxels(session);
    if (!chosen) return Failure(chosen.error());
    const auto keep = std::make_shared<const VoxelSet>(chosen->voxels);
    return editOf(session, "Crop to the selection",
                  gridOf(session, chosen->model).solidCount() - keep->count(),
                  [keep, model = chosen->model](const Document& document) {
                      return patchCrop(document, model, *keep);
                  });
}

Result<Action> trimToBox(const Session& session, const IBox& entityBox) {
    const Result<Chosen> chosen = chosenVoxels(session);
    if (!chosen) return Failure(chosen.error());
    const IBox box = chosen->entityFromModel.inverse().applyToBox(entityBox);
    // Of the selection, if there is one, only what is selected goes.
    VoxelSet beyond = chosen->voxels;
    beyond.subtract(selectBox(gridOf(session, chosen->model), box));
    const std::uint64_t count = beyond.count();
    return editOf(session, "Trim to the limits", count,
                  patchOfSet(chosen->model, std::move(beyond), EditMode::erase, 0));
}

Result<Action> selectionToObject(const Session& session) {
    const Result<Chosen> chosen = chosenVoxels(session);
    if (!chosen) return Failure(chosen.error());
    const Document& document = session.document();
    Action action = addObject(document, freeName("Part", document.nodes));
    auto& scene = std::get<SceneEdit>(action.parts.front());
    // In the space of the model that they come from, and where that lies: none has to be moved.
    VoxelClip clip = clipOf(session, *chosen);
    scene.addedModels.front().voxels = std::move(clip.voxels);
    const Placement entityFromRoot = placementAt(document.nodes.front(), session.frame());
    scene.after.nodes.back().placements.front().placement =
        entityFromRoot.inverse() * clip.modelFromClip;
    Result<Action> taken = editOf(session, "To a new object", chosen->voxels.count(),
                                  patchOfSet(chosen->model, chosen->voxels, EditMode::erase, 0));
    if (!taken) return taken;
    taken->parts.insert(taken->parts.begin(), std::move(action.parts.front()));
    return taken;
}

}  // namespace voxprite::editor
