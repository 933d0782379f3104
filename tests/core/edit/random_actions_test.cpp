// Ten thousand actions of every kind, at random: undone they leave no trace, redone they are all
// there again, and the octree that follows them voxel by voxel is the one baked anew.
#include <gtest/gtest.h>

#include <vector>

#include "core/edit/brush.h"
#include "core/edit/clip.h"
#include "core/edit/faces.h"
#include "core/edit/make_action.h"
#include "core/edit/palette_edits.h"
#include "core/edit/regions.h"
#include "core/edit/reshape.h"
#include "core/edit/scene_edits.h"
#include "core/edit/selection.h"
#include "core/edit/shapes.h"
#include "core/edit/socket_edits.h"
#include "core/edit/symmetry.h"
#include "core/edit/transforms.h"
#include "core/model/entity_voxels.h"
#include "core/model/voxel_morphology.h"
#include "core/svo/bake.h"
#include "core/svo/live_octree.h"
#include "tests/support/random.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::Random;

constexpr int kActions = 10'000;
constexpr int kChecked = 100;  // the octree is compared at every so many steps
// Where edits happen, so that the models stay small and keep being edited again.
constexpr IBox kCanvas{{-2, -2, -2}, {12, 12, 12}};

// An octree kept as the editor keeps it.
class FollowingOctree {
  public:
    explicit FollowingOctree(const Document& document) : document_(document) { rebuild(); }

    void follow(const Changed& changed) {
        if (changed.scene) {
            rebuild();
            return;
        }
        const EntitySampler sampler(document_, 0);
        std::vector<LiveOctree::Edit> edits;
        for (const Changed::Voxels& voxels : changed.voxels) {
            for (const Instance& instance : sampler.instances()) {
                if (instance.model != voxels.model) continue;
                for (const glm::ivec3 v : voxels.positions) {
                    const glm::ivec3 at = instance.entityFromModel.applyToVoxel(v);
                    edits.push_back({at, sampler.at(at)});
                }
            }
        }
        ASSERT_TRUE(octree_.apply(edits));
    }

    void expectBaked() const {
        const IBox bounds = entityBounds(document_);
        const Octree baked = bake(flatten(document_, 0), bounds).value();
        ASSERT_EQ(octree_.canonical(bounds).value(), baked);
    }

  private:
    void rebuild() { ASSERT_TRUE(octree_.rebuild(flatten(document_, 0))); }

    const Document& document_;
    LiveOctree octree_;
};

// An artist without a plan.
class Artist {
  public:
    explicit Artist(std::uint64_t seed) : random_(seed) {}

    Action next(const Workspace& workspace) {
        const Document& document = workspace.document;
        model_ = random_.between(0, static_cast<int>(document.models.size()) - 1);
        const int kind = random_.between(0, 19);
        if (kind < 16) return voxelAction(document, kind);
        return otherAction(workspace, kind);
    }
    // Nothing merges into the last step any more.
    void liftTheBrush() { ++mergeKey_; }

  private:
    [[nodiscard]] glm::ivec3 somewhere() { return random_.voxel(-2, 11); }
    [[nodiscard]] std::uint8_t colour() { return static_cast<std::uint8_t>(random_.between(1, 5)); }
    // Building more often than not, else little would be left to edit.
    [[nodiscard]] EditMode mode() {
        return random_.chance(0.4) ? EditMode::attach
                                   : static_cast<EditMode>(random_.between(0, 2));
    }
    // Most of the time a solid voxel, since that is what artists click on.
    [[nodiscard]] glm::ivec3 solid(const VoxelGrid& voxels) {
        glm::ivec3 v = somewhere();
        for (int tries = 0; tries < 50 && voxels.get(v) == 0; ++tries) v = somewhere();
        return v;
    }
    // The voxel that is met first on the way against `normal`.
    [[nodiscard]] glm::ivec3 exposed(const VoxelGrid& voxels, glm::ivec3 normal) {
        glm::ivec3 v = somewhere() + normal * 18;
        for (int i = 0; i < 36 && voxels.get(v) == 0; ++i) v -= normal;
        return v;
    }
    [[nodiscard]] glm::ivec3 direction() {
        glm::ivec3 normal(0);
        normal[random_.between(0, 2)] = random_.chance(0.5) ? 1 : -1;
        return normal;
    }
    [[nodiscard]] Symmetry symmetry() {
        return {{random_.chance(0.3), random_.chance(0.2), random_.chance(0.1)},
                random_.voxel(6, 14)};
    }
    [[nodiscard]] IBox smallBox(int edge) {
        const glm::ivec3 corner = somewhere();
        return {corner, corner + random_.voxel(1, edge)};
    }
    [[nodiscard]] VoxelSet shape() {
        const Shape shape{static_cast<ShapeKind>(random_.between(0, 2)), smallBox(9),
                          random_.between(0, 2), random_.chance(0.3)};
        return mirrored(shapeVoxels(shape).value(), symmetry());
    }

    Action voxelAction(const Document& document, int kind) {
        const VoxelGrid& voxels = document.models[static_cast<std::size_t>(model_)].voxels;
        const EditLimits limits{kCanvas, nullptr};
        const auto action = [](const char* label, Result<VoxelPatch> patch,
                               std::uint64_t mergeKey = 0) {
            return makeAction(label, std::move(patch).value(), mergeKey);
        };
        const auto withSet = [&](const char* label, const VoxelSet& set, EditMode how) {
            return action(label, patchSet(document, model_, set, how, colour(), limits));
        };
        const RegionRule rule{random_.chance(0.5) ? Neighbours::six : Neighbours::twentySix,
                              random_.chance(0.6)};
        switch (kind) {
            case 0:
            case 1: {  // a stroke, in several parts that merge
                const BrushTip tip{static_cast<TipShape>(random_.between(0, 2)),
                                   random_.between(1, 5), random_.between(0, 2)};
                BrushTrail trail(tip);
                trail.startAt(somewhere());
                const std::vector<glm::ivec3> fresh = trail.lineTo(somewhere());
                if (random_.chance(0.5)) liftTheBrush();
                return action("stroke",
                              patchVoxels(document, model_, mirrored(fresh, symmetry()), mode(),
                                          colour(), limits),
                              mergeKey_);
            }
            case 2:
            case 3:
                return withSet("shape", shape(), mode());
            case 4:
                return withSet("fill", connectedRegion(voxels, solid(voxels), rule).value(),
                               random_.chance(0.98) ? EditMode::paint : EditMode::erase);
            case 5: {
                const glm::ivec3 seed = somewhere();
                const IBox around{seed - random_.voxel(0, 5), seed + random_.voxel(1, 5)};
                const int axis = random_.between(0, 2);
                return withSet("plane", planeRegion(voxels, seed, axis, around).value(),
                               EditMode::attach);
            }
            case 6: {
                const glm::dvec3 from = glm::dvec3(somewhere()) + 0.37;
                const std::vector<glm::ivec3> ray =
                    voxelsAlongRay(from, glm::dvec3(somewhere()) - from, kCanvas);
                return action("laser",
                              patchVoxels(document, model_, ray, EditMode::erase, 0, limits));
            }
            case 7:
            case 8: {
                const glm::ivec3 normal = direction();
                const VoxelSet face =
                    faceRegion(voxels, exposed(voxels, normal), normal, rule).value();
                const MovedFace moved{face, normal};
                return action("face", patchFaces(document, model_, {&moved, 1},
                                                 random_.between(-3, 3), {}, limits));
            }
            case 9:
            case 10: {  // moved, turned, flipped, scaled
                const VoxelSet from = selectBox(voxels, smallBox(10));
                VoxelClip clip = copyVoxels(voxels, from);
                moveBy(clip, random_.voxel(-5, 5));
                turn(clip, random_.between(0, 2), random_.between(0, 3));
                if (random_.chance(0.3)) flip(clip, random_.between(0, 2));
                const int factor = random_.chance(0.1) ? 2 : 1;
                EXPECT_TRUE(scale(clip, factor));
                return action("move",
                              patchMove(document, model_, from, clip, PasteRule::over, limits));
            }
            case 11: {
                VoxelClip clip = copyVoxels(voxels, voxelsOfColour(voxels, colour()));
                moveBy(clip, random_.voxel(-5, 5));
                const auto paste = random_.chance(0.5) ? PasteRule::over : PasteRule::under;
                return action("stamp", patchPaste(document, model_, clip, paste, limits));
            }
            case 12: {
                const VoxelSet only = selectBox(voxels, smallBox(20));
                return action("recolour",
                              patchSet(document, model_, voxelsOfColour(voxels, colour()),
                                       EditMode::paint, colour(), {kCanvas, &only}));
            }
            case 13: {
                // What a rectangle on a turned view might hold.
                const HalfSpace corner{{1.0, 1.0, 0.0}, 15.5};
                const VoxelSet only = selectInside(voxels, {&corner, 1});
                return action("delete", patchSet(document, model_,
                                                 combined(only, shape(), SelectMode::intersect),
                                                 EditMode::erase, 0));
            }
            case 14:
                switch (random_.between(0, 3)) {
                    case 0:
                        return reshaped("hollow", document, hollowed(voxels, 2), limits);
                    case 1:
                        return reshaped("dilate", document, dilated(voxels, 1), limits);
                    case 2:
                        return reshaped("erode", document, eroded(voxels, 1), limits);
                    default:
                        return reshaped("smooth", document, smoothed(voxels, 1), limits);
                }
            default:
                if (random_.chance(0.02)) {
                    return action("crop", patchCrop(document, model_, VoxelSet(smallBox(18))));
                }
                VoxelClip whole{voxels, {}};
                moveBy(whole, offsetToGround(voxels.bounds()));
                return action("ground", patchMove(document, model_, selectAll(voxels), whole));
        }
    }

    Action reshaped(const char* label, const Document& document, Result<VoxelGrid> after,
                    const EditLimits& limits) {
        const VoxelSet all = selectAll(document.voxelsOf(model_));
        const VoxelClip clip{std::move(after.value()), {}};
        return makeAction(label,
                          patchMove(document, model_, all, clip, PasteRule::under, limits).value());
    }

    Action otherAction(const Workspace& workspace, int kind) {
        const Document& document = workspace.document;
        const int node = random_.between(1, static_cast<int>(document.nodes.size()) - 1);
        switch (kind) {
            case 16: {
                Palette palette =
                    withColour(document.palette, {}, colour(),
                               {static_cast<std::uint8_t>(random_.between(0, 255)), 90, 30, 255});
                return makeAction("colour", PaletteEdit{{}, Boxed<Palette>(std::move(palette))});
            }
            case 17: {
                Entity entity = document.entity;
                entity.anchorVoxels = glm::dvec3(somewhere());
                entity.yawDegrees = random_.between(0, 359);
                return makeAction("anchor", EntityEdit{{}, entity});
            }
            case 18: {
                GameProfile profile = workspace.profile;
                profile.sigma = random_.between(1, 16);
                return makeAction("sigma", ProfileEdit{{}, profile});
            }
            default:
                switch (random_.between(0, 5)) {
                    case 0:
                        return document.nodes.size() > 6
                                   ? deleteNodes(document, std::vector<int>{node})
                                   : duplicateNode(document, node,
                                                   random_.chance(0.2) ? Copy::own : Copy::linked);
                    case 1:
                        return rename(document, node, "n" + std::to_string(random_.next() % 100));
                    case 2:
                        return turnNode(document, node, 0, random_.between(0, 2), 1);
                    case 3:
                        return moveObject(document, node, random_.voxel(-6, 6), 0);
                    case 4:
                        return addSocket(document, glm::dvec3(somewhere()));
                    default:
                        return setHidden(document, node, random_.chance(0.3));
                }
        }
    }

    Random random_;
    int model_ = 0;
    std::uint64_t mergeKey_ = 1;
};

TEST(RandomActions, TenThousandUndoAndRedoExactly) {
    Workspace workspace;
    workspace.document = test::documentOf(test::figure());
    workspace.document.models[0].voxels.set({0, 0, 40}, 1);
    const Workspace start = workspace;
    History history;
    Artist artist(2024);
    FollowingOctree octree(workspace.document);

    // The document after some of the steps, for the way back and forth.
    struct Milestone {
        std::size_t position;
        Document document;
    };
    std::vector<Milestone> milestones;
    std::uint64_t changedVoxels = 0;
    for (int i = 1; i <= kActions; ++i) {
        const Changed changed = history.execute(workspace, artist.next(workspace));
        for (const Changed::Voxels& voxels : changed.voxels) {
            changedVoxels += voxels.positions.size();
        }
        octree.follow(changed);
        if (i % kChecked == 0) octree.expectBaked();
        if (HasFatalFailure()) return;
        if (i % 1000 == 0) {
            ASSERT_TRUE(validate(workspace.document));
            milestones.push_back({history.position(), workspace.document});
            artist.liftTheBrush();
        }
    }
    // It was work: most actions did something, and to many voxels.
    EXPECT_GT(history.steps().size(), 6000u);
    EXPECT_GT(changedVoxels, 200'000u);
    const Workspace end = workspace;

    std::size_t met = 0;
    const auto check = [&](int step) {
        if (step % kChecked == 0) octree.expectBaked();
        for (const Milestone& milestone : milestones) {
            if (milestone.position != history.position()) continue;
            EXPECT_EQ(workspace.document, milestone.document);
            ++met;
        }
    };
    for (int i = 1; history.canUndo() && !HasFatalFailure(); ++i) {
        octree.follow(history.undo(workspace));
        check(i);
    }
    EXPECT_EQ(workspace.document, start.document);
    EXPECT_EQ(workspace.profile, start.profile);
    for (int i = 1; history.canRedo() && !HasFatalFailure(); ++i) {
        octree.follow(history.redo(workspace));
        check(i);
    }
    EXPECT_EQ(workspace.document, end.document);
    EXPECT_EQ(workspace.profile, end.profile);
    EXPECT_EQ(met, 2 * milestones.size() - 1);  // undoing begins below the last one
}

}  // namespace
}  // namespace voxprite
