// The walk of core/trace/ray_packet.h, compiled once for each SIMD target that the compiler knows.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/trace/ray_walk.cpp"
#include <hwy/foreach_target.h>  // includes this file again for every target

#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/trace/packet_walk-inl.h"
#include "core/trace/ray_walk.h"

HWY_BEFORE_NAMESPACE();
namespace voxprite::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using EightFloats = std::array<float, 8>;

class EyeRays {
  public:
    static constexpr std::size_t kMostLanes = 8;
    using Vector = hn::Vec<hn::CappedTag<double, kMostLanes>>;

    // A node's centre on the picture, see RayPicture.
    struct Place {
        int level = 0;
        float x = 0, y = 0, z = 0;
        std::uint32_t corner[3] = {0, 0, 0};
    };
    struct Brick {};
    // A leaf's lower faces and its edge in steps of the rays' lattice.
    struct Leaf {
        double low[3], edge;
        bool aroundEye = false;
    };

    EyeRays(const RayPicture& picture, const PacketTree& tree, RayPacketHits& hits)
        : picture_(picture), tree_(tree), hits_(hits) {
        const int depth = tree.octree.maxDepth;
        positionBits_ = kRayEdgeBits - depth;
        stepsPerVoxel_ = 1 << positionBits_;
        rootEdge_ = std::ldexp(1.0, kRayEdgeBits);
        for (int a = 0; a < 3; ++a) axes_[static_cast<std::size_t>(a)] = axisOf(a);
        for (int a = 0; picture.inside && a < 3; ++a) {
            // quantiseRay's start of every ray: it is the eye.
            const double steps = (picture.eye[a] + tree.octree.treeFromVoxel[a]) * stepsPerVoxel_;
            const auto start =
                static_cast<double>(static_cast<int>(steps < 0.0 ? steps - 0.5 : steps + 0.5));
            eye_[a] = tree.flip[a] != 0 ? rootEdge_ - start : start;
        }
        // A float is off by 2^-24 of the greatest number on the way, a few times a level.
        const glm::dmat3& m = picture.pictureFromVoxel;
        const auto radius = [&](int row, double half) {
            return (std::abs(m[0][row]) + std::abs(m[1][row]) + std::abs(m[2][row])) * half;
        };
        for (int k = 0; k < depth; ++k) {
            Level& level = levels_[static_cast<std::size_t>(k)];
            for (int row = 0; row < 3; ++row) {
                const double reach =
                    std::abs(picture.rootCentre[row]) + radius(row, std::ldexp(0.5, depth));
                level.radius[row] = static_cast<float>(
                    radius(row, std::ldexp(0.5, k) + picture.slack) * (1.0 + 1e-6) + 4e-6 * reach);
                for (unsigned w = 0; w < 8; ++w) {
                    double offset = 0.0;
                    for (int a = 0; a < 3; ++a) {
                        const bool upper = (w >> a & 1u) != (tree.flip[a] != 0 ? 1u : 0u);
                        offset += m[a][row] * std::ldexp(upper ? 0.5 : -0.5, k);
                    }
                    level.offset[static_cast<std::size_t>(row)][w] = static_cast<float>(offset);
                }
            }
        }
    }

    [[nodiscard]] Place root() const {
        Place place;
        place.level = tree_.octree.maxDepth;
        place.x = static_cast<float>(picture_.rootCentre.x);
        place.y = static_cast<float>(picture_.rootCentre.y);
        place.z = static_cast<float>(picture_.rootCentre.z);
        return place;
    }

    [[nodiscard]] HWY_INLINE Place child(const Place& place, unsigned w) const {
        const Level& level = levels_[static_cast<std::size_t>(place.level - 1)];
        Place child;
        child.level = place.level - 1;
        child.x = place.x + level.offset[0][w];
        child.y = place.y + level.offset[1][w];
        child.z = place.z + level.offset[2][w];
        for (unsigned a = 0; a < 3; ++a)
            child.corner[a] = place.corner[a] | (w >> a & 1u) << child.level;
        return child;
    }

    HWY_INLINE unsigned rectangles(const Place& place, Rectangles& out) const {
        const Level& level = levels_[static_cast<std::size_t>(place.level - 1)];
        const hn::CappedTag<float, 8> d;
        const hn::Rebind<std::int32_t, decltype(d)> di;
        const auto zero = hn::Zero(d);
        unsigned seen = 0;
        for (std::size_t k = 0; k < 8; k += hn::Lanes(d)) {
            const auto centre = [&](std::size_t row, float at) {
                return hn::Add(hn::Load(d, level.offset[row].data() + k), hn::Set(d, at));
            };
            const auto z = centre(2, place.z);
            const auto radiusZ = hn::Set(d, level.radius[2]);
            const auto nearZ = hn::Sub(z, radiusZ);
            const auto farZ = hn::Add(z, radiusZ);
            const auto before = hn::Gt(farZ, zero);
            const auto whole = hn::Gt(nearZ, hn::Mul(farZ, hn::Set(d, 1e-4f)));
            const auto one = hn::Set(d, 1.0f);
            const auto perNear = hn::Div(one, hn::IfThenElse(whole, nearZ, one));
            const auto perFar = hn::Div(one, hn::IfThenElse(before, farZ, one));
            // The pixels from the least to the greatest of x / z over the node's box.
            const auto pixels = [&](std::size_t row, float at, float middle, int last,
                                    std::int32_t* first, std::int32_t* end) {
                const auto c = centre(row, at);
                const auto radius = hn::Set(d, level.radius[row]);
                const auto low = hn::Sub(c, radius);
                const auto high = hn::Add(c, radius);
                const auto least = hn::Mul(low, hn::IfThenElse(hn::Lt(low, zero), perNear, perFar));
                const auto most =
                    hn::Mul(high, hn::IfThenElse(hn::Lt(high, zero), perFar, perNear));
                constexpr float kSlackPx = 1.0f / 64.0f;
                const auto lastPx = hn::Set(d, static_cast<float>(last));
                const auto beyond = hn::Set(d, static_cast<float>(last + 1));
                auto from = hn::Ceil(hn::Add(least, hn::Set(d, middle - kSlackPx)));
                auto to = hn::Floor(hn::Add(most, hn::Set(d, middle + kSlackPx)));
                from = hn::IfThenElse(whole, hn::Min(hn::Max(from, zero), beyond), zero);
                to = hn::IfThenElse(whole, hn::Max(hn::Min(to, lastPx), hn::Set(d, -1.0f)), lastPx);
                hn::Store(hn::ConvertTo(di, from), di, first);
                hn::Store(hn::ConvertTo(di, to), di, end);
                return hn::Gt(from, to);
            };
            const auto noI = pixels(0, place.x, static_cast<float>(picture_.middle.x),
                                    picture_.size.x - 1, out.i0.data() + k, out.i1.data() + k);
            const auto noJ = pixels(1, place.y, static_cast<float>(picture_.middle.y),
                                    picture_.size.y - 1, out.j0.data() + k, out.j1.data() + k);
            const auto none = hn::Or(hn::Or(noI, noJ), hn::Not(before));
            seen |= static_cast<unsigned>(bitsOf(d, hn::Not(none))) << k;
        }
        return seen;
    }

    [[nodiscard]] static Brick brick(const Place&) { return {}; }

    HWY_INLINE bool leaf(const Brick&, const Place& place, unsigned, Leaf& leaf) const {
        leaf.edge = static_cast<double>(1 << (positionBits_ + place.level));
        leaf.aroundEye = picture_.inside;
        for (int a = 0; a < 3; ++a) {
            leaf.low[a] = place.corner[a] * stepsPerVoxel_;
            if (!picture_.inside) continue;
            if (leaf.low[a] + leaf.edge <= eye_[a]) return false;  // behind the eye
            if (leaf.low[a] > eye_[a]) leaf.aroundEye = false;
        }
        return true;
    }

    // Works out the numbers of rays that lack them; those that miss the box, or are cast alone, are
    // done with.
    HWY_INLINE std::uint64_t prepare(int row, std::uint64_t asked) {
        std::uint64_t lacking = asked & ~hits_.quantised[static_cast<std::size_t>(row)];
        return HWY_LIKELY(lacking == 0) ? 0 : quantise(row, lacking);
    }

    [[nodiscard]] static HWY_INLINE std::uint64_t lanes() {
        const hn::CappedTag<double, kMostLanes> d;
        return ~std::uint64_t{0} >> (64 - hn::Lanes(d));
    }

    template <class Entry>
    HWY_INLINE std::uint64_t meet(const Leaf& leaf, std::size_t at, std::uint64_t asked,
                                  const Entry& entry, std::uint32_t* entries) {
        const hn::CappedTag<double, kMostLanes> d;
        const auto zero = hn::Zero(d);
        const auto D0 = hn::LoadU(d, hits_.directions[0].data() + at);
        const auto D1 = hn::LoadU(d, hits_.directions[1].data() + at);
        const auto D2 = hn::LoadU(d, hits_.directions[2].data() + at);
        // How much later, times D[a] D[b], a ray crosses the lower face on b than that on a: all
        // are integers below 2^53.
        const auto laterBy = [&](int pair, int a, int b, Vector Da, Vector Db) {
            const auto G = hn::LoadU(d, hits_.products[static_cast<std::size_t>(pair)].data() + at);
            return hn::NegMulAdd(hn::Set(d, leaf.low[a]), Db,
                                 hn::MulAdd(hn::Set(d, leaf.low[b]), Da, G));
        };
        const auto later01 = laterBy(0, 0, 1, D0, D1);
        const auto later02 = laterBy(1, 0, 2, D0, D2);
        const auto later12 = laterBy(2, 1, 2, D1, D2);
        // Between two faces of one axis lies the time that an edge takes: either lower face has to
        // be crossed before the other's upper one.
        const auto edge = hn::Set(d, leaf.edge);
        const auto across0 = hn::Mul(edge, D0);
        const auto across1 = hn::Mul(edge, D1);
        const auto across2 = hn::Mul(edge, D2);
        const auto missedOf = [&](Vector later, Vector acrossA, Vector acrossB) {
            return hn::Or(hn::Lt(hn::Add(later, acrossA), zero), hn::Ge(later, acrossB));
        };
        const auto missed = hn::Or(
            missedOf(later01, across0, across1),
            hn::Or(missedOf(later02, across0, across2), missedOf(later12, across1, across2)));
        const std::uint64_t hit = bitsOf(d, hn::Not(missed)) & asked;
        if (hit == 0) return 0;
        // The axis whose lower face is crossed last.
        const auto zeroOrOne = hn::IfThenElseZero(hn::Ge(later01, zero), hn::Set(d, 1.0));
        const auto notTwo = hn::Or(hn::Lt(later02, zero), hn::Lt(later12, zero));
        auto axis = hn::IfThenElse(notTwo, zeroOrOne, hn::Set(d, 2.0));
        if (leaf.aroundEye) axis = hn::Set(d, double{kInsideAxis});
        const hn::Rebind<std::int32_t, decltype(d)> dEntry;
        const auto value =
            hn::Or(hn::DemoteTo(dEntry, axis), hn::Set(dEntry, static_cast<std::int32_t>(entry())));
        std::uint8_t bytes[8];
        std::memcpy(bytes, &hit, sizeof hit);
        auto* const place = reinterpret_cast<std::int32_t*>(entries);
        const auto old = hn::LoadU(dEntry, place);
        hn::StoreU(hn::IfThenElse(hn::LoadMaskBits(dEntry, bytes), value, old), dEntry, place);
        return hit;
    }

  private:
    struct Level {
        alignas(32) std::array<EightFloats, 3> offset;
        float radius[3];
    };

    // What the rays have in common on one axis, in voxels.
    struct Axis {
        double first = 0.0, perColumn = 0.0, perRow = 0.0;  // of EyePicture
        double eye = 0.0;
        double distance = 0.0;           // to the face of the box that they come in by
        bool outside = false;            // there is one
        double least = 0.0, most = 0.0;  // where they start, if they meet the box
        double treeFromVoxel = 0.0;
        bool mirrored = false;
    };

    // quantiseRay, operation by operation, for as many rays at once as a vector has lanes.
    HWY_NOINLINE std::uint64_t quantise(int row, std::uint64_t lacking) {
        const hn::CappedTag<double, kMostLanes> d;
        const std::size_t count = hn::Lanes(d);
        std::uint64_t done = 0;
        hits_.quantised[static_cast<std::size_t>(row)] |= lacking;
        for (std::uint64_t left = lacking; left != 0;) {
            const std::size_t first =
                static_cast<std::size_t>(std::countr_zero(left)) / count * count;
            const std::uint64_t chunk = lanes() << first;
            const std::size_t at = PacketHits::index(0, row) + first;
            const std::uint64_t alone = picture_.rays.empty() ? quantisePixels(first, row, at)
                                                              : quantiseGiven(first, row, at);
            done |= alone << first & left & chunk;
            left &= ~chunk;
        }
        castAlone(row, done);
        return done;
    }

    // Both: of a vector's rays; past the last column any.
    HWY_INLINE std::uint64_t quantisePixels(std::size_t first, int row, std::size_t at) {
        const hn::CappedTag<double, kMostLanes> d;
        // EyePicture::ray, operation by operation.
        const auto i =
            hn::Add(hn::Iota(d, 0.0), hn::Set(d, picture_.corner.x + static_cast<double>(first)));
        const double j = picture_.corner.y + row;
        const auto along = [&](const Axis& axis) {
            const auto across = hn::Mul(hn::Set(d, axis.perColumn), i);
            return hn::Add(hn::Add(hn::Set(d, axis.first), across), hn::Set(d, axis.perRow * j));
        };
        return quantiseChunk(along(axes_[0]), along(axes_[1]), along(axes_[2]), at);
    }

    HWY_INLINE std::uint64_t quantiseGiven(std::size_t first, int row, std::size_t at) {
        const hn::CappedTag<double, kMostLanes> d;
        alignas(64) double own[3][kMostLanes];
        for (std::size_t k = 0; k < hn::Lanes(d); ++k) {
            const int column = std::min(static_cast<int>(first + k), picture_.size.x - 1);
            const glm::dvec3 along = picture_.rayAt(column, row).direction;
            own[0][k] = along.x;
            own[1][k] = along.y;
            own[2][k] = along.z;
        }
        return quantiseChunk(hn::Load(d, own[0]), hn::Load(d, own[1]), hn::Load(d, own[2]), at);
    }

    // The numbers of a vector's rays, to `at`; a bit for each that misses the box or stays where it
    // is on an axis: those have none. Axes are written out: compilers keep loops over them, and the
    // vectors in memory.
    HWY_INLINE std::uint64_t quantiseChunk(Vector along0, Vector along1, Vector along2,
                                           std::size_t at) {
        const hn::CappedTag<double, kMostLanes> d;
        const auto largest = hn::Max(hn::Max(hn::Abs(along0), hn::Abs(along1)), hn::Abs(along2));
        const auto scaled0 = hn::Div(along0, largest);
        const auto scaled1 = hn::Div(along1, largest);
        const auto scaled2 = hn::Div(along2, largest);
        auto enter = hn::Zero(d);
        const auto comeIn = [&](const Axis& axis, Vector scaled) HWY_ATTR {
            if (!axis.outside) return;
            const auto when = hn::Div(hn::Set(d, axis.distance), scaled);
            enter = hn::IfThenElse(hn::Gt(when, enter), when, enter);
        };
        comeIn(axes_[0], scaled0);
        comeIn(axes_[1], scaled1);
        comeIn(axes_[2], scaled2);
        auto alone = hn::Lt(enter, hn::Zero(d));
        const auto origin = [&](const Axis& axis, Vector scaled) HWY_ATTR {
            const auto start = hn::Add(hn::Set(d, axis.eye), hn::Mul(scaled, enter));
            const auto within = hn::And(hn::Ge(start, hn::Set(d, axis.least)),
                                        hn::Le(start, hn::Set(d, axis.most)));
            alone = hn::Or(alone, hn::Not(within));
            const auto steps =
                hn::Mul(hn::Add(start, hn::Set(d, axis.treeFromVoxel)), hn::Set(d, stepsPerVoxel_));
            const auto O = hn::Trunc(hn::Add(steps, hn::CopySign(hn::Set(d, 0.5), steps)));
            return axis.mirrored ? hn::Sub(hn::Set(d, rootEdge_), O) : O;
        };
        const auto O0 = origin(axes_[0], scaled0);
        const auto O1 = origin(axes_[1], scaled1);
        const auto O2 = origin(axes_[2], scaled2);
        const auto direction = [&](std::size_t a, Vector scaled) HWY_ATTR {
            const auto steps = hn::Mul(hn::Abs(scaled), hn::Set(d, 1 << kRayDirectionBits));
            const auto D = hn::Floor(hn::Add(steps, hn::Set(d, 0.5)));
            alone = hn::Or(alone, hn::Eq(D, hn::Zero(d)));
            hn::StoreU(D, d, hits_.directions[a].data() + at);
            return D;
        };
        const auto D0 = direction(0, scaled0);
        const auto D1 = direction(1, scaled1);
        const auto D2 = direction(2, scaled2);
        const auto product = [&](std::size_t pair, Vector Oa, Vector Ob, Vector Da,
                                 Vector Db) HWY_ATTR {
            hn::StoreU(hn::MulSub(Oa, Db, hn::Mul(Ob, Da)), d, hits_.products[pair].data() + at);
        };
        product(0, O0, O1, D0, D1);
        product(1, O0, O2, D0, D2);
        product(2, O1, O2, D1, D2);
        return bitsOf(d, alone);
    }

    [[nodiscard]] Axis axisOf(int a) const {
        Axis axis;
        axis.first = picture_.eyePicture.first[a];
        axis.perColumn = picture_.eyePicture.perColumn[a];
        axis.perRow = picture_.eyePicture.perRow[a];
        axis.eye = picture_.eye[a];
        axis.treeFromVoxel = tree_.octree.treeFromVoxel[a];
        const double low = picture_.box.min[a] - axis.treeFromVoxel;
        const double high = picture_.box.max[a] - axis.treeFromVoxel;
        const bool below = axis.eye < low;
        axis.outside = below || axis.eye >= high;
        axis.distance = (below ? low : high) - axis.eye;
        axis.least = low - 1.0;
        axis.most = high + 1.0;
        axis.mirrored = tree_.flip[a] != 0;
        return axis;
    }

    // Rays that have no numbers: those that meet the box all the same.
    void castAlone(int row, std::uint64_t rays) {
        for (; rays != 0; rays &= rays - 1) {
            const int column = std::countr_zero(rays);
            const QuantisedRay q =
                quantiseRay(picture_.octree, picture_.rayAt(column, row), picture_.maxDepth);
            if (q.meetsBox) hits_.add(column, row, castQuantised(picture_.octree, q));
        }
    }

    const RayPicture& picture_;
    const PacketTree& tree_;
    RayPacketHits& hits_;
    int positionBits_ = 0;
    double stepsPerVoxel_ = 0.0;
    double rootEdge_ = 0.0;  // in steps
    double eye_[3]{};        // mirrored, in steps; where it is in the box
    std::array<Axis, 3> axes_;
    std::array<Level, kMaxOctreeDepth> levels_;
};

void castRays(const RayPicture& picture, glm::bvec3 mirrored, std::uint64_t* alive,
              RayPacketHits& hits) {
    const PacketTree tree(picture.octree, picture.box, mirrored, picture.leafLevel);
    EyeRays rays(picture, tree, hits);
    PacketWalk<EyeRays>(tree, rays, alive, hits).run(rays.root());
}

}  // namespace
}  // namespace voxprite::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace voxprite {

HWY_EXPORT(castRays);

void walkRays(const RayPicture& picture, glm::bvec3 mirrored, std::uint64_t* alive,
              RayPacketHits& hits) {
    HWY_DYNAMIC_DISPATCH(castRays)(picture, mirrored, alive, hits);
}

}  // namespace voxprite
#endif
