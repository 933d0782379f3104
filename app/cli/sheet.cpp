// voxprite sheet IN -o OUT.png: sprites from all around, in all frames, packed into one picture,
// with a JSON text beside it.
#include <unistd.h>

#include <cstdio>
#include <filesystem>

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "app/cli/source.h"
#include "core/base/file.h"
#include "core/io/apng.h"
#include "core/io/png.h"
#include "core/io/profile_json.h"
#include "core/sheet/sheet.h"
#include "core/sheet/sheet_json.h"

namespace voxprite::cli {
namespace {

struct Options {
    std::string input, output;
    std::optional<std::string> turntable, profile;
    std::optional<int> model;
    std::optional<double> sigma, voxelSizeMetres;
    SheetOptions sheet;
    int turntableMilliseconds = 80;
    int magnify = 4;
};

std::vector<std::string> parts(std::string_view text, char between) {
    std::vector<std::string> found(1);
    for (const char c : text) {
        if (c == between) {
            found.emplace_back();
        } else {
            found.back() += c;
        }
    }
    return found;
}

std::optional<std::vector<double>> numbersFrom(std::string_view text) {
    std::vector<double> numbers;
    for (const std::string& part : parts(text, ',')) {
        const std::optional<double> number = numberFrom(part);
        if (!number) return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

// "0,2,5-9"
std::optional<std::vector<int>> framesFrom(std::string_view text) {
    std::vector<int> frames;
    for (const std::string& part : parts(text, ',')) {
        const std::vector<std::string> ends = parts(part, '-');
        const std::optional<int> first = indexFrom(ends.front());
        const std::optional<int> last = indexFrom(ends.back());
        if (!first || !last || ends.size() > 2 || *last < *first || *last >= kMaxFrames) {
            return std::nullopt;
        }
        for (int frame = *first; frame <= *last; ++frame) frames.push_back(frame);
    }
    return frames;
}

Result<GameProfile> profileOf(const Options& options) {
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

// A file that is written when all of them are made.
struct MadeFile {
    std::string path;
    Bytes bytes;
};

Status addPng(std::vector<MadeFile>& files, const std::string& path, const Image& image) {
    Result<Bytes> bytes = inFile(writePng(image), path);
    if (!bytes) return Failure(bytes.error());
    files.push_back({path, std::move(*bytes)});
    return {};
}

// All sprites of the sheet one after another: of a still model it turns.
Status addTurntable(std::vector<MadeFile>& files, const Options& options, const Sheet& sheet,
                    const Document& document) {
    std::vector<ApngFrame> frames;
    const std::vector<Image> cells = cellsOf(sheet, sheet.pictures.front(), options.magnify);
    const bool moving = !document.clips.empty();
    for (std::size_t k = 0; k < cells.size(); ++k) {
        frames.push_back({cells[k], moving ? frameMilliseconds(document, sheet.sprites[k].frame)
                                           : options.turntableMilliseconds});
    }
    Result<Bytes> bytes = inFile(writeApng(frames), *options.turntable);
    if (!bytes) return Failure(bytes.error());
    files.push_back({*options.turntable, std::move(*bytes)});
    return {};
}

Result<Report> sheet(const Options& options) {
    const std::filesystem::path output(options.output);
    if (output.extension() != ".png") {
        throw CLI::ValidationError("--output", "the sheet's file must end in .png");
    }
    const Result<GameProfile> profile = profileOf(options);
    if (!profile) return Failure(profile.error());
    const Result<LoadedDocument> loaded = loadSource(options.input, options.model);
    if (!loaded) return Failure(loaded.error());
    const bool told = isatty(STDERR_FILENO) == 1;
    const Result<Sheet> made =
        inFile(makeSheet(loaded->document, *profile, options.sheet,
                         [told](int done, int all) {
                             if (told) std::fprintf(stderr, "\r%d of %d sprites", done, all);
                         }),
               options.input);
    if (told) std::fprintf(stderr, "\r\033[K");
    if (!made) return Failure(made.error());

    std::vector<MadeFile> files;
    for (const SheetPicture& picture : made->pictures) {
        const Status added =
            addPng(files, pictureName(options.output, picture.name), picture.image);
        if (!added) return Failure(added.error());
    }
    if (options.turntable) {
        const Status added = addTurntable(files, options, *made, loaded->document);
        if (!added) return Failure(added.error());
    }
    const std::string text =
        sheetJson(*made, loaded->document, *profile, options.sheet, output.filename().string());
    files.push_back({std::filesystem::path(output).replace_extension(".json").string(),
                     Bytes(text.begin(), text.end())});
    Report report;
    const Image& image = made->pictures.front().image;
    report.json = {{"input", textJson(options.input)},
                   {"size", {image.width, image.height}},
                   {"cell", {made->cellPx.x, made->cellPx.y}},
                   {"anchor", {made->anchorPixel.x, made->anchorPixel.y}},
                   {"sprites", made->sprites.size()},
                   {"files", Json::array()}};
    for (const MadeFile& file : files) {
        if (const Status written = writeFileAtomically(file.path, file.bytes); !written) {
            return Failure(written.error());
        }
        report.json["files"].push_back(
            {{"file", textJson(file.path)}, {"bytes", file.bytes.size()}});
        report.text += file.path + ": " + std::to_string(file.bytes.size()) + " bytes\n";
    }
    report.text +=
        std::to_string(made->sprites.size()) + " sprites of " + std::to_string(made->cellPx.x) +
        "x" + std::to_string(made->cellPx.y) + " pixels in " + std::to_string(image.width) + "x" +
        std::to_string(image.height) + ", anchor at " + std::to_string(made->anchorPixel.x) + "," +
        std::to_string(made->anchorPixel.y) + "\n";
    return report;
}

void addLayoutOptions(CLI::App& sub, const std::shared_ptr<Options>& options) {
    SheetOptions& sheet = options->sheet;
    sub.add_option("--directions", sheet.directions, "How many views round the model (8)")
        ->check(CLI::Range(1, 360));
    addParsed(sub, "--first-yaw", "DEGREES", "The yaw of the first view (0)", numberFrom,
              [options](double yaw) { options->sheet.firstYawDegrees = yaw; });
    addParsed(sub, "--pitch", "A[,B...]", "How high the eye is: degrees, each makes a round (30)",
              numbersFrom, [options](const std::vector<double>& pitches) {
                  options->sheet.pitchesDegrees = pitches;
              });
    sub.add_option_function<std::string>(
           "--frames",
           [options](const std::string& text) {
               if (text == "all") return;
               options->sheet.frames = framesFrom(text);
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
                   text == "none" ? std::vector<std::string>{} : parts(text, ',');
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
    auto options = std::make_shared<Options>();
    sub.add_option("IN", options->input, "The model")->required();
    sub.add_option("-o,--output", options->output, "The sheet; its text stands beside it as .json")
        ->required()
        ->type_name("OUT.png");
    addLayoutOptions(sub, options);
    sub.add_option("--turntable", options->turntable, "An animated PNG of all sprites in turn")
        ->type_name("FILE.png");
    sub.add_option("--turntable-ms", options->turntableMilliseconds,
                   "How long a view of it shows, where no clip says (80)")
        ->check(CLI::Range(1, 65535));
    sub.add_option("--magnify", options->magnify, "Pixels a virtual pixel of the turntable (4)")
        ->check(CLI::Range(1, 32));
    sub.add_option("--profile", options->profile, "The game profile (JSON)")->type_name("FILE");
    addParsed(sub, "--sigma", "PIXELS", "Virtual pixels a voxel, in place of the profile's",
              numberFrom, [options](double sigma) { options->sigma = sigma; });
    addParsed(sub, "--voxel-size", "METRES", "Of a voxel, in place of the profile's", numberFrom,
              [options](double metres) { options->voxelSizeMetres = metres; });
    addParsed(sub, "--model", "INDEX",
              "Only this source model, as `inspect` lists them (from 0), not the entity", indexFrom,
              [options](int model) { options->model = model; });
    addJsonFlag(sub, command);
    runs(sub, command, options, sheet);
}

}  // namespace voxprite::cli
