#include "core/edit/palette_edits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "core/base/oklab.h"
#include "tests/support/random.h"

namespace voxprite {
namespace {

using Indices = std::vector<std::uint8_t>;

Rgba8 grey(int value) {
    return {value, value, value, 255};
}

// A few colours, their voxels, a ramp and a variant.
Document documentOfColours() {
    Document document = Document::withEmptyModel();
    document.palette = Palette{};
    for (int i = 1; i <= 12; ++i) {
        document.palette.colours[static_cast<std::size_t>(i)] = grey(20 * i);
        document.palette.names[static_cast<std::size_t>(i)] = "grey " + std::to_string(i);
    }
    document.palette.materials[2] = {{"_type", "_metal"}};
    document.palette.ramps = {{"shades", {3, 4, 5}}};
    document.palette.variants = {{"Red", {{2, Rgba8(200, 0, 0, 255)}, {5, Rgba8(90, 0, 0, 255)}}}};
    document.models.resize(2);
    document.models[0].voxels.fill({{0, 0, 0}, {16, 16, 16}}, 2);
    document.models[0].voxels.set({3, 3, 3}, 7);
    document.models[0].voxels.set({4, 3, 3}, 0);
    document.models[1].voxels.set({-5, 6, 7}, 7);
    document.models[1].voxels.set({-6, 6, 7}, 9);
    return document;
}

TEST(PaletteEdits, CountsAreThoseOfAllModels) {
    const ColourCounts counts = colourCounts(documentOfColours());
    EXPECT_EQ(counts[0], 0u);
    EXPECT_EQ(counts[2], 4094u);
    EXPECT_EQ(counts[7], 2u);
    EXPECT_EQ(counts[9], 1u);
    EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}), 4097u);
}

TEST(PaletteEdits, AVariantKeepsOnlyWhatDiffers) {
    const Palette start = documentOfColours().palette;
    const Palette own = withColour(start, std::nullopt, 4, Rgba8(1, 2, 3, 255));
    EXPECT_EQ(own.colours[4], Rgba8(1, 2, 3, 255));
    const Palette varied = withColour(start, 0, 4, Rgba8(1, 2, 3, 255));
    EXPECT_EQ(varied.colours, start.colours);
    EXPECT_EQ(varied.withVariant(0).colours[4], Rgba8(1, 2, 3, 255));
    EXPECT_EQ(withColour(varied, 0, 4, start.colours[4]), start);
    EXPECT_EQ(withColour(start, std::nullopt, 0, grey(9)), start);
}

TEST(PaletteEdits, SwappingTwiceIsNothing) {
    const Palette start = documentOfColours().palette;
    const Palette swapped = withSwapped(start, 2, 9);
    EXPECT_EQ(swapped.colours[9], start.colours[2]);
    EXPECT_EQ(swapped.names[2], "grey 9");
    EXPECT_EQ(swapped.materials[9], start.materials[2]);
    EXPECT_EQ(swapped.variants[0].overrides.at(9), Rgba8(200, 0, 0, 255));
    EXPECT_FALSE(swapped.variants[0].overrides.contains(2));
    EXPECT_EQ(withSwapped(swapped, 2, 9), start);
    EXPECT_EQ(withSwapped(start, 2, 5).variants[0].overrides.at(5), Rgba8(200, 0, 0, 255));
}

TEST(PaletteEdits, ADuplicateTakesAFreePlaceAndIsShownBeside) {
    const Document document = documentOfColours();
    const ColourCounts counts = colourCounts(document);
    ASSERT_EQ(freeIndex(document.palette, counts), 13);
    const Palette palette = withDuplicate(document.palette, 5, 13);
    EXPECT_EQ(palette.colours[13], grey(100));
    EXPECT_EQ(palette.names[13], "grey 5");
    EXPECT_EQ(palette.variants[0].overrides.at(13), Rgba8(90, 0, 0, 255));
    EXPECT_EQ(palette.displayOrder[5], 5);
    EXPECT_EQ(palette.displayOrder[6], 13);
    EXPECT_EQ(palette.displayOrder[7], 6);
    EXPECT_FALSE(palette.rampOf(13));
    EXPECT_TRUE(validate(palette));
}

TEST(PaletteEdits, InAFullPaletteOnlyWhatNobodyUsesIsFree) {
    Palette palette = Palette::standard();
    ColourCounts counts{};
    counts.fill(1);
    EXPECT_FALSE(freeIndex(palette, counts));
    counts[40] = counts[80] = counts[120] = counts[160] = 0;
    palette.names[160] = "sky";
    palette.ramps = {{"", {120, 121}}};
    EXPECT_EQ(freeIndex(palette, counts), 80);
    palette.variants = {{"x", {{80, grey(1)}}}};
    EXPECT_EQ(freeIndex(palette, counts), 40);
}

TEST(PaletteEdits, AGradientStepsEvenlyToTheEye) {
    Palette palette = documentOfColours().palette;
    palette.colours[1] = Rgba8(20, 30, 120, 255);
    palette.colours[6] = Rgba8(250, 220, 90, 255);
    const Indices through{1, 9, 3, 2, 6};
    const Palette after = withGradient(palette, std::nullopt, through);
    EXPECT_EQ(after.colours[1], palette.colours[1]);
    EXPECT_EQ(after.colours[6], palette.colours[6]);
    EXPECT_EQ(after.colours[4], palette.colours[4]);
    const OkLab first = okLabFrom(palette.colours[1]), last = okLabFrom(palette.colours[6]);
    for (std::size_t i = 1; i < 4; ++i) {
        const OkLab wanted = mix(first, last, static_cast<double>(i) / 4.0);
        // A byte a channel is about this far from the exact colour.
        EXPECT_LT(squaredDistance(okLabFrom(after.colours[through[i]]), wanted), 2e-5);
    }
    // In a variant, between its own ends, and the palette stays.
    const Palette varied = withGradient(palette, 0, Indices{2, 3, 5});
    EXPECT_EQ(varied.colours, palette.colours);
    const Rgba8 between = varied.withVariant(0).colours[3];
    EXPECT_GT(between.x, 90);
    EXPECT_LT(between.x, 200);
    EXPECT_LT(between.y, 20);
}

TEST(PaletteEdits, UnusedColoursGoAndTheirPlacesStayInOrder) {
    const Document document = documentOfColours();
    const Palette after = withoutUnused(document.palette, colourCounts(document));
    for (const std::uint8_t kept : Indices{2, 3, 4, 5, 7, 9}) {
        EXPECT_EQ(after.colours[kept], document.palette.colours[kept]);
        EXPECT_EQ(after.names[kept], document.palette.names[kept]);
    }
    for (const std::uint8_t gone : Indices{1, 6, 8, 10, 11, 12, 13, 255})
        EXPECT_TRUE(after.isVacant(gone));
    EXPECT_EQ(after.displayOrder, document.palette.displayOrder);
    EXPECT_EQ(after.ramps, document.palette.ramps);
}

TEST(PaletteEdits, SlotsMoveAndColoursKeepTheirIndices) {
    const Palette start = Palette::standard();
    Palette moved = withSlotMoved(start, 10, 3);
    EXPECT_EQ(moved.displayOrder[3], 10);
    EXPECT_EQ(moved.displayOrder[4], 3);
    EXPECT_EQ(moved.displayOrder[10], 9);
    EXPECT_EQ(moved.displayOrder[11], 11);
    EXPECT_EQ(moved.colours, start.colours);
    EXPECT_EQ(withSlotMoved(moved, 3, 10), start);
    EXPECT_EQ(withSlotMoved(start, 0, 5), start);
    EXPECT_EQ(withSlotMoved(start, 5, 0), start);
    test::Random random(4);
    for (int i = 0; i < 500; ++i) {
        moved = withSlotMoved(std::move(moved), static_cast<std::size_t>(random.between(0, 255)),
                              static_cast<std::size_t>(random.between(0, 255)));
    }
    EXPECT_TRUE(validate(moved));
}

TEST(PaletteEdits, OrdersAreOfTheDisplayAlone) {
    const Palette start = Palette::standard();
    Indices all;
    for (int i = 1; i < 256; ++i) all.push_back(static_cast<std::uint8_t>(i));
    ColourCounts counts{};
    counts[17] = 5;
    counts[99] = 8;
    const Palette byUse = withOrder(start, all, PaletteOrder::use, counts);
    EXPECT_EQ(byUse.displayOrder[1], 99);
    EXPECT_EQ(byUse.displayOrder[2], 17);
    EXPECT_EQ(byUse.displayOrder[3], 1);
    EXPECT_EQ(byUse.colours, start.colours);
    EXPECT_EQ(withOrder(byUse, all, PaletteOrder::index, counts), start);

    const Palette byLight = withOrder(start, all, PaletteOrder::lightness, counts);
    for (std::size_t slot = 2; slot < 256; ++slot) {
        EXPECT_GE(okLabFrom(byLight.colours[byLight.displayOrder[slot - 1]]).lightness,
                  okLabFrom(byLight.colours[byLight.displayOrder[slot]]).lightness);
    }
    const Palette byHue = withOrder(start, all, PaletteOrder::hue, counts);
    EXPECT_TRUE(validate(byHue));
    EXPECT_EQ(byHue.displayOrder[1], 255);  // 0x11 grey, the darkest of the greys
    double before = -1.0;
    for (std::size_t slot = 1; slot < 256; ++slot) {
        const OkLab colour = okLabFrom(byHue.colours[byHue.displayOrder[slot]]);
        if (chromaOf(colour) < 0.02) continue;
        EXPECT_GE(hueDegreesOf(colour), before);
        before = hueDegreesOf(colour);
    }
    // Only the slots of the chosen ones, vacant places last.
    Palette few = documentOfColours().palette;
    few = withOrder(few, Indices{200, 3, 8, 5}, PaletteOrder::lightness, counts);
    EXPECT_EQ(few.displayOrder[3], 8);
    EXPECT_EQ(few.displayOrder[5], 5);
    EXPECT_EQ(few.displayOrder[8], 3);
    EXPECT_EQ(few.displayOrder[200], 200);
}

TEST(PaletteEdits, RampsGoFromDarkToLightAndShareNothing) {
    Palette palette = documentOfColours().palette;
    palette = withRamp(palette, Indices{9, 1, 4, 4, 0, 77});
    ASSERT_EQ(palette.ramps.size(), 2u);
    EXPECT_EQ(palette.ramps[0].indices, (Indices{3, 5}));
    EXPECT_EQ(palette.ramps[1].indices, (Indices{1, 4, 9}));
    EXPECT_TRUE(validate(palette));
    // A ramp of one goes.
    palette = withRamp(palette, Indices{3, 2});
    ASSERT_EQ(palette.ramps.size(), 2u);
    EXPECT_EQ(palette.ramps[0].indices, (Indices{1, 4, 9}));
    EXPECT_EQ(withRamp(palette, Indices{8}), palette);
    EXPECT_EQ(withoutRamp(palette, 0).ramps.size(), 1u);
}

TEST(PaletteEdits, StepsOfARampGoWhereTheyAreDragged) {
    Palette palette = documentOfColours().palette;
    palette.ramps = {{"", {1, 4, 9, 3}}};
    EXPECT_EQ(withRampStepMoved(palette, 0, 0, 2).ramps[0].indices, (Indices{4, 9, 1, 3}));
    EXPECT_EQ(withRampStepMoved(palette, 0, 3, 0).ramps[0].indices, (Indices{3, 1, 4, 9}));
    EXPECT_EQ(withRampStepMoved(palette, 0, 2, 2), palette);
    EXPECT_EQ(withRampStepMoved(palette, 0, 4, 0), palette);
    EXPECT_EQ(withRampStepMoved(palette, 0, 0, 4), palette);
    EXPECT_EQ(withRampStepMoved(palette, 1, 0, 1), palette);
    EXPECT_TRUE(validate(withRampStepMoved(palette, 0, 1, 3)));
}

TEST(PaletteEdits, SuggestedRampsFollowAHue) {
    Palette palette;
    const auto set = [&](std::size_t index, int r, int g, int b) {
        palette.colours[index] = Rgba8(r, g, b, 255);
    };
    set(1, 120, 20, 20);
    set(2, 190, 40, 36);
    set(3, 240, 90, 80);
    set(4, 20, 60, 20);
    set(5, 40, 120, 40);
    set(6, 70, 70, 70);
    set(7, 130, 130, 130);
    set(8, 30, 30, 200);  // alone of its hue
    const Palette after = withSuggestedRamps(palette, Indices{8, 7, 6, 5, 4, 3, 2, 1, 99});
    std::set<Indices> ramps;
    for (const PaletteRamp& ramp : after.ramps) ramps.insert(ramp.indices);
    EXPECT_EQ(ramps, (std::set<Indices>{{1, 2, 3}, {4, 5}, {6, 7}}));
    EXPECT_TRUE(validate(after));
    EXPECT_EQ(withSuggestedRamps(after, Indices{1, 2, 3, 4, 5, 6, 7, 8}), after);
}

TEST(PaletteEdits, VariantsComeAndGo) {
    Palette palette = documentOfColours().palette;
    EXPECT_EQ(freeVariantName(palette, "Red"), "Red 2");
    EXPECT_EQ(freeVariantName(palette, ""), "Variant");
    palette = withVariantAdded(palette, 0, "Blue");
    EXPECT_EQ(palette.variants[1].overrides, palette.variants[0].overrides);
    palette = withVariantAdded(palette, std::nullopt, "Winter");
    EXPECT_TRUE(palette.variants[2].overrides.empty());
    EXPECT_TRUE(validate(palette));
    palette = withVariantRemoved(palette, 0);
    EXPECT_EQ(palette.variantNamed("Blue"), 0u);
    EXPECT_FALSE(palette.variantNamed("Red"));
}

TEST(PaletteEdits, ListsGoOutAndComeInByTheOrderOfDisplay) {
    Palette palette = documentOfColours().palette;
    palette = withSlotMoved(palette, 12, 1);
    const ColourList list = colourList(palette);
    ASSERT_EQ(list.size(), 12u);
    EXPECT_EQ(list[0], (NamedColour{grey(240), "grey 12"}));
    EXPECT_EQ(list[1], (NamedColour{grey(20), "grey 1"}));
    EXPECT_EQ(colourList(palette, 0)[2].colour, Rgba8(200, 0, 0, 255));
    EXPECT_EQ(withColours(palette, std::nullopt, list), palette);
    const Palette changed =
        withColours(palette, std::nullopt, {{Rgba8(1, 2, 3, 255), ""}, {grey(7), "soot"}});
    EXPECT_EQ(changed.colours[12], Rgba8(1, 2, 3, 255));
    EXPECT_EQ(changed.names[12], "grey 12");
    EXPECT_EQ(changed.names[1], "soot");
    EXPECT_EQ(changed.colours[2], palette.colours[2]);
    EXPECT_EQ(changed.displayOrder, palette.displayOrder);
    const Palette varied = withColours(palette, 0, {{Rgba8(1, 2, 3, 255), "no"}});
    EXPECT_EQ(varied.names, palette.names);
    EXPECT_EQ(varied.variants[0].overrides.at(12), Rgba8(1, 2, 3, 255));
}

TEST(PaletteEdits, RecolouringIsAStepThatUndoesExactly) {
    Workspace workspace;
    workspace.document = documentOfColours();
    const Document start = workspace.document;
    History history;
    Action action = recolour(start, 7, 9);
    ASSERT_TRUE(makeParts(action, start));
    history.execute(workspace, action);
    EXPECT_EQ(history.steps().back().label, "Recolour 2 voxels");
    const ColourCounts counts = colourCounts(workspace.document);
    EXPECT_EQ(counts[7], 0u);
    EXPECT_EQ(counts[9], 3u);
    EXPECT_EQ(counts[2], 4094u);
    history.undo(workspace);
    EXPECT_EQ(workspace.document, start);
    for (Action nothing : {recolour(start, 7, 0), recolour(start, 0, 7), recolour(start, 7, 7)}) {
        ASSERT_TRUE(makeParts(nothing, start));
        EXPECT_TRUE(nothing.parts.empty());
    }
}

TEST(PaletteEdits, RecolouringMoreThanAStepHoldsIsRefused) {
    Document document = documentOfColours();
    // Each model alone would do.
    for (Model& model : document.models) model.voxels.fill({{0, 0, 0}, {256, 256, 320}}, 2);
    Action action = recolour(document, 2, 3);
    const Status made = makeParts(action, document);
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().message,
              "The edit is too large: it would change 41943040 voxels; at most 33554432 voxels "
              "change at once");
}

// Any edits in any order: the palette stays valid, no voxel changes, undo leads back.
TEST(PaletteEdits, AnySequenceKeepsThePaletteValid) {
    Workspace workspace;
    workspace.document = documentOfColours();
    const Document start = workspace.document;
    const ColourCounts counts = colourCounts(start);
    History history;
    test::Random random(21);
    const auto index = [&] { return static_cast<std::uint8_t>(random.between(0, 30)); };
    const auto indices = [&] {
        std::set<std::uint8_t> chosen;
        for (int i = random.between(0, 6); i > 0; --i) chosen.insert(index());
        return Indices(chosen.begin(), chosen.end());
    };
    for (int step = 0; step < 2000; ++step) {
        const Palette before = workspace.document.palette;
        Palette after = before;
        VariantIndex variant;
        if (!before.variants.empty() && random.chance(0.5)) {
            variant = random.next() % before.variants.size();
        }
        switch (random.between(0, 11)) {
            case 0:
                after = withColour(after, variant, index(), grey(random.between(0, 255)));
                break;
            case 1:
                after = withSwapped(after, index(), index());
                break;
            case 2:
                after = withDuplicate(after, index(), index());
                break;
            case 3:
                after = withGradient(after, variant, indices());
                break;
            case 4:
                after = withoutUnused(after, counts);
                break;
            case 5:
                after = withSlotMoved(after, index(), index());
                break;
            case 6:
                after = withOrder(after, indices(), static_cast<PaletteOrder>(random.between(0, 3)),
                                  counts);
                break;
            case 7:
                after = withRamp(after, indices());
                break;
            case 8:
                after = withSuggestedRamps(after, indices());
                break;
            case 9:
                if (!after.ramps.empty()) after = withoutRamp(after, 0);
                break;
            case 10:
                if (after.variants.size() < 6) {
                    after = withVariantAdded(after, variant, freeVariantName(after, "Team"));
                } else {
                    after = withVariantRemoved(after, 0);
                }
                break;
            default:
                after = withColours(after, variant, colourList(after, variant));
                break;
        }
        ASSERT_TRUE(validate(after)) << step;
        Action action;
        action.parts.emplace_back(PaletteEdit{before, after});
        history.execute(workspace, std::move(action));
    }
    EXPECT_EQ(workspace.document.models, start.models);
    while (history.canUndo()) history.undo(workspace);
    EXPECT_EQ(workspace.document, start);
}

}  // namespace
}  // namespace voxprite
