// The writer: what it writes reads back equal and keeps MagicaVoxel's rules.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <set>

#include "core/io/formats.h"
#include "core/io/vox.h"
#include "core/model/entity_voxels.h"
#include "tests/support/random.h"
#include "tests/support/raw_vox.h"
#include "tests/support/vox_builder.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Bytes written(const Document& document) {
    const Result<Bytes> bytes = writeVox(document);
    EXPECT_TRUE(bytes) << bytes.error().describe();
    return bytes.value_or(Bytes{});
}

Document readBack(const Document& document) {
    const Result<VoxImport> import = readVox(written(document));
    EXPECT_TRUE(import) << import.error().describe();
    if (!import) return {};
    EXPECT_TRUE(import->warnings.empty()) << import->warnings[0];
    return import->document;
}

// What .vox has no words for; see vox.h.
Document withoutWhatVoxLacks(Document document) {
    document.clips.clear();
    document.sockets.clear();
    document.entity = {};
    document.authored = {};
    return document;
}

// The canvas that the format gives a model of this size.
IBox canvasOf(glm::ivec3 size) {
    return {-(size / 2), size - size / 2};
}

void expectSameFrames(const Document& a, const Document& b) {
    ASSERT_EQ(frameCount(a), frameCount(b));
    for (int frame = 0; frame < frameCount(a); ++frame) {
        EXPECT_TRUE(flatten(a, frame) == flatten(b, frame)) << "frame " << frame;
    }
}

// Everything that a .vox can say, with models on canvases of even and odd sizes.
Document everything() {
    Document document = withoutWhatVoxLacks(test::busyDocument());
    for (Model& model : document.models) {
        const IBox bounds = model.voxels.bounds();
        const glm::ivec3 half = glm::max(-bounds.min, bounds.max) + 1;
        model.canvas = canvasOf(2 * half + 1);
    }
    document.models.emplace_back().canvas = canvasOf({256, 1, 2});
    for (SceneNode& node : document.nodes) {
        node.glides = true;
        node.glides = movesBetweenKeys(node);
        if (!node.isGroup() && node.layer < 0) node.layer = 0;
    }
    document.nodes[0].attributes = {{"_own", "1"}, {"group/_own", "2"}, {"shape/_own", "3"}};
    document.cameras = {{0, {{"_mode", "pers"}}}, {3, {}}};
    document.renderSettings = {{0, {{"_type", "_env"}}}, {0, {{"_type", "_ground"}}}};
    document.palette.names[17] = "cloth";
    document.palette.names[200] = "steel";
    return document;
}

TEST(VoxWrite, ADocumentWithEverythingReadsBackEqual) {
    const Document document = everything();
    ASSERT_TRUE(validate(document));
    const Document again = readBack(document);
    EXPECT_EQ(again.palette, document.palette);
    EXPECT_EQ(again.layers, document.layers);
    EXPECT_EQ(again.nodes, document.nodes);
    EXPECT_EQ(again.models, document.models);
    EXPECT_TRUE(again == document);
    expectSameFrames(again, document);
    EXPECT_TRUE(written(again) == written(document));
}

TEST(VoxWrite, NodesKeepTheirOrderWhateverItIs) {
    Document document = test::documentOf(test::figure());
    document.models[0].canvas = canvasOf({64, 64, 64});
    document.nodes.resize(4);
    document.nodes[0].children = {3, 1};
    document.nodes[2].parent = 3;
    document.nodes[2].models = {{0, 0}};
    document.nodes[3].parent = 0;
    document.nodes[3].children = {2};
    ASSERT_TRUE(validate(document));
    EXPECT_TRUE(readBack(document) == document);
}

TEST(VoxWrite, EveryPlacementReadsBackEqual) {
    Document document = test::documentOf(test::asymmetric());
    document.models[0].canvas = canvasOf({63, 64, 65});
    for (int byte = 0; byte < 128; ++byte) {
        const Result<SignedPermutation> rotation = SignedPermutation::fromVoxByte(byte);
        if (!rotation) continue;
        document.nodes[1].placements[0].placement = {*rotation, {byte, -byte, 2 * byte}};
        const Bytes file = written(document);
        const Result<VoxImport> import = readVox(file);
        ASSERT_TRUE(import);
        EXPECT_TRUE(import->document == document) << byte;
        const VoxelGrid flat = flatten(document, 0);
        const std::optional<test::RawVox> raw = test::readRawVox(file);
        ASSERT_TRUE(raw);
        EXPECT_EQ(raw->placed.size(), flat.solidCount()) << byte;
        flat.forEachSolid([&](glm::ivec3 v, std::uint8_t value) {
            EXPECT_EQ(raw->placed.at(test::packed(v.x, v.y, v.z)), value) << byte;
        });
    }
}

TEST(VoxWrite, NamesOfSingleColoursAndOfRowsReadBackEqual) {
    Document document = Document::withEmptyModel();
    for (std::size_t i = 1; i <= 8; ++i) document.palette.names[i] = "glass";
    EXPECT_EQ(readBack(document).palette.names, document.palette.names);
    document.palette.names[3] = "thick glass";
    EXPECT_EQ(readBack(document).palette.names, document.palette.names);
    std::swap(document.palette.displayOrder[3], document.palette.displayOrder[77]);
    EXPECT_EQ(readBack(document).palette, document.palette);
}

TEST(VoxWrite, AModelWithoutCanvasGetsTheSmallestThatFits) {
    Document document;
    document.models.emplace_back().voxels.set({0, -3, 2}, 5);
    document.models.emplace_back();
    const Document again = readBack(document);
    EXPECT_EQ(again.models[0].canvas, canvasOf({1, 6, 5}));
    EXPECT_EQ(again.models[0].voxels, document.models[0].voxels);
    EXPECT_EQ(again.models[1].canvas, canvasOf({1, 1, 1}));
}

TEST(VoxWrite, VoxelsDrawnOutsideTheCanvasWidenIt) {
    Document document = test::documentOf({});
    document.models[0].canvas = canvasOf({4, 4, 4});
    document.models[0].voxels.set({127, -128, 0}, 1);
    const Document again = readBack(document);
    EXPECT_EQ(again.models[0].canvas, canvasOf({255, 256, 4}));
    expectSameFrames(again, document);
}

TEST(VoxWrite, AModelLargerThan256IsSplitUnderAGroup) {
    Document document = test::documentOf({});
    VoxelGrid& voxels = document.models[0].voxels;
    test::Random random(1);
    for (int i = 0; i < 2000; ++i) {
        voxels.set(random.voxel(-400, 400), static_cast<std::uint8_t>(random.between(1, 255)));
    }
    document.nodes[1].name = "large";
    document.nodes[1].placements[0].placement = {*SignedPermutation::fromVoxByte(41), {3, 5, 7}};
    const Document again = readBack(document);
    EXPECT_EQ(again.nodes[1].name, "large");
    EXPECT_TRUE(again.nodes[1].isGroup());
    EXPECT_EQ(again.nodes[1].children.size(), 64u);  // -400..400 is four tiles of 256 on each axis
    expectSameFrames(again, document);
}

// What MagicaVoxel would let glide is held still by keys of its own.
TEST(VoxWrite, WhatHoldsStillUntilItJumpsStillDoes) {
    for (const bool glides : {false, true}) {
        Document document = test::documentOf(test::asymmetric());
        document.nodes[1].placements = {{0, {{}, {0, 0, 0}}},
                                        {4, {{}, {40, 0, 0}}},
                                        {5, {{}, {41, 0, 0}}},
                                        {9, {{}, {41, 0, 0}}}};
        document.nodes[1].glides = glides;
        const Document again = readBack(document);
        EXPECT_EQ(again.nodes[1].glides, glides);
        EXPECT_EQ(again.nodes[1].placements.size(), glides ? 4u : 5u);
        expectSameFrames(again, document);
    }
}

TEST(VoxWrite, AModelThatFitsStaysOneObjectWhereverItGrew) {
    const SignedPermutation turned = *SignedPermutation::fromVoxByte(41);
    for (const bool glides : {false, true}) {
        Document document = test::documentOf({});
        document.models[0].voxels.fill({{0, 0, -104}, {48, 48, 136}}, 7);
        document.models[0].voxels.set({47, 3, 135}, 1);
        document.nodes[1].name = "tower";
        document.nodes[1].placements = {{0, {turned, {3, 5, 7}}}, {3, {turned, {9, -5, 7}}}};
        document.nodes[1].glides = glides;
        const Document again = readBack(document);
        ASSERT_EQ(again.nodes.size(), 2u);
        EXPECT_EQ(again.nodes[1].name, "tower");
        EXPECT_EQ(again.models.size(), 1u);
        EXPECT_EQ(again.models[0].canvas.size(), glm::ivec3(48, 48, 240));
        expectSameFrames(again, document);
        // A turn about another pivot glides along another way: an object below keeps the pivot.
        document.nodes[1].placements[1].placement.rotation = {};
        expectSameFrames(readBack(document), document);
        // What turns on the spot stays there, though its pivot's place changes.
        document.nodes[1].placements[1].placement.translation = {3, 5, 7};
        expectSameFrames(readBack(document), document);
    }
}

TEST(VoxWrite, AnObjectWithoutALayerLiesOnTheFirstThatIsSeen) {
    Document document = test::documentOf(test::figure());
    EXPECT_EQ(readBack(document).nodes[1].layer, -1);  // there are none
    document.layers.resize(3);
    document.layers[0].hidden = true;
    EXPECT_EQ(readBack(document).nodes[1].layer, 1);
    document.nodes[1].layer = 2;
    EXPECT_EQ(readBack(document).nodes[1].layer, 2);
    document.nodes[1].layer = -1;
    for (Layer& layer : document.layers) layer.hidden = true;
    EXPECT_EQ(readBack(document).nodes[1].layer, -1);
}

TEST(VoxWrite, ThatAModelIsCutIsSaid) {
    Document document = test::documentOf({});
    document.models[0].voxels.fill({{-10, 0, 1000}, {246, 1, 1001}}, 1);
    EXPECT_TRUE(lossesOf(document, Format::vox).empty());
    document.models[0].voxels.set({246, 0, 1000}, 1);
    EXPECT_THAT(lossesOf(document, Format::vox),
                ElementsAre(HasSubstr("1 model is written in pieces")));
}

TEST(VoxWrite, AModelFarFromItsOriginIsMovedThere) {
    Document document = test::documentOf({});
    document.models[0].voxels.set({1000, 0, 0}, 1);
    document.models[0].voxels.set({1001, 0, 0}, 2);
    const Document again = readBack(document);
    EXPECT_EQ(again.models.size(), 1u);
    expectSameFrames(again, document);
}

// Frames of different extents: large, small, large again elsewhere; the small one not split.
TEST(VoxWrite, ASplitAnimationShowsTheSameFrames) {
    std::vector<VoxelGrid> frames(4);
    frames[0].fill({{-200, 0, 0}, {200, 2, 2}}, 1);
    frames[1].fill({{0, 0, 0}, {3, 3, 3}}, 2);
    frames[2].fill({{0, -300, 0}, {1, 300, 1}}, 3);
    for (const bool loop : {false, true}) {
        Document document = test::animationOf(frames);
        document.nodes[1].loopModels = loop;
        document.nodes[1].placements = {{1, {{}, {1, 0, 0}}}, {5, {{}, {0, 0, 9}}}};
        ASSERT_TRUE(validate(document));
        expectSameFrames(readBack(document), document);
    }
}

TEST(VoxWrite, WhatTheFormatCannotHoldIsRefused) {
    const auto reason = [](const Document& document) {
        const Result<Bytes> bytes = writeVox(document);
        return bytes ? "written" : bytes.error().message;
    };
    Document named;
    named.nodes[0].attributes = {{"_name", "x"}};
    EXPECT_THAT(reason(named), HasSubstr("_name has a field of its own"));
    Document layers;
    layers.layers.resize(1025);
    EXPECT_THAT(reason(layers), HasSubstr("1024 layers"));
    Document huge = test::documentOf({});
    huge.models[0].voxels.fill({{0, 0, 0}, {1024, 1024, 1024}}, 1);
    EXPECT_THAT(reason(huge), HasSubstr("1073741824 voxels"));
    Document deep;
    for (int level = 0; level < 2000; ++level) {
        deep.nodes.back().children = {level + 1};
        deep.nodes.emplace_back().parent = level;
    }
    EXPECT_THAT(reason(deep), HasSubstr("nested deeper"));
    Document invalid;
    invalid.nodes[0].layer = 3;
    EXPECT_THAT(reason(invalid), HasSubstr("layer 3"));
}

// A split object below this many groups.
Document nested(int groups) {
    Document document;
    document.models.emplace_back().voxels = test::solidBox({300, 1, 1});
    for (int level = 0; level <= groups; ++level) {
        document.nodes.back().children = {level + 1};
        document.nodes.emplace_back().parent = level;
    }
    document.nodes.back().models = {{0, 0}};
    return document;
}

TEST(VoxWrite, TheDeepestNestingThatIsWrittenCanBeRead) {
    int deepest = 0;
    for (int step = 1024; step > 0; step /= 2) {
        if (writeVox(nested(deepest + step))) deepest += step;
    }
    EXPECT_GT(deepest, 1000);
    EXPECT_LT(deepest, 2000);
    expectSameFrames(readBack(nested(deepest)), nested(deepest));
}

struct Chunk {
    std::string id;
    Bytes content;
};

std::vector<Chunk> chunksOf(const Bytes& file) {
    const auto number = [&](std::size_t at) {
        std::uint32_t value = 0;
        std::memcpy(&value, file.data() + at, 4);
        return value;
    };
    EXPECT_EQ(std::memcmp(file.data(), "VOX ", 4), 0);
    EXPECT_EQ(number(4), 200u);
    EXPECT_EQ(number(12), 0u);
    EXPECT_EQ(number(16) + 20, file.size());
    std::vector<Chunk> chunks;
    for (std::size_t at = 20; at < file.size();) {
        Chunk chunk{{file.begin() + static_cast<std::ptrdiff_t>(at),
                     file.begin() + static_cast<std::ptrdiff_t>(at) + 4},
                    {}};
        const std::size_t length = number(at + 4);
        EXPECT_EQ(number(at + 8), 0u) << chunk.id;
        const auto first = file.begin() + static_cast<std::ptrdiff_t>(at) + 12;
        chunk.content.assign(first, first + static_cast<std::ptrdiff_t>(length));
        at += 12 + length;
        chunks.push_back(std::move(chunk));
    }
    return chunks;
}

std::int32_t numberAt(const Bytes& bytes, std::size_t at) {
    std::int32_t value = 0;
    std::memcpy(&value, bytes.data() + at, 4);
    return value;
}

// Sizes, palette, ids and alternation as MagicaVoxel demands them.
TEST(VoxWrite, MagicaVoxelsRulesAreKept) {
    Document document = everything();
    document.models.emplace_back().voxels.fill({{-300, -1, -1}, {300, 1, 1}}, 9);
    document.nodes[0].children.push_back(static_cast<int>(document.nodes.size()));
    SceneNode& split = document.nodes.emplace_back();
    split.parent = 0;
    split.models = {{0, static_cast<int>(document.models.size()) - 1}};
    const Bytes file = written(document);
    std::map<int, std::string> kinds;
    std::map<int, std::vector<int>> links;
    int models = 0;
    int layers = 0;
    for (const auto& [id, content] : chunksOf(file)) {
        if (id == "SIZE") {
            ++models;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                EXPECT_GE(numberAt(content, 4 * axis), 1);
                EXPECT_LE(numberAt(content, 4 * axis), 256);
            }
        } else if (id == "XYZI") {
            EXPECT_EQ(static_cast<std::size_t>(numberAt(content, 0)) * 4 + 4, content.size());
        } else if (id == "RGBA") {
            EXPECT_EQ(content.size(), 1024u);
        } else if (id == "IMAP") {
            EXPECT_EQ(content.size(), 256u);
            EXPECT_EQ(std::set<int>(content.begin(), content.end()).size(), 256u);
        } else if (id == "LAYR") {
            EXPECT_EQ(numberAt(content, 0), layers++);
            EXPECT_EQ(numberAt(content, content.size() - 4), -1);
        } else if (id == "nTRN" || id == "nGRP" || id == "nSHP") {
            const int node = numberAt(content, 0);
            EXPECT_TRUE(kinds.emplace(node, id).second) << node;
            std::size_t at = 4;
            const int texts = 2 * numberAt(content, at);  // keys and values
            at += 4;
            for (int i = 0; i < texts; ++i) {
                at += 4 + static_cast<std::size_t>(numberAt(content, at));
            }
            if (id == "nTRN") {
                links[node] = {numberAt(content, at)};
                EXPECT_EQ(numberAt(content, at + 4), -1);
                EXPECT_LT(numberAt(content, at + 8), static_cast<int>(document.layers.size()));
                EXPECT_GE(numberAt(content, at + 12), 1);
            } else if (id == "nGRP") {
                for (int i = 1; i <= numberAt(content, at); ++i) {
                    links[node].push_back(numberAt(content, at + 4 * static_cast<std::size_t>(i)));
                }
            } else {
                EXPECT_GE(numberAt(content, at), 1);
                EXPECT_LT(numberAt(content, at + 4), models);
            }
        }
    }
    EXPECT_EQ(kinds.at(0), "nTRN");
    EXPECT_EQ(kinds.at(links.at(0)[0]), "nGRP");
    for (const auto& [node, children] : links) {
        for (const int child : children) {
            EXPECT_EQ(kinds.at(child) == "nTRN", kinds.at(node) == "nGRP") << node;
        }
    }
}

}  // namespace
}  // namespace voxprite
