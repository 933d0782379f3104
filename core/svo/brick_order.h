// Cubes of 8x8x8 voxels, and the 64 bricks of 2x2x2 in them in the order of octants: brick i lies
// at x = 2 * (bits 3 and 0 of i), y = 2 * (bits 4 and 1), z = 2 * (bits 5 and 2).
//
// Voxels come as the grid has them (core/model/voxel_grid.h): a row of eight bytes along z at
// voxels + (x << 6 | y << 3), and bit (y << 3 | z) of solid[x] where one is not 0.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

namespace voxprite {

namespace brick_order {

// Exchanges bits `high` and `low` of the index of every bit of a word.
template <unsigned high, unsigned low>
[[nodiscard]] constexpr std::uint64_t swapIndexBits(std::uint64_t word) {
    static_assert(high > low);
    constexpr std::uint64_t kMoving = [] {  // where `low` is set and `high` is not
        std::uint64_t bits = 0;
        for (unsigned i = 0; i < 64; ++i)
            if ((i >> low & 1u) != 0 && (i >> high & 1u) == 0) bits |= std::uint64_t{1} << i;
        return bits;
    }();
    constexpr unsigned kDistance = (1u << high) - (1u << low);
    const std::uint64_t changed = (word ^ word >> kDistance) & kMoving;
    return word ^ changed ^ changed << kDistance;
}

// Words of pairs of planes, each with one bit a brick (y and z even), to one bit a brick in order.
[[nodiscard]] constexpr std::uint64_t inOrder(std::uint64_t x0, std::uint64_t x2, std::uint64_t x4,
                                              std::uint64_t x6) {
    constexpr std::uint64_t kEven = 0x0055'0055'0055'0055u;
    // Bits of the index, from the highest: y2 y1 x2 z2 z1 x1.
    const std::uint64_t word =
        (x0 & kEven) | (x2 & kEven) << 1 | (x4 & kEven) << 8 | (x6 & kEven) << 9;
    // To: z2 y2 x2 z1 y1 x1.
    return swapIndexBits<2, 1>(swapIndexBits<4, 2>(swapIndexBits<5, 2>(word)));
}

// Where the voxels of each brick begin.
inline constexpr auto kFirstVoxel = [] {
    std::array<std::uint16_t, 64> first{};
    for (unsigned i = 0; i < first.size(); ++i) {
        const unsigned x = (i & 1u) | (i >> 2 & 2u);
        const unsigned y = (i >> 1 & 1u) | (i >> 3 & 2u);
        const unsigned z = (i >> 2 & 1u) | (i >> 4 & 2u);
        first[i] = static_cast<std::uint16_t>(x << 7 | y << 4 | z << 1);
    }
    return first;
}();

using Words = std::uint64_t __attribute__((vector_size(16)));
using Bytes = std::uint8_t __attribute__((vector_size(16)));
using Pairs = std::uint16_t __attribute__((vector_size(16)));

template <class Vector>
[[nodiscard]] inline Vector load(const std::uint8_t* bytes) {
    Vector vector;
    std::memcpy(&vector, bytes, sizeof vector);
    return vector;
}

}  // namespace brick_order

// Bit i: brick i holds something.
[[nodiscard]] constexpr std::uint64_t bricksWithAny(const std::uint64_t* solid) {
    const auto fold = [solid](int x) {
        std::uint64_t word = solid[x] | solid[x + 1];
        word |= word >> 8;
        return word | word >> 1;
    };
    return brick_order::inOrder(fold(0), fold(2), fold(4), fold(6));
}

// Bit i: brick i has eight voxels.
[[nodiscard]] constexpr std::uint64_t bricksWithAll(const std::uint64_t* solid) {
    const auto fold = [solid](int x) {
        std::uint64_t word = solid[x] & solid[x + 1];
        word &= word >> 8;
        return word & word >> 1;
    };
    return brick_order::inOrder(fold(0), fold(2), fold(4), fold(6));
}

// The payload of brick i.
[[nodiscard]] inline std::uint64_t brickOf(const std::uint8_t* voxels, unsigned i) {
    const std::uint8_t* at = voxels + brick_order::kFirstVoxel[i];
    const auto pair = [at](int offset) {
        std::uint16_t two = 0;
        std::memcpy(&two, at + offset, sizeof two);
        return std::uint64_t{two};
    };
    // Pairs along z, in the order of octants; then their lower bytes before the higher ones.
    std::uint64_t payload = pair(0) | pair(64) << 16 | pair(8) << 32 | pair(72) << 48;
    std::uint64_t changed = (payload ^ payload >> 8) & 0x0000'FF00'0000'FF00u;
    payload ^= changed ^ changed << 8;
    changed = (payload ^ payload >> 16) & 0x0000'0000'FFFF'0000u;
    return payload ^ changed ^ changed << 16;
}

namespace brick_order {

// The four bricks at one x and y.
template <unsigned column>
inline void cutColumn(const std::uint8_t* voxels, std::uint64_t* payloads) {
    constexpr unsigned x = column & 3u;
    constexpr unsigned y = column >> 2;
    const std::uint8_t* rows = voxels + (x << 7 | y << 4);
    // Two rows at x and two at x + 1, interleaved byte by byte.
    const auto low = load<Bytes>(rows);
    const auto high = load<Bytes>(rows + 64);
    const auto first = reinterpret_cast<Pairs>(
        __builtin_shufflevector(low, high, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23));
    const auto second = reinterpret_cast<Pairs>(__builtin_shufflevector(
        low, high, 8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31));
    const auto near =
        reinterpret_cast<Words>(__builtin_shufflevector(first, second, 0, 8, 1, 9, 2, 10, 3, 11));
    const auto far =
        reinterpret_cast<Words>(__builtin_shufflevector(first, second, 4, 12, 5, 13, 6, 14, 7, 15));
    // Bricks at z = 0 and 1 differ in the low bit of z, those at 2 and 3 have its high one, too.
    std::uint64_t* out = payloads + ((x & 1u) | (y & 1u) << 1 | (x >> 1) << 3 | (y >> 1) << 4);
    out[0] = near[0];
    out[4] = near[1];
    out[32] = far[0];
    out[36] = far[1];
}

}  // namespace brick_order

// All 64 payloads, those of empty bricks included.
inline void cutIntoBricks(const std::uint8_t* voxels, std::uint64_t* payloads) {
    [&]<unsigned... column>(std::integer_sequence<unsigned, column...>) {
        (brick_order::cutColumn<column>(voxels, payloads), ...);
    }
    (std::make_integer_sequence<unsigned, 16>{});
}

// `count` rows of eight bytes that begin `shift` bytes after those at `first`, and end in those at
// `next`.
inline void copyRows(const std::uint8_t* first, const std::uint8_t* next, int shift, int count,
                     std::uint64_t* rows) {
    using namespace brick_order;
    if (shift == 0) {
        std::memcpy(rows, first, 8 * static_cast<std::size_t>(count));
        return;
    }
    const int bits = 8 * shift;
    int row = 0;
    for (; row + 2 <= count; row += 2) {
        const Words both = load<Words>(first + 8 * row) >> bits | load<Words>(next + 8 * row)
                                                                      << 1 << (63 - bits);
        std::memcpy(rows + row, &both, sizeof both);
    }
    if (row < count) {
        rows[row] = load<std::uint64_t>(first + 8 * row) >> bits |
                    load<std::uint64_t>(next + 8 * row) << (64 - bits);
    }
}

}  // namespace voxprite
