// Real files: against a count made from the bare chunks, and there and back again.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "core/base/file.h"
#include "core/io/vox.h"
#include "core/model/entity_voxels.h"
#include "tests/support/corpus.h"
#include "tests/support/raw_vox.h"

namespace voxprite {
namespace {

using testing::HasSubstr;

const std::set<std::string> kNotReadable{"not_a.vox", "slab6_vox_test.vox", "teardown.vox"};

bool isReadable(const std::filesystem::path& path) {
    return !kNotReadable.contains(path.filename().string());
}

Bytes bytesOf(const std::filesystem::path& path) {
    const Result<Bytes> bytes = readFile(path);
    EXPECT_TRUE(bytes) << bytes.error().describe();
    return bytes.value_or(Bytes{});
}

Document documentOf(const std::filesystem::path& path) {
    const Result<VoxImport> import = readVox(bytesOf(path));
    EXPECT_TRUE(import) << path << ": " << import.error().describe();
    return import ? import->document : Document{};
}

std::unordered_map<std::uint64_t, std::uint8_t> packedVoxels(const VoxelGrid& voxels) {
    std::unordered_map<std::uint64_t, std::uint8_t> result;
    voxels.forEachSolid(
        [&](glm::ivec3 v, std::uint8_t value) { result[test::packed(v.x, v.y, v.z)] = value; });
    return result;
}

// The file of this name somewhere in the corpus.
std::filesystem::path named(const std::string& name) {
    for (const std::filesystem::path& path : test::corpusFiles()) {
        if (path.filename() == name) return path;
    }
    ADD_FAILURE() << name << " is missing from the corpus";
    return {};
}

TEST(VoxCorpus, OtherFormatsAreRefusedWithTheReason) {
    if (test::corpusNotice()) return;
    const auto reason = [](const std::string& name) {
        const Result<VoxImport> import = readVox(bytesOf(named(name)));
        return import ? "it was read" : import.error().message;
    };
    EXPECT_THAT(reason("not_a.vox"), HasSubstr("not a MagicaVoxel file"));
    EXPECT_THAT(reason("slab6_vox_test.vox"), HasSubstr("Slab6"));
    EXPECT_THAT(reason("teardown.vox"), HasSubstr("TDCZ"));
}

TEST(VoxCorpus, VoxelsSizesAndColoursAreThoseOfTheBareChunks) {
    if (test::corpusNotice()) return;
    for (const std::filesystem::path& path : test::corpusFiles()) {
        std::optional<test::RawVox> raw = test::readRawVox(bytesOf(path));
        ASSERT_EQ(raw.has_value(), isReadable(path)) << path;
        if (!raw) continue;
        const Document document = documentOf(path);
        ASSERT_EQ(document.models.size(), raw->models.size()) << path;
        for (std::size_t i = 0; i < raw->models.size(); ++i) {
            test::RawModel& expected = raw->models[i];
            const Model& model = document.models[i];
            const glm::ivec3 size(expected.size[0], expected.size[1], expected.size[2]);
            EXPECT_EQ(model.canvas.size(), size) << path;
            std::int64_t solid = 0;
            for (const std::uint8_t cell : expected.cells) solid += cell != 0;
            EXPECT_EQ(model.voxels.solidCount(), static_cast<std::uint64_t>(solid)) << path;
            std::int64_t equal = 0;
            model.voxels.forEachSolid([&](glm::ivec3 v, std::uint8_t value) {
                const glm::ivec3 inFile = v + size / 2;
                equal += expected.at(inFile.x, inFile.y, inFile.z) == value;
            });
            EXPECT_EQ(equal, solid) << path << ", model " << i;
        }
        for (std::size_t i = 0; i < raw->colours.size() && i < 255; ++i) {
            const auto& c = raw->colours[i];
            EXPECT_EQ(document.palette.colours[i + 1], Rgba8(c[0], c[1], c[2], c[3])) << path;
        }
        if (raw->colours.empty()) {
            EXPECT_EQ(document.palette.colours, Palette::standard().colours) << path;
        }
    }
}

TEST(VoxCorpus, TheSceneGraphPutsEveryVoxelInItsPlace) {
    if (test::corpusNotice()) return;
    for (const std::filesystem::path& path : test::corpusFiles()) {
        const std::optional<test::RawVox> raw = test::readRawVox(bytesOf(path));
        if (!raw || !raw->hasSceneGraph) continue;
        EXPECT_TRUE(packedVoxels(flatten(documentOf(path), 0)) == raw->placed) << path;
    }
}

TEST(VoxCorpus, WritingAndReadingGivesTheSameDocument) {
    if (test::corpusNotice()) return;
    for (const std::filesystem::path& path : test::corpusFiles()) {
        if (!isReadable(path)) continue;
        const Document document = documentOf(path);
        const Result<Bytes> written = writeVox(document);
        ASSERT_TRUE(written) << path << ": " << written.error().describe();
        const Result<VoxImport> again = readVox(*written);
        ASSERT_TRUE(again) << path << ": " << again.error().describe();
        EXPECT_TRUE(again->document == document) << path;
        EXPECT_TRUE(again->warnings.empty()) << path << ": " << again->warnings[0];
        EXPECT_TRUE(writeVox(again->document) == *written) << path;
    }
}

// Four turned and mirrored copies of one floor must tile the ground without gap or overlap.
TEST(VoxCorpus, MirroredFloorsMeet) {
    if (test::corpusNotice()) return;
    const Document document = documentOf(named("test-transform.vox"));
    std::vector<IBox> floors;
    for (const Instance& instance : instancesOf(document, 0)) {
        if (document.nodes[static_cast<std::size_t>(instance.node)].name != "floor") continue;
        const Model& model = document.models[static_cast<std::size_t>(instance.model)];
        floors.push_back(instance.entityFromModel.applyToBox(model.voxels.bounds()));
    }
    ASSERT_EQ(floors.size(), 4u);
    IBox all;
    std::int64_t area = 0;
    for (const IBox& floor : floors) {
        all = all.united(floor);
        area += std::int64_t{floor.size().x} * floor.size().y;
        EXPECT_EQ(floor.size().z, 6);
    }
    EXPECT_EQ(all.size(), glm::ivec3(256, 256, 6));
    EXPECT_EQ(area, 256 * 256);
}

// The arms are turned by -90 and 90 degrees, the hands mirrored too: the figure is symmetrical.
TEST(VoxCorpus, TurnedLimbsOfACharacterAreSymmetrical) {
    if (test::corpusNotice()) return;
    const Document document = documentOf(named("vox_character.vox"));
    const auto boundsOf = [&](const std::string& name) {
        for (const Instance& instance : instancesOf(document, 0)) {
            if (document.nodes[static_cast<std::size_t>(instance.node)].name != name) continue;
            const Model& model = document.models[static_cast<std::size_t>(instance.model)];
            return instance.entityFromModel.applyToBox(model.voxels.bounds());
        }
        ADD_FAILURE() << name;
        return IBox{};
    };
    for (const std::string limb : {"Arm", "ForeArm", "Hand", "Leg", "Thigh"}) {
        IBox right = boundsOf("Right" + limb);
        std::swap(right.min.x, right.max.x);
        right.min.x *= -1;
        right.max.x *= -1;
        EXPECT_EQ(boundsOf("Left" + limb), right) << limb;
    }
    EXPECT_EQ(boundsOf("RightArm").min.z, 28);
    EXPECT_EQ(boundsOf("RightForeArm").max.z, 29);
    EXPECT_EQ(boundsOf("RightForeArm").min.z, boundsOf("RightHand").max.z);
}

TEST(VoxCorpus, AnimationsAreRead) {
    if (test::corpusNotice()) return;
    const Document moving = documentOf(named("animation.0.99.7.1.vox"));
    const SceneNode& node = moving.nodes.at(1);
    ASSERT_EQ(node.placements.size(), 3u);
    EXPECT_EQ(node.placements[1].frame, 9);
    EXPECT_EQ(node.placements[1].placement.translation, glm::ivec3(-29, 31, 20));
    EXPECT_TRUE(node.loopPlacements);
    EXPECT_EQ(placementAt(node, 3).translation, glm::ivec3(-1, -9, 20));  // a third of the way
    EXPECT_EQ(frameCount(moving), 31);
    const Document ranged = documentOf(named("test_meta_chunk.vox"));
    EXPECT_EQ(ranged.nodes.at(1).attributes.at("_frm_t"), "29 0 20");
    EXPECT_EQ(ranged.nodes.at(1).attributes.at("shape/_frm_id"), "0");
}

}  // namespace
}  // namespace voxprite
