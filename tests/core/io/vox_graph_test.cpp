// The reader on scene graphs: what they may say and what they may not.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/io/vox.h"
#include "core/model/entity_voxels.h"
#include "tests/support/vox_builder.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::VoxBuilder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Document read(const VoxBuilder& builder) {
    const Result<VoxImport> import = readVox(builder.bytes());
    EXPECT_TRUE(import) << import.error().describe();
    return import ? import->document : Document{};
}

void expectRefused(const VoxBuilder& builder, std::uint64_t offset, const std::string& reason) {
    const Result<VoxImport> import = readVox(builder.bytes());
    ASSERT_FALSE(import);
    EXPECT_EQ(import.error().offset, offset) << import.error().describe();
    EXPECT_THAT(import.error().message, HasSubstr(reason));
}

VoxBuilder oneModel() {
    VoxBuilder builder;
    builder.model({1, 1, 1}, {{0, 0, 0, 1}});
    return builder;
}

TEST(VoxGraph, ATransformAndItsChildAreOneNode) {
    VoxBuilder builder = oneModel();
    builder.transform(0, 1)
        .group(1, {2, 4})
        .transform(2, 3, {{"_name", "left"}, {"_hidden", "1"}}, {{{"_t", "1 -2 3"}}}, 1)
        .shape(3, {{0, {}}})
        .transform(4, 5, {{"_name", "both"}, {"_hidden", "0"}})
        .group(5, {6})
        .transform(6, 3)
        .layer(0, {})
        .layer(1, {{"_name", "front"}, {"_hidden", "1"}, {"_color", "1 2 3"}});
    const Document document = read(builder);
    ASSERT_EQ(document.nodes.size(), 4u);
    EXPECT_THAT(document.nodes[0].children, ElementsAre(1, 2));
    EXPECT_TRUE(document.nodes[0].isGroup());
    EXPECT_EQ(document.nodes[1].name, "left");
    EXPECT_TRUE(document.nodes[1].hidden);
    EXPECT_EQ(document.nodes[1].layer, 1);
    EXPECT_EQ(document.nodes[1].placements[0].placement.translation, glm::ivec3(1, -2, 3));
    EXPECT_THAT(document.nodes[1].models, ElementsAre(ModelKey{0, 0}));
    EXPECT_EQ(document.nodes[2].name, "both");
    EXPECT_FALSE(document.nodes[2].hidden);
    EXPECT_TRUE(document.nodes[2].isGroup());
    EXPECT_THAT(document.nodes[2].children, ElementsAre(3));
    EXPECT_THAT(document.nodes[3].models, ElementsAre(ModelKey{0, 0}));
    EXPECT_EQ(document.layers[1].name, "front");
    EXPECT_TRUE(document.layers[1].hidden);
    EXPECT_EQ(document.layers[1].attributes, (Properties{{"_color", "1 2 3"}}));
}

// Every rotation byte there is, against a matrix worked out here: centres of cells are turned about
// the pivot floor(size / 2), in steps of half a voxel.
TEST(VoxGraph, AllRotationsAndMirrorsTurnCellsAboutThePivot) {
    const glm::ivec3 size(3, 4, 6);
    const std::vector<VoxBuilder::Voxel> voxels{{0, 0, 0, 1}, {2, 0, 0, 2}, {0, 3, 0, 3},
                                                {0, 0, 5, 4}, {2, 3, 5, 5}, {1, 2, 3, 6}};
    int legal = 0;
    for (int byte = 0; byte < 256; ++byte) {
        VoxBuilder builder;
        builder.model(size, voxels)
            .transform(0, 1)
            .group(1, {2})
            .transform(2, 3, {}, {{{"_r", std::to_string(byte)}, {"_t", "10 20 30"}}})
            .shape(3, {{0, {}}});
        const Result<VoxImport> import = readVox(builder.bytes());
        const int first = byte & 3;
        const int second = (byte >> 2) & 3;
        const bool isLegal = first < 3 && second < 3 && first != second && byte < 128;
        ASSERT_EQ(import.has_value(), isLegal) << byte;
        if (!isLegal) continue;
        ++legal;
        const int columns[3] = {first, second, 3 - first - second};
        test::VoxelMap expected;
        for (const VoxBuilder::Voxel& v : voxels) {
            const int at[3] = {v[0], v[1], v[2]};
            int cell[3];
            for (int row = 0; row < 3; ++row) {
                const int c = columns[row];
                const int centre = 2 * (at[c] - size[c] / 2) + 1;
                const int turned = ((byte >> (4 + row)) & 1) ? -centre : centre;
                cell[row] = (turned - 1) / 2 + 10 * (row + 1);
            }
            expected[{cell[0], cell[1], cell[2]}] = v[3];
        }
        EXPECT_EQ(test::mapOf(flatten(import->document, 0)), expected) << byte;
    }
    EXPECT_EQ(legal, 48);
}

TEST(VoxGraph, KeyframesOfTransformsAndModels) {
    VoxBuilder builder = oneModel();
    builder.model({1, 1, 1}, {{0, 0, 0, 2}})
        .transform(0, 1)
        .group(1, {2})
        .transform(2, 3, {{"_loop", "1"}},
                   {{{"_f", "9"}, {"_t", "9 0 0"}}, {{"_f", "2"}, {"_t", "2 0 0"}}})
        .shape(3, {{1, {{"_f", "0"}}}, {0, {{"_f", "4"}}}}, {{"_loop", "1"}});
    const SceneNode node = read(builder).nodes[1];
    ASSERT_EQ(node.placements.size(), 2u);
    EXPECT_EQ(node.placements[0].frame, 2);
    EXPECT_EQ(node.placements[1].frame, 9);
    EXPECT_EQ(node.placements[1].placement.translation.x, 9);
    EXPECT_TRUE(node.loopPlacements);
    EXPECT_TRUE(node.glides);
    EXPECT_THAT(node.models, ElementsAre(ModelKey{0, 1}, ModelKey{4, 0}));
    EXPECT_TRUE(node.loopModels);
}

TEST(VoxGraph, ModelsWithoutFramesFollowOneAnother) {
    VoxBuilder builder = oneModel();
    builder.transform(0, 1).group(1, {2}).transform(2, 3).shape(3, {{0, {}}, {0, {}}, {0, {}}});
    EXPECT_THAT(read(builder).nodes[1].models,
                ElementsAre(ModelKey{0, 0}, ModelKey{1, 0}, ModelKey{2, 0}));
}

TEST(VoxGraph, ALaterKeyForTheSameFrameWins) {
    VoxBuilder builder = oneModel();
    builder.transform(0, 1).group(1, {2}).transform(
        2, 3, {}, {{{"_f", "1"}, {"_t", "1 1 1"}}, {{"_f", "1"}, {"_t", "2 2 2"}}});
    builder.shape(3, {{0, {}}});
    const SceneNode node = read(builder).nodes[1];
    ASSERT_EQ(node.placements.size(), 1u);
    EXPECT_EQ(node.placements[0].placement.translation, glm::ivec3(2));
}

TEST(VoxGraph, AttributesThatAreNotUnderstoodAreKeptWithTheirPlace) {
    VoxBuilder builder = oneModel();
    builder.transform(0, 1)
        .group(1, {2}, {{"_g", "group's"}})
        .transform(2, 3, {{"_x", "transform's"}}, {{{"_f", "3"}, {"_y", "frame's"}}})
        .shape(3, {{0, {{"_z", "model's"}}}}, {{"_s", "shape's"}});
    const Document document = read(builder);
    EXPECT_EQ(document.nodes[0].attributes, (Properties{{"group/_g", "group's"}}));
    EXPECT_EQ(document.nodes[1].attributes, (Properties{{"_x", "transform's"},
                                                        {"frame/0/_y", "frame's"},
                                                        {"model/0/_z", "model's"},
                                                        {"shape/_s", "shape's"}}));
}

TEST(VoxGraph, SharedNodesAreCopiedForEachUse) {
    VoxBuilder builder = oneModel();
    builder.transform(0, 1)
        .group(1, {2, 3})
        .transform(2, 4, {}, {{{"_t", "5 0 0"}}})
        .transform(3, 4, {}, {{{"_t", "-5 0 0"}}})
        .group(4, {5, 5})
        .transform(5, 6)
        .shape(6, {{0, {}}});
    const Document document = read(builder);
    ASSERT_EQ(document.nodes.size(), 7u);  // the root, two groups, two objects in each
    EXPECT_EQ(test::mapOf(flatten(document, 0)), (test::VoxelMap{{{5, 0, 0}, 1}, {{-5, 0, 0}, 1}}));
    EXPECT_EQ(instancesOf(document, 0).size(), 4u);
}

TEST(VoxGraph, NodesOutOfTheUsualAlternationAreRead) {
    VoxBuilder chain = oneModel();
    chain.transform(0, 1, {}, {{{"_t", "1 0 0"}}})
        .transform(1, 2, {}, {{{"_t", "0 1 0"}}})
        .group(2, {3, 4})
        .shape(3, {{0, {}}})
        .transform(4, 3, {}, {{{"_t", "0 0 1"}}});
    EXPECT_EQ(test::mapOf(flatten(read(chain), 0)),
              (test::VoxelMap{{{1, 1, 0}, 1}, {{1, 1, 1}, 1}}));
    VoxBuilder rootIsObject = oneModel();
    rootIsObject.transform(0, 1, {{"_name", "it"}}, {{{"_t", "1 2 3"}}}).shape(1, {{0, {}}});
    const Document document = read(rootIsObject);
    ASSERT_EQ(document.nodes.size(), 2u);
    EXPECT_EQ(document.nodes[1].name, "it");
    EXPECT_EQ(test::mapOf(flatten(document, 0)), (test::VoxelMap{{{1, 2, 3}, 1}}));
}

TEST(VoxGraph, ALayerThatDoesNotExistIsNone) {
    VoxBuilder none = oneModel();
    none.transform(0, 1, {}, {{}}, 0).shape(1, {{0, {}}});
    const Result<VoxImport> without = readVox(none.bytes());
    ASSERT_TRUE(without);
    EXPECT_EQ(without->document.nodes[1].layer, -1);
    EXPECT_THAT(without->warnings, IsEmpty());
    none.layer(7, {{"_name", "seven"}});
    EXPECT_EQ(read(none).layers.size(), 8u);
    EXPECT_EQ(read(none).nodes[1].layer, 0);
    none.layer(1024, {});
    EXPECT_FALSE(readVox(none.bytes()));
}

TEST(VoxGraph, NodesThatAreNotUsedAreLeftOut) {
    VoxBuilder builder = oneModel();
    builder.transform(0, 1).group(1, {}).transform(7, 8).shape(8, {{0, {}}});
    const Result<VoxImport> import = readVox(builder.bytes());
    ASSERT_TRUE(import);
    EXPECT_EQ(import->document.nodes.size(), 1u);
    EXPECT_THAT(import->warnings, ElementsAre(HasSubstr("2 nodes do not hang on the root")));
}

TEST(VoxGraph, WrongReferencesAreRefusedWhereTheyStand) {
    VoxBuilder missing = oneModel();
    missing.transform(0, 1);
    const std::uint64_t group = missing.nextContent();
    missing.group(1, {9});
    expectRefused(missing, group, "node 1 refers to node 9, which does not exist");

    VoxBuilder model = oneModel();
    model.transform(0, 1);
    const std::uint64_t shape = model.nextContent();
    model.shape(1, {{1, {}}});
    expectRefused(model, shape, "shows model 1; there are 1");

    VoxBuilder rootless = oneModel();
    const std::uint64_t first = rootless.nextContent();
    rootless.transform(1, 2).group(2, {});
    expectRefused(rootless, first, "no node 0");

    VoxBuilder twice = oneModel();
    twice.transform(0, 1).group(1, {});
    const std::uint64_t second = twice.nextContent();
    twice.group(1, {});
    expectRefused(twice, second, "two nodes 1");
}

TEST(VoxGraph, CyclesAreRefused) {
    VoxBuilder builder = oneModel();
    builder.transform(0, 1).group(1, {2});
    const std::uint64_t closing = builder.nextContent();
    builder.transform(2, 1);
    expectRefused(builder, closing, "node 2 contains itself");
    VoxBuilder self = oneModel();
    const std::uint64_t root = self.nextContent();
    self.transform(0, 0);
    expectRefused(self, root, "node 0 contains itself");
}

// A chain of groups: 2 * levels nodes deep.
VoxBuilder nested(int levels) {
    VoxBuilder builder = oneModel();
    for (int level = 0; level < levels; ++level) {
        builder.transform(2 * level, 2 * level + 1);
        if (level + 1 < levels) {
            builder.group(2 * level + 1, {2 * level + 2});
        } else {
            builder.shape(2 * level + 1, {{0, {}}});
        }
    }
    return builder;
}

TEST(VoxGraph, DeepNestingIsBoundedAndNeverOverflowsTheStack) {
    EXPECT_EQ(flatten(read(nested(1000)), 0).solidCount(), 1u);
    const Result<VoxImport> import = readVox(nested(100'000).bytes());
    ASSERT_FALSE(import);
    EXPECT_THAT(import.error().message, HasSubstr("nested deeper"));
    EXPECT_TRUE(import.error().offset);
}

TEST(VoxGraph, SharingThatDoublesAtEachLevelIsRefused) {
    VoxBuilder builder = oneModel();
    for (int level = 0; level < 100; ++level) {
        builder.transform(2 * level, 2 * level + 1)
            .group(2 * level + 1, {2 * level + 2, 2 * level + 2});
    }
    builder.transform(200, 201).shape(201, {{0, {}}});
    const Result<VoxImport> import = readVox(builder.bytes());
    ASSERT_FALSE(import);
    EXPECT_THAT(import.error().message, HasSubstr("uses shared nodes so often"));
    EXPECT_TRUE(import.error().offset);
}

// A long name counts as often as it would be copied.
TEST(VoxGraph, SharingOfLongTextIsRefused) {
    VoxBuilder builder = oneModel();
    builder.transform(0, 1)
        .group(1, std::vector<int>(10'000, 2))
        .transform(2, 3, {{"_name", std::string(100'000, 'x')}})
        .shape(3, {{0, {}}});
    const Result<VoxImport> import = readVox(builder.bytes());
    ASSERT_FALSE(import);
    EXPECT_THAT(import.error().message, HasSubstr("uses shared nodes so often"));
}

TEST(VoxGraph, NumbersOutOfRangeAreRefused) {
    for (const Properties& frame : {Properties{{"_t", "1 2"}},
                                    {{"_t", "1 2 3 4"}},
                                    {{"_t", "a b c"}},
                                    {{"_t", "1.5 0 0"}},
                                    {{"_t", "16777217 0 0"}},
                                    {{"_t", "99999999999 0 0"}},
                                    {{"_r", "3"}},
                                    {{"_r", "-1"}},
                                    {{"_r", "x"}},
                                    {{"_f", "-1"}},
                                    {{"_f", "x"}},
                                    {{"_f", "1000000000"}}}) {
        const Result<VoxImport> import = readVox(test::oneObject({1, 1, 1}, frame).bytes());
        ASSERT_FALSE(import) << frame.begin()->second;
        EXPECT_TRUE(import.error().offset);
        EXPECT_THAT(import.error().message, HasSubstr(frame.begin()->second));
    }
    // Each in range, but not their sum.
    VoxBuilder builder = oneModel();
    builder.transform(0, 1, {}, {{{"_t", "16777000 0 0"}}})
        .group(1, {2})
        .transform(2, 3, {}, {{{"_t", "16777000 0 0"}}})
        .shape(3, {{0, {}}});
    EXPECT_FALSE(readVox(builder.bytes()));
}

}  // namespace
}  // namespace voxprite
