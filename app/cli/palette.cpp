// voxprite palette IN -o OUT: the colours of a model as a file of colours, or a model with other
// colours.
#include <algorithm>

#include "app/cli/command.h"
#include "app/cli/convert_batch.h"
#include "app/cli/outputs.h"
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
    bool* json = nullptr;  // owned by the Command

    [[nodiscard]] bool changesColours() const { return import || removeUnused || suggestRamps; }
};

// A model where the ending is a model's, else a file of colours.
std::optional<Format> modelFormatOf(const std::string& output) {
    const Result<Format> format = formatOf(output);
    if (!format || isFileOfColours(output)) return std::nullopt;
    return *format;
}

// What the output has words for; of no output all, as the model itself is reported on.
Holds heldBy(const std::optional<std::string>& output) {
    if (!output) return Holds::everything();
    const std::optional<Format> format = modelFormatOf(*output);
    return format ? infoOf(*format).holds : Holds{};
}

// The variant that is named; added first when colours shall go into it.
Result<VariantIndex> variantFor(Palette& palette, const PaletteOptions& options) {
    if (!options.variant) return VariantIndex();
    const Result<std::size_t> known = variantNamed(palette, *options.variant);
    if (known) return VariantIndex(*known);
    if (!options.import) return inFile(Result<VariantIndex>(Failure(known.error())), options.input);
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

// Says what the output will lack, and returns it.
Result<std::vector<std::string>> save(const PaletteOptions& options, Document document,
                                      VariantIndex variant) {
    const std::string& output = *options.output;
    const std::optional<Format> format = modelFormatOf(output);
    if (!format) {
        const Status saved = saveColours(output, colourList(document.palette, variant));
        if (!saved) return Failure(saved.error());
        return {};
    }
    const FormatInfo& info = infoOf(*format);
    if (options.variant && !info.holds.variants) {
        if (Status s = chooseVariant(document.palette, *options.variant); !s) {
            return Failure(s.error());
        }
    }
    std::vector<std::string> losses;
    if (info.writes()) losses = lossesOf(document, *format);
    if (!*options.json) tellLosses(options.input, losses);
    const Result<GameProfile> profile = profileForSaving(std::nullopt, document);
    if (!profile) return Failure(profile.error());
    const Status saved = saveDocument(output, document, *profile);
    if (!saved) return Failure(saved.error());
    return losses;
}

void checkFiles(const PaletteOptions& options) {
    if (!options.output) {
        if (options.changesColours()) throw CLI::RequiredError("-o OUT, for the changed colours,");
        return;
    }
    const Output output{"--output", *options.output};
    const std::optional<Format> format = modelFormatOf(output.path);
    if (format ? !infoOf(*format).writes() : !isFileOfColours(output.path)) {
        std::vector<std::string> endings = writtenEndings();
        endings.insert(endings.begin(), {".gpl", ".pal"});
        throw CLI::ValidationError(output.option,
                                   "'" + output.path + "' must end in " + listed(endings));
    }
    // A model may get its new colours in its own place, if all of it is written.
    std::vector<std::string> inputs;
    if (!format || !isReadWhole(options.input, options.reading)) inputs.push_back(options.input);
    if (options.import) inputs.push_back(*options.import);
    checkReplacesNone(output, inputs);
}

Result<Report> palette(const PaletteOptions& options) {
    checkFiles(options);
    Result<LoadedDocument> loaded = loadDocument(options.input, options.reading);
    if (!loaded) return Failure(loaded.error());
    if (options.output && !loaded->whole) {
        checkReplacesNone({"--output", *options.output}, {options.input});
    }
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

    Json warnings = warningsJson(*loaded);
    const std::string ofReading = warningLines(warnings);
    if (options.output) {
        const Result<std::vector<std::string>> losses = save(options, document, *variant);
        if (!losses) return Failure(losses.error());
        for (const std::string& loss : *losses) warnings.push_back(textJson(loss));
    }
    const Palette shown = *variant ? colours.withVariant(**variant) : colours;
    Json list = Json::array();
    for (const std::uint8_t index : used) list.push_back(colourJson(shown, index, counts[index]));
    const Holds held = heldBy(options.output);
    const std::size_t variants = held.variants ? colours.variants.size() : 0;
    const std::size_t ramps = held.ramps ? colours.ramps.size() : 0;
    Report report;
    report.json = {{"used", std::move(list)},
                   {"variants", variants},
                   {"ramps", ramps},
                   {"warnings", std::move(warnings)}};
    report.text = (options.output ? *options.output : options.input) + ": " +
                  std::to_string(used.size()) + " colours in use, " + std::to_string(variants) +
                  " variant(s), " + std::to_string(ramps) + " ramp(s)\n" + ofReading;
    return report;
}

}  // namespace

void addPalette(CLI::App& app, Command& command) {
    CLI::App& sub = *app.add_subcommand("palette", "Take colours out of a model, or put them in");
    auto options = std::make_shared<PaletteOptions>();
    options->json = &command.json;
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
