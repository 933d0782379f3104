#include "app/editor/views/sigma_comparison.h"

#include <algorithm>

#include "core/model/game_profile.h"

namespace voxprite::editor {

void SigmaComparison::open(int count, double profileSigma) {
    cells = count;
    // From coarse to fine; what is finer than the game's sigma would be minified in a small cell.
    constexpr std::array kTwo{0.5, 1.0};
    constexpr std::array kFour{0.25, 0.5, 0.75, 1.0};
    const bool four = count == 4;
    for (std::size_t i = 0; i < sigmas.size(); ++i) {
        const double factor = four ? kFour[i] : kTwo[i % kTwo.size()];
        sigmas[i] = std::clamp(profileSigma * factor, kLeastSigma, kMostSigma);
    }
    inForce = four ? 3 : 1;
    sigmas[static_cast<std::size_t>(inForce)] = profileSigma;
}

void SigmaComparison::follow(double profileSigma) {
    if (!on()) return;
    inForce = std::clamp(inForce, 0, cells - 1);
    if (sigmas[static_cast<std::size_t>(inForce)] == profileSigma) return;
    const auto end = sigmas.begin() + cells;
    const auto found = std::find(sigmas.begin(), end, profileSigma);
    if (found != end) inForce = static_cast<int>(found - sigmas.begin());
    sigmas[static_cast<std::size_t>(inForce)] = profileSigma;
}

std::size_t SigmaComparison::inForceAmong(std::size_t pictures) const {
    return pictures > 1 ? std::min(static_cast<std::size_t>(inForce), pictures - 1) : 0;
}

std::vector<CellArea> cellAreas(glm::ivec2 viewPx, int cells, int gapPx) {
    if (cells <= 1) return {{glm::ivec2(0), viewPx}};
    const bool wide = viewPx.x >= viewPx.y;
    const glm::ivec2 count = cells == 4 ? glm::ivec2(2)
                             : wide     ? glm::ivec2(2, 1)
                                        : glm::ivec2(1, 2);
    std::vector<CellArea> areas;
    for (int row = 0; row < count.y; ++row) {
        for (int column = 0; column < count.x; ++column) {
            const glm::ivec2 at(column, row);
            const glm::ivec2 free = viewPx - gapPx * (count - 1);
            const glm::ivec2 from = free * at / count + gapPx * at;
            const glm::ivec2 to = free * (at + 1) / count + gapPx * at;
            areas.push_back(
                {from, glm::ivec2(std::max(1, to.x - from.x), std::max(1, to.y - from.y))});
        }
    }
    return areas;
}

}  // namespace voxprite::editor
