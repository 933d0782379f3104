#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <numeric>

#include "core/base/file.h"
#include "core/io/svo_file.h"
#include "core/io/vox.h"
#include "core/model/entity_voxels.h"
#include "core/svo/bake.h"
#include "tests/core/io/svo_sections.h"
#include "tests/support/corpus.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Bytes exported(const Document& document) {
    return writeSvo(bakeForExport(document, GameProfile{}).value()).value();
}

VoxelGrid boxAt(glm::ivec3 min, glm::ivec3 size, std::uint8_t value) {
    VoxelGrid voxels;
    voxels.fill({min, min + size}, value);
    return voxels;
}

// A box that grows and shrinks again: frames 1 and 3 are equal though their models differ.
Document growing() {
    return test::animationOf({boxAt({0, 0, 0}, {2, 2, 2}, 1), boxAt({-1, 0, 0}, {4, 2, 5}, 2),
                              boxAt({-3, 0, 0}, {8, 3, 7}, 3), boxAt({-1, 0, 0}, {4, 2, 5}, 2)});
}

void expectDiffers(const Bytes& bytes, const Document& document, const char* reason) {
    const Status same = verifyExport(bytes, document);
    ASSERT_FALSE(same.has_value()) << reason;
    EXPECT_THAT(same.error().message, HasSubstr(reason));
}

TEST(SvoExport, OneFrameIsOneModelWithoutClips) {
    Document document = test::documentOf(test::figure());
    document.entity.name = "figure";
    GameProfile profile;
    profile.voxelSizeMetres = 0.05;
    profile.sigma = 3.0;
    profile.outline.colour = {40, 0, 0, 255};
    const SvoFile file = bakeForExport(document, profile).value();
    ASSERT_EQ(file.models.size(), 1u);
    EXPECT_EQ(file.models[0].name, "figure");
    EXPECT_EQ(toVoxels(file.models[0].octree), test::figure());
    EXPECT_TRUE(file.clips.empty());
    EXPECT_EQ(file.name, "figure");
    EXPECT_EQ(file.palette, document.palette.colours);
    EXPECT_EQ(file.voxelSizeMetres, 0.05);
    EXPECT_EQ(file.sigma, 3.0);
    EXPECT_EQ(file.outline, profile.outline);
    EXPECT_TRUE(verifyExport(writeSvo(file).value(), document));
}

TEST(SvoExport, AnchorCountsFromTheMinimumCorner) {
    Document document = test::documentOf(boxAt({-10, 4, 100}, {6, 2, 3}, 1));
    EXPECT_EQ(bakeForExport(document, {}).value().anchor, glm::dvec3(3.0, 1.0, 0.0));
    document.entity.anchorVoxels = glm::dvec3(0.0, 0.5, 99.0);
    EXPECT_EQ(bakeForExport(document, {}).value().anchor, glm::dvec3(10.0, -3.5, -1.0));
}

TEST(SvoExport, FramesHaveTheBoundsOfTheEntityAndEqualOnesAreShared) {
    const SvoFile file = bakeForExport(growing(), {}).value();
    ASSERT_EQ(file.models.size(), 3u);
    for (const SvoModel& model : file.models) {
        EXPECT_EQ(model.octree.size, glm::ivec3(8, 3, 7));
        EXPECT_EQ(model.octree.origin, glm::ivec3(-3, 0, 0));
    }
    ASSERT_EQ(file.clips.size(), 1u);
    EXPECT_EQ(file.clips[0].name, "all");
    EXPECT_THAT(file.clips[0].models, ElementsAre(0, 1, 2, 1));
    EXPECT_THAT(file.clips[0].durationsMilliseconds, ElementsAre(125, 125, 125, 125));
    EXPECT_TRUE(file.clips[0].loop);
}

TEST(SvoExport, ClipsComeFromTheDocument) {
    Document document = growing();
    document.clips = {{"up", 0, 2, 24.0, false}, {"down", 2, 3, 1000.0, true}};
    const SvoFile file = bakeForExport(document, {}).value();
    ASSERT_EQ(file.clips.size(), 2u);
    EXPECT_THAT(file.clips[0].models, ElementsAre(0, 1, 2));
    const auto& durations = file.clips[0].durationsMilliseconds;
    EXPECT_EQ(std::accumulate(durations.begin(), durations.end(), 0u), 125u);  // three of 24
    EXPECT_FALSE(file.clips[0].loop);
    EXPECT_THAT(file.clips[1].models, ElementsAre(2, 1));
    EXPECT_THAT(file.clips[1].durationsMilliseconds, ElementsAre(1, 1));
    EXPECT_TRUE(verifyExport(writeSvo(file).value(), document));
}

TEST(SvoExport, ClipsKeepTheirDurationsFromFileToFile) {
    Document document = growing();
    // 6 and 24 frames a second are no whole number of milliseconds a frame.
    document.clips = {{"walk", 0, 3, 6.0, true}, {"run", 0, 3, 24.0, true}, {"odd", 0, 3, 7.3}};
    const Bytes bytes = exported(document);
    const Document again = documentFromSvo(readSvo(bytes).value());
    EXPECT_EQ(again.clips[0].framesPerSecond, 6.0);
    EXPECT_EQ(again.clips[1].framesPerSecond, 24.0);
    EXPECT_EQ(exported(again), bytes);
}

TEST(SvoExport, BusyDocumentIsExactInEveryFrame) {
    const Document document = test::busyDocument();
    const Bytes bytes = exported(document);
    ASSERT_TRUE(verifyExport(bytes, document));
    const SvoFile file = readSvo(bytes).value();
    ASSERT_EQ(file.clips.size(), 2u);
    for (int frame = 0; frame < 4; ++frame) {
        const std::uint32_t model = file.clips[0].models[static_cast<std::size_t>(frame)];
        EXPECT_EQ(toVoxels(file.models[model].octree), flatten(document, frame)) << frame;
    }
    EXPECT_EQ(toVoxels(file.models[file.clips[1].models[0]].octree), flatten(document, 4));
    EXPECT_EQ(file.colourNames[7], "amber glass");
}

// The minimal reader that svo_file.h gives, on the bare sections.
std::uint32_t voxelByTheManual(const std::uint32_t* n, const std::uint64_t* p, unsigned maxDepth,
                               unsigned x, unsigned y, unsigned z) {
    std::uint32_t w = n[0];
    for (int bit = static_cast<int>(maxDepth) - 1;; --bit) {
        const unsigned o = (z >> bit & 1) << 2 | (y >> bit & 1) << 1 | (x >> bit & 1);
        if (!(w >> 31)) {
            return w >> 30 ? static_cast<std::uint8_t>(p[w & 0x3FFFFFFF] >> 8 * o) : w;
        }
        if (!(w >> o & 1)) return 0;
        w = n[(w >> 8 & 0x7FFFFF) + static_cast<unsigned>(std::popcount(w & ((1u << o) - 1)))];
    }
}

TEST(SvoExport, TheManualsReaderReadsEveryFrame) {
    const Document document = growing();
    std::vector<test::SvoSection> sections = test::sectionsOf(exported(document));
    const Bytes& models = test::sectionNamed(sections, "MODL").bytes;
    const Bytes& frames = test::sectionNamed(sections, "FRAM").bytes;
    std::vector<std::uint32_t> nodes(test::sectionNamed(sections, "NODE").bytes.size() / 4);
    std::memcpy(nodes.data(), test::sectionNamed(sections, "NODE").bytes.data(), 4 * nodes.size());
    std::vector<std::uint64_t> payloads(test::sectionNamed(sections, "PAYL").bytes.size() / 8);
    std::memcpy(payloads.data(), test::sectionNamed(sections, "PAYL").bytes.data(),
                8 * payloads.size());
    for (int frame = 0; frame < 4; ++frame) {
        const auto model =
            64 * test::valueAt<std::uint32_t>(frames, 8 * static_cast<std::size_t>(frame));
        const auto word = [&](std::size_t at) {
            return test::valueAt<std::uint32_t>(models, model + at);
        };
        const glm::ivec3 origin(static_cast<int>(word(32)), static_cast<int>(word(36)),
                                static_cast<int>(word(40)));
        const VoxelGrid voxels = flatten(document, frame);
        for (unsigned x = 0; x < word(12); ++x) {
            for (unsigned y = 0; y < word(16); ++y) {
                for (unsigned z = 0; z < word(20); ++z) {
                    EXPECT_EQ(voxelByTheManual(nodes.data() + word(0), payloads.data() + word(4),
                                               word(8), x, y, z),
                              voxels.get(origin + glm::ivec3(x, y, z)));
                }
            }
        }
    }
}

TEST(SvoExport, EmptyDocumentIsExportedToo) {
    const Document document = Document::withEmptyModel();
    const Bytes bytes = exported(document);
    EXPECT_TRUE(verifyExport(bytes, document));
    EXPECT_TRUE(flatten(documentFromSvo(readSvo(bytes).value()), 0).empty());
}

TEST(SvoExport, NamesBecomeUtf8) {
    Document document = growing();
    document.entity.name = "caf\xE9";
    document.palette.names[3] = "\xFF";
    document.clips = {{"\xE9t\xE9", 0, 3, 8.0, true}};
    const SvoFile file = readSvo(exported(document)).value();
    EXPECT_EQ(file.name, "café");
    EXPECT_EQ(file.colourNames[3], "ÿ");
    EXPECT_EQ(file.clips[0].name, "été");
}

TEST(SvoExport, TooLongIsRefused) {
    VoxelGrid voxels = boxAt({0, 0, 0}, {1, 1, 1}, 1);
    voxels.set({70000, 0, 0}, 1);
    const Result<SvoFile> file = bakeForExport(test::documentOf(voxels), {});
    ASSERT_FALSE(file.has_value());
    EXPECT_THAT(file.error().message, HasSubstr("65,536"));
}

TEST(SvoExport, VerificationSeesEveryDifference) {
    const Document document = growing();
    const Bytes bytes = exported(document);
    ASSERT_TRUE(verifyExport(bytes, document));

    Document other = document;
    other.models[2].voxels.set({2, 1, 3}, 77);
    expectDiffers(bytes, other, "frame 2, voxel (2, 1, 3) should be 77 and is 3");
    other.models[2].voxels.set({2, 1, 3}, 0);
    expectDiffers(bytes, other, "frame 2, voxel (2, 1, 3) should be 0 and is 3");
    other = document;
    other.models[0].voxels.set({3, 0, 0}, 1);
    expectDiffers(bytes, other, "frame 0, voxel (3, 0, 0) should be 1 and is 0");
    other = document;
    other.palette.colours[9].x ^= 1;
    expectDiffers(bytes, other, "palette");
    other = document;
    other.entity.anchorVoxels = glm::dvec3(0.0);
    expectDiffers(bytes, other, "anchor");
    other = document;
    other.clips = {{"half", 0, 1, 8.0, true}};
    expectDiffers(bytes, other, "clips");
    other.clips.push_back(other.clips[0]);
    expectDiffers(bytes, other, "clips");
    Bytes damaged = bytes;
    damaged[bytes.size() / 2] ^= 1;
    EXPECT_FALSE(verifyExport(damaged, document));
}

TEST(SvoExport, FramesOutsideEveryClipAreExportedAndVerified) {
    Document document = growing();
    document.clips = {{"start", 0, 1, 8.0, true}};
    const Bytes bytes = exported(document);
    EXPECT_TRUE(verifyExport(bytes, document));
    document.models[2].voxels.set({2, 1, 3}, 77);
    expectDiffers(bytes, document, "frame 2");
}

TEST(SvoExport, OneSourceModelAlone) {
    const Document document = test::busyDocument();
    for (int model = 0; model < static_cast<int>(document.models.size()); ++model) {
        const SvoFile file = bakeModelForExport(document, {}, model).value();
        ASSERT_EQ(file.models.size(), 1u);
        const VoxelGrid& voxels = document.models[static_cast<std::size_t>(model)].voxels;
        EXPECT_EQ(toVoxels(file.models[0].octree), voxels);
        const Bytes bytes = writeSvo(file).value();
        EXPECT_TRUE(verifyModelExport(bytes, document, model));
        const int another = model == 0 ? 1 : 0;
        EXPECT_FALSE(verifyModelExport(bytes, document, another));
    }
    EXPECT_FALSE(bakeModelForExport(document, {}, -1).has_value());
    EXPECT_FALSE(bakeModelForExport(document, {}, 99).has_value());
}

TEST(SvoExport, OpensAsADocumentAgain) {
    for (const Document& document :
         {test::documentOf(test::asymmetric()), growing(), test::busyDocument()}) {
        const Bytes bytes = exported(document);
        const Document again = documentFromSvo(readSvo(bytes).value());
        const Status valid = validate(again);
        ASSERT_TRUE(valid.has_value()) << valid.error().message;
        ASSERT_EQ(frameCount(again), frameCount(document));
        for (int frame = 0; frame < frameCount(document); ++frame) {
            EXPECT_EQ(flatten(again, frame), flatten(document, frame));
        }
        EXPECT_EQ(entityBounds(again), entityBounds(document));
        EXPECT_EQ(anchorVoxels(again.entity, entityBounds(again)),
                  anchorVoxels(document.entity, entityBounds(document)));
        EXPECT_EQ(again.palette.colours, document.palette.colours);
        EXPECT_EQ(again.entity.name, document.entity.name);
        EXPECT_TRUE(verifyExport(exported(again), again));
    }
    const Bytes bytes = exported(growing());
    EXPECT_EQ(exported(documentFromSvo(readSvo(bytes).value())), bytes);
}

TEST(SvoExport, EveryModelOfTheCorpusComesBack) {
    if (test::corpusNotice()) return;
    int files = 0;
    for (const auto& path : test::corpusFiles()) {
        const Result<VoxImport> import = readVox(readFile(path).value());
        if (!import) continue;
        SCOPED_TRACE(path.string());
        ++files;
        const Document& document = import->document;
        const Result<SvoFile> baked = bakeForExport(document, GameProfile{});
        ASSERT_TRUE(baked.has_value()) << baked.error().message;
        const Bytes bytes = writeSvo(*baked).value();
        const Status same = verifyExport(bytes, document);
        EXPECT_TRUE(same.has_value()) << same.error().message;
        const Document again = documentFromSvo(readSvo(bytes).value());
        EXPECT_TRUE(validate(again));
        EXPECT_EQ(flatten(again, 0),
                  flatten(document, document.clips.empty() ? 0 : document.clips[0].first));
    }
    EXPECT_GT(files, 10);
}

}  // namespace
}  // namespace voxprite
