// voxprite [edit] [FILE...]: the editor.
#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "app/cli/outputs.h"
#include "app/cli/source.h"
#include "app/editor/editor.h"
#include "core/io/formats.h"

namespace voxprite::cli {
namespace {

void checkFiles(const EditorOptions& options) {
    std::vector<std::string> inputs(options.files.begin(), options.files.end());
    for (const auto& input : {options.profile, options.playScript}) {
        if (input) inputs.push_back(input->string());
    }
    const auto check = [&](const char* option, const std::optional<std::filesystem::path>& path) {
        if (path) checkReplacesNone({option, path->string()}, inputs);
    };
    if (options.screenshot) checkEnding({"--screenshot", options.screenshot->string()}, {".png"});
    check("--screenshot", options.screenshot);
    check("--record", options.record);
    check("--dump-layout", options.layoutDump);
    check("--frame-times", options.frameTimes);
    check("--start-times", options.startTimes);
}

Result<Report> edit(const EditorOptions& options) {
    checkFiles(options);
    if (Status status = runEditor(options); !status) return Failure(status.error());
    return Report{};
}

}  // namespace

void addEdit(CLI::App& app, Command& command) {
    CLI::App& sub = *app.add_subcommand("edit", "Open the editor (the default command)");
    auto options = std::make_shared<EditorOptions>();
    sub.add_option_function<std::vector<std::string>>(
        "FILE",
        [options](const std::vector<std::string>& files) {
            options->files.assign(files.begin(), files.end());
        },
        "Models to open: " + listed(modelEndings()));
    addEntityOption(sub, options->entity);
    const auto addPath = [&](const char* name, std::optional<std::filesystem::path>& target,
                             const char* form, const char* description) {
        sub.add_option_function<std::string>(
               name, [&target](const std::string& path) { target = path; }, description)
            ->type_name(form);
    };
    addPath("--profile", options->profile, "FILE", "The game profile (JSON) to work with");
    addPath("--screenshot", options->screenshot, "OUT.png",
            "Write the window's content after --frames frames, then quit");
    sub.add_option("--frames", options->frames, "Frames before the screenshot")
        ->check(CLI::Range(1, 100000));
    addPath("--play", options->playScript, "SCRIPT", "Replay recorded input (JSON lines)");
    addPath("--record", options->record, "SCRIPT", "Record the input of this session");
    addPath("--recovery", options->recovery, "FOLDER",
            "Where unsaved work is copied to, and what a crash left is looked for");
    addPath("--dump-layout", options->layoutDump, "FILE",
            "Write where widgets lie on screen, for tests");
    addPath("--frame-times", options->frameTimes, "FILE",
            "Write how long the window's thread was busy in the longest frames of each stretch "
            "that the script marks");
    addPath("--start-times", options->startTimes, "FILE",
            "Write when the parts of the start were done, up to the first frames");
    addParsed(sub, "--window", "WxH", "The window's size at content scale 1", sizeFrom,
              [options](glm::ivec2 size) { options->windowPx = size; });
    addParsed(sub, "--content-scale", "NUMBER",
              "Pixels a unit of the layout, instead of the display's own", numberFrom,
              [options](double scale) { options->contentScale = scale; })
        ->check(CLI::Range(0.5, 4.0));
    runs(sub, command, options, edit);
}

}  // namespace voxprite::cli
