// The GPU chooses the clusters that the processor chooses.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/lod/cluster_cut.h"
#include "render/cluster_pass.h"
#include "tests/render/gl_test.h"
#include "tests/support/random.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::must;
using test::Random;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kEndless = std::numeric_limits<double>::infinity();

struct Clusters {
    Octree octree;
    ClusterMesh mesh;
    GpuClusters gpu;

    explicit Clusters(const VoxelGrid& voxels)
        : octree(must(bake(voxels))), mesh(must(buildClusters(octree.view()))) {
        gpu.upload(mesh);
    }
    [[nodiscard]] PlacedEntity placedAt(glm::dvec3 anchorMetres, double yawDegrees,
                                        double scale) const {
        Entity entity;
        entity.positionMetres = anchorMetres;
        entity.yawDegrees = yawDegrees;
        entity.pitchDegrees = 0.3 * yawDegrees;
        entity.scale = scale;
        return placeEntity(entity, IBox{glm::ivec3(0), octree.size}, GameProfile{});
    }
};

// Does an error of the page lie so near the budget that rounding may decide?
bool isClose(const ClusterPage& page, const ClusterCutParams& params) {
    const auto near = [&](float projected) {
        return projected > 0.0f && std::isfinite(projected) &&
               std::abs(projected - params.pixelBudget) <= 1e-5f * params.pixelBudget;
    };
    return near(clusterProjectedError(page.lodError, page.lodBoundsCentre, page.lodBoundsRadius,
                                      params)) ||
           near(clusterProjectedError(page.parentError, page.parentBoundsCentre,
                                      page.parentBoundsRadius, params));
}

class ClusterCuts : public test::GlTest {
  protected:
    struct Counts {
        std::uint64_t pages = 0, chosen = 0, close = 0, wrong = 0;
        std::uint64_t mixed = 0;  // cuts of several levels
    };

    void compare(ClusterPass& pass, const std::vector<ClusterPass::Instance>& instances,
                 const std::vector<const ClusterMesh*>& meshes, const Camera& camera,
                 double budgetPx) {
        pass.choose(instances, camera, {.budgetPx = budgetPx, .leaveOutUnseen = false});
        const auto commands = pass.readCommands();
        std::size_t slot = 0;
        for (std::size_t i = 0; i < instances.size(); ++i) {
            const ClusterMesh& mesh = *meshes[i];
            const ClusterCutParams params = clusterCutParams(
                clusterView(instances[i].placed, mesh.treeFromVoxel, camera, budgetPx), mesh.reach,
                static_cast<std::uint32_t>(mesh.pages.size()));
            bool fine = false, coarse = false;
            for (std::size_t p = 0; p < mesh.pages.size(); ++p, ++slot) {
                const ClusterPage& page = mesh.pages[p];
                const bool chosen = choosesCluster(page, params);
                const bool drawn = commands[slot][1] == 1;
                ASSERT_LE(commands[slot][1], 1U);
                ++counts_.pages;
                if (isClose(page, params)) {
                    ++counts_.close;
                    continue;
                }
                counts_.chosen += chosen;
                (mesh.pageLevels[p] == 0 ? fine : coarse) |= chosen;
                // What has no triangles is not drawn, whatever the rule says of it.
                counts_.wrong += drawn != (chosen && page.indexCount > 0);
                ASSERT_EQ(commands[slot][0], page.indexCount);
                ASSERT_EQ(commands[slot][2], page.firstIndex);
                ASSERT_EQ(commands[slot][4], i);
            }
            counts_.mixed += fine && coarse;
        }
        ASSERT_EQ(slot, commands.size());
    }

    Counts counts_;
};

TEST_F(ClusterCuts, TheGpuChoosesWhatTheProcessorChooses) {
    Clusters ball(test::shellSphere(150));
    Clusters noise(test::randomVoxels(5, {70, 33, 90}, 0.05, 9));
    ClusterPass pass = must(ClusterPass::create());
    Random random(17);
    for (int view = 0; view < 3000; ++view) {
        // Two balls and the noise, turned and scaled; the eye outside, inside and at a surface,
        // from a tenth of a metre to kilometres away.
        const double scale = std::exp(6.0 * random.unit() - 3.0);
        const glm::dvec3 away(1e5 * (view % 5 == 0 ? random.unit() : 0.0), 0.0, 0.0);
        std::vector<ClusterPass::Instance> instances{
            {&ball.gpu, ball.placedAt(away, 360.0 * random.unit(), scale), {}},
            {&ball.gpu, ball.placedAt(away + glm::dvec3(20, 1, 3), 0.0, 1.0), {}},
            {&noise.gpu, noise.placedAt(away + glm::dvec3(-9, 0, 5), 50.0, 2.0), {}}};
        const PlacedEntity& target = instances[static_cast<std::size_t>(view % 3)].placed;
        Camera camera = orbitCamera(
            {360.0 * random.unit(), 180.0 * random.unit() - 90.0, 360.0 * random.unit()},
            target.centreMetres(), target.radiusMetres() * std::exp(9.0 * random.unit() - 3.0),
            1.0 + 169.0 * random.unit(), {64 + view % 2000, 1 + view % 1999});
        if (view % 7 == 3) {
            camera.orthographic = true;
            camera.orthographicHeightMetres = std::exp(12.0 * random.unit() - 6.0);
        }
        const double budget = view % 11 == 0 ? 0.0 : std::exp(8.0 * random.unit() - 4.0);
        compare(pass, instances, {&ball.mesh, &ball.mesh, &noise.mesh}, camera, budget);
        if (HasFatalFailure()) return;
    }
    EXPECT_EQ(counts_.wrong, 0U);
    EXPECT_GT(counts_.chosen, 100'000U);
    EXPECT_GT(counts_.mixed, 300U);
    EXPECT_LT(counts_.close, counts_.pages / 10'000);
}

TEST_F(ClusterCuts, WhateverTheCameraSaysTheGpuAgrees) {
    Clusters ball(test::shellSphere(70));
    ClusterPass pass = must(ClusterPass::create());
    const std::vector<ClusterPass::Instance> instances{
        {&ball.gpu, ball.placedAt({0, 0, 0}, 0.0, 1.0), {}}};
    const auto with = [](auto change) {
        Camera camera = orbitCamera({30, 20, 0}, {0, 0, 0}, 30.0, 45.0, {300, 200});
        change(camera);
        return camera;
    };
    const std::vector<Camera> cameras{with([](Camera& c) { c.eyeMetres.x = kNone; }),
                                      with([](Camera& c) { c.eyeMetres.y = kEndless; }),
                                      with([](Camera& c) { c.eyeMetres = glm::dvec3(1e30); }),
                                      with([](Camera& c) { c.eyeMetres = glm::dvec3(0.0); }),
                                      with([](Camera& c) { c.verticalFovDegrees = kNone; }),
                                      with([](Camera& c) { c.verticalFovDegrees = 0.0; }),
                                      with([](Camera& c) { c.verticalFovDegrees = 180.0; }),
                                      with([](Camera& c) { c.nearMetres = kNone; }),
                                      with([](Camera& c) { c.nearMetres = 0.0; }),
                                      with([](Camera& c) { c.nearMetres = kEndless; }),
                                      with([](Camera& c) {
                                          c.viewportPx = {0, 0};
                                      }),
                                      with([](Camera& c) { c.forward = glm::dvec3(kNone); }),
                                      with([](Camera& c) {
                                          c.orthographic = true;
                                          c.orthographicHeightMetres = kNone;
                                      }),
                                      with([](Camera& c) {
                                          c.orthographic = true;
                                          c.orthographicHeightMetres = 0.0;
                                      })};
    for (const Camera& camera : cameras) {
        for (const double budget : {0.0, 1.0, 1e30, kEndless, kNone, -1.0}) {
            compare(pass, instances, {&ball.mesh}, camera, budget);
            if (HasFatalFailure()) return;
        }
    }
    EXPECT_EQ(counts_.wrong, 0U);
    EXPECT_GT(counts_.chosen, 0U);
}

}  // namespace
}  // namespace voxprite
