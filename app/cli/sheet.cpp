// voxprite sheet IN -o OUT.png: sprites from all around, in all frames, packed into one picture,
// with a JSON text beside it.
#include <unistd.h>

#include <cstdio>
#include <filesystem>

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "app/cli/outputs.h"
#include "app/cli/source.h"
#include "core/base/ending.h"
#include "core/io/profile_json.h"
#include "core/sheet/sheet_files.h"

namespace voxprite::cli {
namespace {

struct SheetCommandOptions {
    std::string input, output;
    std::optional<std::string> turntable, profile;
    std::optional<int> model;
    ReadOptions reading;
    std::optional<double> sigma, voxelSizeMetres;
    SheetOptions sheet;
    int turntableMilliseconds = 80;
    int magnify = 4;
    bool force = false;
};

std::vector<std::string> namesFrom(const std::string& text) {
    std::vector<std::string> names(1);
    for (const char c : text) {
        if (c == ',') {
            names.emplace_back();
        } else {
            names.back() += c;
        }
    }
    return names;
}

Result<GameProfile> profileOf(const SheetCommandOptions& options) {
    GameProfile profile;
    if (options.profile) {
        const Result<GameProfile> read = readProfileFile(*options.profile);
        if (!read) return read;
        profile = *read;
    }
    if (options.sigma) profile.sigma = *options.sigma;
    if (options.voxelSizeMetres) profile.voxelSizeMetres = *options.voxelSizeMetres;
    if (const Status valid = validate(profile); !valid) {
        throw CLI::ValidationError(valid.error().message);
    }
    return profile;
}

Result<Report> sheet(const SheetCommandOptions& options) {
    const std::filesystem::path output(options.output);
    if (lowerEndingOf(output) != ".png") {
        throw CLI::ValidationError("--output", "the sheet's file must end in .png");
    }
    std::optional<Turntable> turntable;
    if (options.turntable) {
        checkEnding({"--turntable", *options.turntable}, {".png", ".gif"});
        if (isSameFile(*options.turntable, output)) {
            throw CLI::ValidationError("--turntable", "has the name of the sheet that -o writes");
        }
        turntable = {*options.turntable, options.turntableMilliseconds, options.magnify};
    }
    const Result<GameProfile> profile = profileOf(options);
    if (!profile) return Failure(profile.error());
    const Result<LoadedDocument> loaded =
        loadSource(options.input, options.model, std::nullopt, options.reading);
    if (!loaded) return Failure(loaded.error());
    std::vector<std::string> inputs{options.input};
    if (options.profile) inputs.push_back(*options.profile);
    for (const std::filesystem::path& replaced :
         replacedBySheet(loaded->document.palette, options.sheet, output, turntable)) {
        const bool turns = turntable && replaced == turntable->path;
        checkReplacesNone({turns ? "--turntable" : "--output", replaced.string()}, inputs);
    }
    const bool told = isatty(STDERR_FILENO) == 1;
    const Result<Sheet> made =
        inFile(makeSheet(loaded->document, *profile, options.sheet,
                         [told](int done, int all) {
                             if (told) std::fprintf(stderr, "\r%d of %d sprites", done, all);
                         }),
               options.input);
    if (told) std::fprintf(stderr, "\r\033[K");
    if (!made) return Failure(made.error());

    const Result<std::vector<SheetFile>> files =
        sheetFiles(*made, loaded->document, *profile, options.sheet, output, turntable);
    if (!files) return Failure(files.error());
    Json warnings = warningsJson(*loaded);
    for (const SheetFile& file : *files) {
        if (file.loss) warnings.push_back(textJson(file.path.string() + ": " + *file.loss));
    }
    if (const Status written = writeSheetFiles(*files, options.force); !written) {
        return Failure(written.error());
    }
    Report report;
    const Image& image = made->pictures.front().image;
    report.json = {{"input", textJson(options.input)},
                   {"size", {image.width, image.height}},
                   {"cell", {made->cellPx.x, made->cellPx.y}},
                   {"anchor", {made->anchorPixel.x, made->anchorPixel.y}},
                   {"sprites", made->sprites.size()},
                   {"files", Json::array()},
                   {"warnings", warnings}};
    report.text = warningLines(warnings);
    for (const SheetFile& file : *files) {
        report.json["files"].push_back(
            {{"file", textJson(file.path.string())}, {"bytes", file.bytes.size()}});
        report.text += file.path.string() + ": " + std::to_string(file.bytes.size()) + " bytes\n";
    }
    report.text +=
        std::to_string(made->sprites.size()) + " sprites of " + std::to_string(made->cellPx.x) +
        "x" + std::to_string(made->cellPx.y) + " pixels in " + std::to_string(image.width) + "x" +
        std::to_string(image.height) + ", anchor at " + std::to_string(made->anchorPixel.x) + "," +
        std::to_string(made->anchorPixel.y) + "\n";
    return report;
}

void addLayoutOptions(CLI::App& sub, const std::shared_ptr<SheetCommandOptions>& options) {
    SheetOptions& sheet = options->sheet;
    sub.add_option("--directions", sheet.directions, "How many views round the model (8)")
        ->check(CLI::Range(1, 360));
    addParsed(sub, "--first-yaw", "DEGREES", "The yaw of the first view (0)", numberFrom,
              [options](double yaw) { options->sheet.firstYawDegrees = yaw; });
    addParsed(sub, "--pitch", "A[,B...]", "How high the eye is: degrees, each makes a round (30)",
              numbersFromList, [options](const std::vector<double>& pitches) {
                  for (const double pitch : pitches) {
                      if (pitch >= -90.0 && pitch <= 90.0) continue;
                      throw CLI::ValidationError("--pitch", "must be -90 to 90 degrees");
                  }
                  options->sheet.pitchesDegrees = pitches;
              });
    sub.add_option_function<std::string>(
           "--frames",
           [options](const std::string& text) {
               if (text == "all") return;
               options->sheet.frames = framesFromList(text);
               if (!options->sheet.frames) {
                   throw CLI::ValidationError("--frames",
                                              "expected all or 0,2,5-9, got '" + text + "'");
               }
           },
           "The frames of the animation (all)")
        ->type_name("all|0,2,5-9");
    sub.add_option_function<std::string>(
           "--variants",
           [options](const std::string& text) {
               if (text == "all") return;
               options->sheet.variants =
                   text == "none" ? std::vector<std::string>{} : namesFrom(text);
           },
           "A sheet for each of these palette variants beside that of the palette itself (all)")
        ->type_name("all|none|NAME,...");
    sub.add_flag_callback(
        "--no-trim", [options] { options->sheet.trim = false; },
        "Keep every sprite on a whole cell: a grid for engines that know no offsets");
    sub.add_option("--padding", sheet.paddingPx, "Transparent pixels between sprites (1)")
        ->check(CLI::Range(0, 64));
    sub.add_option("--largest-edge", sheet.largestEdgePx, "Of the picture (8192)")
        ->check(CLI::Range(16, 16384));
    sub.add_flag("--normals", sheet.normals, "A picture of the faces' normals, too");
    sub.add_flag("--depths", sheet.depths, "A picture of the depths, too");
    sub.add_flag("--indices", sheet.indices, "A picture of the palette indices, too");
}

}  // namespace

void addSheet(CLI::App& app, Command& command) {
    CLI::App& sub = *app.add_subcommand("sheet", "Write a sprite sheet and its JSON (Aseprite's)");
    auto options = std::make_shared<SheetCommandOptions>();
    sub.add_option("IN", options->input, "The model")->required();
    sub.add_option("-o,--output", options->output, "The sheet; its text stands beside it as .json")
        ->required()
        ->type_name("OUT.png");
    addLayoutOptions(sub, options);
    sub.add_option("--turntable", options->turntable,
                   "An animated picture of all sprites in turn: GIF, or PNG, which loses nothing")
        ->type_name("FILE.png|FILE.gif");
    sub.add_option("--turntable-ms", options->turntableMilliseconds,
                   "How long a view of it shows, where no clip says (80)")
        ->check(CLI::Range(1, 65535));
    sub.add_option("--magnify", options->magnify, "Pixels a virtual pixel of the turntable (4)")
        ->check(CLI::Range(1, 32));
    sub.add_flag("--force", options->force,
                 "Replace files that lie beside OUT under the names of those written beside it, "
                 "even if no text of such a sheet refers to them");
    sub.add_option("--profile", options->profile, "The game profile (JSON)")->type_name("FILE");
    addParsed(sub, "--sigma", "PIXELS", "Virtual pixels a voxel, in place of the profile's",
              numberFrom, [options](double sigma) { options->sigma = sigma; });
    addParsed(sub, "--voxel-size", "METRES", "Of a voxel, in place of the profile's", numberFrom,
              [options](double metres) { options->voxelSizeMetres = metres; });
    addParsed(sub, "--model", "INDEX",
              "Only this source model, as `inspect` lists them (from 0), not the entity", indexFrom,
              [options](int model) { options->model = model; });
    addEntityOption(sub, options->reading);
    addJsonFlag(sub, command);
    runs(sub, command, options, sheet);
}

}  // namespace voxprite::cli
