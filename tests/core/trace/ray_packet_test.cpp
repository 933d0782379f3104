// Packets of eye rays give what the scalar caster gives, for every SIMD target that the machine
// has.
#include "core/trace/ray_packet.h"

#include <gtest/gtest.h>

#include <memory>

#include "tests/core/trace/dense_model.h"
#include "tests/core/trace/simd_targets.h"
#include "tests/core/trace/views.h"

namespace voxprite::test {
namespace {

// Rays through pixels from one eye, along view.forward; lengths differ when asked to.
std::vector<Ray> picture(glm::dvec3 eye, const OrthoView& view, double focalPx, glm::ivec2 size,
                         bool unit) {
    std::vector<Ray> rays;
    for (int j = 0; j < size.y; ++j)
        for (int i = 0; i < size.x; ++i) {
            const glm::dvec3 direction = view.forward * focalPx +
                                         view.right * (i - (size.x - 1) / 2.0) +
                                         view.up * (j - (size.y - 1) / 2.0);
            rays.push_back({eye, unit ? glm::normalize(direction) : direction});
        }
    return rays;
}

class RayPackets : public testing::Test {
  protected:
    ~RayPackets() override { useAllSimdTargets(); }

    void expectScalar(const OctreeView& octree, const std::vector<Ray>& rays, glm::ivec2 size,
                      int maxDepth, const std::string& what) {
        expectScalar(octree, rays, size, maxDepth, what,
                     [&] { return castRayPacket(octree, rays, size, maxDepth, *hits_); });
    }

    void expectScalar(const OctreeView& octree, const EyePicture& picture, glm::ivec2 corner,
                      glm::ivec2 size, int maxDepth, const std::string& what) {
        std::vector<Ray> rays;
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) rays.push_back(picture.ray(corner + glm::ivec2(i, j)));
        expectScalar(octree, rays, size, maxDepth, what, [&] {
            return castRayPacket(octree, picture, corner, size, maxDepth, *hits_);
        });
    }

    template <class Cast>
    void expectScalar(const OctreeView& octree, const std::vector<Ray>& rays, glm::ivec2 size,
                      int maxDepth, const std::string& what, const Cast& cast) {
        std::vector<LatticeHit> want;
        for (const Ray& ray : rays)
            want.push_back(castQuantised(octree, quantiseRay(octree, ray, maxDepth)));
        for (const std::int64_t target : targets_) {
            useSimdTarget(target);
            together_ += cast() ? 1 : 0;
            std::size_t at = 0;
            for (int j = 0; j < size.y; ++j)
                for (int i = 0; i < size.x; ++i, ++at) {
                    const LatticeHit got = hits_->at(i, j);
                    solid_ += want[at].material != 0 ? 1 : 0;
                    inside_ += want[at].material != 0 && want[at].faceAxis == kInsideAxis ? 1 : 0;
                    ASSERT_TRUE(got.material == want[at].material &&
                                (got.material == 0 || (got.voxel == want[at].voxel &&
                                                       got.faceAxis == want[at].faceAxis)))
                        << what << ", pixel " << i << " " << j << ": material " << int{got.material}
                        << " at " << got.voxel.x << "," << got.voxel.y << "," << got.voxel.z
                        << " axis " << int{got.faceAxis} << ", not " << int{want[at].material}
                        << " at " << want[at].voxel.x << "," << want[at].voxel.y << ","
                        << want[at].voxel.z << " axis " << int{want[at].faceAxis};
                    ASSERT_EQ(hits_->rows[static_cast<std::size_t>(j)] >> i & 1,
                              want[at].material != 0 ? 1u : 0u);
                }
        }
    }

    const std::vector<std::int64_t> targets_ = simdTargets();
    std::unique_ptr<RayPacketHits> hits_ = std::make_unique<RayPacketHits>();
    std::size_t together_ = 0, solid_ = 0, inside_ = 0;
};

std::vector<DenseModel> models() {
    std::vector<DenseModel> models{solid({1, 1, 1}, 7), solid({16, 16, 16}, 200), shell(40),
                                   figure(1)};
    models.push_back(randomVoxels({1, 1, 37}, 0.4, 1));
    models.push_back(randomVoxels({33, 21, 2}, 0.3, 2));
    models.push_back(randomVoxels({30, 30, 30}, 0.02, 3));
    return models;
}

TEST_F(RayPackets, FromOutsideNearAndFar) {
    std::mt19937 random(1);
    std::size_t pictures = 0;
    for (const DenseModel& model : models()) {
        const NaiveOctree tree(model);
        const glm::dvec3 middle = glm::dvec3(model.size) / 2.0;
        const double radius = glm::length(middle);
        for (int n = 0; n < 12; ++n) {
            const OrthoView view = randomView(random, 1);
            const double away = radius * (n % 3 == 0 ? 1.05 : n % 3 == 1 ? 2.7 : 40.0);
            const glm::ivec2 size = n % 2 == 0 ? glm::ivec2(64) : glm::ivec2(37, 19);
            const double focalPx = 40.0 * away / radius;
            ++pictures;
            expectScalar(tree.view(),
                         picture(middle - view.forward * away, view, focalPx, size, n % 4 < 2),
                         size, kMaxOctreeDepth, model.name + " " + std::to_string(n));
            if (HasFatalFailure()) return;
        }
    }
    EXPECT_EQ(together_, pictures * targets_.size());
    EXPECT_GT(solid_, 50'000u);
}

// Rays run through faces, edges and corners of the grid, and some along an axis.
TEST_F(RayPackets, AlongAxesAndDiagonals) {
    const DenseModel model = randomVoxels({16, 16, 16}, 0.1, 4);
    const NaiveOctree tree(model);
    for (const glm::dvec3& forward : canonicalDirections())
        for (const glm::ivec2 size : {glm::ivec2(33, 33), glm::ivec2(32, 32)}) {
            const OrthoView view = viewAlong(forward, 1);
            expectScalar(tree.view(),
                         picture(glm::dvec3(8) - forward * 24.0, view, 64, size, false), size,
                         kMaxOctreeDepth, "special");
            if (HasFatalFailure()) return;
        }
    EXPECT_EQ(together_, 52 * targets_.size());
}

TEST_F(RayPackets, FromInside) {
    std::mt19937 random(2);
    for (const DenseModel& model :
         {randomVoxels({24, 24, 24}, 0.03, 5), solid({8, 8, 8}, 3), shell(32)}) {
        const NaiveOctree tree(model);
        for (int n = 0; n < 12; ++n) {
            // In the middle of a cell, on its corner, and anywhere.
            std::uniform_real_distribution<double> inBox(0.0, model.size.x);
            glm::dvec3 eye(inBox(random), inBox(random), inBox(random));
            if (n % 3 == 0) eye = glm::floor(eye);
            if (n % 3 == 1) eye = glm::floor(eye) + 0.5;
            const OrthoView view = n < 6 ? randomView(random, 1) : viewAlong({1, n - 8, 0}, 1);
            const glm::ivec2 size(50, 41);
            expectScalar(tree.view(), picture(eye, view, 30, size, true), size, kMaxOctreeDepth,
                         "inside " + model.name);
            if (HasFatalFailure()) return;
        }
    }
    EXPECT_GT(inside_, 1000u);
    EXPECT_GT(solid_, inside_ + 10'000);
}

// A ray's numbers may say that it does not run along an axis at all, though it does, downward: in
// the face where it starts that is another voxel.
TEST_F(RayPackets, FromAFaceInsideAlmostAlongIt) {
    const NaiveOctree tree(solid({2, 2, 2}, 9));
    for (const double sideways : {-2.2e-16, -1e-9, 0.0, 1e-9}) {
        for (const glm::dvec3 eye : {glm::dvec3(1, 1, 1.5623), glm::dvec3(1, 0.3, 0.7)}) {
            std::vector<Ray> rays;
            for (int j = 0; j < 4; ++j)
                for (int i = 0; i < 4; ++i)
                    rays.push_back({eye, {sideways + i * 0.01, j * 0.01, -1.0}});
            expectScalar(tree.view(), rays, {4, 4}, kMaxOctreeDepth, "almost along a face");
            const EyePicture picture{eye, {sideways, 0, -1}, {0.01, 0, 0}, {0, 0.01, 0}};
            expectScalar(tree.view(), picture, {0, 0}, {4, 4}, kMaxOctreeDepth, "of a picture");
            if (HasFatalFailure()) return;
        }
    }
}

TEST_F(RayPackets, CutTreesAndLiveOctrees) {
    std::mt19937 random(3);
    const DenseModel model = randomVoxels({20, 12, 17}, 0.1, 6);
    for (const auto& [depth, offset] :
         {std::pair{5, glm::ivec3(0)}, std::pair{7, glm::ivec3(40, 9, 77)},
          std::pair{4, glm::ivec3(-2, -5, 3)}}) {
        const NaiveOctree live(model, depth, offset);
        for (const int maxDepth : {kMaxOctreeDepth, depth - 1, depth - 2, 1, 0}) {
            const OrthoView view = randomView(random, 1);
            const glm::dvec3 eye = glm::dvec3(model.size) / 2.0 - view.forward * 40.0;
            const glm::ivec2 size(48, 64);
            expectScalar(live.view(), picture(eye, view, 60, size, true), size, maxDepth,
                         "depth " + std::to_string(maxDepth));
            if (HasFatalFailure()) return;
        }
    }
    EXPECT_GT(together_, 10u);
}

// Pixel (0, 0) is the picture's middle.
EyePicture eyePicture(glm::dvec3 eye, const OrthoView& view, double focalPx) {
    return {eye, view.forward * focalPx, view.right, view.up};
}

TEST_F(RayPackets, OfAnEyesPicture) {
    std::mt19937 random(5);
    std::size_t pictures = 0;
    for (const DenseModel& model : models()) {
        const NaiveOctree tree(model);
        const glm::dvec3 middle = glm::dvec3(model.size) / 2.0;
        const double radius = glm::length(middle);
        for (std::size_t n = 0; n < 8; ++n) {
            const OrthoView view =
                n % 2 == 0 ? randomView(random, 1) : viewAlong(canonicalDirections()[n], 1);
            // From within, near and far.
            const double away = radius * (n % 4 == 0   ? 0.3
                                          : n % 4 == 1 ? 1.05
                                          : n % 4 == 2 ? 2.7
                                                       : 40.0);
            EyePicture seen = eyePicture(middle - view.forward * away, view, 40.0 * away / radius);
            if (n % 3 == 0) seen.perRow += seen.perColumn * 0.4;  // pixels are no squares
            const glm::ivec2 size = n % 5 == 0 ? glm::ivec2(37, 19) : glm::ivec2(64);
            for (const glm::ivec2 corner : {-size / 2, glm::ivec2(0), glm::ivec2(-70, 10)}) {
                ++pictures;
                expectScalar(tree.view(), seen, corner, size, kMaxOctreeDepth,
                             model.name + " " + std::to_string(n));
                if (HasFatalFailure()) return;
            }
        }
    }
    EXPECT_EQ(together_, pictures * targets_.size());
    EXPECT_GT(solid_, 50'000u);
    EXPECT_GT(inside_, 1000u);
}

TEST_F(RayPackets, OfAnEyesPictureInCutTrees) {
    std::mt19937 random(6);
    const DenseModel model = randomVoxels({20, 12, 17}, 0.1, 6);
    const NaiveOctree live(model, 7, glm::ivec3(40, 9, 77));
    for (const int maxDepth : {kMaxOctreeDepth, 6, 5, 1, 0}) {
        const OrthoView view = randomView(random, 1);
        const glm::dvec3 eye = glm::dvec3(model.size) / 2.0 - view.forward * 40.0;
        expectScalar(live.view(), eyePicture(eye, view, 60), {-24, -32}, {48, 64}, maxDepth,
                     "depth " + std::to_string(maxDepth));
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(together_, 3u);
}

// What is no picture, or too skewed a one to be told from none, is cast ray by ray.
TEST_F(RayPackets, OfWhatIsNoPicture) {
    std::mt19937 random(7);
    const DenseModel model = randomVoxels({20, 20, 20}, 0.1, 7);
    const NaiveOctree tree(model);
    const OrthoView view = randomView(random, 1);
    const EyePicture fine = eyePicture(glm::dvec3(10) - view.forward * 30.0, view, 30);
    EyePicture flat = fine, still = fine, broken = fine, skewed = fine;
    flat.perRow = flat.perColumn;
    still.perColumn = glm::dvec3(0.0);
    broken.first.x = std::numeric_limits<double>::infinity();
    skewed.perRow = skewed.perColumn + view.up * 1e-13;
    for (const EyePicture& none : {flat, still, broken, skewed}) {
        expectScalar(tree.view(), none, {-16, -16}, {32, 32}, kMaxOctreeDepth, "no picture");
        if (HasFatalFailure()) return;
    }
    EXPECT_EQ(together_, 0u);
}

// Rays that are no picture are cast one by one: the same hits.
TEST_F(RayPackets, AnyRays) {
    std::mt19937 random(4);
    const DenseModel model = randomVoxels({20, 20, 20}, 0.1, 7);
    const NaiveOctree tree(model);
    const glm::ivec2 size(20, 10);
    const OrthoView view = randomView(random, 1);
    const glm::dvec3 eye = glm::dvec3(10) - view.forward * 30.0;
    const std::vector<Ray> fine = picture(eye, view, 30, size, true);
    std::vector<Ray> bent = fine, apart = fine, broken = fine, parallel = fine;
    bent[57].direction += view.right * 0.01;
    apart[3].origin.x += 1e-9;
    broken[9].direction.y = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t k = 0; k < parallel.size(); ++k) {
        parallel[k].origin += fine[k].direction;
        parallel[k].direction = view.forward;
    }
    for (const std::vector<Ray>* rays : {&bent, &apart, &broken, &parallel}) {
        expectScalar(tree.view(), *rays, size, kMaxOctreeDepth, "no picture");
        if (HasFatalFailure()) return;
    }
    EXPECT_EQ(together_, 0u);
    expectScalar(tree.view(), std::vector<Ray>(1, fine[0]), {1, 1}, kMaxOctreeDepth, "one");
    EXPECT_TRUE(castRayPacket(Octree{}.view(), fine, size, kMaxOctreeDepth, *hits_));
    EXPECT_EQ(hits_->at(3, 3).material, 0);
}

}  // namespace
}  // namespace voxprite::test
