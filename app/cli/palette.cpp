// voxprite palette IN -o OUT: the colours of a model as a file of colours, or a model with other
// colours.
#include <algorithm>

#include "app/cli/command.h"
#include "app/cli/source.h"
#include "core/edit/palette_edits.h"
#include "core/io/palette_files.h"

namespace voxprite::cli {
namespace {

struct PaletteOptions {
    std::string input;
    std::optional<std::string> output, import, variant;
    ReadOptions reading;
    bool removeUnused = false;
    bool suggestRamps = false;
};

// The variant that is named; added first when colours shall go into it.
Result<VariantIndex> variantFor(Palette& palette, const PaletteOptions& options) {
    if (!options.variant) return VariantIndex();
    if (const VariantIndex known = palette.variantNamed(*options.variant)) return known;
    if (!options.import) {
        return failInFile(options.input,
                          "there is no palette variant \"" + *options.variant + "\"");
    }
    palette = withVariantAdded(std::move(palette), std::nullopt, *options.variant);
    if (Status valid = validate(palette); !valid) return Failure(valid.error());
    return VariantIndex(palette.variants.size() - 1);
}

std::vector<std::uint8_t> usedIndices(const ColourCounts& counts) {
    std::vector<std::uint8_t> used;
    for (int index = 1; index < 256; ++index) {
        if (counts[static_cast<std::size_t>(index)] > 0) {
            used.push_back(static_cast<std::uint8_t>(index));
        }
    }
    return used;
}

Json colourJson(const Palette& palette, std::uint8_t index, std::uint64_t voxels) {
    const Rgba8 colour = palette.colours[index];
    return {{"index", index},
            {"rgb", {colour.x, colour.y, colour.z}},
            {"name", textJson(palette.names[index])},
            {"voxels", voxels}};
}

Result<Report> palette(const PaletteOptions& options) {
    Result<LoadedDocument> loaded = loadDocument(options.input, options.reading);
    if (!loaded) return Failure(loaded.error());
    Document& document = loaded->document;
    Palette& colours = document.palette;
    const ColourCounts counts = colourCounts(document);
    const std::vector<std::uint8_t> used = usedIndices(counts);

    const Result<VariantIndex> variant = variantFor(colours, options);
    if (!variant) return Failure(variant.error());
    if (options.import) {
        const Result<ColourList> list = loadColours(*options.import);
        if (!list) return Failure(list.error());
        colours = withColours(std::move(colours), *variant, *list);
    }
    if (options.removeUnused) colours = withoutUnused(std::move(colours), counts);
    if (options.suggestRamps) colours = withSuggestedRamps(std::move(colours), used);

    if (options.output) {
        // A model where the ending is a model's, else a file of colours.
        const Status saved =
            !isFileOfColours(*options.output) && formatOf(*options.output)
                ? profileForSaving(std::nullopt, document).and_then([&](const GameProfile& game) {
                      return saveDocument(*options.output, document, game);
                  })
                : saveColours(*options.output, colourList(colours, *variant));
        if (!saved) return Failure(saved.error());
    }
    const Palette shown = *variant ? colours.withVariant(**variant) : colours;
    Json list = Json::array();
    for (const std::uint8_t index : used) list.push_back(colourJson(shown, index, counts[index]));
    Report report;
    report.json = {{"used", std::move(list)},
                   {"variants", colours.variants.size()},
                   {"ramps", colours.ramps.size()}};
    report.text = (options.output ? *options.output : options.input) + ": " +
                  std::to_string(used.size()) + " colours in use, " +
                  std::to_string(colours.variants.size()) + " variant(s), " +
                  std::to_string(colours.ramps.size()) + " ramp(s)\n";
    return report;
}

}  // namespace

void addPalette(CLI::App& app, Command& command) {
    CLI::App& sub = *app.add_subcommand("palette", "Take colours out of a model, or put them in");
    auto options = std::make_shared<PaletteOptions>();
    sub.add_option("IN", options->input, "A model: " + listed(modelEndings()))->required();
    sub.add_option("-o,--output", options->output,
                   "A file of colours (.png, .gpl, .pal), or the model with the colours changed")
        ->type_name("OUT");
    sub.add_option("--import", options->import,
                   "Take the colours of this file (.png, .gpl, .pal), in the order of display")
        ->type_name("FILE");
    sub.add_option("--variant", options->variant,
                   "Of this palette variant; with --import it is added if there is none")
        ->type_name("NAME");
    sub.add_flag("--remove-unused", options->removeUnused,
                 "Clear the colours that no voxel and no ramp uses");
    sub.add_flag("--suggest-ramps", options->suggestRamps,
                 "Make ramps of the colours in use that have about the same hue");
    addEntityOption(sub, options->reading);
    addJsonFlag(sub, command);
    runs(sub, command, options, palette);
}

}  // namespace voxprite::cli
