#include "app/editor/session/session.h"

#include <algorithm>
#include <utility>

#include "core/sprite/view_axes.h"

namespace voxprite::editor {
namespace {

// An octree is sooner built anew than changed in so many places, if they are much of the model.
constexpr std::size_t kManyVoxels = 50'000;

// Of ascending changes; null where there is none.
const VoxelChange* changeAt(const std::vector<VoxelChange>& changes, glm::ivec3 position) {
    const auto comesBefore = [](glm::ivec3 a, glm::ivec3 b) {
        if (a.x != b.x) return a.x < b.x;
        return a.y != b.y ? a.y < b.y : a.z < b.z;
    };
    const auto found =
        std::ranges::lower_bound(changes, position, comesBefore, &VoxelChange::position);
    return found != changes.end() && found->position == position ? &*found : nullptr;
}

}  // namespace

Session::Session() {
    workspace_.profile.viewStepDegrees = kUsualViewStepDegrees;
    savedProfile_ = workspace_.profile;
    // An empty model always fits.
    static_cast<void>(rebuild());
    chooseActiveNode();
    followPalette();
}

Status Session::perform(Action action) {
    if (action.makePatches) {
        Result<std::shared_ptr<Prepared>> prepared = prepare(std::move(action), {});
        if (!prepared) {
            dropPrepared();
            return Failure(prepared.error());
        }
        commit(std::move(**prepared));
        return {};
    }
    const std::size_t position = history_.position();
    Status followed;
    const Changed changed = history_.execute(workspace_, std::move(action), following(followed));
    if (changed.any()) {
        selection_.stepMade(position, history_.position() == position + 1, changed);
        arrive(changed);
    }
    return followed;
}

Status Session::undo() {
    const std::size_t position = history_.position();
    Status followed;
    const Changed changed = history_.undo(workspace_, following(followed));
    if (changed.any()) {
        selection_.wentTo(position, history_.position(), changed);
        arrive(changed);
    }
    return followed;
}

Status Session::redo() {
    const std::size_t position = history_.position();
    Status followed;
    const Changed changed = history_.redo(workspace_, following(followed));
    if (changed.any()) {
        selection_.wentTo(position, history_.position(), changed);
        arrive(changed);
    }
    return followed;
}

History::Follow Session::following(Status& first) {
    // Told again on the way back, from where it fits; what went wrong was said before.
    return [this, &first](const Changed& changed) {
        Status followed = follow(changed);
        if (first) first = followed;
        return followed;
    };
}

void Session::arrive(const Changed& changed) {
    activeNode_ = changed.nodeNow(activeNode_);
    chooseActiveNode();
    selection_.follow(document(), changed);
}

Status Session::follow(const Changed& changed) {
    if (!changed.any()) return {};
    ++revision_;
    if (changed.scene || changed.palette || !changed.voxels.empty()) {
        ++modelRevision_;
        ++contentsRevision_;
    }
    if (changed.palette) followPalette();
    for (const Changed::Voxels& voxels : changed.voxels) reviseVoxels(voxels.model);
    if (changed.scene) return rebuild();
    for (const Changed::Voxels& voxels : changed.voxels) {
        if (Status followed = followVoxels(voxels); !followed) return followed;
    }
    return {};
}

void Session::reviseVoxels(int model) {
    const auto index = static_cast<std::size_t>(model);
    // A model that the step has added gets its first one with the others.
    if (index < voxelRevisions_.size()) voxelRevisions_[index] = ++lastVoxelRevision_;
}

void Session::setClip(VoxelClip clip) {
    copied_ = fitted_ = {std::make_shared<const VoxelClip>(std::move(clip)),
                         std::make_shared<const Palette>(document().palette)};
}

void Session::setFittedClip(VoxelClip clip) {
    fitted_ = {std::make_shared<const VoxelClip>(std::move(clip)),
               std::make_shared<const Palette>(document().palette)};
}

void Session::showVariant(std::optional<std::size_t> variant) {
    variant_ = variant;
    ++revision_;
    ++modelRevision_;
    followPalette();
}

void Session::followPalette() {
    const Palette& palette = document().palette;
    if (variant_ && *variant_ >= palette.variants.size()) variant_.reset();
    shownPalette_ = variant_ ? palette.withVariant(*variant_) : palette;
}

Status Session::followVoxels(const Changed::Voxels& changed) {
    const std::size_t many = changed.positions.size();
    const auto rebuild = [&]() -> Status {
        Status rebuilt = octree_.rebuild(flatten(workspace_.document, frame_));
        if (!rebuilt) return rebuilt;
        bounds_ = frames_ == 1 ? octree_.solidBounds() : entityBounds(workspace_.document);
        shown_.reset(octree_);
        return {};
    };
    if (many > kManyVoxels && many > octree_.solidCount() / 64) return rebuild();
    std::vector<LiveOctree::Edit> edits;
    // Where no other object may lie over it or under it, the model itself says what shows.
    const bool alone = sampler_->instances().size() == 1;
    const VoxelGrid::Reader reader(
        workspace_.document.models[static_cast<std::size_t>(changed.model)].voxels);
    for (const Instance& instance : sampler_->instances()) {
        if (instance.model != changed.model) continue;
        edits.reserve(edits.size() + many);
        for (const glm::ivec3 position : changed.positions) {
            const glm::ivec3 voxel = instance.entityFromModel.applyToVoxel(position);
            edits.push_back({voxel, alone ? reader.get(position) : sampler_->at(voxel)});
        }
    }
    // Edits may reach too far together with what they empty: voxels that move a long way.
    if (!octree_.apply(edits)) return rebuild();
    growOrShrinkBounds(changed);
    shown_.follow(octree_, edits);
    return {};
}

void Session::growOrShrinkBounds(const Changed::Voxels& changed) {
    const auto model = static_cast<std::size_t>(changed.model);
    const VoxelGrid::Reader reader(workspace_.document.models[model].voxels);
    IBox grown = bounds_;
    bool mayShrink = false;
    for (const Placement& place : placesOfModel_[model]) {
        for (const glm::ivec3 position : changed.positions) {
            const glm::ivec3 voxel = place.applyToVoxel(position);
            if (reader.get(position) != 0) {
                grown = grown.united(IBox::around(voxel, voxel));
            } else if (!grown.empty()) {
                const IBox inner{grown.min + 1, grown.max - 1};
                mayShrink = mayShrink || !inner.contains(voxel);
            }
        }
    }
    if (!mayShrink) {
        bounds_ = grown;
    } else {
        // With one frame the octree knows, and much sooner.
        bounds_ = frames_ == 1 ? octree_.solidBounds() : entityBounds(workspace_.document);
    }
}

std::uint8_t Session::valueWith(const std::vector<VoxelPatch>& patches,
                                glm::ivec3 entityVoxel) const {
    const auto& all = instances();
    for (auto instance = all.rbegin(); instance != all.rend(); ++instance) {
        const glm::ivec3 position = instance->entityFromModel.inverse().applyToVoxel(entityVoxel);
        const auto model = static_cast<std::size_t>(instance->model);
        std::uint8_t value = document().models[model].voxels.get(position);
        for (const VoxelPatch& patch : patches) {
            if (patch.model != instance->model) continue;
            if (const VoxelChange* change = changeAt(patch.changes, position))
                value = change->after;
        }
        if (value != 0) return value;
    }
    return 0;
}

Status Session::preview(const std::vector<VoxelPatch>& patches) {
    std::vector<LiveOctree::Edit> edits;
    for (const Instance& instance : instances()) {
        for (const VoxelPatch& patch : patches) {
            if (patch.model != instance.model) continue;
            edits.reserve(edits.size() + patch.changes.size());
            for (const VoxelChange& change : patch.changes) {
                const glm::ivec3 voxel = instance.entityFromModel.applyToVoxel(change.position);
                // Where no other object may lie over it or under it, the patch itself says.
                const bool alone = instances().size() == 1 && patches.size() == 1;
                edits.push_back({voxel, alone ? change.after : valueWith(patches, voxel)});
            }
        }
    }
    return shown_.preview(octree_, std::move(edits));
}

void Session::clearPreview() {
    if (previews()) shown_.follow(octree_, {});
}

OctreeChanges Session::takeOctreeChanges() {
    // Nobody keeps a copy of the document's own octree.
    static_cast<void>(octree_.takeChanges());
    return shown_.takeChanges();
}

Result<Session::Derived> Session::derive(const Document& document, int frame) {
    Derived derived;
    if (Status built = derived.octree.rebuild(flatten(document, frame)); !built) {
        return Failure(built.error());
    }
    derived.shown.reset(derived.octree);
    derived.bounds = entityBounds(document);
    derived.frames = frameCount(document);
    derived.placesOfModel.resize(document.models.size());
    for (int each = 0; each < derived.frames; ++each) {
        for (const Instance& instance : instancesOf(document, each)) {
            auto& places = derived.placesOfModel[static_cast<std::size_t>(instance.model)];
            if (std::ranges::find(places, instance.entityFromModel) == places.end()) {
                places.push_back(instance.entityFromModel);
            }
        }
    }
    return derived;
}

void Session::install(Derived derived) {
    octree_ = std::move(derived.octree);
    shown_ = std::move(derived.shown);
    bounds_ = derived.bounds;
    frames_ = derived.frames;
    placesOfModel_ = std::move(derived.placesOfModel);
    const std::size_t models = document().models.size();
    voxelRevisions_.resize(std::min(voxelRevisions_.size(), models));
    while (voxelRevisions_.size() < models) voxelRevisions_.push_back(++lastVoxelRevision_);
    sampler_.emplace(workspace_.document, frame_);
}

Status Session::rebuild() {
    const int frame = std::clamp(frame_, 0, frameCount(document()) - 1);
    Result<Derived> derived = derive(document(), frame);
    if (!derived) return Failure(derived.error());
    frame_ = frame;
    install(std::move(*derived));
    return {};
}

Status Session::setFrame(int frame) {
    if (frame == frame_ || frame < 0 || frame >= frames_) return {};
    const int before = std::exchange(frame_, frame);
    ++revision_;
    ++modelRevision_;
    Status rebuilt = octree_.rebuild(flatten(workspace_.document, frame_));
    if (!rebuilt) {
        frame_ = before;
        return rebuilt;
    }
    shown_.reset(octree_);
    sampler_.emplace(workspace_.document, frame_);
    return {};
}

void Session::chooseActiveNode() {
    const auto& nodes = document().nodes;
    const auto isObject = [&](int node) {
        return node >= 0 && static_cast<std::size_t>(node) < nodes.size() &&
               !nodes[static_cast<std::size_t>(node)].isGroup();
    };
    if (isObject(activeNode_)) return;
    activeNode_ = -1;
    if (!instances().empty()) {
        activeNode_ = instances().back().node;
        return;
    }
    const auto object = std::ranges::find_if(nodes, [](const auto& n) { return !n.isGroup(); });
    if (object != nodes.end()) activeNode_ = static_cast<int>(object - nodes.begin());
}

void Session::setActiveNode(int node) {
    activeNode_ = node;
    chooseActiveNode();
}

std::optional<Instance> Session::activeInstance() const {
    const auto& all = instances();
    const auto found = std::ranges::find(all, activeNode_, &Instance::node);
    if (found == all.end()) return std::nullopt;
    return *found;
}

int Session::nodeAt(glm::ivec3 entityVoxel) const {
    const auto& all = instances();
    for (auto instance = all.rbegin(); instance != all.rend(); ++instance) {
        const auto model = static_cast<std::size_t>(instance->model);
        const glm::ivec3 position = instance->entityFromModel.inverse().applyToVoxel(entityVoxel);
        if (document().models[model].voxels.get(position) != 0) return instance->node;
    }
    return -1;
}

PlacedEntity Session::madeInGame() const {
    PlacedEntity placed = placeEntity(document().entity, bounds_, profile());
    placed.anchorMetres.y += groundClearanceMetres(profile());
    return placed;
}

PlacedEntity Session::placedInGame() const {
    PlacedEntity placed = madeInGame();
    const IBox shown = shownBounds();
    placed.modelSize = shown.empty() ? glm::ivec3(0) : shown.size();
    placed.anchor = anchorVoxels(document().entity, bounds_) - glm::dvec3(shown.min);
    return placed;
}

PlacedEntity Session::placedForEditing(const IBox& box) {
    PlacedEntity placed = placeEntity(Entity{}, box, GameProfile{});
    placed.anchor = -glm::dvec3(box.min);
    placed.anchorMetres = glm::dvec3(0.0);
    placed.voxelSizeMetres = 1.0;
    return placed;
}

}  // namespace voxprite::editor
