#include "core/io/csm_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "core/io/csm_reader.h"
#include "core/io/formats.h"
#include "core/model/entity_voxels.h"
#include "core/svo/bake.h"
#include "tests/core/svo/reference_octree.h"
#include "tests/support/must.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::must;
using testing::ElementsAre;
using testing::HasSubstr;

ByteView bytesOf(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

std::string textOf(const Document& document) {
    const Bytes bytes = must(writeCsm(document));
    return {bytes.begin(), bytes.end()};
}

// What the text is in its canonical form.
std::string canonical(const std::string& text) {
    return textOf(must(readCsm(bytesOf(text))));
}

TEST(CsmWrite, TheCanonicalText) {
    EXPECT_EQ(canonical("> [1 2 3 4 5 6 7 8]"), "> [1 2 3 4 5 6 7 8]\n");
    EXPECT_EQ(canonical(">hg 4 >b 9"), ">b 9\n>h [0 0 0 0 0 0 4 0]\n");
    EXPECT_EQ(canonical("> 42"), "> 42\n");
    EXPECT_EQ(canonical(">a [1 1 1 1 1 1 1 1] >b 1 >c 2"), "> [1 1 2 0 0 0 0 0]\n>aa 1\n");
}

TEST(CsmWrite, SolidsCollapseAndKeepTheirResolution) {
    // Eight cubed of one colour is one value, and says that it is eight.
    EXPECT_EQ(canonical("> 5 >aaa 5"), "> 5\n>aaa 5\n");
    EXPECT_EQ(canonical(">h 5 >aaa 0"), "> [0 0 0 0 0 0 0 5]\n>aaa 0\n");
    EXPECT_EQ(canonical(">aaa 0"), ">aaa 0\n");
    EXPECT_EQ(canonical(">aab 7 >aba [3 3 3 3 3 3 3 3]"),
              ">aa [0 7 0 0 0 0 0 0]\n"
              ">ab [3 0 0 0 0 0 0 0]\n"
              ">aaaa 0\n");
    EXPECT_EQ(canonical(""), "> 0\n");
}

TEST(CsmWrite, OctreesReadBackEqual) {
    std::mt19937 random(31);
    for (int i = 0; i < 150; ++i) {
        const int levels = static_cast<int>(random() % 6);
        const int edge = 1 << levels;
        const VoxelGrid voxels = test::randomModel(random, glm::ivec3(edge / 2), edge);
        const Octree octree = must(bake(voxels, {glm::ivec3(0), glm::ivec3(edge)}));
        const std::string text = csmText(octree.view());
        const Octree read = must(octreeFromCsm(bytesOf(text)));
        EXPECT_EQ(read, octree) << text;
        EXPECT_EQ(csmText(read.view()), text);
    }
}

TEST(CsmWrite, DocumentsFromCsmReadBackEqual) {
    for (const std::string text :
         {"> 1", "> 0", ">h 3", ">aaa 0", ">abc [1 2 3 0 0 0 0 8] >h 200", ">gg 1 | >aaaaa <gg",
          "> [1 [2 0 0 0 0 0 0 0] 0 0 0 0 0 0] | >b < >hh /x <"}) {
        const Document document = must(readCsm(bytesOf(text)));
        const std::string written = textOf(document);
        EXPECT_EQ(must(readCsm(bytesOf(written))), document) << text << "\n" << written;
        EXPECT_EQ(canonical(written), written);
    }
}

TEST(CsmWrite, VoxelsKeepTheirPlaceUnlessItIsBelowZero) {
    const auto voxelsOf = [](const std::string& text) {
        return test::mapOf(must(readCsm(bytesOf(text))).models.at(0).voxels);
    };
    VoxelGrid voxels;
    voxels.set({5, 0, 9}, 1);
    voxels.set({6, 2, 9}, 2);
    EXPECT_EQ(voxelsOf(textOf(test::documentOf(voxels))), test::mapOf(voxels));
    voxels.set({5, -3, 9}, 4);
    test::VoxelMap moved;
    for (const auto& [at, value] : test::mapOf(voxels)) {
        moved[{std::get<0>(at), std::get<1>(at) + 3, std::get<2>(at)}] = value;
    }
    EXPECT_EQ(voxelsOf(textOf(test::documentOf(voxels))), moved);
    EXPECT_THAT(csmLosses(test::documentOf(voxels)).back(), HasSubstr("moved by 0, 3, 0"));
    // Too far away for 65,536: by the voxels themselves.
    VoxelGrid far;
    far.set({70000, 5, 5}, 1);
    EXPECT_EQ(textOf(test::documentOf(far)), "> 1\n");
    far.set({0, 0, 0}, 1);
    EXPECT_FALSE(writeCsm(test::documentOf(far)));
}

TEST(CsmWrite, TheFirstFrameAsItIsSeen) {
    const Document busy = test::busyDocument();
    const Document read = must(readCsm(must(writeCsm(busy))));
    const VoxelGrid expected = flatten(busy, 0);
    const glm::ivec3 shift = read.models[0].voxels.bounds().min - expected.bounds().min;
    test::VoxelMap shifted;
    for (const auto& [at, value] : test::mapOf(expected)) {
        shifted[{std::get<0>(at) + shift.x, std::get<1>(at) + shift.y, std::get<2>(at) + shift.z}] =
            value;
    }
    EXPECT_EQ(test::mapOf(read.models[0].voxels), shifted);
}

TEST(CsmWrite, WhatIsLostIsSaid) {
    Document document = must(readCsm(bytesOf(">b 9 >hg 4")));
    const std::string colours =
        ".csm holds palette indices alone: colours, names and materials are left out";
    const auto losses = [](const Document& d) { return lossesOf(d, Format::csm); };
    EXPECT_THAT(losses(document), ElementsAre(colours));
    document.entity.anchorVoxels = glm::dvec3(1, 2, 3);
    document.sockets.push_back({"hand"});
    document.clips.push_back({"walk"});
    EXPECT_THAT(
        losses(document),
        ElementsAre(colours, ".csm has no clips: 1 left out", ".csm has no sockets: 1 left out",
                    ".csm has no words for all of the entity; left out: anchor"));

    const std::vector<std::string> busy = losses(test::busyDocument());
    EXPECT_THAT(busy, testing::Contains(HasSubstr("objects are merged into it")));
    EXPECT_THAT(busy, testing::Contains(HasSubstr("hidden objects")));
    EXPECT_THAT(busy, testing::Contains(HasSubstr("frames")));
    EXPECT_THAT(busy, testing::Contains(HasSubstr("is moved by")));
}

}  // namespace
}  // namespace voxprite
