#include "app/cli/convert_batch.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "app/cli/outputs.h"
#include "app/cli/source.h"
#include "core/io/batch.h"

namespace voxprite::cli {
namespace {

// JSON lines that are on the disk as soon as they are said.
class Log {
  public:
    static Result<Log> open(const std::optional<std::string>& path) {
        Log log;
        if (!path) return log;
        log.file_.reset(std::fopen(path->c_str(), "w"));
        if (!log.file_) {
            return failInFile(*path,
                              "cannot be written: " + std::generic_category().message(errno));
        }
        return log;
    }
    void line(const Json& json) {
        if (!file_) return;
        const std::string text = json.dump() + "\n";
        whole_ = whole_ && std::fwrite(text.data(), 1, text.size(), file_.get()) == text.size() &&
                 std::fflush(file_.get()) == 0;
    }
    [[nodiscard]] bool whole() const { return whole_; }

  private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::unique_ptr<std::FILE, Close> file_;
    bool whole_ = true;
};

Json textsJson(const std::vector<std::string>& texts) {
    Json list = Json::array();
    for (const std::string& text : texts) list.push_back(textJson(text));
    return list;
}

Json outcomeJson(const BatchItem& item, const BatchOutcome& outcome, const std::string& to) {
    Json json = {{"input", textJson(item.input)},
                 {"output", textJson(item.output)},
                 {"to", to},
                 {"status", outcome.error ? "failed" : "converted"}};
    if (!outcome.error) {
        json["from"] = nameOf(outcome.from);
        json["bytes"] = outcome.bytes;
    }
    json["warnings"] = textsJson(outcome.warnings);
    json["losses"] = textsJson(outcome.losses);
    if (outcome.error) json["error"] = textJson(outcome.error->describe());
    return json;
}

// It is written line by line, over whatever has its name.
void checkLog(const Output& log, const BatchCommand& batch, const std::vector<BatchItem>& items) {
    checkReplacesNone(log, batch.inputs);
    if (batch.profile) checkReplacesNone(log, {*batch.profile});
    for (const BatchItem& item : items) {
        if (!isSameFile(item.output, log.path)) continue;
        throw CLI::ValidationError(
            log.option, "'" + log.path + "' is what " + item.input.string() + " becomes");
    }
}

std::string countOf(std::size_t files) {
    return std::to_string(files) + (files == 1 ? " file" : " files");
}

}  // namespace

void tellLosses(const std::string& input, const std::vector<std::string>& losses) {
    for (const std::string& loss : losses) {
        std::fprintf(stderr, "%s: %s\n", input.c_str(), loss.c_str());
    }
}

Result<Report> convertBatch(const BatchCommand& batch) {
    const Result<Format> to = formatNamed(batch.to);
    if (!to) throw CLI::ValidationError("--to", to.error().message);
    if (!infoOf(*to).writes()) {
        throw CLI::ValidationError("--to", batch.to + " is read but not written");
    }
    checkReplacesNone({"--out-dir", batch.folder}, {});
    const std::vector<std::filesystem::path> inputs(batch.inputs.begin(), batch.inputs.end());
    const Result<std::vector<BatchItem>> items = planBatch(inputs, batch.folder, *to);
    if (!items) return Failure(items.error());
    if (batch.log) checkLog({"--log", *batch.log}, batch, *items);

    std::optional<GameProfile> game;
    if (batch.profile) {
        const Result<GameProfile> read = profileForSaving(batch.profile, Document{});
        if (!read) return Failure(read.error());
        game = *read;
    }
    std::error_code error;
    std::filesystem::create_directories(batch.folder, error);
    if (error) return failInFile(batch.folder, "cannot be made: " + error.message());
    Result<Log> log = Log::open(batch.log);
    if (!log) return Failure(log.error());

    BatchOptions options;
    options.jobs = batch.jobs;
    options.strict = batch.strict;
    options.reading = batch.reading;
    options.writing = batch.writing;
    options.profile = [&](const Document& document) {
        return game ? *game : profileForSaving(std::nullopt, document).value();
    };
    if (batch.variant) {
        options.prepare = [&](Document& d) { return chooseVariant(d.palette, *batch.variant); };
    }
    BatchReport report;
    if (!batch.quiet) {
        report.losing = [&](std::size_t index, const std::vector<std::string>& losses) {
            tellLosses((*items)[index].input.string(), losses);
        };
    }
    Json list = Json::array();
    std::size_t failed = 0;
    report.done = [&](std::size_t index, const BatchOutcome& outcome) {
        const BatchItem& item = (*items)[index];
        Json json = outcomeJson(item, outcome, batch.to);
        log->line(json);
        list.push_back(std::move(json));
        if (outcome.error) ++failed;
        if (batch.quiet) return;
        const std::string what = outcome.error
                                     ? "failed: " + outcome.error->describe()
                                     : item.input.string() + " -> " + item.output.string();
        std::fprintf(stderr, "[%zu/%zu] %s\n", index + 1, items->size(), what.c_str());
        for (const std::string& warning : outcome.warnings) {
            std::fprintf(stderr, "  warning: %s\n", warning.c_str());
        }
    };
    static_cast<void>(runBatch(*items, options, report));

    Report result;
    const std::size_t converted = items->size() - failed;
    result.json = {{"converted", converted}, {"failed", failed}, {"files", std::move(list)}};
    result.text = countOf(converted) + " converted to " + infoOf(*to).ending + " in " +
                  batch.folder + ", " + std::to_string(failed) + " failed\n";
    if (failed > 0) {
        result.failure = Error{{},
                               {},
                               {},
                               {},
                               std::to_string(failed) + " of " + countOf(items->size()) +
                                   " failed" + (batch.log ? "; see " + *batch.log : "")};
    } else if (!log->whole()) {
        result.failure = Error{*batch.log, {}, {}, {}, "the log could not be written"};
    }
    return result;
}

}  // namespace voxprite::cli
