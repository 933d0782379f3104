// The way of a packet down the octree, whatever its rays: see core/trace/packet_caster.h. Included
// once for each SIMD target.
#if defined(VOXPRITE_PACKET_WALK_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef VOXPRITE_PACKET_WALK_INL
#undef VOXPRITE_PACKET_WALK_INL
#else
#define VOXPRITE_PACKET_WALK_INL
#endif

#include <hwy/highway.h>

#include <bit>
#include <cstring>

#include "core/trace/packet_caster.h"
#include "core/trace/packet_tables.h"

HWY_BEFORE_NAMESPACE();
namespace voxprite::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Pixels of a packet by octant: columns i0 ... i1, rows j0 ... j1.
struct Rectangles {
    alignas(32) EightInts i0, i1, j0, j1;

    [[nodiscard]] std::uint64_t columns(unsigned w) const {
        return (~std::uint64_t{0} << i0[w]) & (~std::uint64_t{0} >> (63 - i1[w]));
    }
};

// Of all lanes of a vector.
template <class D>
HWY_INLINE std::uint64_t bitsOf(D d, hn::Mask<D> mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    std::uint64_t bits;
    std::memcpy(&bits, bytes, sizeof bits);
    return bits;
}

// `Rays` knows where nodes lie among the packet's pixels and which rays meet a voxel. It has
//
//   Place      a node: its level, corner (walk coordinates) and place on the picture
//   child      the place of one of its octants, in walk order
//   rectangles which octants can cover pixels of the packet, and which pixels
//   Brick      what the tests of a node's eight leaves share;  brick
//   Leaf       the test of one of them;                        leaf
//   prepare    makes rays of a row ready for tests; those that are done with for other reasons
//   meet       which of the rays asked meet a leaf, from pixel `at` on, one a bit; their entries
template <class Rays>
class PacketWalk {
  public:
    using Place = typename Rays::Place;

    // `alive`: a bit a ray that looks for its hit, a word a row; kEdge of them and 8 more to read.
    PacketWalk(const PacketTree& tree, Rays& rays, std::uint64_t* alive, PacketHits& hits)
        : tree_(tree), octree_(tree.octree), rays_(rays), alive_(alive), hits_(hits) {}

    void run(const Place& root) {
        const std::uint32_t word = octree_.nodes[0];
        if (node::isInternal(word)) {
            descend(word, root);
        } else if (node::isBrick(word)) {
            drawBrick(word, root);
        } else {
            splitLeaf(word, root);
        }
    }

  private:
    // Does any ray of the rectangle still look for its hit?
    [[nodiscard]] HWY_INLINE bool anyAlive(const Rectangles& r, unsigned w) const {
        const std::uint64_t columns = r.columns(w);
        const int j1 = r.j1[w];
        int j = r.j0[w];
        if (j1 - j < 4) {
            std::uint64_t rows = 0;
            for (; j <= j1; ++j) rows |= alive_[j];
            return (rows & columns) != 0;
        }
        const hn::ScalableTag<std::uint64_t> d;
        const int lanes = static_cast<int>(hn::Lanes(d));
        auto rows = hn::Zero(d);
        for (; j + lanes <= j1 + 1; j += lanes) rows = hn::Or(rows, hn::LoadU(d, alive_ + j));
        if (j <= j1) {
            const auto left = hn::FirstN(d, static_cast<std::size_t>(j1 + 1 - j));
            rows = hn::Or(rows, hn::IfThenElseZero(left, hn::LoadU(d, alive_ + j)));
        }
        return !hn::AllTrue(d, hn::Eq(hn::And(rows, hn::Set(d, columns)), hn::Zero(d)));
    }

    void descend(std::uint32_t word, const Place& place) {
        Rectangles r;
        unsigned todo = rays_.rectangles(place, r) & tree_.walkMask[node::childMask(word)];
        const auto childAt = [&](unsigned w) {
            return octree_.nodes[node::childIndex(word, w ^ tree_.flipOctant)];
        };
        if (place.level - 1 == tree_.leafLevel) {
            return drawLeaves(todo, r, place,
                              [&](unsigned w) { return firstMaterial(octree_, childAt(w)); });
        }
        for (; todo != 0; todo &= todo - 1) {
            const auto w = static_cast<unsigned>(std::countr_zero(todo));
            if (!anyAlive(r, w)) continue;
            const std::uint32_t child = childAt(w);
            const Place at = rays_.child(place, w);
            if (node::isInternal(child)) {
                descend(child, at);
            } else if (node::isBrick(child)) {
                drawBrick(child, at);
            } else {
                splitLeaf(child, at);
            }
        }
    }

    void drawBrick(std::uint32_t word, const Place& place) {
        const std::uint64_t payload = octree_.payloads[node::payloadIndex(word)];
        Rectangles r;
        const unsigned todo = rays_.rectangles(place, r) & tree_.walkMask[solidOctants(payload)];
        drawLeaves(todo, r, place,
                   [&](unsigned w) { return payloadMaterial(payload, w ^ tree_.flipOctant); });
    }

    // A uniform leaf, down to the voxels that are seen of it.
    void splitLeaf(std::uint32_t material, const Place& place) {
        Rectangles r;
        unsigned todo = rays_.rectangles(place, r);
        if (place.level - 1 == tree_.leafLevel)
            return drawLeaves(todo, r, place, [=](unsigned) { return material; });
        for (; todo != 0; todo &= todo - 1) {
            const auto w = static_cast<unsigned>(std::countr_zero(todo));
            if (!anyAlive(r, w)) continue;
            const Place at = rays_.child(place, w);
            if (!outsideBox(at)) splitLeaf(material, at);
        }
    }

    // Those of the eight leaves below the place that are in `todo`, in walk order.
    template <class MaterialOf>
    HWY_INLINE void drawLeaves(unsigned todo, const Rectangles& r, const Place& place,
                               const MaterialOf& materialOf) {
        if (todo == 0) return;
        const bool cut = !inBox(place);
        const auto brick = rays_.brick(place);
        for (; todo != 0; todo &= todo - 1) {
            const auto w = static_cast<unsigned>(std::countr_zero(todo));
            const Place at = rays_.child(place, w);
            if (cut && !inBox(at)) continue;
            typename Rays::Leaf leaf;
            if (!rays_.leaf(brick, at, w, leaf)) continue;
            draw(leaf, r, w, [&] { return voxelAt(materialOf(w), at); });
        }
    }

    // Gives a leaf to every ray of the rectangle that meets it and still looks for its hit.
    template <class HitOf>
    HWY_INLINE void draw(const typename Rays::Leaf& leaf, const Rectangles& r, unsigned w,
                         const HitOf& hitOf) {
        constexpr std::uint64_t kLanes = ~std::uint64_t{0} >> (64 - Rays::kMostLanes);
        static_assert(Rays::kMostLanes <= PacketHits::kPadding);
        const std::uint64_t columns = r.columns(w);
        std::uint32_t entry = 0;
        for (int j = r.j0[w]; j <= r.j1[w]; ++j) {
            std::uint64_t asked = alive_[j] & columns;
            if (asked == 0) continue;
            if (const std::uint64_t done = rays_.prepare(j, asked)) {
                alive_[j] &= ~done;
                asked &= ~done;
            }
            while (asked != 0) {
                const int i = std::countr_zero(asked);
                const std::size_t at = PacketHits::index(i, j);
                const std::uint64_t hit = rays_.meet(
                    leaf, at, asked >> i & kLanes,
                    [&] {
                        if (entry == 0) {
                            entry = static_cast<std::uint32_t>(hits_.voxels.size()) << 2;
                            hits_.voxels.push_back(hitOf());
                        }
                        return entry;
                    },
                    hits_.entries.data() + at);
                alive_[j] &= ~(hit << i);
                hits_.rows[static_cast<std::size_t>(j)] |= hit << i;
                asked &= ~(rays_.lanes() << i);
            }
        }
    }

    [[nodiscard]] bool inBox(const Place& place) const {
        for (int a = 0; a < 3; ++a) {
            const auto low = static_cast<std::int64_t>(place.corner[a]);
            if (low < tree_.box.min[a] || low + (1 << place.level) > tree_.box.max[a]) return false;
        }
        return true;
    }
    [[nodiscard]] bool outsideBox(const Place& place) const {
        for (int a = 0; a < 3; ++a) {
            const auto low = static_cast<std::int64_t>(place.corner[a]);
            if (low + (1 << place.level) <= tree_.box.min[a] || low >= tree_.box.max[a])
                return true;
        }
        return false;
    }

    [[nodiscard]] static unsigned solidOctants(std::uint64_t payload) {
        // The highest bit of each byte that is not 0, then those eight bits side by side.
        constexpr std::uint64_t kLow = 0x7F7F'7F7F'7F7F'7F7Full;
        const std::uint64_t solid = (((payload & kLow) + kLow) | payload) & ~kLow;
        return static_cast<unsigned>(((solid >> 7) * 0x0102'0408'1020'4080ull) >> 56);
    }

    [[nodiscard]] LatticeHit voxelAt(std::uint32_t material, const Place& place) const {
        LatticeHit hit;
        hit.material = static_cast<std::uint8_t>(material);
        for (int a = 0; a < 3; ++a) {
            const std::uint32_t cell = (place.corner[a] ^ tree_.flip[a]) >> place.level
                                                                                << place.level;
            hit.voxel[a] = static_cast<int>(cell) - octree_.treeFromVoxel[a];
        }
        return hit;
    }

    const PacketTree& tree_;
    const OctreeView& octree_;
    Rays& rays_;
    std::uint64_t* alive_;
    PacketHits& hits_;
};

}  // namespace
}  // namespace voxprite::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
