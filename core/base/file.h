// Whole files in, whole files out. Writing is atomic: a temporary file in the same folder, fsync,
// rename, fsync of the folder; a failure leaves the old file as it was and no temporary behind. A
// file that is read-only is not replaced. To a device or a pipe (/dev/stdout) the bytes are simply
// written.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace voxprite {

// Files larger than this are refused before anything is allocated.
inline constexpr std::uint64_t kMaxFileBytes = std::uint64_t{4} << 30;

// Tells two versions of a file apart: whoever writes to it or replaces it makes another one.
struct FileStamp {
    std::uint64_t device = 0, inode = 0, bytes = 0;
    std::int64_t changedNanoseconds = 0;
    bool operator==(const FileStamp&) const = default;
};
// None where there is no file.
[[nodiscard]] std::optional<FileStamp> stampOf(const std::filesystem::path& path);

[[nodiscard]] Result<Bytes> readFile(const std::filesystem::path& path);
[[nodiscard]] Result<std::string> readTextFile(const std::filesystem::path& path);
// What would keep a file from being written there, as far as the name and the folder tell: for
// whoever writes several files that belong together.
[[nodiscard]] Status checkWritable(const std::filesystem::path& path);
[[nodiscard]] Status writeFileAtomically(const std::filesystem::path& path, ByteView bytes);
[[nodiscard]] Status writeFileAtomically(const std::filesystem::path& path,
                                         const std::string& text);

}  // namespace voxprite
