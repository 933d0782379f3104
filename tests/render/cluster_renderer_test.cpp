// Clusters show what rays show: the same pixels at the finest, no cracks in any mix of levels.
#include "render/cluster_renderer.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/io/formats.h"
#include "core/model/entity_voxels.h"
#include "render/voxel_view.h"
#include "tests/render/gl_test.h"
#include "tests/support/random.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::GpuModel;
using test::must;
using test::Random;

constexpr glm::ivec2 kViewport{240, 200};
constexpr Rgba8 kBright{255, 0, 255, 255};

struct Picture {
    Image colour;
    std::vector<float> depth;
    [[nodiscard]] float depthAt(int x, int y) const {
        return depth[static_cast<std::size_t>(y * kViewport.x + x)];
    }
};

class ClusterPictures : public test::GlTest {
  protected:
    struct Model {
        GpuModel rays;
        ClusterMesh mesh;
        GpuClusters clusters;
        explicit Model(const VoxelGrid& voxels)
            : rays(voxels), mesh(must(buildClusters(rays.octree.view()))) {
            clusters.upload(mesh);
        }
        [[nodiscard]] PlacedEntity placed(double yawDegrees = 25.0) const {
            return rays.placedAt({3.0, 1.0, -2.0}, GameProfile{}, yawDegrees);
        }
    };

    void SetUp() override {
        GlTest::SetUp();
        view_ = std::make_unique<VoxelView>(must(VoxelView::create()));
        renderer_ = std::make_unique<ClusterRenderer>(must(ClusterRenderer::create()));
    }
    void TearDown() override {
        renderer_.reset();
        view_.reset();
        GlTest::TearDown();
    }

    Picture byRays(const Model& model, const PlacedEntity& placed, const Camera& camera) {
        VoxelViewOptions options;
        options.edges = false;
        options.occlusion = VoxelOcclusion::off;
        options.ground = false;
        options.spriteLight = true;
        Frame frame(kViewport);
        view_->draw(frame, model.rays.gpu, model.rays.palette, placed, camera, options);
        return {frame.readColour(), frame.readDepth()};
    }
    Picture byClusters(const Model& model, const PlacedEntity& placed, const Camera& camera,
                       double budgetPx) {
        Frame frame(kViewport);
        frame.begin(kBright);
        const ClusterInstance instance{&model.clusters, &model.rays.palette, placed};
        (void)must(
            renderer_->draw(frame, camera, GameProfile{}, {&instance, 1}, {.budgetPx = budgetPx}));
        return {frame.readColour(), frame.readDepth()};
    }
    static Camera camera(const PlacedEntity& placed, const OrbitAngles& angles, double distance) {
        return orbitCamera(angles, placed.centreMetres(), distance * placed.radiusMetres(), 45.0,
                           kViewport);
    }

    // At the finest all pixels are those of rays, but where the border between two faces runs
    // within rounding of a pixel's middle.
    void expectEqual(const Picture& rays, const Picture& clusters, double mostWrong) {
        int wrong = 0, hits = 0;
        for (std::size_t k = 0; k < rays.depth.size(); ++k) {
            const bool hit = rays.depth[k] > 0.0f;
            hits += hit;
            if (hit != (clusters.depth[k] > 0.0f)) {
                ++wrong;
            } else if (hit) {
                const bool sameDepth =
                    std::abs(clusters.depth[k] - rays.depth[k]) <= 1e-4f * rays.depth[k];
                wrong += rays.colour.pixels[k] != clusters.colour.pixels[k] || !sameDepth;
            }
        }
        EXPECT_GT(hits, 1500);
        EXPECT_LE(wrong, mostWrong * hits);
        wrong_ += wrong;
        hits_ += hits;
    }

    // What is solid for rays is so for every coarser level: nothing behind the exact surface may be
    // seen, where the pixels around see it, too.
    static int seenThrough(const Picture& rays, const Picture& clusters) {
        int cracks = 0;
        for (int y = 1; y + 1 < kViewport.y; ++y) {
            for (int x = 1; x + 1 < kViewport.x; ++x) {
                float farthest = 1.0f;
                for (int k = 0; k < 9; ++k) {
                    farthest = std::min(farthest, rays.depthAt(x - 1 + k % 3, y - 1 + k / 3));
                }
                cracks += clusters.depthAt(x, y) < farthest * (1.0f - 1e-4f);
            }
        }
        return cracks;
    }

    std::unique_ptr<VoxelView> view_;
    std::unique_ptr<ClusterRenderer> renderer_;
    std::int64_t wrong_ = 0, hits_ = 0;
};

VoxelGrid sample(const std::string& name) {
    const LoadedDocument loaded =
        must(loadDocument(std::string(VOXPRITE_SOURCE_DIR) + "/samples/" + name));
    return flatten(loaded.document, 0);
}

// A room to stand in, with pillars and a step on each wall.
VoxelGrid room() {
    VoxelGrid voxels;
    voxels.fill(IBox{{0, 0, 0}, {90, 70, 50}}, 3);
    voxels.fill(IBox{{2, 2, 2}, {88, 68, 48}}, 0);
    for (int k = 0; k < 7; ++k) {
        const auto material = static_cast<std::uint8_t>(10 + k);
        voxels.fill(IBox{{11 * k + 5, 20 + 5 * k, 2}, {11 * k + 8, 24 + 5 * k, 40 - k}}, material);
    }
    return voxels;
}

TEST_F(ClusterPictures, TheFinestAreThePixelsThatRaysSee) {
    Model letters(test::asymmetric());
    Model knight(sample("knight.vox"));
    Model inside(room());
    Model ball(test::shellSphere(64));
    for (const Model* model : {&letters, &knight, &ball}) {
        const PlacedEntity placed = model->placed();
        for (const OrbitAngles& angles :
             {OrbitAngles{35, 25, 0}, OrbitAngles{200, -40, 10}, OrbitAngles{-70, 8, 0}}) {
            for (const double distance : {1.6, 3.0}) {
                const Camera eye = camera(placed, angles, distance);
                expectEqual(byRays(*model, placed, eye), byClusters(*model, placed, eye, 0.0),
                            0.01);
            }
        }
        Camera parallel = camera(placed, {20, 30, 0}, 3.0);
        parallel.orthographic = true;
        parallel.orthographicHeightMetres = 2.4 * placed.radiusMetres();
        expectEqual(byRays(*model, placed, parallel), byClusters(*model, placed, parallel, 0.0),
                    0.01);
    }
    const PlacedEntity placed = inside.placed(0.0);
    for (const OrbitAngles& angles : {OrbitAngles{15, 10, 0}, OrbitAngles{190, -30, 20}}) {
        const Camera eye = camera(placed, angles, 0.3);
        expectEqual(byRays(inside, placed, eye), byClusters(inside, placed, eye, 0.0), 0.01);
    }
    EXPECT_LT(wrong_, 2e-3 * static_cast<double>(hits_));
}

// Edges, shade, shadow and marks are where rays have them.
TEST_F(ClusterPictures, TheVoxelViewLosesNothing) {
    Model knight(sample("knight.vox"));
    Model inside(room());
    const GpuModel marked(test::solidBox({9, 9, 12}, 3));
    const Rgba8 tint{255, 160, 40, 110};
    for (const Model* model : {&knight, &inside}) {
        const PlacedEntity placed = model->placed(0.0);
        // A part of the model's own box, so that marks lie on its surface, before and behind it.
        PlacedEntity part = placed;
        part.modelSize = marked.octree.size;
        for (const OrbitAngles& angles : {OrbitAngles{35, 25, 0}, OrbitAngles{-70, 50, 0}}) {
            const Camera eye = camera(placed, angles, model == &knight ? 1.5 : 0.3);
            const auto draw = [&](const GpuClusters* clusters) {
                VoxelViewOptions options;
                options.shadow = true;
                options.clusters = clusters;
                options.clusterBudgetPx = 0.0;
                Frame frame(kViewport);
                view_->draw(frame, model->rays.gpu, model->rays.palette, placed, eye, options);
                view_->drawMarked(frame, marked.gpu, part, eye, tint, 1.0f);
                return frame.readColour();
            };
            const Image rays = draw(nullptr);
            const Image clusters = draw(&model->clusters);
            int wrong = 0;
            for (std::size_t k = 0; k < rays.pixels.size(); ++k) {
                const glm::ivec3 off =
                    glm::abs(glm::ivec3(rays.pixels[k]) - glm::ivec3(clusters.pixels[k]));
                wrong += std::max({off.x, off.y, off.z}) > 3;
            }
            EXPECT_LE(wrong, kViewport.x * kViewport.y / 250);
        }
    }
}

TEST_F(ClusterPictures, NoMixOfLevelsHasCracks) {
    Model knight(sample("knight.vox"));
    Model cottage(sample("cottage.vox"));
    Model inside(room());
    Model solid(test::solidBox({130, 90, 70}, 5));
    Model ball(test::shellSphere(100));
    Model noise(test::randomVoxels(9, {60, 60, 60}, 0.4, 200));
    Random random(4);
    int mixed = 0, cracks = 0;
    for (int turn = 0; turn < 6; ++turn) {
        for (const Model* model : {&knight, &cottage, &inside, &solid, &ball, &noise}) {
            const PlacedEntity placed = model->placed(360.0 * random.unit());
            const double distance =
                model == &inside ? 0.4 * random.unit() : 0.8 + 3.0 * random.unit();
            const Camera eye = camera(
                placed, {360.0 * random.unit(), 160.0 * random.unit() - 80.0, 90.0 * random.unit()},
                distance);
            const Picture exact = byRays(*model, placed, eye);
            const double budget = turn % 3 == 0 ? 0.0 : std::exp(4.0 * random.unit() - 1.0);
            const Picture coarse = byClusters(*model, placed, eye, budget);
            mixed += coarse.depth != exact.depth;
            cracks += seenThrough(exact, coarse);
        }
    }
    EXPECT_EQ(cracks, 0);
    EXPECT_GT(mixed, 15);
}

}  // namespace
}  // namespace voxprite
