// Pasted under another palette, voxels keep their looks.
#include "core/edit/clip_colours.h"

#include <gtest/gtest.h>

#include "core/edit/unused_models.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

constexpr Rgba8 kRed(200, 10, 20, 255), kBlue(10, 20, 200, 255), kGreen(10, 180, 40, 255);

VoxelGrid rowOf(std::initializer_list<int> indices) {
    VoxelGrid voxels;
    int x = 0;
    for (const int index : indices) voxels.set({x++, 0, 0}, static_cast<std::uint8_t>(index));
    return voxels;
}

// Vacant but for what the test puts there.
Document emptyPalette() {
    Document document = test::documentOf(VoxelGrid());
    document.palette = Palette{};
    return document;
}

TEST(ClipColours, StayWhereTheDocumentHasTheSame) {
    Document document = emptyPalette();
    Palette source;
    for (Palette* palette : {&document.palette, &source}) {
        palette->colours[3] = kRed;
        palette->colours[9] = kBlue;
    }
    // The same red elsewhere does not lure it away; unused colours may differ.
    document.palette.colours[1] = kRed;
    source.colours[200] = kGreen;
    const ColourMatch match = matchColours(rowOf({3, 9, 3}), source, document);
    EXPECT_TRUE(match.isIdentity());
    EXPECT_EQ(match.palette, document.palette);
}

TEST(ClipColours, GoWhereTheColourIs) {
    Document document = emptyPalette();
    document.palette.colours[4] = kBlue;
    document.palette.colours[7] = kBlue;
    document.palette.names[7] = "Team";
    Palette source;
    source.colours[9] = kBlue;
    EXPECT_EQ(matchColours(rowOf({9}), source, document).indexOf[9], 4);
    source.names[9] = "Team";
    const ColourMatch named = matchColours(rowOf({9}), source, document);
    EXPECT_EQ(named.indexOf[9], 7) << "the one of the same name";
    EXPECT_EQ(named.added, 0);
    EXPECT_FALSE(named.isIdentity());
    const VoxelGrid moved = recoloured(rowOf({9, 9}), named.indexOf);
    EXPECT_EQ(moved, rowOf({7, 7}));
}

TEST(ClipColours, AreAddedWhileThereIsRoom) {
    Document document = emptyPalette();
    document.models[0].voxels = rowOf({1});  // in use, though its place is vacant
    document.palette.colours[2] = kBlue;
    document.palette.variants = {{"Night", {{3, kGreen}}}};  // of a colour that is gone
    Palette source;
    source.colours[2] = kRed;
    source.names[2] = "Blood";
    source.materials[2]["_type"] = "_glass";
    source.colours[5] = kGreen;
    const ColourMatch match = matchColours(rowOf({2, 5}), source, document);
    EXPECT_EQ(match.added, 2);
    EXPECT_EQ(match.approximated, 0);
    EXPECT_EQ(match.indexOf[2], 3);
    EXPECT_EQ(match.indexOf[5], 4);
    EXPECT_EQ(match.palette.colours[3], kRed);
    EXPECT_EQ(match.palette.names[3], "Blood");
    EXPECT_EQ(match.palette.materials[3].at("_type"), "_glass");
    EXPECT_EQ(match.palette.colours[4], kGreen);
    EXPECT_TRUE(match.palette.variants[0].overrides.empty());
    EXPECT_EQ(match.palette.colours[2], kBlue) << "nothing of the document's is taken away";
    EXPECT_EQ(match.palette.colours[1], Rgba8(0));
}

TEST(ClipColours, BecomeTheNearestWhereThereIsNone) {
    Document document = emptyPalette();
    VoxelGrid all;
    for (int i = 1; i < 256; ++i) {
        const auto index = static_cast<std::size_t>(i);
        document.palette.colours[index] = Rgba8(i, i, i, 255);
        all.set({i, 0, 0}, static_cast<std::uint8_t>(i));
    }
    document.palette.colours[40] = Rgba8(250, 5, 5, 255);
    document.models[0].voxels = all;
    Palette source;
    source.colours[8] = kRed;
    const ColourMatch match = matchColours(rowOf({8}), source, document);
    EXPECT_EQ(match.approximated, 1);
    EXPECT_EQ(match.added, 0);
    EXPECT_EQ(match.indexOf[8], 40);
    EXPECT_EQ(match.palette, document.palette);
}

TEST(ClipColours, OfWholeBlocks) {
    VoxelGrid solid = test::solidBox({64, 64, 64}, 6);
    std::array<std::uint8_t, 256> indexOf{};
    indexOf[6] = 11;
    EXPECT_EQ(recoloured(solid, indexOf), test::solidBox({64, 64, 64}, 11));
}

TEST(UnusedModels, AreThoseThatNoObjectShows) {
    Document document = test::busyDocument();
    const int before = unusedModels(document);
    const Document kept = withoutUnusedModels(document);
    EXPECT_EQ(unusedModels(kept), 0);
    EXPECT_EQ(kept.models.size(), document.models.size() - static_cast<std::size_t>(before));

    // One among the others, which then have other numbers and show the same.
    Document more = document;
    more.models.insert(more.models.begin(), Model{});
    for (SceneNode& node : more.nodes) {
        for (ModelKey& key : node.models) ++key.model;
    }
    EXPECT_EQ(unusedModels(more), before + 1);
    EXPECT_EQ(withoutUnusedModels(more), kept);
}

}  // namespace
}  // namespace voxprite
