// The palette panel, by hand: choosing, dragging, recolouring, a variant; all of it undone.
#include <array>

#include "core/edit/palette_edits.h"
#include "core/io/formats.h"
#include "tests/app/editor_window.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;

class PaletteInAWindow : public EditorWindow {
  protected:
    // Where a slot's swatch is, in a grid of 16 x 16.
    glm::ivec2 swatch(int slot) {
        const auto found = layout();
        const Json& box = found.at("items").at("palette.swatches");
        const double width = (box[2].get<double>() - box[0].get<double>()) / 16.0;
        const double height = (box[3].get<double>() - box[1].get<double>()) / 16.0;
        return {static_cast<int>(box[0].get<double>() + (slot % 16 + 0.5) * width),
                static_cast<int>(box[1].get<double>() + (slot / 16 + 0.5) * height)};
    }
    void awaitState(const std::string& name, const Json& value) {
        await(name + " " + value.dump(),
              [&](const Json& now) { return now.at("state").at(name) == value; });
    }
};

TEST_F(PaletteInAWindow, ColoursAreChosenMovedRecolouredAndVaried) {
    ASSERT_NO_FATAL_FAILURE(startDisplay({1280, 1000}));
    Document expected = documentOf(solidBox({6, 5, 4}, 5));
    const std::string path = file("box.voxprite").string();
    ASSERT_TRUE(saveDocument(path, expected, GameProfile{}));
    ASSERT_NO_FATAL_FAILURE(startEditor({path}));
    awaitState("voxels", 120);
    static_cast<void>(centreOf("palette.swatches"));

    click(swatch(20));
    awaitState("colour", 20);
    key("bracketright");
    awaitState("colour", 21);

    // Dragged to another slot: the order of display changes and nothing else.
    drag(swatch(9), swatch(3));
    awaitState("steps", 1);
    awaitState("colour", 9);
    // The menu of a colour: its voxels become the one in hand. It is now in slot 6.
    click(swatch(6), 3);
    click(centreOf("palette.menu.recolour"));
    awaitState("steps", 2);
    // A variant with a colour of its own.
    click(centreOf("palette.variant.add"));
    awaitState("steps", 3);
    click(centreOf("palette.hex"));
    key("ctrl+a");
    type("112233");
    key("Return");
    awaitState("steps", 4);
    // The field has let go of the keys once a click elsewhere is answered.
    click(swatch(1));
    awaitState("colour", 1);
    key("ctrl+s");
    awaitState("unsaved", false);
    awaitState("working", false);

    expected.palette = withSlotMoved(expected.palette, 9, 3);
    expected.palette.variants = {{"Variant", {{9, Rgba8(0x11, 0x22, 0x33, 255)}}}};
    for (Model& model : expected.models) {
        VoxelGrid painted;
        model.voxels.forEachSolid([&](glm::ivec3 v, std::uint8_t) { painted.set(v, 9); });
        model.voxels = painted;
    }
    const auto saved = loadDocument(path);
    ASSERT_TRUE(saved);
    EXPECT_EQ(saved->document.palette, expected.palette);
    EXPECT_EQ(saved->document.models, expected.models);

    for (int step = 3; step >= 0; --step) {
        key("ctrl+z");
        awaitState("steps", step);
    }
    key("ctrl+s");
    awaitState("unsaved", false);
    awaitState("working", false);
    const auto undone = loadDocument(path);
    ASSERT_TRUE(undone);
    EXPECT_EQ(undone->document.palette, Palette::standard());
    EXPECT_EQ(colourCounts(undone->document)[5], 120u);
}

TEST_F(PaletteInAWindow, ManyAreChangedAtOnce) {
    ASSERT_NO_FATAL_FAILURE(startDisplay({1280, 1000}));
    const Document start = documentOf(solidBox({6, 5, 4}, 5));
    const std::string path = file("box.voxprite").string();
    ASSERT_TRUE(saveDocument(path, start, GameProfile{}));
    ASSERT_NO_FATAL_FAILURE(startEditor({path}));
    awaitState("voxels", 120);
    static_cast<void>(centreOf("palette.swatches"));
    const ColourCounts counts = colourCounts(start);
    Palette expected = start.palette;

    click(swatch(20));
    awaitState("colour", 20);
    clickWith("ctrl", swatch(24));
    click(centreOf("command.swap_colours"));
    awaitState("steps", 1);
    expected = withSwapped(expected, 20, 24);
    click(swatch(30));
    awaitState("colour", 30);
    clickWith("shift", swatch(33));
    click(centreOf("command.gradient"));
    awaitState("steps", 2);
    const std::array<std::uint8_t, 4> ramp{30, 31, 32, 33};
    expected = withGradient(expected, std::nullopt, ramp);
    click(swatch(3));
    awaitState("colour", 3);
    clickWith("shift", swatch(6));
    click(centreOf("palette.sort"));
    click(centreOf("palette.sort_by_use"));  // all voxels have the colour 5
    awaitState("steps", 3);
    const std::array<std::uint8_t, 4> sorted{3, 4, 5, 6};
    expected = withOrder(expected, sorted, PaletteOrder::use, counts);
    click(swatch(40));
    awaitState("colour", 40);
    const std::optional<std::uint8_t> copy = freeIndex(expected, counts);
    ASSERT_TRUE(copy);
    click(centreOf("command.duplicate_colour"));
    awaitState("steps", 4);
    awaitState("colour", *copy);
    expected = withDuplicate(expected, 40, *copy);
    // What is in the air comes down first, and is recoloured with the rest.
    key("ctrl+a");
    awaitState("selected", 120);
    key("Prior");
    awaitState("making", true);
    click(swatch(3), 3);  // where sorting has put the colour 5
    click(centreOf("palette.menu.recolour"));
    awaitState("steps", 6);
    awaitState("making", false);

    key("ctrl+s");
    awaitState("unsaved", false);
    awaitState("working", false);
    const auto saved = loadDocument(path);
    ASSERT_TRUE(saved);
    EXPECT_EQ(saved->document.palette, expected);
    EXPECT_NE(expected, start.palette);
    EXPECT_EQ(colourCounts(saved->document)[*copy], 120u);
}

}  // namespace
}  // namespace voxprite::test
