// Do two pictures show the same things? Compared by what each pixel shows, not by its colour.
#pragma once

#include <cstdint>
#include <span>

#include "core/base/result.h"

namespace voxprite {

struct IdComparison {
    std::uint64_t covered = 0;    // pixels that show a thing in either
    std::uint64_t differing = 0;  // those of another thing, or of a thing in one alone
    std::uint64_t onlyOne = 0;    // those of a thing in one alone
    // differing / covered; 0 when nothing is.
    [[nodiscard]] double rate() const {
        return covered == 0 ? 0.0 : static_cast<double>(differing) / static_cast<double>(covered);
    }
};

// Ids from `firstThing` on are things; all below are none (nothing, an outline), and alike. Fails
// when the counts differ.
[[nodiscard]] Result<IdComparison> compareIds(std::span<const std::uint32_t> a,
                                              std::span<const std::uint32_t> b,
                                              std::uint32_t firstThing);

}  // namespace voxprite
