#include "core/svo/live_octree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/svo/bake.h"
#include "core/svo/validate.h"
#include "tests/core/svo/reference_octree.h"

namespace voxprite {
namespace {

using Edit = LiveOctree::Edit;

// The live octree is safe to traverse and holds just the grid's voxels.
void expectIsBakeOf(const LiveOctree& live, const VoxelGrid& voxels) {
    const IBox bounds = voxels.bounds();
    EXPECT_EQ(live.solidBounds(), bounds);
    EXPECT_EQ(live.solidCount(), voxels.solidCount());
    const Status safe = validateOctree(live.view(bounds));
    EXPECT_TRUE(safe.has_value()) << safe.error().describe();
    EXPECT_EQ(live.canonical(bounds).value(), bake(voxels, bounds).value());
}

// What the GPU does: a copy of the arrays that learns of changes only.
class Mirror {
  public:
    void update(LiveOctree& live, const IBox& bounds) {
        const OctreeChanges changes = live.takeChanges();
        const OctreeView view = live.view(bounds);
        if (changes.everything) {
            nodes_.assign(view.nodes.begin(), view.nodes.end());
            payloads_.assign(view.payloads.begin(), view.payloads.end());
        }
        nodes_.resize(view.nodes.size());
        payloads_.resize(view.payloads.size());
        copy(changes.nodes, view.nodes, nodes_);
        copy(changes.payloads, view.payloads, payloads_);
        written_ = 0;
        for (const ArrayRange& range : changes.nodes) written_ += range.count;
    }

    [[nodiscard]] std::uint32_t nodesWritten() const { return written_; }

    // The mirror's arrays make the same octree (holes may differ).
    void expectSameAs(const LiveOctree& live, const IBox& bounds) const {
        OctreeView view = live.view(bounds);
        view.nodes = nodes_;
        view.payloads = payloads_;
        const Status safe = validateOctree(view);
        ASSERT_TRUE(safe.has_value()) << safe.error().describe();
        int wrong = 0;
        for (int x = 0; x < view.size.x; ++x) {
            for (int y = 0; y < view.size.y; ++y) {
                for (int z = 0; z < view.size.z; ++z) {
                    const glm::ivec3 v(x, y, z);
                    wrong += materialAt(view, v) != live.at(bounds.min + v);
                }
            }
        }
        EXPECT_EQ(wrong, 0);
    }

  private:
    template <class T>
    static void copy(const std::vector<ArrayRange>& ranges, std::span<const T> from,
                     std::vector<T>& to) {
        std::uint32_t end = 0;
        for (const ArrayRange& range : ranges) {
            EXPECT_TRUE(end == 0 || range.first > end) << "runs are merged and ascend";
            end = range.first + range.count;
            ASSERT_LE(end, from.size());
            std::copy_n(from.begin() + range.first, range.count, to.begin() + range.first);
        }
    }

    std::vector<std::uint32_t> nodes_;
    std::vector<std::uint64_t> payloads_;
    std::uint32_t written_ = 0;
};

TEST(LiveOctree, StartsEmpty) {
    LiveOctree live;
    EXPECT_EQ(live.solidCount(), 0u);
    EXPECT_EQ(live.at({0, 0, 0}), 0);
    EXPECT_TRUE(live.solidBounds().empty());
    EXPECT_EQ(live.canonical(IBox{}).value(), Octree{});
    EXPECT_TRUE(validateOctree(live.view(IBox{})));
    EXPECT_TRUE(live.takeChanges().everything);
    EXPECT_FALSE(live.takeChanges().any());
}

TEST(LiveOctree, RebuildTakesTheVoxelsOver) {
    std::mt19937 random(4);
    LiveOctree live;
    for (int i = 0; i < 30; ++i) {
        const VoxelGrid voxels =
            test::randomModel(random, test::randomIn(random, glm::ivec3(-90), glm::ivec3(90)), 20);
        ASSERT_TRUE(live.rebuild(voxels));
        expectIsBakeOf(live, voxels);
        const IBox around{voxels.bounds().min - 2, voxels.bounds().max + 2};
        for (int j = 0; j < 500; ++j) {
            const glm::ivec3 v = test::randomIn(random, around.min, around.max);
            EXPECT_EQ(live.at(v), voxels.get(v));
        }
    }
}

TEST(LiveOctree, RebuildThatFailsChangesNothing) {
    VoxelGrid voxels;
    voxels.set({1, 2, 3}, 4);
    LiveOctree live;
    ASSERT_TRUE(live.rebuild(voxels));
    VoxelGrid tooLong = voxels;
    tooLong.set({100000, 2, 3}, 4);
    EXPECT_FALSE(live.rebuild(tooLong));
    expectIsBakeOf(live, voxels);
}

TEST(LiveOctree, ThousandsOfEditsAndAllOfThemUndone) {
    std::mt19937 random(5);
    const auto below = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
    for (int session = 0; session < 12; ++session) {
        const glm::ivec3 centre = test::randomIn(random, glm::ivec3(-70), glm::ivec3(70));
        VoxelGrid voxels;
        if (session % 3 != 0) voxels = test::randomModel(random, centre, 18);
        const VoxelGrid start = voxels;
        LiveOctree live;
        ASSERT_TRUE(live.rebuild(voxels));
        Mirror mirror;

        std::vector<std::vector<Edit>> undo;
        for (int step = 0; step < 200; ++step) {
            // Within, across and well outside the bounds, on all sides; boxes too, to collapse.
            const int reach = step % 7 == 0 ? 40 : 10;
            std::vector<Edit> edits;
            const glm::ivec3 low = centre - reach;
            const auto material = static_cast<std::uint8_t>(below(3) == 0 ? 0 : 1 + below(3));
            if (step % 5 == 0) {
                const glm::ivec3 a = test::randomIn(random, low, centre + reach);
                const IBox box =
                    IBox::around(a, a + test::randomIn(random, glm::ivec3(-5), glm::ivec3(6)));
                for (int x = box.min.x; x < box.max.x; ++x) {
                    for (int y = box.min.y; y < box.max.y; ++y) {
                        for (int z = box.min.z; z < box.max.z; ++z) {
                            edits.push_back({{x, y, z}, material});
                        }
                    }
                }
            } else {
                for (int i = 1 + below(20); i > 0; --i) {
                    edits.push_back({test::randomIn(random, low, centre + reach),
                                     static_cast<std::uint8_t>(below(3) == 0 ? 0 : 1 + below(3))});
                }
            }
            std::vector<Edit> back;
            for (const Edit& edit : edits) {
                back.insert(back.begin(), {edit.voxel, voxels.get(edit.voxel)});
                voxels.set(edit.voxel, edit.material);
            }
            undo.push_back(std::move(back));
            ASSERT_TRUE(live.apply(edits));
            if (step % 10 == 9) {
                expectIsBakeOf(live, voxels);
                mirror.update(live, voxels.bounds());
            }
        }
        mirror.expectSameAs(live, voxels.bounds());
        for (; !undo.empty(); undo.pop_back()) ASSERT_TRUE(live.apply(undo.back()));
        expectIsBakeOf(live, start);
        mirror.update(live, start.bounds());
        mirror.expectSameAs(live, start.bounds());
    }
}

TEST(LiveOctree, CanonicalTakesAnyBounds) {
    std::mt19937 random(6);
    for (int i = 0; i < 60; ++i) {
        const VoxelGrid voxels = test::randomModel(random, {0, 0, 0}, 20);
        LiveOctree live;
        ASSERT_TRUE(live.rebuild(voxels));
        const int reach = i % 2 == 0 ? 15 : 60;
        const IBox bounds =
            IBox::around(test::randomIn(random, glm::ivec3(-reach), glm::ivec3(reach)),
                         test::randomIn(random, glm::ivec3(-reach), glm::ivec3(reach)));
        EXPECT_EQ(live.canonical(bounds).value(), bake(voxels, bounds).value());
    }
    EXPECT_FALSE(LiveOctree{}.canonical({{0, 0, 0}, {1, 65537, 1}}).has_value());
}

TEST(LiveOctree, GrowsOnEverySide) {
    LiveOctree live;
    VoxelGrid voxels;
    std::uint8_t material = 1;
    for (const int distance : {1, 7, 100, 3000, 30000}) {
        for (int side = 0; side < 6; ++side) {
            glm::ivec3 v(0);
            v[side % 3] = side < 3 ? distance : -distance;
            const Edit edit{v, material++};
            voxels.set(v, edit.material);
            ASSERT_TRUE(live.apply({&edit, 1}));
            EXPECT_EQ(live.at(v), edit.material);
        }
        expectIsBakeOf(live, voxels);
    }
}

TEST(LiveOctree, UniformRootGrows) {
    VoxelGrid voxels;
    voxels.fill({{8, 8, 8}, {16, 16, 16}}, 9);
    LiveOctree live;
    ASSERT_TRUE(live.rebuild(voxels));
    const Edit edit{{7, 16, 9}, 3};
    ASSERT_TRUE(live.apply({&edit, 1}));
    voxels.set(edit.voxel, edit.material);
    expectIsBakeOf(live, voxels);
}

TEST(LiveOctree, ErasingEverythingGivesBackTheEmptyRoot) {
    VoxelGrid voxels;
    voxels.fill({{-3, -3, -3}, {4, 4, 4}}, 9);
    voxels.set({500, 0, 0}, 1);
    LiveOctree live;
    ASSERT_TRUE(live.rebuild(voxels));
    std::vector<Edit> erase;
    voxels.forEachSolid([&](glm::ivec3 v, std::uint8_t) { erase.push_back({v, 0}); });
    ASSERT_TRUE(live.apply(erase));
    EXPECT_EQ(live.solidCount(), 0u);
    const OctreeView view = live.view(IBox{});
    EXPECT_THAT(view.nodes, testing::ElementsAre(0u));
    EXPECT_TRUE(view.payloads.empty());
    EXPECT_EQ(view.maxDepth, 1);

    const Edit again{{-70000, 3, 3}, 5};  // and it may start anywhere
    ASSERT_TRUE(live.apply({&again, 1}));
    VoxelGrid one;
    one.set(again.voxel, again.material);
    expectIsBakeOf(live, one);
}

TEST(LiveOctree, RootIsNoLargerThanNeeded) {
    VoxelGrid voxels;
    voxels.fill({{0, 0, 0}, {16, 16, 16}}, 9);
    LiveOctree live;
    ASSERT_TRUE(live.rebuild(voxels));
    const std::vector<Edit> far{{{-5000, 40, 900}, 1}};
    const std::vector<Edit> farBack{{{-5000, 40, 900}, 0}};
    ASSERT_TRUE(live.apply(far));
    EXPECT_EQ(live.view(voxels.bounds()).maxDepth, 13);
    ASSERT_TRUE(live.apply(farBack));
    EXPECT_EQ(live.view(voxels.bounds()).maxDepth, 4);
    expectIsBakeOf(live, voxels);
}

TEST(LiveOctree, StaysCollapsed) {
    // A 16-cube voxel by voxel, in a scattered order: at the end the tree is one word again.
    std::vector<Edit> edits;
    for (int i = 0; i < 4096; ++i) {
        const int n = (i * 1237) % 4096;
        edits.push_back({{n & 15, n >> 4 & 15, n >> 8}, 3});
    }
    LiveOctree live;
    for (const Edit& edit : edits) ASSERT_TRUE(live.apply({&edit, 1}));
    const IBox bounds{{0, 0, 0}, {16, 16, 16}};
    VoxelGrid voxels;
    voxels.fill(bounds, 3);
    expectIsBakeOf(live, voxels);
    EXPECT_TRUE(node::isUniform(live.view(bounds).nodes[0]));
}

TEST(LiveOctree, LastEditOfAVoxelWins) {
    LiveOctree live;
    const std::vector<Edit> edits{
        {{1, 1, 1}, 5}, {{1, 1, 1}, 0}, {{1, 1, 1}, 7}, {{2, 1, 1}, 7}, {{2, 1, 1}, 0}};
    ASSERT_TRUE(live.apply(edits));
    EXPECT_EQ(live.at({1, 1, 1}), 7);
    EXPECT_EQ(live.at({2, 1, 1}), 0);
    EXPECT_EQ(live.solidCount(), 1u);
}

TEST(LiveOctree, EditsThatChangeNothingTouchNothing) {
    VoxelGrid voxels;
    voxels.fill({{0, 0, 0}, {9, 9, 9}}, 9);
    LiveOctree live;
    ASSERT_TRUE(live.rebuild(voxels));
    EXPECT_TRUE(live.takeChanges().everything);
    const std::vector<Edit> edits{
        {{3, 3, 3}, 9}, {{8, 8, 8}, 9}, {{12, 1, 1}, 0}, {{-500, 0, 0}, 0}, {{0, 1 << 30, 0}, 0}};
    ASSERT_TRUE(live.apply(edits));
    EXPECT_FALSE(live.takeChanges().any());
    EXPECT_EQ(live.at({1 << 30, 0, -(1 << 30)}), 0);
}

TEST(LiveOctree, AnEditTouchesOnePathFromTheRoot) {
    std::mt19937 random(7);
    VoxelGrid voxels;
    for (int i = 0; i < 60000; ++i) {
        voxels.set(test::randomIn(random, glm::ivec3(0), glm::ivec3(256)), 1);
    }
    voxels.set({0, 0, 0}, 1);
    voxels.set({255, 255, 255}, 1);
    LiveOctree live;
    ASSERT_TRUE(live.rebuild(voxels));
    Mirror mirror;
    mirror.update(live, voxels.bounds());
    for (int i = 0; i < 2000; ++i) {
        const Edit edit{test::randomIn(random, glm::ivec3(0), glm::ivec3(256)),
                        static_cast<std::uint8_t>(i % 3)};
        ASSERT_TRUE(live.apply({&edit, 1}));
        mirror.update(live, voxels.bounds());
        EXPECT_LE(mirror.nodesWritten(), 8u * 16u);  // eight levels; a bridged gap may add to each
    }
}

TEST(LiveOctree, MemoryIsUsedAgain) {
    std::mt19937 random(8);
    const VoxelGrid voxels = test::randomModel(random, {0, 0, 0}, 30);
    LiveOctree live;
    ASSERT_TRUE(live.rebuild(voxels));
    std::size_t nodesAfterFirst = 0;
    for (int round = 0; round < 40; ++round) {
        std::mt19937 same(9);
        std::vector<Edit> edits;
        std::vector<Edit> back;
        for (int i = 0; i < 500; ++i) {
            const glm::ivec3 v = test::randomIn(same, glm::ivec3(-20), glm::ivec3(20));
            edits.push_back({v, static_cast<std::uint8_t>(i % 4)});
            back.push_back({v, voxels.get(v)});
        }
        ASSERT_TRUE(live.apply(edits));
        ASSERT_TRUE(live.apply(back));
        const std::size_t nodes = live.view(voxels.bounds()).nodes.size();
        if (round == 0) nodesAfterFirst = nodes;
        EXPECT_LE(nodes, 2 * nodesAfterFirst) << "round " << round;
    }
    expectIsBakeOf(live, voxels);
    EXPECT_GE(live.bytes(), live.view(voxels.bounds()).nodes.size_bytes());
}

TEST(LiveOctree, TooFarIsRefusedAndNothingApplied) {
    VoxelGrid voxels;
    voxels.set({0, 0, 0}, 1);
    voxels.set({60000, 0, 0}, 1);
    LiveOctree live;
    ASSERT_TRUE(live.rebuild(voxels));

    const std::vector<Edit> tooFar{{{1, 1, 1}, 5}, {{-5536, 0, 0}, 6}};
    const Status refused = live.apply(tooFar);
    ASSERT_FALSE(refused.has_value());
    EXPECT_THAT(refused.error().message, testing::HasSubstr("65,536"));
    expectIsBakeOf(live, voxels);

    // One voxel less is exactly 65,536: the root moves, though it grew the other way first.
    const std::vector<Edit> justFits{{{1, 1, 1}, 5}, {{-5535, 0, 0}, 6}};
    ASSERT_TRUE(live.apply(justFits));
    for (const Edit& edit : justFits) voxels.set(edit.voxel, edit.material);
    expectIsBakeOf(live, voxels);

    const std::vector<Edit> beyond{{{kMaxCoordinate + 1, 0, 0}, 5}};
    EXPECT_FALSE(live.apply(beyond));
    const std::vector<Edit> overflow{{{INT_MIN, 0, 0}, 5}, {{INT_MAX, 0, 0}, 5}};
    EXPECT_FALSE(live.apply(overflow));
    expectIsBakeOf(live, voxels);
}

TEST(LiveOctree, TooManyNodesIsRefusedAndNothingApplied) {
    const auto scattered = [](glm::ivec3 min, glm::ivec3 max) {
        std::vector<Edit> edits;  // one voxel in each brick
        for (int x = min.x; x < max.x; x += 2) {
            for (int y = min.y; y < max.y; y += 2) {
                for (int z = min.z; z < max.z; z += 2) edits.push_back({{x, y, z}, 1});
            }
        }
        return edits;
    };
    VoxelGrid voxels;
    const std::vector<Edit> start = scattered({0, 0, 0}, {64, 64, 64});
    for (const Edit& edit : start) voxels.set(edit.voxel, edit.material);
    const auto nodes = static_cast<std::uint32_t>(bake(voxels).value().nodes.size());

    LiveOctree tooSmall(nodes - 1);
    EXPECT_FALSE(tooSmall.rebuild(voxels));
    EXPECT_FALSE(tooSmall.apply(start));
    EXPECT_EQ(tooSmall.solidCount(), 0u);
    EXPECT_EQ(tooSmall.canonical(voxels.bounds()).value(),
              bake(VoxelGrid{}, voxels.bounds()).value());

    LiveOctree live(nodes + 2000);
    ASSERT_TRUE(live.rebuild(voxels));
    const Status refused = live.apply(scattered({0, 0, 64}, {64, 64, 70}));
    ASSERT_FALSE(refused.has_value());
    EXPECT_THAT(refused.error().message, testing::HasSubstr("nodes"));
    expectIsBakeOf(live, voxels);

    // Drawing and erasing what does fit goes on for ever: holes are given up when they must be.
    for (int round = 0; round < 20; ++round) {
        std::vector<Edit> edits = scattered({0, 0, 64 + 2 * round}, {64, 64, 66 + 2 * round});
        ASSERT_TRUE(live.apply(edits)) << "round " << round;
        EXPECT_EQ(live.solidCount(), voxels.solidCount() + edits.size());
        for (Edit& edit : edits) edit.material = 0;
        ASSERT_TRUE(live.apply(edits)) << "round " << round;
    }
    expectIsBakeOf(live, voxels);
}

// Levels above the root are nodes, too: a full array has no room for them.
TEST(LiveOctree, GrowingAFullTreeIsRefusedAndNothingApplied) {
    VoxelGrid voxels;
    for (int k = 0; k < 40; ++k) voxels.set({3 * k, 5 * k % 64, 7 * k % 64}, 1);
    VoxelGrid grown = voxels;
    const Edit far{{-1000, -1000, -1000}, 2};
    grown.set(far.voxel, far.material);
    const auto nodesOf = [](const VoxelGrid& grid) {
        return static_cast<std::uint32_t>(bake(grid).value().nodes.size());
    };
    std::size_t refused = 0, applied = 0;
    for (std::uint32_t limit = nodesOf(voxels); limit < nodesOf(grown) + 200; ++limit) {
        LiveOctree live(limit);
        ASSERT_TRUE(live.rebuild(voxels));
        const bool done = live.apply(std::span(&far, 1)).has_value();
        ++(done ? applied : refused);
        expectIsBakeOf(live, done ? grown : voxels);
        if (HasFailure()) FAIL() << limit << " nodes";
    }
    EXPECT_GT(refused, 5u);
    EXPECT_GT(applied, 5u);
}

// The bounds of all frames may lie anywhere; an empty frame has nothing to place in them.
TEST(LiveOctree, AnEmptyTreeFarFromTheBoundsIsStillAView) {
    LiveOctree live;
    ASSERT_TRUE(live.rebuild(VoxelGrid{}));
    const OctreeView view = live.view({{1 << 20, 0, 0}, {(1 << 20) + 8, 8, 8}});
    EXPECT_EQ(view.size, glm::ivec3(8));
    EXPECT_EQ(view.treeFromVoxel, glm::ivec3(0));
}

}  // namespace
}  // namespace voxprite
