#include "core/io/batch.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>

#include "core/base/parallel.h"
#include "core/io/slice_names.h"

namespace voxprite {
namespace {

namespace fs = std::filesystem;

std::string listedLosses(const std::vector<std::string>& losses) {
    std::string text;
    for (const std::string& loss : losses) text += (text.empty() ? "" : "; ") + loss;
    return text;
}

// The same file has the same text here, whatever the way to it.
std::string identityOf(const fs::path& path) {
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(path, error);
    return (error ? path.lexically_normal() : whole).string();
}

// Where an output will lie, with what is named after it. Numbered pictures are layers of one stack,
// whatever their numbers.
std::vector<std::string> placesOf(const fs::path& output, Format to) {
    const std::optional<SliceName> layer = to == Format::png ? sliceNameOf(output) : std::nullopt;
    if (layer && isSurelyNumbered(*layer)) {
        return {(output.parent_path() / (layer->beginning + "*.png")).string()};
    }
    if (to != Format::obj) return {output.string()};
    std::vector<std::string> places;
    for (const std::string& name : infoOf(to).names(output.filename(), Document())) {
        places.push_back((output.parent_path() / name).string());
    }
    return places;
}

// Not an output over a layer, or over what a mesh refers to. Only where there is something to be
// overwritten are the inputs looked into.
Status overwriteNothingRead(const std::vector<BatchItem>& items) {
    std::error_code unknown;
    if (std::ranges::none_of(
            items, [&](const BatchItem& item) { return fs::exists(item.output, unknown); })) {
        return {};
    }
    std::map<std::string, fs::path> inputOf;
    for (const BatchItem& item : items) {
        for (const fs::path& file : filesReadFor(item.input)) {
            inputOf.emplace(identityOf(file), item.input);
        }
    }
    for (const BatchItem& item : items) {
        const auto found = inputOf.find(identityOf(item.output));
        if (found == inputOf.end()) continue;
        return failInFile(item.output.string(),
                          "is read for " + found->second.string() +
                              " and would be overwritten; nothing was converted");
    }
    return {};
}

class Batch {
  public:
    Batch(const std::vector<BatchItem>& items, const BatchOptions& options,
          const BatchReport& report)
        : items_(items),
          options_(options),
          report_(report),
          outcomes_(items.size()),
          finished_(items.size()) {}

    std::vector<BatchOutcome> run() {
        const int wanted = options_.jobs > 0 ? options_.jobs : hardwareThreads();
        const auto count = std::min<std::size_t>(static_cast<std::size_t>(wanted), items_.size());
        std::vector<std::jthread> workers;
        for (std::size_t k = 1; k < count; ++k) workers.emplace_back([this] { work(); });
        work();
        for (std::jthread& worker : workers) worker.join();
        return std::move(outcomes_);
    }

  private:
    void work() {
        for (std::size_t index = next_++; index < items_.size(); index = next_++) {
            BatchOutcome outcome;
            try {
                if (Status s = convert(index, outcome); !s) outcome.error = s.error();
            } catch (const std::bad_alloc&) {  // that of this file is free again
                outcome.error =
                    failInFile(items_[index].input.string(), "there is not enough memory").value();
            } catch (const std::exception& error) {
                outcome.error = failInFile(items_[index].input.string(), error.what()).value();
            }
            finish(index, std::move(outcome));
        }
    }

    Status convert(std::size_t index, BatchOutcome& outcome) {
        const auto& [input, output] = items_[index];
        Result<LoadedDocument> loaded = loadDocument(input, options_.reading);
        if (!loaded) return Failure(loaded.error());
        outcome.from = loaded->format;
        outcome.warnings = std::move(loaded->warnings);
        Document& document = loaded->document;
        if (options_.prepare) {
            if (Status s = inFile(options_.prepare(document), input.string()); !s) return s;
        }
        const Result<Format> to = formatOf(output);
        if (!to) return Failure(to.error());
        outcome.losses = lossesOf(document, *to);
        if (options_.strict && !outcome.losses.empty()) {
            return failInFile(input.string(),
                              "would lose something: " + listedLosses(outcome.losses));
        }
        if (report_.losing && !outcome.losses.empty()) {
            const std::lock_guard lock(reporting_);
            report_.losing(index, outcome.losses);
        }
        const GameProfile profile = options_.profile ? options_.profile(document) : GameProfile{};
        if (Status s = saveDocument(output, document, profile, {}, options_.writing); !s) return s;
        std::error_code unknown;
        const std::uintmax_t bytes = fs::file_size(output, unknown);
        outcome.bytes = unknown ? 0 : bytes;
        return {};
    }

    void finish(std::size_t index, BatchOutcome outcome) {
        const std::lock_guard lock(reporting_);
        outcomes_[index] = std::move(outcome);
        finished_[index] = true;
        while (told_ < items_.size() && finished_[told_]) {
            if (report_.done) report_.done(told_, outcomes_[told_]);
            ++told_;
        }
    }

    const std::vector<BatchItem>& items_;
    const BatchOptions& options_;
    const BatchReport& report_;
    std::atomic<std::size_t> next_{0};
    std::mutex reporting_;  // guards all below
    std::vector<BatchOutcome> outcomes_;
    std::vector<bool> finished_;
    std::size_t told_ = 0;
};

}  // namespace

Result<std::vector<BatchItem>> planBatch(const std::vector<fs::path>& inputs,
                                         const fs::path& folder, Format to) {
    std::vector<BatchItem> items;
    std::map<std::string, fs::path> inputOf;
    std::map<std::string, fs::path> inputFiles;
    for (const fs::path& input : inputs) inputFiles.emplace(identityOf(input), input);
    for (const fs::path& input : inputs) {
        // A folder of layers may be named with a slash at its end.
        const fs::path named = input.has_filename() ? input : input.parent_path();
        const fs::path output = folder / (named.stem().string() + infoOf(to).ending);
        for (const std::string& place : placesOf(output, to)) {
            const auto [known, isNew] = inputOf.try_emplace(place, input);
            if (isNew) continue;
            return failInFile(input.string(), "would be written to " + known->first +
                                                  ", as would " + known->second.string() +
                                                  "; nothing was converted");
        }
        if (inputFiles.contains(identityOf(output))) {
            return failInFile(output.string(),
                              "is an input and would be overwritten; nothing was converted");
        }
        items.push_back({input, output});
    }
    if (Status kept = overwriteNothingRead(items); !kept) return Failure(kept.error());
    return items;
}

std::vector<BatchOutcome> runBatch(const std::vector<BatchItem>& items, const BatchOptions& options,
                                   const BatchReport& report) {
    return Batch(items, options, report).run();
}

}  // namespace voxprite
