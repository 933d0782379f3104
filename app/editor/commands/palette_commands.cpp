#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/editor/commands/command_context.h"
#include "app/editor/commands/tables.h"
#include "app/editor/panels/palette_editor.h"
#include "app/editor/panels/toasts.h"
#include "app/editor/session/file_flow.h"
#include "app/editor/window/icons.h"
#include "core/io/palette_files.h"

namespace voxprite::editor {
namespace {

template <PaletteOrder order>
constexpr Command sortCommand(Command command) {
    command.menu = MenuId::palette;
    command.run = [](CommandContext& c) { c.perform(c.palette.sort(order)); };
    return command;
}

template <int slots>
constexpr Command stepCommand(Command command) {
    command.menu = MenuId::palette;
    command.repeats = true;
    command.run = [](CommandContext& c) { c.palette.step(slots); };
    return command;
}

void duplicate(CommandContext& c) {
    if (auto action = c.palette.duplicate()) {
        c.perform(std::move(*action));
    } else {
        c.toasts.error("All 255 colours are in use");
    }
}

void importColours(CommandContext& c) {
    c.files.browse(
        {.title = "Import colours", .button = "Import", .extensions = {".gpl", ".pal", ".png"}},
        [](CommandContext& context, const std::filesystem::path& file) {
            const Result<ColourList> colours = loadColours(file);
            if (!colours) return context.report(Failure(colours.error()));
            context.perform(context.palette.change(
                "Import " + std::to_string(colours->size()) + " colours",
                withColours(context.palette.palette(), context.session.variant(), *colours)));
        });
}

void exportColours(CommandContext& c) {
    c.files.browse({.title = "Export colours (.png, .gpl or .pal)",
                    .button = "Export",
                    .saving = true,
                    .extensions = {".png", ".gpl", ".pal"},
                    .name = (c.session.path() ? c.session.title() : "palette") + ".png"},
                   [](CommandContext& context, const std::filesystem::path& file) {
                       const Status saved = saveColours(
                           file, colourList(context.palette.palette(), context.session.variant()));
                       if (!saved) return context.report(saved);
                       context.toasts.info("Saved " + file.filename().string());
                   });
}

void addPaletteVariant(CommandContext& c) {
    if (!c.palette.canAddVariant()) {
        return c.toasts.error("There are as many variants as a palette can have");
    }
    c.perform(c.palette.addVariant("Variant"));
    c.session.showVariant(c.palette.palette().variants.size() - 1);
}

void nextVariant(CommandContext& c) {
    const std::size_t count = c.palette.palette().variants.size();
    const std::size_t shown = c.session.variant() ? *c.session.variant() + 1 : 0;
    const std::size_t next = (shown + 1) % (count + 1);
    c.session.showVariant(next == 0 ? VariantIndex() : VariantIndex(next - 1));
}

}  // namespace

std::span<const Command> paletteCommands() {
    using enum CommandId;
    static constexpr std::array kCommands{
        stepCommand<-1>({.id = lastColour,
                         .tag = "last_colour",
                         .name = "Colour before",
                         .chords = {key(GLFW_KEY_LEFT_BRACKET)}}),
        stepCommand<1>({.id = nextColour,
                        .tag = "next_colour",
                        .name = "Colour after",
                        .chords = {key(GLFW_KEY_RIGHT_BRACKET)}}),
        Command{.id = duplicateColour,
                .tag = "duplicate_colour",
                .menu = MenuId::palette,
                .name = "Duplicate colour",
                .icon = icon::kDuplicate,
                .separator = true,
                .settles = true,
                .run = duplicate},
        Command{.id = swapColours,
                .tag = "swap_colours",
                .menu = MenuId::palette,
                .name = "Swap two colours",
                .icon = icon::kSwap,
                .run = [](CommandContext& c) { c.perform(c.palette.swap()); },
                .enabled = [](const CommandContext& c) { return c.palette.canSwap(); }},
        Command{.id = gradientColours,
                .tag = "gradient",
                .menu = MenuId::palette,
                .name = "Gradient between the ends",
                .icon = icon::kGradient,
                .run = [](CommandContext& c) { c.perform(c.palette.gradient()); },
                .enabled = [](const CommandContext& c) { return c.palette.canGrade(); }},
        Command{.id = removeUnusedColours,
                .tag = "remove_unused_colours",
                .menu = MenuId::palette,
                .name = "Remove unused colours",
                .icon = icon::kSweep,
                .settles = true,
                .run = [](CommandContext& c) { c.perform(c.palette.removeUnused()); }},
        sortCommand<PaletteOrder::hue>({.id = sortByHue,
                                        .tag = "sort_by_hue",
                                        .name = "Sort by hue",
                                        .icon = icon::kSort,
                                        .separator = true}),
        sortCommand<PaletteOrder::lightness>(
            {.id = sortByLightness, .tag = "sort_by_lightness", .name = "Sort by lightness"}),
        sortCommand<PaletteOrder::use>(
            {.id = sortByUse, .tag = "sort_by_use", .name = "Sort by use"}),
        sortCommand<PaletteOrder::index>(
            {.id = sortByIndex, .tag = "sort_by_index", .name = "Sort by index"}),
        Command{.id = makeRamp,
                .tag = "make_ramp",
                .menu = MenuId::palette,
                .name = "Make a ramp of the chosen",
                .icon = icon::kRamp,
                .separator = true,
                .run = [](CommandContext& c) { c.perform(c.palette.makeRamp()); },
                .enabled = [](const CommandContext& c) { return c.palette.chosen().size() > 1; }},
        Command{.id = suggestRamps,
                .tag = "suggest_ramps",
                .menu = MenuId::palette,
                .name = "Suggest ramps",
                .icon = icon::kSuggest,
                .run = [](CommandContext& c) { c.perform(c.palette.suggestRamps()); }},
        Command{.id = removeRamp,
                .tag = "remove_ramp",
                .menu = MenuId::palette,
                .name = "Remove the ramp",
                .run = [](CommandContext& c) { c.perform(c.palette.removeRamp()); },
                .enabled =
                    [](const CommandContext& c) {
                        return c.palette.palette().rampOf(c.palette.inHand()).has_value();
                    }},
        Command{.id = addVariant,
                .tag = "add_palette_variant",
                .menu = MenuId::palette,
                .name = "Add a variant",
                .icon = icon::kPlus,
                .separator = true,
                .run = addPaletteVariant},
        Command{.id = showNextVariant,
                .tag = "next_palette_variant",
                .menu = MenuId::palette,
                .name = "Next variant",
                .run = nextVariant,
                .enabled =
                    [](const CommandContext& c) { return !c.palette.palette().variants.empty(); }},
        Command{.id = importPalette,
                .tag = "import_palette",
                .menu = MenuId::palette,
                .name = "Import colours…",
                .icon = icon::kImport,
                .separator = true,
                .run = importColours},
        Command{.id = exportPalette,
                .tag = "export_palette",
                .menu = MenuId::palette,
                .name = "Export colours…",
                .icon = icon::kExportColours,
                .run = exportColours},
    };
    return kCommands;
}

}  // namespace voxprite::editor
