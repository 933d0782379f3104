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

    // A node's centre on the picture, see RayPicture.
    struct Place {
        int level = 0;
        float x = 0, y = 0, z = 0;
        std::uint32_t corner[3] = {0, 0, 0};
    };
    struct Brick {};
    // A leaf's lower and upper faces in steps of the rays' lattice.
    struct Leaf {
        double low[3], high[3];
        bool aroundEye = false;
    };

    EyeRays(const RayPicture& picture, const PacketTree& tree, RayPacketHits& hits)
        : picture_(picture), tree_(tree), hits_(hits) {
        const int depth = tree.octree.maxDepth;
        positionBits_ = kRayEdgeBits - depth;
        rootEdge_ = std::ldexp(1.0, kRayEdgeBits);
        for (int a = 0; a < 3; ++a) {
            boxLow_[a] = picture.box.min[a] - tree.octree.treeFromVoxel[a];
            boxHigh_[a] = picture.box.max[a] - tree.octree.treeFromVoxel[a];
        }
        for (int a = 0; picture.inside && a < 3; ++a) {
            // quantiseRay's start of every ray: it is the eye.
            const double steps =
                (picture.eye[a] + tree.octree.treeFromVoxel[a]) * (1 << positionBits_);
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
        const double step = 1 << positionBits_;
        const auto edge = static_cast<double>(1 << (positionBits_ + place.level));
        leaf.aroundEye = picture_.inside;
        for (int a = 0; a < 3; ++a) {
            leaf.low[a] = place.corner[a] * step;
            leaf.high[a] = leaf.low[a] + edge;
            if (!picture_.inside) continue;
            if (leaf.high[a] <= eye_[a]) return false;  // behind the eye
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
        const hn::Vec<decltype(d)> D[3] = {hn::LoadU(d, hits_.directions[0].data() + at),
                                           hn::LoadU(d, hits_.directions[1].data() + at),
                                           hn::LoadU(d, hits_.directions[2].data() + at)};
        // G - (l[a] D[b] - u[b] D[a]), not negative where u[b] comes after l[a], and so on: all
        // integers below 2^53.
        const auto product = [&](double face, int axis) {
            return hn::Mul(hn::Set(d, face), D[axis]);
        };
        auto missed = hn::Lt(hn::Zero(d), hn::Zero(d));
        hn::Mask<decltype(d)> firstLater[3];
        for (int p = 0; p < 3; ++p) {
            const int a = kPairFirst[p];
            const int b = kPairSecond[p];
            const auto G = hn::LoadU(d, hits_.products[static_cast<std::size_t>(p)].data() + at);
            const auto lowA = product(leaf.low[a], b);
            const auto highA = product(leaf.high[a], b);
            const auto lowB = hn::Add(G, product(leaf.low[b], a));
            const auto highB = hn::Add(G, product(leaf.high[b], a));
            missed = hn::Or(missed, hn::Or(hn::Lt(highB, lowA), hn::Ge(lowB, highA)));
            firstLater[p] = hn::Lt(lowB, lowA);
        }
        std::uint64_t hit = bitsOf(d, hn::Not(missed)) & asked;
        if (hit == 0) return 0;
        const std::uint64_t later01 = bitsOf(d, firstLater[0]);
        const std::uint64_t notTwo = bitsOf(d, hn::Or(firstLater[1], firstLater[2]));
        const std::uint32_t base = entry();
        for (std::uint64_t left = hit; left != 0; left &= left - 1) {
            const int k = std::countr_zero(left);
            std::uint32_t axis = (later01 >> k & 1) != 0 ? 0 : 1;
            if ((notTwo >> k & 1) == 0) axis = 2;
            if (leaf.aroundEye) axis = kInsideAxis;
            entries[k] = base | axis;
        }
        return hit;
    }

  private:
    struct Level {
        alignas(32) std::array<EightFloats, 3> offset;
        float radius[3];
    };

    using Vector = hn::Vec<hn::CappedTag<double, kMostLanes>>;

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
            Vector direction[3];
            directionsAt(first, row, direction);
            const std::uint64_t alone = quantiseChunk(direction, PacketHits::index(0, row) + first);
            done |= alone << first & left & chunk;
            left &= ~chunk;
        }
        castAlone(row, done);
        return done;
    }

    // Of a vector's rays; past the last column any.
    HWY_INLINE void directionsAt(std::size_t first, int row, Vector (&direction)[3]) const {
        const hn::CappedTag<double, kMostLanes> d;
        if (picture_.rays.empty()) {
            // EyePicture::ray, operation by operation.
            const EyePicture& picture = picture_.eyePicture;
            const auto i = hn::Add(hn::Iota(d, 0.0),
                                   hn::Set(d, picture_.corner.x + static_cast<double>(first)));
            const double j = picture_.corner.y + row;
            for (int a = 0; a < 3; ++a) {
                const auto across = hn::Mul(hn::Set(d, picture.perColumn[a]), i);
                direction[a] = hn::Add(hn::Add(hn::Set(d, picture.first[a]), across),
                                       hn::Set(d, picture.perRow[a] * j));
            }
            return;
        }
        alignas(64) double own[3][kMostLanes];
        for (std::size_t k = 0; k < hn::Lanes(d); ++k) {
            const int column = std::min(static_cast<int>(first + k), picture_.size.x - 1);
            const glm::dvec3 along = picture_.rayAt(column, row).direction;
            for (int a = 0; a < 3; ++a) own[a][k] = along[a];
        }
        for (int a = 0; a < 3; ++a) direction[a] = hn::Load(d, own[a]);
    }

    // The numbers of a vector's rays, to `at`; a bit for each that misses the box or stays where it
    // is on an axis: those have none.
    HWY_INLINE std::uint64_t quantiseChunk(const Vector (&along)[3], std::size_t at) {
        const hn::CappedTag<double, kMostLanes> d;
        const auto zero = hn::Zero(d);
        const auto largest =
            hn::Max(hn::Max(hn::Abs(along[0]), hn::Abs(along[1])), hn::Abs(along[2]));
        const Vector scaled[3] = {hn::Div(along[0], largest), hn::Div(along[1], largest),
                                  hn::Div(along[2], largest)};
        auto alone = hn::Lt(zero, zero);
        auto enter = zero;
        for (int a = 0; a < 3; ++a) {
            const bool below = picture_.eye[a] < boxLow_[a];
            if (!below && picture_.eye[a] < boxHigh_[a]) continue;
            alone = hn::Or(alone, below ? hn::Le(scaled[a], zero) : hn::Ge(scaled[a], zero));
            const double distance = (below ? boxLow_[a] : boxHigh_[a]) - picture_.eye[a];
            const auto when = hn::Div(hn::Set(d, distance), scaled[a]);
            enter = hn::IfThenElse(hn::Gt(when, enter), when, enter);
        }
        const auto rounded = [&](Vector x) {
            return hn::Trunc(hn::Add(x, hn::CopySign(hn::Set(d, 0.5), x)));
        };
        Vector O[3] = {zero, zero, zero}, D[3] = {zero, zero, zero};
        for (int a = 0; a < 3; ++a) {
            const auto start = hn::Add(hn::Set(d, picture_.eye[a]), hn::Mul(scaled[a], enter));
            const auto within = hn::And(hn::Ge(start, hn::Set(d, boxLow_[a] - 1.0)),
                                        hn::Le(start, hn::Set(d, boxHigh_[a] + 1.0)));
            alone = hn::Or(alone, hn::Not(within));
            const auto inTree =
                hn::Add(start, hn::Set(d, static_cast<double>(picture_.octree.treeFromVoxel[a])));
            const auto origin = rounded(hn::Mul(inTree, hn::Set(d, 1 << positionBits_)));
            O[a] = tree_.flip[a] != 0 ? hn::Sub(hn::Set(d, rootEdge_), origin) : origin;
            D[a] = hn::Abs(rounded(hn::Mul(scaled[a], hn::Set(d, 1 << kRayDirectionBits))));
            alone = hn::Or(alone, hn::Eq(D[a], zero));
            hn::StoreU(D[a], d, hits_.directions[static_cast<std::size_t>(a)].data() + at);
        }
        for (int p = 0; p < 3; ++p) {
            const auto G = hn::Sub(hn::Mul(O[kPairFirst[p]], D[kPairSecond[p]]),
                                   hn::Mul(O[kPairSecond[p]], D[kPairFirst[p]]));
            hn::StoreU(G, d, hits_.products[static_cast<std::size_t>(p)].data() + at);
        }
        return bitsOf(d, alone);
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
    double rootEdge_ = 0.0;              // in steps
    double eye_[3]{};                    // mirrored, in steps; where it is in the box
    double boxLow_[3]{}, boxHigh_[3]{};  // in voxels
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
