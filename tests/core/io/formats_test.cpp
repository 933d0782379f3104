#include "core/io/formats.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/base/file.h"
#include "core/io/svo_file.h"
#include "core/model/entity_voxels.h"
#include "tests/support/corpus.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

namespace fs = std::filesystem;

TEST(Formats, AreKnownByTheirEnding) {
    EXPECT_EQ(formatOf("a/hut.vox").value(), Format::vox);
    EXPECT_EQ(formatOf("HUT.VOX").value(), Format::vox);
    EXPECT_EQ(formatOf("my.game.voxprite").value(), Format::voxprite);
    EXPECT_EQ(formatOf("x.svo").value(), Format::svo);
    EXPECT_EQ(formatOf("x.csm").value(), Format::csm);
    EXPECT_EQ(modelEndings().front(), ".voxprite");
    for (const FormatInfo& info : formats()) {
        EXPECT_EQ(formatOf(std::string("x") + info.ending).value(), info.format);
        EXPECT_EQ(formatNamed(info.name).value(), info.format);
        EXPECT_EQ(&infoOf(info.format), &info);
        EXPECT_STREQ(nameOf(info.format), info.name);
    }
    EXPECT_FALSE(formatNamed(".vox"));
    EXPECT_EQ(listed({}), "");
    EXPECT_EQ(listed({".a"}), ".a");
    EXPECT_EQ(listed({".a", ".b", ".c"}), ".a, .b or .c");
    const auto unknown = formatOf("hut.txt");
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().file, "hut.txt");
    EXPECT_NE(unknown.error().message.find(".voxprite"), std::string::npos);
    EXPECT_FALSE(formatOf("hut"));
    EXPECT_FALSE(formatOf(""));
}

TEST(Formats, WhatAFormatCannotHoldIsSaid) {
    Document document = Document::withEmptyModel();
    const std::size_t atFirst = lossesOf(document, Format::vox).size();
    document.palette.variants = {{"Red", {}}, {"Blue", {}}};
    document.palette.ramps = {{"", {1, 2}}};
    EXPECT_TRUE(lossesOf(document, Format::voxprite).empty());
    for (const Format format : {Format::vox, Format::svo}) {
        const auto losses = lossesOf(document, format);
        ASSERT_EQ(losses.size(), atFirst + 2);
        EXPECT_NE(losses[atFirst].find("Red, Blue"), std::string::npos);
        EXPECT_NE(losses[atFirst + 1].find("ramps"), std::string::npos);
    }
}

// A file may say so, a document may not: placements and models have to stay within 2^24 together.
TEST(Formats, AnOctreeAtTheEdgeOfTheCoordinatesIsRefused) {
    const test::TemporaryFolder folder;
    SvoFile file = bakeForExport(test::documentOf(test::figure()), GameProfile{}).value();
    for (SvoModel& model : file.models)
        model.octree.origin = glm::ivec3(kMaxCoordinate - 100, 0, 0);
    file.anchor = glm::dvec3(-1e7, 0, 0);  // from the corner: within 1e7 of the origin
    ASSERT_TRUE(writeFileAtomically(folder / "in.svo", writeSvo(file).value()));
    EXPECT_TRUE(loadDocument(folder / "in.svo"));
    for (SvoModel& model : file.models) model.octree.origin.x = kMaxCoordinate - 20;
    ASSERT_TRUE(writeFileAtomically(folder / "edge.svo", writeSvo(file).value()));
    const auto refused = loadDocument(folder / "edge.svo");
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("reach beyond"), std::string::npos);
}

TEST(Formats, EveryFormatKeepsTheVoxels) {
    const test::TemporaryFolder folder;
    const Document document = test::busyDocument();
    for (const char* name : {"a.vox", "a.voxprite", "a.svo"}) {
        const fs::path path = folder / name;
        const Status saved = saveDocument(path, document, GameProfile{});
        ASSERT_TRUE(saved) << saved.error().describe();
        const auto loaded = loadDocument(path);
        ASSERT_TRUE(loaded) << loaded.error().describe();
        EXPECT_EQ(loaded->format, formatOf(path).value());
        ASSERT_EQ(frameCount(loaded->document), frameCount(document)) << name;
        const IBox bounds = entityBounds(document);
        const glm::ivec3 shift = entityBounds(loaded->document).min - bounds.min;
        for (int frame = 0; frame < frameCount(document); ++frame) {
            const VoxelGrid expected = flatten(document, frame);
            const VoxelGrid read = flatten(loaded->document, frame);
            EXPECT_EQ(read.solidCount(), expected.solidCount()) << name << " frame " << frame;
            std::uint64_t different = 0;
            const VoxelGrid::Reader reader(read);
            expected.forEachSolid([&](glm::ivec3 v, std::uint8_t value) {
                if (reader.get(v + shift) != value) ++different;
            });
            EXPECT_EQ(different, 0u) << name << " frame " << frame;
        }
    }
}

TEST(Formats, CsmKeepsTheVoxelsOfOneFrame) {
    const test::TemporaryFolder folder;
    const fs::path path = folder / "figure.csm";
    const Document document = test::documentOf(test::figure());
    ASSERT_TRUE(saveDocument(path, document, GameProfile{}));
    const auto loaded = loadDocument(path);
    ASSERT_TRUE(loaded) << loaded.error().describe();
    EXPECT_EQ(loaded->format, Format::csm);
    EXPECT_TRUE(loaded->warnings.empty());
    EXPECT_EQ(flatten(loaded->document, 0), test::figure());
    EXPECT_FALSE(lossesOf(document, Format::csm).empty());

    std::ofstream(path) << "> [1 2 3\n4 5 6 7 888]";
    const auto wrong = loadDocument(path);
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().describe(),
              path.string() + ": line 2, column 9: a value above 255 has no voxel: 0 to 255");
    std::ofstream(path) << "# nothing\n";
    EXPECT_EQ(loadDocument(path)->warnings.size(), 1u);
}

// A copy that broke off at once is no model without voxels.
TEST(Formats, AFileWithoutAByteIsRefused) {
    const test::TemporaryFolder folder;
    for (const FormatInfo& info : formats()) {
        const fs::path path = folder / (std::string("empty") + info.ending);
        std::ofstream(path) << "";
        const auto loaded = loadDocument(path);
        ASSERT_FALSE(loaded) << info.ending;
        EXPECT_EQ(loaded.error().message.find("JSON"), std::string::npos) << info.ending;
    }
}

TEST(Formats, ProjectsRecordTheProfileAtTheTimeOfSaving) {
    const test::TemporaryFolder folder;
    GameProfile profile;
    profile.voxelSizeMetres = 0.25;
    profile.sigma = 2.0;
    const fs::path path = folder / "figure.voxprite";
    ASSERT_TRUE(saveDocument(path, test::documentOf(test::figure()), profile));
    const auto loaded = loadDocument(path);
    ASSERT_TRUE(loaded);
    EXPECT_EQ(loaded->document.authored, (AuthoredValues{0.25, 2.0}));
    EXPECT_TRUE(loaded->warnings.empty());
}

TEST(Formats, ExportsHoldTheProfilesValues) {
    const test::TemporaryFolder folder;
    GameProfile profile;
    profile.voxelSizeMetres = 0.25;
    profile.outline.colour = Rgba8(9, 8, 7, 255);
    const fs::path path = folder / "figure.svo";
    ASSERT_TRUE(saveDocument(path, test::documentOf(test::figure()), profile));
    const auto file = readSvo(readFile(path).value());
    ASSERT_TRUE(file);
    EXPECT_EQ(file->voxelSizeMetres, 0.25);
    EXPECT_EQ(file->outline.colour, profile.outline.colour);
}

TEST(Formats, ErrorsNameTheFile) {
    const test::TemporaryFolder folder;
    const std::string missing = (folder / "missing.vox").string();
    EXPECT_EQ(loadDocument(missing).error().file, missing);

    const std::string broken = (folder / "broken.vox").string();
    std::ofstream(broken) << "VOX ";
    const auto loaded = loadDocument(broken);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().file, broken);
    EXPECT_TRUE(loaded.error().offset.has_value());

    const std::string nowhere = (folder / "no/such/folder.vox").string();
    const Status saved = saveDocument(nowhere, Document::withEmptyModel(), GameProfile{});
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().file, nowhere);
    EXPECT_FALSE(fs::exists(nowhere));
}

TEST(Formats, AFailedSaveLeavesTheOldFile) {
    const test::TemporaryFolder folder;
    const fs::path path = folder / "figure.voxprite";
    ASSERT_TRUE(saveDocument(path, test::documentOf(test::figure()), GameProfile{}));
    const Bytes before = readFile(path).value();
    Document invalid = test::documentOf(test::figure());
    invalid.entity.scale = -1.0;
    EXPECT_FALSE(saveDocument(path, invalid, GameProfile{}));
    EXPECT_EQ(readFile(path).value(), before);
}

TEST(FormatsCorpus, ProjectsOfRealFilesReadBackEqual) {
    if (test::corpusNotice()) return;
    const test::TemporaryFolder folder;
    const fs::path path = folder / "a.voxprite";
    int opened = 0;
    for (const fs::path& file : test::corpusFiles()) {
        const auto loaded = loadDocument(file);
        if (!loaded) continue;
        ++opened;
        const Status saved = saveDocument(path, loaded->document, GameProfile{});
        ASSERT_TRUE(saved) << file << ": " << saved.error().describe();
        const auto read = loadDocument(path);
        ASSERT_TRUE(read) << file << ": " << read.error().describe();
        EXPECT_EQ(read->document, loaded->document) << file;
    }
    EXPECT_GT(opened, 0);
}

TEST(Formats, SayWhatTheyHaveNoWordsFor) {
    Document document = test::busyDocument();
    EXPECT_EQ(lossesOf(document, Format::vox),
              (std::vector<std::string>{
                  ".vox has no clips: 2 left out", ".vox has no sockets: 2 left out",
                  ".vox has no words for all of the entity; left out: its name, anchor, rotation, "
                  "scale and the VoxelSize and sigma it was made with"}));
    EXPECT_TRUE(lossesOf(document, Format::voxprite).empty());
    EXPECT_EQ(
        lossesOf(document, Format::svo),
        (std::vector<std::string>{
            ".svo has no words for all of a palette; left out: materials and the palette's "
            "order of display",
            ".svo holds one model: 7 objects are merged into it",
            ".svo has no hidden objects: 2 left out",
            ".svo holds what is seen of the scene; left out: names of objects, groups, layers "
            "and locks",
            ".svo has no words for all of the entity; left out: rotation and scale"}));
    document.clips.clear();
    document.sockets.clear();
    document.entity = {};
    document.authored = {};
    EXPECT_TRUE(lossesOf(document, Format::vox).empty());
}

// Two frames that no clip shows; one of them looks like one that is shown.
TEST(Formats, SvoTellsWhatBecomesOfFramesWithoutClip) {
    const test::TemporaryFolder folder;
    Document document = test::animationOf(
        {test::figure(), test::asymmetric(), test::figure(), test::solidBox({2, 2, 2})});
    document.clips = {Clip{"step", 0, 1, 8.0, true, {}}};
    document.sockets = {Socket{"hand", {{0, {1, 1, 1}}, {3, {2, 2, 2}}}},
                        Socket{"still", {{0, {1, 1, 1}}}}};
    EXPECT_EQ(lossesOf(document, Format::svo),
              (std::vector<std::string>{
                  ".svo has frames in clips alone: the 2 that no clip shows are added at the end, "
                  "but for those that look like another",
                  ".svo has sockets in clips alone: where they lie in other frames is left out"}));
    const fs::path path = folder / "step.svo";
    ASSERT_TRUE(saveDocument(path, document, GameProfile{}));
    const auto back = loadDocument(path);
    ASSERT_TRUE(back);
    EXPECT_EQ(frameCount(back->document), 3);
    EXPECT_EQ(positionAt(back->document.sockets[0], 2), glm::dvec3(1, 1, 1));
    // What lies in all frames where the last clip leaves it is kept.
    document.sockets.erase(document.sockets.begin());
    EXPECT_EQ(lossesOf(document, Format::svo).size(), 1u);
}

}  // namespace
}  // namespace voxprite
