#include "core/model/entity_voxels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/support/random.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::mapOf;
using test::VoxelMap;

// The entity's frame once more, by plain recursion and one voxel after the other.
VoxelMap plainFlatten(const Document& document, int frame) {
    const auto inTrack = [&](const auto& keys, bool loop) {
        int f = frame;
        while (loop && f > keys.back().frame) f -= keys.back().frame - keys.front().frame + 1;
        while (loop && f < keys.front().frame) f += keys.back().frame - keys.front().frame + 1;
        return f;
    };
    const auto keyAt = [&](const auto& keys, bool loop) {
        auto current = keys.front();
        for (const auto& key : keys) {
            if (key.frame <= inTrack(keys, loop)) current = key;
        }
        return current;
    };
    const auto placementOf = [&](const SceneNode& node) {
        const int f = inTrack(node.placements, node.loopPlacements);
        Placement placement = keyAt(node.placements, node.loopPlacements).placement;
        for (std::size_t k = 0; node.glides && k + 1 < node.placements.size(); ++k) {
            const PlacementKey& key = node.placements[k];
            const PlacementKey& next = node.placements[k + 1];
            if (f < key.frame || f >= next.frame) continue;
            for (int axis = 0; axis < 3; ++axis) {
                const double way =
                    next.placement.translation[axis] - key.placement.translation[axis];
                placement.translation[axis] +=
                    static_cast<int>(std::floor(way * (f - key.frame) / (next.frame - key.frame)));
            }
        }
        return placement;
    };
    VoxelMap map;
    const std::function<void(int, Placement)> draw = [&](int index, Placement entityFromParent) {
        const SceneNode& node = document.nodes[static_cast<std::size_t>(index)];
        if (node.hidden) return;
        if (node.layer >= 0 && document.layers[static_cast<std::size_t>(node.layer)].hidden) return;
        const Placement entityFromNode = entityFromParent * placementOf(node);
        if (!node.models.empty()) {
            const int model = keyAt(node.models, node.loopModels).model;
            for (const auto& [p, value] :
                 mapOf(document.models[static_cast<std::size_t>(model)].voxels)) {
                const glm::ivec3 v =
                    entityFromNode.applyToVoxel({std::get<0>(p), std::get<1>(p), std::get<2>(p)});
                map[{v.x, v.y, v.z}] = value;
            }
        }
        for (const int child : node.children) draw(child, entityFromNode);
    };
    draw(0, Placement{});
    return map;
}

IBox boundsOf(const VoxelMap& map) {
    IBox box;
    for (const auto& [p, value] : map) {
        const glm::ivec3 v(std::get<0>(p), std::get<1>(p), std::get<2>(p));
        box = box.united({v, v + 1});
    }
    return box;
}

TEST(EntityVoxels, FlattensEveryFrameOfABusyDocument) {
    const Document document = test::busyDocument();
    ASSERT_EQ(frameCount(document), 5);
    IBox all;
    for (int frame = 0; frame < 5; ++frame) {
        const VoxelMap expected = plainFlatten(document, frame);
        EXPECT_EQ(mapOf(flatten(document, frame)), expected) << frame;
        EXPECT_EQ(frameBounds(document, frame), boundsOf(expected)) << frame;
        all = all.united(boundsOf(expected));
    }
    EXPECT_EQ(entityBounds(document), all);
    EXPECT_FALSE(entityBounds(document) == frameBounds(document, 0));
}

TEST(EntityVoxels, SamplesAsItFlattens) {
    const Document document = test::busyDocument();
    test::Random random(21);
    for (int frame = 0; frame < 5; ++frame) {
        const VoxelGrid flat = flatten(document, frame);
        const EntitySampler sampler(document, frame);
        flat.forEachSolid(
            [&](glm::ivec3 v, std::uint8_t value) { ASSERT_EQ(sampler.at(v), value); });
        for (int i = 0; i < 3000; ++i) {
            const glm::ivec3 v = random.voxel(-60, 60);
            ASSERT_EQ(sampler.at(v), flat.get(v));
        }
    }
}

TEST(EntityVoxels, TheSamplerSeesLaterEdits) {
    Document document = test::documentOf(test::solidBox({2, 2, 2}));
    const EntitySampler sampler(document, 0);
    document.models[0].voxels.set({7, 7, 7}, 42);
    EXPECT_EQ(sampler.at({7, 7, 7}), 42);
}

TEST(EntityVoxels, LaterObjectsWin) {
    Document document = test::documentOf(test::solidBox({3, 1, 1}, 1));
    document.models.push_back(Model{test::solidBox({3, 1, 1}, 2), {}});
    SceneNode above;
    above.parent = 0;
    above.models = {ModelKey{0, 1}};
    above.placements[0].placement.translation = {1, 0, 0};
    document.nodes.push_back(above);
    document.nodes[0].children = {1, 2};
    EXPECT_EQ(mapOf(flatten(document, 0)),
              (VoxelMap{{{0, 0, 0}, 1}, {{1, 0, 0}, 2}, {{2, 0, 0}, 2}, {{3, 0, 0}, 2}}));
    document.nodes[0].children = {2, 1};
    EXPECT_EQ(mapOf(flatten(document, 0)),
              (VoxelMap{{{0, 0, 0}, 1}, {{1, 0, 0}, 1}, {{2, 0, 0}, 1}, {{3, 0, 0}, 2}}));
}

TEST(EntityVoxels, HiddenThingsShowOnlyWhenAskedFor) {
    const Document document = test::busyDocument();
    const auto names = [&](bool includeHidden) {
        std::vector<std::string> list;
        for (const Instance& instance : instancesOf(document, 0, includeHidden)) {
            list.push_back(document.nodes[static_cast<std::size_t>(instance.node)].name);
        }
        return list;
    };
    EXPECT_EQ(names(false), (std::vector<std::string>{"tumbled letter", "noise", "mirrored letter",
                                                      "letter", "walker", "overlap", "nothing"}));
    EXPECT_EQ(names(true).size(), 9u);
    Document grouped = document;
    grouped.nodes[1].hidden = true;
    EXPECT_EQ(instancesOf(grouped, 0).size(), 4u);
    grouped.nodes[0].hidden = true;
    EXPECT_TRUE(instancesOf(grouped, 0).empty());
    EXPECT_EQ(entityBounds(grouped), IBox{});
}

TEST(EntityVoxels, TracksHoldTheirKeysAndLoop) {
    Document document = test::animationOf(
        {test::solidBox({1, 1, 1}, 1), test::solidBox({1, 1, 1}, 2), test::solidBox({1, 1, 1}, 3)});
    SceneNode& node = document.nodes[1];
    node.models = {{1, 0}, {2, 1}, {4, 2}};
    document.nodes[0].placements.push_back({9, Placement{}});
    ASSERT_EQ(frameCount(document), 10);
    const auto played = [&] {
        std::vector<int> models;
        for (int frame = 0; frame < 10; ++frame) {
            models.push_back(instancesOf(document, frame).at(0).model);
        }
        return models;
    };
    EXPECT_EQ(played(), (std::vector<int>{0, 0, 1, 1, 2, 2, 2, 2, 2, 2}));
    node.loopModels = true;
    // From the first key to the last, before the first as well.
    EXPECT_EQ(played(), (std::vector<int>{2, 0, 1, 1, 2, 0, 1, 1, 2, 0}));
    node.models = {{0, 1}};
    EXPECT_EQ(played(), std::vector<int>(10, 1));
}

TEST(EntityVoxels, AnObjectGlidesFromKeyToKeyAndTurnsAtThem) {
    SceneNode node;
    SignedPermutation turned;
    turned.sign = {-1, -1, 1};
    node.placements = {{1, {{}, {10, -1, 0}}}, {5, {turned, {0, 2, 0}}}, {6, {{}, {9, 9, 9}}}};
    node.glides = true;
    const auto placeAt = [&](int frame) { return placementAt(node, frame).translation; };
    EXPECT_EQ(placeAt(0), glm::ivec3(10, -1, 0));
    EXPECT_EQ(placeAt(1), glm::ivec3(10, -1, 0));
    EXPECT_EQ(placeAt(2), glm::ivec3(7, -1, 0));  // 7.5, -0.25: rounded down
    EXPECT_EQ(placeAt(3), glm::ivec3(5, 0, 0));
    EXPECT_EQ(placeAt(4), glm::ivec3(2, 1, 0));
    EXPECT_EQ(placementAt(node, 4).rotation, SignedPermutation{});
    EXPECT_EQ(placementAt(node, 5), (Placement{turned, {0, 2, 0}}));
    EXPECT_EQ(placeAt(6), glm::ivec3(9, 9, 9));
    EXPECT_EQ(placeAt(60), glm::ivec3(9, 9, 9));
    EXPECT_TRUE(movesBetweenKeys(node));
    // Wherever it takes place, a motion is the same.
    std::vector<glm::ivec3> places;
    for (int frame = 0; frame < 8; ++frame) places.push_back(placeAt(frame));
    for (PlacementKey& key : node.placements) key.placement.translation -= glm::ivec3(20, 5, 3);
    for (int frame = 0; frame < 8; ++frame) {
        EXPECT_EQ(placeAt(frame), places[static_cast<std::size_t>(frame)] - glm::ivec3(20, 5, 3));
    }
    node.placements[1].frame = 2;
    node.placements[2].frame = 3;
    EXPECT_FALSE(movesBetweenKeys(node));
}

// Random tracks, so that every combination of periods is met: no frame's voxels may leave the
// bounds, and the bounds may not be wider than all frames together.
TEST(EntityVoxels, BoundsAreThoseOfAllFrames) {
    test::Random random(22);
    for (int round = 0; round < 200; ++round) {
        Document document =
            test::animationOf({test::solidBox({1, 2, 3}), test::solidBox({4, 1, 1})});
        for (std::size_t i = 0; i < 2; ++i) {
            SceneNode& node = document.nodes[i];
            node.placements.clear();
            int frame = random.between(0, 3);
            for (int k = random.between(1, 4); k > 0; --k) {
                node.placements.push_back({frame, {{}, random.voxel(-30, 30)}});
                frame += random.between(1, 4);
            }
            node.loopPlacements = random.chance(0.7);
            node.glides = random.chance(0.5);
        }
        document.nodes[1].models = {{random.between(0, 2), 0}, {random.between(3, 6), 1}};
        document.nodes[1].loopModels = random.chance(0.7);
        ASSERT_TRUE(validate(document));
        IBox all;
        for (int frame = 0; frame < frameCount(document); ++frame) {
            const VoxelMap seen = plainFlatten(document, frame);
            ASSERT_EQ(mapOf(flatten(document, frame)), seen) << round << ", frame " << frame;
            all = all.united(boundsOf(seen));
        }
        ASSERT_EQ(entityBounds(document), all) << round;
    }
}

TEST(EntityVoxels, AnEmptyDocumentHasOneEmptyFrame) {
    const Document document = Document::withEmptyModel();
    EXPECT_EQ(frameCount(document), 1);
    EXPECT_EQ(entityBounds(document), IBox{});
    EXPECT_TRUE(flatten(document, 0).empty());
    EXPECT_TRUE(flatten(Document{}, 0).empty());
    EXPECT_TRUE(instancesOf(Document{}, 0).empty());
}

TEST(EntityVoxels, TheAnchorIsTheBottomCentreUnlessSet) {
    Entity entity;
    EXPECT_EQ(anchorVoxels(entity, {{0, 0, 0}, {32, 16, 64}}), glm::dvec3(16, 8, 0));
    EXPECT_EQ(anchorVoxels(entity, {{-3, -5, -7}, {2, -4, 0}}), glm::dvec3(-0.5, -4.5, -7));
    EXPECT_EQ(anchorVoxels(entity, IBox{}), glm::dvec3(0, 0, 0));
    entity.anchorVoxels = glm::dvec3(100.5, -3, 7);
    EXPECT_EQ(anchorVoxels(entity, {{0, 0, 0}, {32, 16, 64}}), glm::dvec3(100.5, -3, 7));
}

// The fixture that other rooms rely on to notice turned or mirrored axes.
TEST(EntityVoxels, TheAsymmetricModelDiffersFromAllItsTurnedSelves) {
    const VoxelGrid model = test::asymmetric();
    int same = 0;
    for (int byte = 0; byte < 128; ++byte) {
        const auto rotation = SignedPermutation::fromVoxByte(byte);
        if (!rotation) continue;
        Placement placement{*rotation, {}};
        placement.translation = -placement.applyToBox(model.bounds()).min;
        VoxelGrid turned;
        model.forEachSolid([&](glm::ivec3 v, std::uint8_t value) {
            turned.set(placement.applyToVoxel(v), value);
        });
        same += turned == model;
    }
    EXPECT_EQ(same, 1);
}

}  // namespace
}  // namespace voxprite
