// Errors as values. Core returns `Result<T>`; it never exits the program and never throws across
// its own edge. Exceptions of libraries are caught in the file that calls the library.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace voxprite {

// Why something failed, and where. `file` is filled in by whoever knows the path (see inFile);
// a binary reader gives `offset` (bytes from the start), a text reader `line` and `column` (from
// 1).
struct Error {
    std::string file;
    std::optional<std::uint64_t> offset;
    std::optional<int> line;
    std::optional<int> column;
    std::string message;

    // "hut.vox: byte 120: chunk XYZI is cut short", on one line whatever the message holds.
    [[nodiscard]] std::string describe() const;
};

template <class T>
using Result = tl::expected<T, Error>;
using Status = Result<void>;
using Failure = tl::unexpected<Error>;

// Text from a file as people may see it: control characters, with which it could break the line or
// speak to the terminal, are blanks.
[[nodiscard]] std::string onOneLine(std::string text);

[[nodiscard]] Failure fail(std::string message);
[[nodiscard]] Failure failAtByte(std::uint64_t offset, std::string message);
[[nodiscard]] Failure failAtLine(int line, int column, std::string message);
[[nodiscard]] Failure failInFile(std::string file, std::string message);

// Names the file in the error of `result`, unless an inner reader already named one.
template <class T>
[[nodiscard]] Result<T> inFile(Result<T> result, const std::string& file) {
    if (!result && result.error().file.empty()) result.error().file = file;
    return result;
}

}  // namespace voxprite
