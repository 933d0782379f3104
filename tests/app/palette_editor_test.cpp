// Choosing and editing colours, as the palette's commands and panel do.
#include "app/editor/panels/palette_editor.h"

#include <gtest/gtest.h>

#include "app/editor/views/variant_pictures.h"
#include "core/io/formats.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/voxels.h"

namespace voxprite::editor {
namespace {

using Indices = std::vector<std::uint8_t>;

class PaletteEditing : public testing::Test {
  protected:
    void SetUp() override {
        Document document = test::documentOf(test::figure());
        document.palette.variants = {{"Red", {{1, Rgba8(200, 0, 0, 255)}}}};
        const test::TemporaryFolder folder;
        ASSERT_TRUE(saveDocument(folder / "figure.voxprite", document, GameProfile{}));
        ASSERT_TRUE(session.open(folder / "figure.voxprite"));
        start = session.document();
    }
    void perform(Action action) {
        const Status performed = session.perform(std::move(action));
        ASSERT_TRUE(performed) << performed.error().describe();
    }
    void undoAll() {
        while (session.history().canUndo()) ASSERT_TRUE(session.undo());
    }

    Session session;
    EditorSettings settings;
    PaletteEditor editor{session, settings};
    Document start;
};

TEST_F(PaletteEditing, TheColourInHandIsAlwaysChosen) {
    EXPECT_EQ(editor.chosen(), (Indices{1}));
    editor.choose(9);
    EXPECT_EQ(settings.tool.colour, 9);
    editor.chooseTo(12);
    EXPECT_EQ(editor.chosen(), (Indices{9, 10, 11, 12}));
    EXPECT_EQ(editor.inHand(), 9);
    editor.chooseTo(7);
    EXPECT_EQ(editor.chosen(), (Indices{7, 8, 9}));
    editor.toggle(8);
    editor.toggle(200);
    EXPECT_EQ(editor.chosen(), (Indices{7, 9, 200}));
    editor.toggle(9);
    EXPECT_EQ(editor.chosen(), (Indices{7, 200}));
    EXPECT_EQ(editor.inHand(), 7);
    editor.choose(0);  // no colour to draw with
    EXPECT_EQ(editor.inHand(), 7);
    editor.choose(3);
    EXPECT_EQ(editor.chosen(), (Indices{3}));
    editor.toggle(3);
    EXPECT_EQ(editor.chosen(), (Indices{3}));
}

TEST_F(PaletteEditing, SteppingFollowsTheDisplayAndPassesOverVacantPlaces) {
    Palette palette = withSlotMoved(start.palette, 5, 2);
    palette.colours[2] = Rgba8(0);
    perform(editor.change("", palette));
    editor.choose(1);
    editor.step(1);
    EXPECT_EQ(editor.inHand(), 5);
    editor.step(1);
    EXPECT_EQ(editor.inHand(), 3);
    editor.step(-1);
    EXPECT_EQ(editor.inHand(), 5);
    editor.choose(1);
    editor.step(-1);
    EXPECT_EQ(editor.inHand(), 255);
    editor.step(1);
    EXPECT_EQ(editor.inHand(), 1);
}

TEST_F(PaletteEditing, EveryEditIsOneStepThatUndoes) {
    editor.choose(20);
    editor.chooseTo(24);
    perform(editor.gradient());
    perform(editor.makeRamp());
    perform(editor.removeRamp());
    editor.choose(100);
    perform(editor.sort(PaletteOrder::lightness));
    perform(editor.suggestRamps());
    perform(editor.removeUnused());
    perform(editor.addVariant("Winter"));
    const auto duplicate = editor.duplicate();
    ASSERT_TRUE(duplicate);
    perform(*duplicate);
    EXPECT_EQ(session.history().position(), 8u);
    EXPECT_EQ(session.document().models, start.models);
    undoAll();
    EXPECT_EQ(session.document(), start);
}

TEST_F(PaletteEditing, AVariantIsEditedWhileItIsShown) {
    EXPECT_EQ(session.shownPalette(), start.palette);
    const std::uint64_t before = session.modelRevision();
    session.showVariant(0);
    EXPECT_GT(session.modelRevision(), before);
    EXPECT_EQ(session.shownPalette().colours[1], Rgba8(200, 0, 0, 255));
    EXPECT_FALSE(session.unsaved());
    editor.choose(4);
    perform(editor.setColour(Rgba8(9, 9, 9, 255), 0));
    EXPECT_EQ(session.document().palette.colours, start.palette.colours);
    EXPECT_EQ(session.shownPalette().colours[4], Rgba8(9, 9, 9, 255));
    // Undo takes away a variant that is shown: the palette's own colours are shown again.
    perform(editor.addVariant("Red"));
    session.showVariant(1);
    EXPECT_EQ(session.document().palette.variants[1].name, "Red 2");
    ASSERT_TRUE(session.undo());
    EXPECT_FALSE(session.variant());
    EXPECT_EQ(session.shownPalette(), session.document().palette);
    undoAll();
    EXPECT_EQ(session.document(), start);
}

TEST_F(PaletteEditing, NoVariantComesBeyondWhatAPaletteCanHave) {
    perform(editor.duplicateVariant(0));
    EXPECT_EQ(session.document().palette.variants[1].name, "Red 2");
    EXPECT_EQ(session.document().palette.variants[1].overrides,
              start.palette.variants[0].overrides);
    while (editor.canAddVariant()) perform(editor.duplicateVariant(0));
    const Palette full = session.document().palette;
    EXPECT_EQ(full.variants.size(), kMaxPaletteVariants);
    perform(editor.duplicateVariant(0));
    perform(editor.addVariant("Winter"));
    EXPECT_EQ(session.document().palette, full);
    EXPECT_TRUE(validate(session.document().palette));
}

TEST_F(PaletteEditing, RecoloursAllVoxelsOfAColour) {
    const ColourCounts counts = editor.counts();
    std::uint8_t used = 1;
    while (counts[used] == 0) ++used;
    ASSERT_EQ(counts[200], 0u);
    perform(editor.recolour(used, 200));
    EXPECT_EQ(editor.counts()[200], counts[used]);
    EXPECT_EQ(editor.counts()[used], 0u);
    undoAll();
    EXPECT_EQ(session.document(), start);
}

TEST_F(PaletteEditing, CountsAreShownAsTheyBecomeKnown) {
    const ColourCounts first = editor.shownCounts(0.0);
    EXPECT_EQ(first, editor.counts());
    std::uint8_t used = 1;
    while (first[used] == 0) ++used;
    perform(editor.recolour(used, 200));
    // Long after, whatever the first counting cost.
    EXPECT_EQ(editor.shownCounts(3600.0)[200], first[used]);
}

TEST_F(PaletteEditing, TheStripShowsTheSameSpriteInOtherColours) {
    const Palette varied = start.palette.withVariant(0);
    const auto plain = smallSprite(session, start.palette, 48);
    const auto red = smallSprite(session, varied, 48);
    ASSERT_TRUE(plain && red);
    EXPECT_LE(plain->size.x, 48);
    EXPECT_LE(plain->size.y, 48);
    EXPECT_GT(plain->size.y, 20);
    EXPECT_EQ(plain->idsSha256(), red->idsSha256());
    Session empty;
    EXPECT_FALSE(smallSprite(empty, start.palette, 48));
}

}  // namespace
}  // namespace voxprite::editor
