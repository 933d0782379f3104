// The walk of core/trace/packet_caster.h, compiled once for each SIMD target that the compiler
// knows; the best one that the machine has is chosen when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/trace/packet_walk.cpp"
#include <hwy/foreach_target.h>  // includes this file again for every target

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/trace/packet_caster.h"
#include "core/trace/packet_tables.h"
#include "core/trace/packet_walk-inl.h"
#include "core/trace/packet_walk.h"

HWY_BEFORE_NAMESPACE();
namespace voxprite::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// The parallel rays of a lattice.
class ParallelRays {
  public:
    static constexpr std::size_t kMostLanes = 16;

    // A node's centre in fixed-point pixels.
    struct Place {
        int level = 0;
        std::int32_t i = 0, j = 0;
        std::uint32_t corner[3] = {0, 0, 0};
    };
    // By pair of axes: 2^P (k[a] D[b] - k[b] D[a]), and what VoxelTest subtracts.
    struct Brick {
        std::uint32_t corner[3];
    };
    using Leaf = Brick;

    ParallelRays(const PacketTables& tables, glm::ivec2 first, glm::ivec2 size, PacketHits& hits)
        : tables_(tables), first_(first), size_(size), hits_(hits) {}

    [[nodiscard]] Place root() const {
        Place place;
        place.level = tables_.tree.octree.maxDepth;
        place.i = fixed(tables_.rootI - first_.x);
        place.j = fixed(tables_.rootJ - first_.y);
        return place;
    }

    [[nodiscard]] HWY_INLINE Place child(const Place& place, unsigned w) const {
        const PacketLevel& level = levelBelow(place);
        Place child;
        child.level = place.level - 1;
        child.i = place.i + level.centreI[w];
        child.j = place.j + level.centreJ[w];
        for (unsigned a = 0; a < 3; ++a)
            child.corner[a] = place.corner[a] | (w >> a & 1u) << child.level;
        return child;
    }

    HWY_INLINE unsigned rectangles(const Place& place, Rectangles& out) const {
        const PacketLevel& level = levelBelow(place);
        const hn::CappedTag<std::int32_t, 8> d;
        const auto zero = hn::Zero(d);
        const auto lastI = hn::Set(d, size_.x - 1);
        const auto lastJ = hn::Set(d, size_.y - 1);
        const auto i = hn::Set(d, place.i);
        const auto j = hn::Set(d, place.j);
        const int shift = tables_.fractionBits;
        unsigned seen = 0;
        for (std::size_t k = 0; k < 8; k += hn::Lanes(d)) {
            const auto at = [&](const EightInts& table, auto centre) {
                return hn::ShiftRightSame(hn::Add(hn::Load(d, table.data() + k), centre), shift);
            };
            const auto i0 = hn::Max(at(level.lowI, i), zero);
            const auto i1 = hn::Min(at(level.highI, i), lastI);
            const auto j0 = hn::Max(at(level.lowJ, j), zero);
            const auto j1 = hn::Min(at(level.highJ, j), lastJ);
            hn::Store(i0, d, out.i0.data() + k);
            hn::Store(i1, d, out.i1.data() + k);
            hn::Store(j0, d, out.j0.data() + k);
            hn::Store(j1, d, out.j1.data() + k);
            const auto none = hn::Or(hn::Gt(i0, i1), hn::Gt(j0, j1));
            seen |= static_cast<unsigned>(bitsOf(d, hn::Not(none))) << k;
        }
        return seen;
    }

    [[nodiscard]] HWY_INLINE Brick brick(const Place& place) const {
        Brick brick;
        for (int p = 0; p < 3; ++p) {
            const int a = kPairFirst[p];
            const int b = kPairSecond[p];
            brick.corner[p] = (place.corner[a] * tables_.D[b] - place.corner[b] * tables_.D[a])
                              << tables_.positionBits;
        }
        return brick;
    }

    HWY_INLINE bool leaf(const Brick& brick, const Place&, unsigned w, Leaf& leaf) const {
        for (int p = 0; p < 3; ++p)
            leaf.corner[p] = brick.corner[p] + tables_.voxelTest.corner[p][w];
        return true;
    }

    HWY_INLINE std::uint64_t prepare(int, std::uint64_t) {
        if (!startsKnown_) findStarts();
        return 0;
    }

    [[nodiscard]] static HWY_INLINE std::uint64_t lanes() {
        const hn::CappedTag<std::int32_t, kMostLanes> d;
        return ~std::uint64_t{0} >> (64 - hn::Lanes(d));
    }

    template <class Entry>
    HWY_INLINE std::uint64_t meet(const Leaf& leaf, std::size_t at, std::uint64_t asked,
                                  const Entry& entry, std::uint32_t* entries) {
        const VoxelTest& test = tables_.voxelTest;
        const hn::CappedTag<std::int32_t, kMostLanes> d;
        const auto x = [&](int p) {
            return hn::Sub(hn::LoadU(d, starts(p) + at),
                           hn::Set(d, static_cast<std::int32_t>(leaf.corner[p])));
        };
        const auto x01 = x(0);
        const auto x02 = x(1);
        const auto x12 = x(2);
        const auto meets = hn::And(
            hn::Lt(x01, hn::Set(d, test.end[0])),
            hn::And(hn::Lt(x02, hn::Set(d, test.end[1])), hn::Lt(x12, hn::Set(d, test.end[2]))));
        const std::uint64_t hit = bitsOf(d, meets) & asked;
        if (hit == 0) return 0;
        // The axis whose lower face is crossed last.
        const auto notTwo = hn::Or(hn::Lt(x02, hn::Set(d, test.middle[1])),
                                   hn::Lt(x12, hn::Set(d, test.middle[2])));
        const auto notOne = hn::Lt(x01, hn::Set(d, test.middle[0]));
        const auto zeroOrOne = hn::IfThenZeroElse(notOne, hn::Set(d, 1));
        const auto axis = hn::IfThenElse(notTwo, zeroOrOne, hn::Set(d, 2));
        const auto value = hn::Or(axis, hn::Set(d, static_cast<std::int32_t>(entry())));
        std::uint8_t bytes[8];
        std::memcpy(bytes, &hit, sizeof hit);
        auto* const place = reinterpret_cast<std::int32_t*>(entries);
        const auto old = hn::LoadU(d, place);
        hn::StoreU(hn::IfThenElse(hn::LoadMaskBits(d, bytes), value, old), d, place);
        return hit;
    }

  private:
    [[nodiscard]] const PacketLevel& levelBelow(const Place& place) const {
        return tables_.levels[static_cast<std::size_t>(place.level - 1)];
    }
    [[nodiscard]] std::int32_t fixed(double px) const {
        return static_cast<std::int32_t>(std::lround(std::ldexp(px, tables_.fractionBits)));
    }
    [[nodiscard]] std::int32_t* starts(int p) {
        return hits_.starts[static_cast<std::size_t>(p)].data();
    }

    // Where the rays of a row start on one axis, modulo 2^32: the first, and a step, each split at
    // kStepShift so that nothing that matters is lost. Mirrored: O ^ flip - flipEnd.
    struct RowOfStarts {
        std::int32_t high, low, stepHigh, stepLow;
        std::int32_t flip, flipEnd;
        std::int32_t lowestBit;  // set where the rays stay where they are
    };

    [[nodiscard]] static std::int32_t wrapped(std::int32_t a, std::int32_t b) {
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) *
                                         static_cast<std::uint32_t>(b));
    }

    [[nodiscard]] RowOfStarts rowOf(int a, int row) const {
        constexpr std::int64_t kLow = (std::int64_t{1} << kStepShift) - 1;
        const std::int64_t start =
            std::int64_t{first_.x} * tables_.U[a] + std::int64_t{first_.y + row} * tables_.V[a];
        RowOfStarts starts;
        starts.high = static_cast<std::int32_t>((start >> kStepShift) + tables_.C[a]);
        starts.low = static_cast<std::int32_t>(start & kLow);
        starts.stepHigh = tables_.U[a] >> kStepShift;
        starts.stepLow = static_cast<std::int32_t>(tables_.U[a] & kLow);
        const bool mirrored = tables_.tree.flip[a] != 0;
        const std::uint32_t edge = std::uint32_t{1} << tables_.positionBits
                                                    << tables_.tree.octree.maxDepth;
        starts.flip = mirrored ? -1 : 0;
        starts.flipEnd = mirrored ? static_cast<std::int32_t>(~edge) : 0;
        starts.lowestBit = tables_.D[a] == 0 ? 1 : 0;
        return starts;
    }

    // G of every ray, by pair.
    void findStarts() {
        startsKnown_ = true;
        const hn::CappedTag<std::int32_t, 16> d;
        const auto lanes = static_cast<int>(hn::Lanes(d));
        using Vector = hn::Vec<decltype(d)>;
        for (int row = 0; row < size_.y; ++row) {
            RowOfStarts along[3];
            for (int a = 0; a < 3; ++a) along[a] = rowOf(a, row);
            // Of the first columns; what the columns before them add comes as a number.
            const auto stepLow = [&](const RowOfStarts& axis) {
                return hn::Add(hn::Mul(hn::Iota(d, 0), hn::Set(d, axis.stepLow)),
                               hn::Set(d, axis.low));
            };
            const auto stepHigh = [&](const RowOfStarts& axis) {
                return hn::Add(hn::Mul(hn::Iota(d, 0), hn::Set(d, axis.stepHigh)),
                               hn::Set(d, axis.high));
            };
            const Vector low0 = stepLow(along[0]), high0 = stepHigh(along[0]);
            const Vector low1 = stepLow(along[1]), high1 = stepHigh(along[1]);
            const Vector low2 = stepLow(along[2]), high2 = stepHigh(along[2]);
            const auto D0 = hn::Set(d, static_cast<std::int32_t>(tables_.D[0]));
            const auto D1 = hn::Set(d, static_cast<std::int32_t>(tables_.D[1]));
            const auto D2 = hn::Set(d, static_cast<std::int32_t>(tables_.D[2]));
            for (int column = 0; column < size_.x; column += lanes) {
                const auto start = [&](const RowOfStarts& axis, Vector low, Vector high) {
                    const auto lower = hn::Add(low, hn::Set(d, column * axis.stepLow));
                    const auto upper = hn::Add(high, hn::Set(d, wrapped(column, axis.stepHigh)));
                    const auto O = hn::Add(upper, hn::ShiftRight<kStepShift>(lower));
                    const auto mirrored =
                        hn::Sub(hn::Xor(O, hn::Set(d, axis.flip)), hn::Set(d, axis.flipEnd));
                    return hn::Or(mirrored, hn::Set(d, axis.lowestBit));
                };
                const auto O0 = start(along[0], low0, high0);
                const auto O1 = start(along[1], low1, high1);
                const auto O2 = start(along[2], low2, high2);
                const std::size_t at = PacketHits::index(column, row);
                hn::StoreU(hn::Sub(hn::Mul(O0, D1), hn::Mul(O1, D0)), d, starts(0) + at);
                hn::StoreU(hn::Sub(hn::Mul(O0, D2), hn::Mul(O2, D0)), d, starts(1) + at);
                hn::StoreU(hn::Sub(hn::Mul(O1, D2), hn::Mul(O2, D1)), d, starts(2) + at);
            }
        }
    }

    const PacketTables& tables_;
    glm::ivec2 first_, size_;
    PacketHits& hits_;
    bool startsKnown_ = false;
};

void castPacket(const PacketTables& tables, glm::ivec2 first, glm::ivec2 size, PacketHits& hits) {
    alignas(64) std::uint64_t alive[PacketHits::kEdge + 8];
    std::fill_n(alive, size.y, ~std::uint64_t{0} >> (PacketHits::kEdge - size.x));
    hits.clear(size.y);
    ParallelRays rays(tables, first, size, hits);
    PacketWalk<ParallelRays>(tables.tree, rays, alive, hits).run(rays.root());
}

}  // namespace
}  // namespace voxprite::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace voxprite {

HWY_EXPORT(castPacket);

void walkPacket(const PacketTables& tables, glm::ivec2 first, glm::ivec2 size, PacketHits& hits) {
    HWY_DYNAMIC_DISPATCH(castPacket)(tables, first, size, hits);
}

}  // namespace voxprite
#endif
