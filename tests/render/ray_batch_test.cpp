// The shaders' exact walk against the processor's, ray by ray, bit for bit.
#include "render/ray_batch.h"

#include <array>

#include "core/svo/live_octree.h"
#include "tests/core/trace/raycast_rays.h"
#include "tests/render/gl_test.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::GpuModel;
using test::must;
using test::Rays;

class RayBatches : public test::GlTest {
  protected:
    // As many rays at each depth: common ones, through corners and edges, grazing ones.
    static void expectEqual(const VoxelGrid& voxels, unsigned seed, int raysADepth) {
        const Octree octree = must(bake(voxels));
        expectEqualIn(octree.view(), seed, raysADepth);
    }
    static void expectEqualIn(const OctreeView& octree, unsigned seed, int raysADepth) {
        GpuOctree gpu;
        gpu.upload(octree);
        Rays rays(seed);
        std::vector<Ray> cast;
        std::vector<QuantisedRay> quantised;
        for (int depth = 0; depth <= octree.maxDepth; ++depth) {
            for (int n = 0; n < raysADepth; ++n) {
                cast.push_back(n % 3 == 0   ? rays.common(octree.size, n % 2 == 0 ? 1.5 : 500.0)
                               : n % 3 == 1 ? rays.special(octree.size)
                                            : rays.grazing(octree.size));
                quantised.push_back(quantiseRay(octree, cast.back(), depth));
            }
        }
        RayBatch batch = must(RayBatch::create());
        batch.upload(quantised);
        batch.cast(gpu);
        const std::vector<LatticeHit> hits = batch.readHits();
        ASSERT_EQ(hits.size(), quantised.size());
        int met = 0;
        int insides = 0;
        for (std::size_t k = 0; k < hits.size(); ++k) {
            const LatticeHit want = castQuantised(octree, quantised[k]);
            ASSERT_EQ(hits[k].material, want.material) << test::describe(cast[k]);
            if (want.material == 0) continue;
            ++met;
            insides += want.faceAxis == kInsideAxis ? 1 : 0;
            ASSERT_EQ(hits[k].voxel, want.voxel) << test::describe(cast[k]);
            ASSERT_EQ(hits[k].faceAxis, want.faceAxis) << test::describe(cast[k]);
        }
        EXPECT_GT(met, static_cast<int>(hits.size()) / 20);
        EXPECT_GT(insides, 0);
    }
};

TEST_F(RayBatches, EqualTheProcessorOnEveryRayAndDepth) {
    expectEqual(test::solidBox({1, 1, 1}, 7), 1, 2000);
    expectEqual(test::solidBox({5, 3, 6}, 9), 2, 2000);
    expectEqual(test::randomVoxels(3, {16, 16, 16}, 0.05, 255), 3, 4000);
    expectEqual(test::randomVoxels(4, {40, 9, 65}, 0.01, 255), 4, 4000);
    expectEqual(test::shellSphere(96), 5, 3000);
}

// The root of the live octree lies elsewhere, and is larger.
TEST_F(RayBatches, EqualTheProcessorInALiveOctree) {
    LiveOctree live;
    const VoxelGrid voxels = test::randomVoxels(5, {13, 9, 11}, 0.1, 255);
    ASSERT_TRUE(live.rebuild(voxels));
    // Voxels drawn outside the root and erased again leave it elsewhere.
    const std::array<LiveOctree::Edit, 1> outside{{{{-20, -3, 30}, 1}}};
    ASSERT_TRUE(live.apply(outside));
    expectEqualIn(live.view({{-20, -3, 0}, {13, 9, 31}}), 6, 2000);
}

TEST_F(RayBatches, NoRaysAndNoVoxels) {
    RayBatch batch = must(RayBatch::create());
    GpuOctree gpu;
    gpu.upload(Octree{}.view());
    batch.upload({});
    batch.cast(gpu);
    EXPECT_TRUE(batch.readHits().empty());
    const QuantisedRay none = quantiseRay(Octree{}.view(), {{-1, 0, 0}, {1, 0, 0}}, 16);
    batch.upload(std::span(&none, 1));
    batch.cast(gpu);
    ASSERT_EQ(batch.readHits().size(), 1u);
    EXPECT_EQ(batch.readHits()[0].material, 0);
}

}  // namespace
}  // namespace voxprite
