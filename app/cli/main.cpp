// The command line: chooses the subcommand, prints what it returns, turns failures into one line
// on stderr and an exit status (0 success, 1 failure, 2 wrong usage).
#include <fcntl.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <new>
#include <sstream>
#include <vector>
#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include "app/cli/arguments.h"
#include "app/cli/command.h"
#include "core/io/json_text.h"

namespace voxprite::cli {
namespace {

constexpr int kFailure = 1;
constexpr int kWrongUsage = 2;

// What was freed is used again instead of being given back: the arrays of octrees, pictures and
// undo steps come and go with every edit, and each page that the system hands out anew costs more
// than the bake that fills it.
void keepFreedMemory() {
#if defined(__GLIBC__)
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
    mallopt(M_TRIM_THRESHOLD, 256 << 20);
#endif
}

// Whoever starts a program may close its standard streams; the next file that it opens then gets
// their number, and what is said on standard error would be written into that file. What stands in
// for them here is opened the wrong way round: using them fails, as it did.
void keepStandardStreams() {
    for (int stream = 0; stream <= 2; ++stream) {
        if (::fcntl(stream, F_GETFD) >= 0) continue;
        if (::open("/dev/null", stream == 0 ? O_WRONLY : O_RDONLY) < 0) return;
    }
}

bool print(const std::string& text) {
    return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() &&
           std::fflush(stdout) == 0;
}

// Scripts find the keys always: `file` is empty where none is concerned, and without a place in it
// `offset` is null.
Json errorJson(const Error& error) {
    Json json = {{"file", textJson(error.file)}};
    if (error.line) {
        json["line"] = *error.line;
        if (error.column) json["column"] = *error.column;
    } else {
        json["offset"] = error.offset ? Json(*error.offset) : Json(nullptr);
    }
    json["message"] = textJson(error.message);
    return {{"error", std::move(json)}};
}

int reportFailure(const std::string& prefix, const Error& error, bool json, int status) {
    if (json) print(errorJson(error).dump(2) + "\n");
    std::fprintf(stderr, "%s: %s\n", prefix.c_str(), error.describe().c_str());
    return status;
}

int reportNotPrinted(const std::string& prefix) {
    return reportFailure(prefix, fail("cannot write to standard output").value(), false, kFailure);
}

int runCommandLine(std::vector<std::string> arguments) {
    // Known before parsing, so that wrong usage is reported as JSON, too.
    const bool wantsJson =
        std::find(arguments.begin(), arguments.end(), "--json") != arguments.end();

    CLI::App app("Voxel models as outlined pixel-art sprites: edit, look, export.", "voxprite");
    app.set_version_flag("--version", "voxprite " VOXPRITE_VERSION);
    app.require_subcommand(1);
    app.footer("voxprite COMMAND --help describes a command; a FILE alone opens the editor.");
    Command command;
    addEdit(app, command);
    addInspect(app, command);
    addConvert(app, command);
    addExport(app, command);
    addPalette(app, command);
    addRender(app, command);
    addSheet(app, command);
    addCompare(app, command);
    addBench(app, command);
    addTrade(app, command);

    std::string prefix = "voxprite";
    try {
        std::vector<std::string> parsed = normalisedArguments(app, std::move(arguments));
        std::reverse(parsed.begin(), parsed.end());  // CLI11 takes them from the back
        app.parse(std::move(parsed));
        if (!app.get_subcommands().empty()) {
            prefix += " " + app.get_subcommands().front()->get_name();
        }
        Result<Report> report = command.run();
        if (!report) return reportFailure(prefix, report.error(), command.json, kFailure);
        if (report->failure) report->json.update(errorJson(*report->failure));
        if (!print(command.json ? report->json.dump(2) + "\n" : report->text)) {
            return reportNotPrinted(prefix);
        }
        if (report->failure) return reportFailure(prefix, *report->failure, false, kFailure);
        return 0;
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {  // --help, --version
            std::ostringstream asked;
            app.exit(error, asked, asked);
            return print(asked.str()) ? 0 : reportNotPrinted(prefix);
        }
        if (!app.get_subcommands().empty()) {
            prefix = "voxprite " + app.get_subcommands().front()->get_name();
        }
        const std::string reason = std::string(error.what()) + " (see " + prefix + " --help)";
        return reportFailure(prefix, fail(reason).value(), wantsJson, kWrongUsage);
    } catch (const std::bad_alloc&) {
        return reportFailure(prefix, fail("there is not enough memory").value(), wantsJson,
                             kFailure);
    } catch (const std::exception& error) {
        return reportFailure(prefix, fail(error.what()).value(), wantsJson, kFailure);
    }
}

}  // namespace
}  // namespace voxprite::cli

int main(int argc, char** argv) {
    voxprite::cli::keepStandardStreams();
    voxprite::cli::keepFreedMemory();
    return voxprite::cli::runCommandLine({argv + std::min(argc, 1), argv + argc});
}
