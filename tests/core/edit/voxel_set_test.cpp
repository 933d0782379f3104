#include "core/edit/voxel_set.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/positions.h"
#include "tests/support/random.h"

namespace voxprite {
namespace {

using test::forEachVoxel;
using test::Random;

// One flag a voxel.
class Flags {
  public:
    static constexpr IBox kDomain{{-16, -16, -16}, {80, 80, 80}};

    [[nodiscard]] bool at(glm::ivec3 v) const { return flags_[index(v)]; }
    void set(glm::ivec3 v, bool value) { flags_[index(v)] = value; }
    template <class Choose>
    void combine(const Flags& other, const Choose& choose) {
        for (std::size_t i = 0; i < flags_.size(); ++i) {
            flags_[i] = choose(flags_[i], other.flags_[i]);
        }
    }

  private:
    static std::size_t index(glm::ivec3 v) {
        const glm::ivec3 size = kDomain.size();
        const glm::ivec3 w = v - kDomain.min;
        return static_cast<std::size_t>((w.x * size.y + w.y) * size.z + w.z);
    }
    std::vector<bool> flags_ = std::vector<bool>(96 * 96 * 96, false);
};

void expectSame(const VoxelSet& set, const Flags& flags) {
    std::uint64_t count = 0;
    IBox bounds;
    forEachVoxel(Flags::kDomain, [&](glm::ivec3 v) {
        ASSERT_EQ(set.contains(v), flags.at(v)) << v.x << " " << v.y << " " << v.z;
        if (!flags.at(v)) return;
        ++count;
        bounds = bounds.united({v, v + 1});
    });
    EXPECT_EQ(set.count(), count);
    EXPECT_EQ(set.bounds(), bounds);
    EXPECT_EQ(set.empty(), count == 0);
}

// Single voxels, rows, leaves and blocks of 64: every form that a grid has.
struct Pair {
    VoxelSet set;
    Flags flags;

    void insert(const IBox& box) {
        set.insert(box);
        forEachVoxel(box, [&](glm::ivec3 v) { flags.set(v, true); });
    }
    void addSomething(Random& random) {
        switch (random.between(0, 3)) {
            case 0:
                for (int i = 0; i < 200; ++i) {
                    const glm::ivec3 v = random.voxel(-16, 79);
                    set.insert(v);
                    flags.set(v, true);
                }
                break;
            case 1:
                insert({{0, 0, 0}, {64, 64, 64}});
                break;
            case 2: {
                const glm::ivec3 corner = random.voxel(-2, 8) * 8;
                insert({corner, corner + 8});
                break;
            }
            default:
                insert(IBox::around(random.voxel(-16, 79), random.voxel(-16, 79)));
        }
    }
};

TEST(VoxelSet, CombinesAsSetsDo) {
    Random random(71);
    for (int round = 0; round < 9; ++round) {
        Pair a;
        Pair b;
        for (int i = 0; i < 3; ++i) {
            a.addSomething(random);
            b.addSomething(random);
        }
        if (round % 3 == 0) {
            a.set.unite(b.set);
            a.flags.combine(b.flags, [](bool x, bool y) { return x || y; });
        } else if (round % 3 == 1) {
            a.set.subtract(b.set);
            a.flags.combine(b.flags, [](bool x, bool y) { return x && !y; });
        } else {
            a.set.intersect(b.set);
            a.flags.combine(b.flags, [](bool x, bool y) { return x && y; });
        }
        expectSame(a.set, a.flags);
        expectSame(b.set, b.flags);  // untouched
        if (HasFatalFailure()) return;
    }
}

TEST(VoxelSet, CombinesWithItself) {
    VoxelSet set(IBox{{-3, -3, -3}, {70, 9, 9}});
    const VoxelSet before = set;
    set.unite(set);
    EXPECT_EQ(set, before);
    set.intersect(set);
    EXPECT_EQ(set, before);
    set.subtract(set);
    EXPECT_TRUE(set.empty());
}

TEST(VoxelSet, EndsWhereCoordinatesEnd) {
    const int last = kMaxCoordinate;
    VoxelSet set(IBox{{last - 1, last - 1, last - 1}, {last + 5, last + 5, last + 5}});
    EXPECT_EQ(set.count(), 8u);
    set.insert(glm::ivec3(last + 1, 0, 0));
    set.insert(glm::ivec3(-last - 1, 0, 0));
    EXPECT_EQ(set.count(), 8u);
    std::vector<std::uint8_t> full(512, 1);
    set.insertBlock(glm::ivec3(last), full.data());
    EXPECT_EQ(set.count(), 8u);
}

TEST(VoxelSet, ASolidCubeOf512CostsNextToNothing) {
    const VoxelSet set(IBox{{0, 0, 0}, {512, 512, 512}});
    EXPECT_EQ(set.count(), 512u * 512u * 512u);
    EXPECT_LT(set.grid().bytes(), 100'000u);
}

}  // namespace
}  // namespace voxprite
