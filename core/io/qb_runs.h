// Words that are no colour in the compressed slices of a .qb: see core/io/qb.h.
#pragma once

#include <cstdint>

namespace voxprite::qb {

inline constexpr std::uint32_t kRun = 2;
inline constexpr std::uint32_t kNextSlice = 6;

}  // namespace voxprite::qb
