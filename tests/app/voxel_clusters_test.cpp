// The edit view's mesh is that of the voxels that are shown, or it is not drawn; and it is drawn
// where frames showed it to be the faster.
#include "app/editor/views/voxel_clusters.h"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <thread>

#include "core/edit/make_action.h"
#include "core/edit/patches.h"
#include "core/io/formats.h"
#include "render/gl/context.h"
#include "tests/support/must.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/voxels.h"

namespace voxprite::editor {
namespace {

using enum DrawingWay;

TEST(DrawingTimes, BothWaysAreTriedThenTheFasterIsKept) {
    DrawingTimes times;
    EXPECT_EQ(times.faster(100.0, 1000), rays);
    times.took(rays, 100.0, 900.0);  // the first pays for what drivers put off
    for (const double ms : {10.0, 12.0}) {
        EXPECT_EQ(times.faster(100.0, 1000), rays);
        times.took(rays, 100.0, ms);
    }
    EXPECT_EQ(times.faster(100.0, 1000), clusters);
    times.took(clusters, 100.0, 900.0);
    for (const double ms : {5.0, 40.0}) {
        EXPECT_EQ(times.faster(100.0, 1000), clusters);
        times.took(clusters, 100.0, ms);
    }
    EXPECT_EQ(times.faster(100.0, 1000), clusters);
    // Other sizes are another matter.
    EXPECT_EQ(times.faster(400.0, 1000), rays);
    times.took(rays, 400.0, 3.0);
    times.took(rays, 400.0, 3.0);
    times.took(clusters, 400.0, 4.0);
    times.took(clusters, 400.0, 4.0);
    EXPECT_EQ(times.faster(400.0, 1000), rays);
    EXPECT_EQ(times.faster(100.0, 1000), clusters);
    // So many triangles are not even tried: on a slow machine the window would stall.
    times.took(rays, 900.0, 20.0);
    times.took(rays, 900.0, 20.0);
    EXPECT_EQ(times.faster(900.0, 60'000), clusters);
    EXPECT_EQ(times.faster(900.0, 80'000), rays);
    times.forget();
    EXPECT_EQ(times.faster(100.0, 1000), rays);
}

TEST(DrawingTimes, NoSizeIsTooStrange) {
    DrawingTimes times;
    for (const double px : {0.0, -1.0, 1e300, std::numeric_limits<double>::infinity(),
                            std::numeric_limits<double>::quiet_NaN()}) {
        times.took(clusters, px, 1.0);
        EXPECT_EQ(times.faster(px, 10), rays);
    }
}

class VoxelClustersOf : public testing::Test {
  protected:
    void SetUp() override {
        const VoxelGrid voxels = test::shellSphere(100);
        ASSERT_TRUE(saveDocument(folder_ / "ball.voxprite", test::documentOf(voxels), {}));
        ASSERT_TRUE(session_.open(folder_ / "ball.voxprite"));
        upload();
    }
    void upload() { octree_.upload(session_.shownOctree().view(session_.shownBounds())); }
    // Until the mesh that is wanted is there; nothing to wait for counts as such.
    void settle(DrawBy drawBy) {
        for (int k = 0; k < 20'000; ++k) {
            clusters_.follow(session_, drawBy);
            if (!clusters_.pending()) return;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        FAIL() << "no mesh came";
    }
    [[nodiscard]] bool drawn(DrawBy drawBy) const {
        return clusters_.toDraw(session_, octree_, drawBy, 100.0) != nullptr;
    }

    test::TemporaryFolder folder_;
    gl::HeadlessContext context_ = test::must(gl::HeadlessContext::create());
    Session session_;
    GpuOctree octree_;
    VoxelClusters clusters_;
};

TEST_F(VoxelClustersOf, ARightMeshOrNone) {
    clusters_.follow(session_, DrawBy::clusters);
    EXPECT_TRUE(clusters_.pending());
    EXPECT_FALSE(drawn(DrawBy::clusters));
    settle(DrawBy::clusters);
    EXPECT_TRUE(drawn(DrawBy::clusters));
    EXPECT_FALSE(drawn(DrawBy::rays));

    // An edit that is coming, then made, then undone: rays until the mesh is there again.
    const std::array at{glm::ivec3(50, 50, 50)};
    const VoxelPatch patch = patchVoxels(session_.document(), 0, at, EditMode::attach, 3);
    ASSERT_TRUE(session_.preview({patch}));
    EXPECT_FALSE(drawn(DrawBy::clusters));
    session_.clearPreview();
    upload();
    EXPECT_TRUE(drawn(DrawBy::clusters));
    const std::uint64_t before =
        clusters_.toDraw(session_, octree_, DrawBy::clusters, 1.0)->revision();
    ASSERT_TRUE(session_.perform(makeAction("Attach", patch)));
    upload();
    EXPECT_FALSE(drawn(DrawBy::clusters));
    settle(DrawBy::clusters);
    ASSERT_TRUE(drawn(DrawBy::clusters));
    EXPECT_NE(clusters_.toDraw(session_, octree_, DrawBy::clusters, 1.0)->revision(), before);
    ASSERT_TRUE(session_.undo());
    upload();
    EXPECT_FALSE(drawn(DrawBy::clusters));
}

TEST_F(VoxelClustersOf, AutomaticDrawsByRaysUntilClustersAreKnownToBeFaster) {
    settle(DrawBy::automatic);
    EXPECT_FALSE(drawn(DrawBy::automatic));
    EXPECT_TRUE(drawn(DrawBy::clusters));
    settle(DrawBy::rays);
    EXPECT_FALSE(clusters_.pending());
}

}  // namespace
}  // namespace voxprite::editor
