#include "app/editor/views/sprite_scene.h"

#include <algorithm>
#include <cmath>

namespace voxprite::editor {
namespace {

// The edited model grows while it is drawn: room is made in steps of an eighth of an octave, so
// that the copies do not shift with every voxel.
double inSteps(double reach) {
    return reach > 0.0 ? std::exp2(std::ceil(std::log2(reach) * 8.0) / 8.0) : 0.0;
}

PlacedEntity placedOnGround(const Entity& entity, const IBox& bounds, const GameProfile& profile) {
    PlacedEntity placed = placeEntity(entity, bounds, profile);
    placed.anchorMetres.y += groundClearanceMetres(profile);
    return placed;
}

}  // namespace

std::vector<Error> SpriteScene::follow(const Session& session, const SceneSettings& settings) {
    std::vector<Error> problems;
    const bool wanted = settings.copies.pattern != CopyPattern::none;
    // Files are read only once they are to be shown.
    if (wanted) problems = extras_.follow(settings.extras);

    const Document& document = session.document();
    const GameProfile& profile = session.profile();
    std::vector<CopySubject> subjects{
        {inSteps(reachMetres(placeEntity(document.entity, session.bounds(), profile))),
         settings.copies.editedUsed}};
    subjects_ = {nullptr};
    for (const ExtraModelChoice& choice : settings.extras) {
        const ExtraModel* extra = wanted ? extras_.find(choice) : nullptr;
        if (extra == nullptr) continue;
        subjects_.push_back(extra);
        subjects.push_back(
            {reachMetres(placeEntity(extra->entity, extra->bounds, profile)), choice.used});
    }
    // Some model there has to be.
    if (std::ranges::none_of(subjects, &CopySubject::used)) subjects.front().used = true;

    if (arrangedFor_ != settings.copies || arrangedSubjects_ != subjects ||
        extrasRevision_ != extras_.revision()) {
        formation_ = arrangeCopies(settings.copies, subjects);
        arrangedFor_ = settings.copies;
        arrangedSubjects_ = std::move(subjects);
        extrasRevision_ = extras_.revision();
        ++arrangement_;
        ++revision_;
    }
    return problems;
}

bool SpriteScene::moves(const SceneSettings& settings) const {
    return walks(settings) || (!formation_.copies.empty() && extras_.animated());
}

void SpriteScene::advance(double seconds, const Session& session, const SceneSettings& settings) {
    if (!moves(settings)) return;
    const std::vector<const GpuOctree*> before = extraFrames();
    seconds_ += seconds;
    if (walks(settings)) {
        const PlacedEntity placed =
            placeEntity(session.document().entity, session.bounds(), session.profile());
        const double height = placed.modelSize.z * placed.metresPerVoxel();
        walkedMetres_ =
            std::fmod(walkedMetres_ + settings.pace * height * seconds, formation_.loopMetres);
    }
    if (walks(settings) || extraFrames() != before) ++revision_;
}

std::vector<const GpuOctree*> SpriteScene::extraFrames() const {
    std::vector<const GpuOctree*> frames;
    for (const ExtraModel* extra : subjects_) {
        if (extra != nullptr) frames.push_back(&extra->at(seconds_));
    }
    return frames;
}

Scene SpriteScene::make(const Session& session, const GpuOctree& edited, const ViewSettings& view,
                        const GameProfile& profile, std::span<ViewHistory> histories) {
    const Document& document = session.document();
    Scene scene;
    scene.background = Rgba8(120, 150, 190, 255);
    scene.sky = true;
    scene.ground = Ground{};
    scene.groundGrid = view.groundGrid;
    scene.shadowBlobs = view.shadow;

    struct Subject {
        const GpuOctree* octree;
        const Palette* palette;
        PlacedEntity placed;
        PlacedEntity shadow;
    };
    // Shadows do not follow an edit that is only being shown.
    const double raised = groundClearanceMetres(profile) - groundClearanceMetres(session.profile());
    Subject own{&edited, &session.shownPalette(), session.placedInGame(), session.madeInGame()};
    own.placed.anchorMetres.y += raised;
    own.shadow.anchorMetres.y += raised;
    std::vector<Subject> subjects{own};
    for (const ExtraModel* extra : subjects_) {
        if (extra == nullptr) continue;
        Entity entity = extra->entity;
        entity.yawDegrees = document.entity.yawDegrees;
        entity.positionMetres = document.entity.positionMetres;
        const PlacedEntity placed = placedOnGround(entity, extra->bounds, profile);
        subjects.push_back({&extra->at(seconds_), &extra->palette, placed, placed});
    }
    shadows_.resize(entityCount());
    scene.entities.reserve(entityCount());
    const auto add = [&](const Subject& subject, const SceneCopy& copy) {
        const std::size_t number = scene.entities.size();
        const double facing = document.entity.yawDegrees;
        shadows_[number] = standing(subject.shadow, copy, facing);
        scene.entities.push_back({subject.octree, subject.palette,
                                  standing(subject.placed, copy, facing), &histories[number],
                                  &shadows_[number]});
    };
    add(own, SceneCopy{});
    for (const SceneCopy& copy : formation_.copies) {
        add(subjects[static_cast<std::size_t>(copy.subject)],
            walked(copy, formation_, walkedMetres_));
    }
    return scene;
}

std::vector<LevelSource> SpriteScene::levelSources(const Session& session,
                                                   const GpuOctree& edited) const {
    std::vector<LevelSource> sources;
    // Revisions of documents and of octrees are counted apart: even and odd numbers.
    if (!session.bounds().empty()) {
        sources.push_back({2 * session.contentsRevision(), session.frame(), &edited,
                           &session.shownPalette(), session.madeInGame(),
                           [&session] { return session.octree().canonical(session.bounds()); }});
    }
    for (const ExtraModel* extra : subjects_) {
        if (extra == nullptr || formation_.copies.empty()) continue;
        const GpuOctree& shown = extra->at(seconds_);
        const auto frame = static_cast<std::size_t>(
            std::ranges::find(extra->frames, &shown, [](const GpuOctree& each) { return &each; }) -
            extra->frames.begin());
        sources.push_back(
            {2 * extra->frames.front().revision() + 1, static_cast<int>(frame), &shown,
             &extra->palette, placedOnGround(extra->entity, extra->bounds, session.profile()),
             [octree = &extra->octrees[frame]]() -> Result<Octree> { return *octree; }});
    }
    return sources;
}

}  // namespace voxprite::editor
