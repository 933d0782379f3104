// The cache of snapshots: lazy, bounded, and forgetting what edits change and nothing else.
#include "core/billboard/snapshot_cache.h"

#include <array>
#include <limits>

#include "core/svo/live_octree.h"
#include "tests/core/billboard/snapshot_support.h"
#include "tests/support/random.h"

namespace voxprite::test {
namespace {

SnapshotCache cacheOf(const SnapshotCacheOptions& options = {},
                      const GameProfile& profile = GameProfile{}, ViewSet views = ViewSet()) {
    return must(SnapshotCache::create(std::move(views), lightOf(profile), options));
}

void show(SnapshotCache& cache, int view, const OctreeView& octree, double sigma = 1.0) {
    EXPECT_TRUE(cache.at(view, octree, sigma));
}

IBox oneVoxel(glm::ivec3 v) {
    return {v, v + 1};
}

TEST(SnapshotCache, BuildsAllTwentySixInOrder) {
    const Octree octree = must(bake(solidBox({16, 16, 16})));
    SnapshotCache cache = cacheOf({.sizePx = 32});
    EXPECT_TRUE(cache.build(octree.view()));
    EXPECT_EQ(cache.held(), 26);
    for (int view = 0; view < 26; ++view) {
        const auto snapshot = must(cache.at(view, octree.view()));
        EXPECT_EQ(snapshot->view, view);
        EXPECT_EQ(snapshot->buffer.size, glm::ivec2(32));
        EXPECT_EQ(snapshot->depth.size(), 32u * 32u);
        EXPECT_GT(snapshot->buffer.opaqueCount(), 0u) << view;
    }
    EXPECT_EQ(cache.cast(), 26u);
    EXPECT_EQ(cacheOf().options().sizePx, 128);
}

TEST(SnapshotCache, CastsAViewWhenItIsFirstAskedForAndNeverAgain) {
    const Octree octree = must(bake(figure()));
    SnapshotCache cache = cacheOf({.sizePx = 24});
    EXPECT_EQ(cache.held(), 0);
    EXPECT_EQ(cache.bytes(), 0u);
    const auto first = must(cache.at(7, octree.view()));
    EXPECT_EQ(cache.held(), 1);
    EXPECT_EQ(must(cache.at(7, octree.view())), first);
    EXPECT_EQ(cache.cast(), 1u);
    EXPECT_TRUE(
        same(*first, castSnapshot(octree.view(), lightOf(GameProfile{}), ViewSet(), 7, 24)));
    show(cache, 8, octree.view());
    EXPECT_EQ(cache.cast(), 2u);
    EXPECT_EQ(cache.bytes(), 2 * first->bytes());
    EXPECT_GE(first->bytes(), 24u * 24u * 12u);
}

TEST(SnapshotCache, RemembersThatAnEmptyModelShowsNothing) {
    const Octree empty;
    SnapshotCache cache = cacheOf({.sizePx = 16});
    EXPECT_TRUE(cache.build(empty.view()));
    EXPECT_TRUE(cache.build(empty.view()));
    EXPECT_EQ(cache.cast(), 26u);
    for (int view = 0; view < 26; ++view) {
        const auto snapshot = must(cache.at(view, empty.view()));
        EXPECT_EQ(snapshot->buffer.opaqueCount(), 0u);
        for (const float depth : snapshot->depth)
            EXPECT_EQ(depth, std::numeric_limits<float>::infinity());
    }
}

TEST(SnapshotCache, ForgetsTheOldestBeyondItsBound) {
    const Octree octree = must(bake(figure()));
    const std::size_t each =
        castSnapshot(octree.view(), lightOf(GameProfile{}), ViewSet(), 0, 32).bytes();
    SnapshotCache cache = cacheOf({.sizePx = 32, .mostBytes = 3 * each + each / 2});
    for (const int view : {0, 1, 2}) show(cache, view, octree.view());
    const auto zero = must(cache.at(0, octree.view()));  // used again: 1 is the oldest now
    show(cache, 3, octree.view());
    EXPECT_EQ(cache.held(), 3);
    EXPECT_LE(cache.bytes(), cache.options().mostBytes);
    const std::uint64_t before = cache.cast();
    show(cache, 0, octree.view());
    show(cache, 2, octree.view());
    show(cache, 3, octree.view());
    EXPECT_EQ(cache.cast(), before);
    show(cache, 1, octree.view());
    EXPECT_EQ(cache.cast(), before + 1);
    // What was handed out outlives the cache's memory of it.
    for (int view = 4; view < 26; ++view) show(cache, view, octree.view());
    EXPECT_EQ(zero->view, 0);
    EXPECT_GT(zero->buffer.opaqueCount(), 0u);
    // The newest stays, however small the bound.
    SnapshotCache tiny = cacheOf({.sizePx = 32, .mostBytes = 1});
    show(tiny, 5, octree.view());
    EXPECT_EQ(tiny.held(), 1);
    show(tiny, 6, octree.view());
    EXPECT_EQ(tiny.held(), 1);
}

TEST(SnapshotCache, NearestHeldIsTheNearestAmongThoseThatAre) {
    const Octree octree = must(bake(figure()));
    SnapshotCache cache = cacheOf({.sizePx = 16});
    EXPECT_EQ(cache.nearestHeld({1, 0, 0}), nullptr);  // an empty cache has none
    show(cache, 5, octree.view());
    show(cache, 2, octree.view());
    EXPECT_EQ(cache.nearestHeld({0, 1, 0.2})->view, 2);
    EXPECT_EQ(cache.nearestHeld({0, 0, -3})->view, 5);
    EXPECT_EQ(cache.nearestHeld({1, 0, 0})->view, 2);  // a tie: the first in order
    EXPECT_EQ(cache.nearestHeld(glm::dvec3(0.0)), nullptr);
    EXPECT_EQ(cache.nearestHeld({std::numeric_limits<double>::quiet_NaN(), 0, 0}), nullptr);
    EXPECT_TRUE(cache.build(octree.view()));
    EXPECT_EQ(cache.nearestHeld({1, 0, 0})->view, 0);
    EXPECT_EQ(cache.nearestHeld({0, 0, -1})->view, 5);
    EXPECT_EQ(cache.nearestHeld({1, 1, 1})->view, 25);
}

TEST(SnapshotCache, OtherColoursForgetEverything) {
    const Octree octree = must(bake(figure()));
    SnapshotCache cache = cacheOf({.sizePx = 16});
    EXPECT_TRUE(cache.build(octree.view()));
    cache.setLight(lightOf(GameProfile{}));
    EXPECT_EQ(cache.held(), 26);
    GameProfile darker;
    darker.light.ambient = 0.2;
    cache.setLight(lightOf(darker));
    EXPECT_EQ(cache.held(), 0);
    EXPECT_EQ(cache.bytes(), 0u);
    EXPECT_TRUE(same(*must(cache.at(3, octree.view())),
                     castSnapshot(octree.view(), lightOf(darker), ViewSet(), 3, 16)));
}

TEST(SnapshotCache, AnotherSizeOrRootForgetsEverything) {
    const Octree small = must(bake(solidBox({5, 5, 5})));
    const Octree large = must(bake(solidBox({9, 5, 5})));
    SnapshotCache cache = cacheOf({.sizePx = 16});
    EXPECT_TRUE(cache.build(small.view()));
    const auto report = cache.edited(large.view(), std::array{IBox{{5, 0, 0}, {9, 5, 5}}});
    EXPECT_EQ(report.forgotten, 26);
    EXPECT_EQ(cache.held(), 0);
}

TEST(SnapshotCache, SizesOutOfRangeAreRefused) {
    for (const int size : {0, -1, kMostSnapshotPx + 1}) {
        const auto cache =
            SnapshotCache::create(ViewSet(), lightOf(GameProfile{}), {.sizePx = size});
        EXPECT_FALSE(cache) << size;
    }
}

// An octree that is edited voxel by voxel, with a box of bounds that stays.
struct Edited {
    glm::ivec3 size;
    VoxelGrid voxels;
    Octree octree;

    explicit Edited(VoxelGrid grid, glm::ivec3 bounds)
        : size(bounds), voxels(std::move(grid)), octree(baked(voxels, size)) {}
    void set(glm::ivec3 voxel, std::uint8_t material) {
        voxels.set(voxel, material);
        octree = baked(voxels, size);
    }
};

TEST(SnapshotEdits, WhatNobodySeesChangesNothing) {
    for (const SnapshotKind kind : {SnapshotKind::seed, SnapshotKind::sprite}) {
        Edited model(solidBox({12, 12, 12}), {12, 12, 12});
        SnapshotCache cache = cacheOf({.kind = kind, .sizePx = 48});
        ASSERT_TRUE(cache.build(model.octree.view(), 2.0));
        model.set({6, 5, 4}, 77);  // inside: painted
        auto report = cache.edited(model.octree.view(), std::array{oneVoxel({6, 5, 4})});
        EXPECT_EQ(report.kept, 26);
        EXPECT_EQ(report.forgotten, 0);
        EXPECT_GT(report.rays, 0u);
        model.set({6, 5, 4}, 0);  // and dug out
        report = cache.edited(model.octree.view(), std::array{oneVoxel({6, 5, 4})});
        EXPECT_EQ(report.kept, 26);
        // Nothing at all.
        EXPECT_EQ(cache.edited(model.octree.view(), {}).kept, 26);
        EXPECT_EQ(cache.edited(model.octree.view(), std::array{IBox{}}).rays, 0u);
    }
}

TEST(SnapshotEdits, OnlyViewsOfThatSideForgetWhatIsPaintedOnIt) {
    for (const SnapshotKind kind : {SnapshotKind::seed, SnapshotKind::sprite}) {
        Edited model(solidBox({12, 12, 12}), {12, 12, 12});
        SnapshotCache cache = cacheOf({.kind = kind, .sizePx = 64});
        ASSERT_TRUE(cache.build(model.octree.view(), 4.0));
        model.set({11, 5, 6}, 77);  // in the middle of the face toward +x
        const auto report = cache.edited(model.octree.view(), std::array{oneVoxel({11, 5, 6})});
        int facing = 0;
        for (int view = 0; view < 26; ++view)
            facing += cache.views().direction(view).x > 0.1 ? 1 : 0;
        EXPECT_EQ(facing, 9);
        EXPECT_EQ(report.forgotten, facing);
        EXPECT_EQ(report.kept, 26 - facing);
        const std::uint64_t before = cache.cast();
        for (int view = 0; view < 26; ++view) {
            const std::uint64_t casts = cache.cast();
            show(cache, view, model.octree.view(), 4.0);
            EXPECT_EQ(cache.cast() > casts, cache.views().direction(view).x > 0.1) << view;
        }
        EXPECT_EQ(cache.cast(), before + 9);
    }
}

// After random edits what is kept equals what a fresh cast gives, and what is forgotten does not.
void editAtRandom(const SnapshotCacheOptions& options, const GameProfile& profile,
                  std::uint64_t seed, double sigma) {
    Random random(seed);
    const glm::ivec3 size{13, 9, 11};
    Edited model(randomVoxels(seed, size, 0.6, 3), size);
    SnapshotCache cache = cacheOf(options, profile);
    const SnapshotLight light = lightOf(profile);
    const auto fresh = [&](int view) {
        return options.kind == SnapshotKind::seed
                   ? castSnapshot(model.octree.view(), light, cache.views(), view, options.sizePx)
                   : must(castSpriteSnapshot(model.octree.view(), light, cache.views(), view,
                                             sigma));
    };
    int kept = 0;
    int forgotten = 0;
    for (int round = 0; round < 6; ++round) {
        ASSERT_TRUE(cache.build(model.octree.view(), sigma));
        std::vector<std::shared_ptr<const Snapshot>> before;
        for (int view = 0; view < 26; ++view)
            before.push_back(must(cache.at(view, model.octree.view(), sigma)));
        std::vector<IBox> boxes;
        const int edits = random.between(1, 3);
        for (int n = 0; n < edits; ++n) {
            const glm::ivec3 at{random.between(0, size.x - 1), random.between(0, size.y - 1),
                                random.between(0, size.z - 1)};
            model.set(at, static_cast<std::uint8_t>(random.between(0, 3)));
            boxes.push_back(oneVoxel(at));
        }
        const auto report = cache.edited(model.octree.view(), boxes);
        kept += report.kept;
        forgotten += report.forgotten;
        const std::uint64_t casts = cache.cast();
        for (int view = 0; view < 26; ++view) {
            const Snapshot now = fresh(view);
            const std::uint64_t castsBefore = cache.cast();
            EXPECT_TRUE(same(*must(cache.at(view, model.octree.view(), sigma)), now)) << view;
            EXPECT_EQ(cache.cast() == castsBefore,
                      same(*before[static_cast<std::size_t>(view)], now));
        }
        EXPECT_EQ(cache.cast() - casts, static_cast<std::uint64_t>(report.forgotten));
    }
    EXPECT_GT(kept, 5);
    EXPECT_GT(forgotten, 5);
}

TEST(SnapshotEdits, KeepExactlyWhatStaysTheSameInPerspective) {
    editAtRandom({.sizePx = 28}, GameProfile{}, 1, 1.0);
    editAtRandom({.sizePx = 7}, GameProfile{}, 2, 1.0);
}

TEST(SnapshotEdits, KeepExactlyWhatStaysTheSameOfSprites) {
    editAtRandom({.kind = SnapshotKind::sprite}, GameProfile{}, 3, 2.0);
    editAtRandom({.kind = SnapshotKind::sprite}, GameProfile{}, 4, 0.5);
}

TEST(SnapshotEdits, KnowThatFacesAskWhatStandsAroundThem) {
    GameProfile profile;
    profile.light.occlusion = 1.0;
    editAtRandom({.sizePx = 28}, profile, 5, 1.0);
    editAtRandom({.kind = SnapshotKind::sprite}, profile, 6, 2.0);
    profile.light.occlusion = 0.0;
    profile.light.shadow = 1.0;
    editAtRandom({.sizePx = 28}, profile, 7, 1.0);
    editAtRandom({.kind = SnapshotKind::sprite}, profile, 8, 2.0);
}

TEST(SnapshotEdits, OfALiveOctreeToo) {
    LiveOctree live;
    const VoxelGrid start = figure();
    ASSERT_TRUE(live.rebuild(start));
    const IBox bounds = live.solidBounds();
    SnapshotCache cache = cacheOf({.sizePx = 40});
    Random random(9);
    for (int round = 0; round < 8; ++round) {
        ASSERT_TRUE(cache.build(live.view(bounds)));
        const glm::ivec3 size = bounds.size();
        const glm::ivec3 at{random.between(0, size.x - 1), random.between(0, size.y - 1),
                            random.between(0, size.z - 1)};
        const LiveOctree::Edit edit{bounds.min + at,
                                    static_cast<std::uint8_t>(random.between(0, 4))};
        ASSERT_TRUE(live.apply({&edit, 1}));
        cache.edited(live.view(bounds), std::array{oneVoxel(at)});
        for (int view = 0; view < 26; ++view)
            EXPECT_TRUE(
                same(*must(cache.at(view, live.view(bounds))),
                     castSnapshot(live.view(bounds), lightOf(GameProfile{}), ViewSet(), view, 40)));
    }
}

}  // namespace
}  // namespace voxprite::test
