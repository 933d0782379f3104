// Many files converted at once: each by itself, so that one that cannot be read or written stops
// and spoils no other.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/io/formats.h"

namespace voxprite {

struct BatchItem {
    std::filesystem::path input;
    std::filesystem::path output;
};

// Each input under its own name in `folder`, with the ending of the format. Fails, before any work
// is done, where two would get the same name or be layers of one stack, or an input or what is read
// for one would be overwritten. Whether the inputs can be read is not asked.
[[nodiscard]] Result<std::vector<BatchItem>> planBatch(
    const std::vector<std::filesystem::path>& inputs, const std::filesystem::path& folder,
    Format to);

struct BatchOutcome {
    std::optional<Error> error;  // nothing was written then
    Format from = Format::vox;   // where the input's ending is known
    std::uint64_t bytes = 0;     // of the output
    std::vector<std::string> warnings;
    std::vector<std::string> losses;
};

struct BatchOptions {
    int jobs = 0;  // files at a time; 0: as many as there are cores
    // A file that would lose anything is an error and is not written.
    bool strict = false;
    ReadOptions reading{};
    WriteOptions writing{};
    // What is done to each document between reading and writing (a palette variant chosen); may be
    // empty.
    std::function<Status(Document& document)> prepare{};
    // The profile that a document is saved with.
    std::function<GameProfile(const Document& document)> profile{};
};

// What is told on the way. Calls come one at a time, from any thread.
struct BatchReport {
    // Just before a file is written: what it will lack. Not called where that is nothing.
    std::function<void(std::size_t index, const std::vector<std::string>& losses)> losing{};
    // As soon as a file is done, in the order of the items: `index` counts up without gaps.
    std::function<void(std::size_t index, const BatchOutcome& outcome)> done{};
};

// One outcome an item, in their order. What a file becomes depends on it and the options alone.
[[nodiscard]] std::vector<BatchOutcome> runBatch(const std::vector<BatchItem>& items,
                                                 const BatchOptions& options,
                                                 const BatchReport& report = {});

}  // namespace voxprite
