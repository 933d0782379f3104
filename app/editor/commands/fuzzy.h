// Finding a name from a few of its letters, as editors' command palettes do.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace voxprite::editor {

struct FuzzyMatch {
    int score = 0;                    // larger is nearer
    std::vector<std::size_t> places;  // bytes of the text that matched, ascending
};

// The letters of `query` must stand in `text` in that order, in any case; spaces in it are skipped.
// Beginnings of words and runs of letters count more; a shorter text wins over a longer one.
[[nodiscard]] std::optional<FuzzyMatch> fuzzyMatch(std::string_view query, std::string_view text);

}  // namespace voxprite::editor
