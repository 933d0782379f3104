#include "app/editor/commands/fuzzy.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <string>

namespace voxprite::editor {
namespace {

constexpr int kLetter = 1, kRun = 8, kWordStart = 8, kTextStart = 4;
constexpr int kNone = std::numeric_limits<int>::min() / 2;

char lower(char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

bool startsWord(std::string_view text, std::size_t at) {
    return at == 0 || std::isalnum(static_cast<unsigned char>(text[at - 1])) == 0;
}

}  // namespace

std::optional<FuzzyMatch> fuzzyMatch(std::string_view query, std::string_view text) {
    std::string letters;
    for (const char c : query) {
        if (c != ' ') letters += lower(c);
    }
    if (letters.empty()) return FuzzyMatch{};
    // best[i][j]: the best score with letter i matched at text[j] (Smith and Waterman 1981).
    const std::size_t n = letters.size(), m = text.size();
    std::vector<std::vector<int>> best(n, std::vector<int>(m, kNone));
    std::vector<std::vector<std::size_t>> from(n, std::vector<std::size_t>(m, 0));
    for (std::size_t i = 0; i < n; ++i) {
        int before = i == 0 ? 0 : kNone;  // the best of letter i - 1 anywhere to the left
        std::size_t place = 0;
        for (std::size_t j = 0; j < m; ++j) {
            if (i > 0 && j > 0 && best[i - 1][j - 1] > before) {
                before = best[i - 1][j - 1];
                place = j - 1;
            }
            if (lower(text[j]) != letters[i] || before == kNone) continue;
            const int here =
                kLetter + (startsWord(text, j) ? kWordStart : 0) + (j == 0 ? kTextStart : 0);
            best[i][j] = before + here;
            from[i][j] = place;
            if (i > 0 && j > 0 && best[i - 1][j - 1] != kNone &&
                best[i - 1][j - 1] + here + kRun > best[i][j]) {
                best[i][j] = best[i - 1][j - 1] + here + kRun;
                from[i][j] = j - 1;
            }
        }
    }
    const auto& last = best[n - 1];
    const auto end = std::ranges::max_element(last);
    if (end == last.end() || *end == kNone) return std::nullopt;
    FuzzyMatch match;
    match.score = *end * 8 - static_cast<int>(m);
    match.places.resize(n);
    std::size_t at = static_cast<std::size_t>(end - last.begin());
    for (std::size_t i = n; i-- > 0; at = from[i][at]) match.places[i] = at;
    return match;
}

}  // namespace voxprite::editor
