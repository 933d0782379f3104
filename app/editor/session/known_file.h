// A file that is open in the editor, and how it is known again: another program may write to it,
// or put another in its place, at any time.
#pragma once

#include <filesystem>
#include <optional>

#include "core/base/file.h"

namespace voxprite::editor {

struct KnownFile {
    std::filesystem::path path;
    // As it was last read or written here; none where there was no file.
    std::optional<FileStamp> stamp{};

    // Does it hold, by now, what another program wrote? (One that is gone holds nothing.)
    [[nodiscard]] bool changedOutside() const {
        const std::optional<FileStamp> now = stampOf(path);
        return now && now != stamp;
    }
    bool operator==(const KnownFile&) const = default;
};

}  // namespace voxprite::editor
