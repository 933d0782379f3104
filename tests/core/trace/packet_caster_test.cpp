// Packets of rays give what the scalar caster gives, for every SIMD target that the machine has.
#include "core/trace/packet_caster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "tests/core/trace/dense_model.h"
#include "tests/core/trace/simd_targets.h"
#include "tests/core/trace/views.h"

namespace voxprite::test {
namespace {

class Packets : public testing::Test {
  protected:
    ~Packets() override { useAllSimdTargets(); }

    // Every pixel of the lattice, in packets whose edges differ.
    void expectScalar(const OctreeView& octree, const LatticeView& lattice,
                      const std::string& what) {
        const LatticeCaster scalar(octree, lattice);
        const PacketCaster packets(octree, lattice);
        fast_ += packets.fast() ? 1 : 0;
        std::vector<LatticeHit> want;
        for (int j = 0; j < lattice.size.y; ++j)
            for (int i = 0; i < lattice.size.x; ++i)
                want.push_back(scalar.cast(lattice.first + glm::ivec2(i, j)));
        for (const std::int64_t target : targets_) {
            useSimdTarget(target);
            const glm::ivec2 edge{64, 64 - static_cast<int>(packets_++ % 50)};
            for (int j = 0; j < lattice.size.y; j += edge.y)
                for (int i = 0; i < lattice.size.x; i += edge.x) {
                    const glm::ivec2 at{i, j};
                    const glm::ivec2 size = glm::min(edge, lattice.size - at);
                    packets.cast(lattice.first + at, size, *hits_);
                    compare(want, lattice.size.x, at, size, what);
                    if (HasFatalFailure()) return;
                }
        }
    }

    void compare(const std::vector<LatticeHit>& want, int width, glm::ivec2 at, glm::ivec2 size,
                 const std::string& what) {
        for (int row = 0; row < size.y; ++row)
            for (int column = 0; column < size.x; ++column) {
                const LatticeHit& hit =
                    want[static_cast<std::size_t>(at.y + row) * static_cast<std::size_t>(width) +
                         static_cast<std::size_t>(at.x + column)];
                const LatticeHit got = hits_->at(column, row);
                const std::uint64_t bits = hits_->rows[static_cast<std::size_t>(row)];
                ASSERT_EQ(bits >> column & 1, hit.material != 0 ? 1u : 0u) << what;
                solid_ += hit.material != 0 ? 1 : 0;
                ASSERT_TRUE(
                    got.material == hit.material &&
                    (hit.material == 0 || (got.voxel == hit.voxel && got.faceAxis == hit.faceAxis)))
                    << what << ", pixel " << at.x + column << " " << at.y + row << ": material "
                    << int{got.material} << " at " << got.voxel.x << "," << got.voxel.y << ","
                    << got.voxel.z << " axis " << int{got.faceAxis} << ", not " << int{hit.material}
                    << " at " << hit.voxel.x << "," << hit.voxel.y << "," << hit.voxel.z << " axis "
                    << int{hit.faceAxis};
            }
    }

    const std::vector<std::int64_t> targets_ = simdTargets();
    std::unique_ptr<PacketHits> hits_ = std::make_unique<PacketHits>();
    unsigned packets_ = 0;
    int fast_ = 0;  // lattices that packets were made for
    std::size_t solid_ = 0;
};

std::vector<DenseModel> models() {
    std::vector<DenseModel> models{solid({1, 1, 1}, 7), solid({16, 16, 16}, 200),
                                   solid({5, 3, 6}, 9), shell(24), figure(1)};
    models.push_back(randomVoxels({1, 1, 37}, 0.4, 1));
    models.push_back(randomVoxels({33, 1, 2}, 0.3, 2));
    models.push_back(randomVoxels({17, 21, 15}, 0.01, 3));
    models.push_back(randomVoxels({12, 12, 12}, 0.4, 4));
    return models;
}

TEST_F(Packets, OrdinaryAndSpecialViewsAtEverySigma) {
    std::mt19937 random(1);
    for (const DenseModel& model : models()) {
        const NaiveOctree tree(model);
        const int edge = std::max({model.size.x, model.size.y, model.size.z});
        for (const double sigma : {1.0 / 64, 0.3, 0.5, 1.0, 1.5, 2.0, 5.0, 16.0}) {
            if (edge * sigma > 70) continue;
            std::vector<OrthoView> views{viewAlong({0, 1, 0}, sigma), viewAlong({1, -1, 0}, sigma),
                                         viewAlong({-1, 1, 1}, sigma)};
            for (int n = 0; n < 2; ++n) views.push_back(randomView(random, sigma));
            for (const OrthoView& view : views) {
                expectScalar(tree.view(), quantiseView(view, model.size).value(), model.name);
                if (HasFatalFailure()) return;
            }
        }
    }
    EXPECT_GT(solid_, 100'000u);
}

TEST_F(Packets, All26CanonicalViews) {
    const DenseModel model = randomVoxels({20, 20, 20}, 0.05, 5);
    const NaiveOctree tree(model);
    int lattices = 0;
    for (const double sigma : {1.0, 4.0})
        for (const glm::dvec3& direction : canonicalDirections()) {
            ++lattices;
            expectScalar(tree.view(), quantiseView(viewAlong(direction, sigma), model.size).value(),
                         model.name);
            if (HasFatalFailure()) return;
        }
    EXPECT_EQ(fast_, lattices);
}

TEST_F(Packets, VoxelsOfManyPixels) {
    std::mt19937 random(2);
    for (const glm::ivec3 size : {glm::ivec3(1), glm::ivec3(2, 1, 3)}) {
        const NaiveOctree tree(randomVoxels(size, 0.8, 6));
        for (int n = 0; n < 3; ++n) {
            const OrthoView view = n == 0 ? viewAlong({1, 1, -1}, 64) : randomView(random, 64);
            expectScalar(tree.view(), quantiseView(view, size).value(), "large voxels");
            if (HasFatalFailure()) return;
        }
    }
}

// Starts and directions of few bits: faces, edges and corners are met all the time. Skewed and
// mirrored lattices too, and such as the packets leave to the scalar caster.
TEST_F(Packets, TiesAndSkewedLattices) {
    std::mt19937 random(3);
    const DenseModel model = randomVoxels({9, 7, 8}, 0.15, 7);
    const NaiveOctree tree(model);
    int lattices = 0;
    for (int n = 0; n < 600; ++n) {
        const bool special = n % 3 != 0;
        std::uniform_int_distribution<int> component(-3, 3), step(-4, 4), any(-300'000, 300'000);
        LatticeView lattice;
        lattice.positionBits = 1 + n % 6;
        const int half = 1 << (lattice.positionBits - 1);
        for (int a = 0; a < 3; ++a) {
            lattice.C[a] = component(random) * half + 4 * half;
            lattice.D[a] = special ? component(random) : any(random) / 40;
            lattice.U[a] = special ? step(random) * half << kStepShift : any(random);
            lattice.V[a] = special ? step(random) * half << kStepShift : any(random);
        }
        const Result<PixelBounds> bounds = pixelBounds(lattice, model.size);
        if (!bounds || bounds->size.x > 400 || bounds->size.y > 400) continue;
        lattice.first = bounds->first;
        lattice.size = bounds->size;
        ++lattices;
        expectScalar(tree.view(), lattice, "lattice " + std::to_string(n));
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(lattices, 200);
    EXPECT_GT(fast_, 150);
    EXPECT_GT(solid_, 20'000u);
}

// Live octrees stand anywhere in their root, hold what the bounds leave out, and lack what the
// bounds promise; uniform leaves reach over the bounds.
TEST_F(Packets, LiveOctrees) {
    std::mt19937 random(4);
    const DenseModel noise = randomVoxels({12, 12, 12}, 0.2, 8);
    for (const auto& [depth, offset] :
         {std::pair{7, glm::ivec3(40, 9, 77)}, std::pair{3, glm::ivec3(-2, -5, 3)},
          std::pair{3, glm::ivec3(-9, 2, 20)}, std::pair{4, glm::ivec3(0, 3, 1)}}) {
        const NaiveOctree live(noise, depth, offset);
        for (const double sigma : {0.7, 3.0}) {
            const OrthoView view = randomView(random, sigma);
            expectScalar(live.view(), quantiseView(view, noise.size).value(), "live");
            if (HasFatalFailure()) return;
        }
    }
    for (const DenseModel& model : {randomVoxels({16, 16, 16}, 0.3, 9), solid({16, 16, 16}, 3)}) {
        const NaiveOctree whole(model);
        OctreeView cut = whole.view();
        cut.size = {6, 5, 9};
        cut.treeFromVoxel = {3, 7, 2};
        for (int n = 0; n < 8; ++n) {
            const OrthoView view =
                n == 0 ? viewAlong({0, 0, -1}, 2) : randomView(random, 0.5 * (n + 1));
            expectScalar(cut, quantiseView(view, cut.size).value(), "cut " + model.name);
            if (HasFatalFailure()) return;
        }
    }
}

// One solid voxel every 64 along a line of 65,536: long, thin, and at the walk's limits.
TEST_F(Packets, TheLongestModel) {
    for (int axis = 0; axis < 3; ++axis) {
        Octree octree;
        octree.size = glm::ivec3(1);
        octree.size[axis] = 1 << 16;
        octree.maxDepth = 16;
        octree.nodes.clear();
        const std::uint32_t both = 1u | 1u << (1 << axis);
        // Breadth first: level by level twice as many, until nodes of edge 64 have one child each.
        for (int level = 16; level > 6; --level) {
            const std::size_t count = std::size_t{1} << (16 - level);
            const auto next = static_cast<std::uint32_t>(octree.nodes.size() + count);
            for (std::uint32_t k = 0; k < count; ++k)
                octree.nodes.push_back(node::internal(next + 2 * k, both));
        }
        const std::size_t count = std::size_t{1} << 10;
        for (int level = 6; level > 1; --level) {
            const auto next = static_cast<std::uint32_t>(octree.nodes.size() + count);
            for (std::uint32_t k = 0; k < count; ++k)
                octree.nodes.push_back(node::internal(next + k, 1));
        }
        for (std::uint32_t k = 0; k < count; ++k) octree.nodes.push_back(node::brick(k));
        for (std::uint64_t k = 0; k < count; ++k) octree.payloads.push_back(1 + k % 255);
        glm::dvec3 aside(1, 2, -1.5);
        aside[axis] = 0.3;
        glm::dvec3 nearlyAlong(0.01, 0.02, 0.015);
        nearlyAlong[axis] = -1;
        for (const glm::dvec3& forward : {aside, nearlyAlong}) {
            const Result<LatticeView> lattice =
                quantiseView(viewAlong(forward, 1.0 / 64), octree.size);
            ASSERT_TRUE(lattice) << lattice.error().message;
            // All of it is a million pixels; its middle and an end.
            const LatticeView whole = *lattice;
            for (const glm::ivec2 part : {whole.first + whole.size / 2 - 40, whole.first}) {
                LatticeView cut = whole;
                cut.first = glm::max(part, whole.first);
                cut.size = glm::min(glm::ivec2(80), whole.first + whole.size - cut.first);
                expectScalar(octree.view(), cut, "long");
                if (HasFatalFailure()) return;
            }
        }
    }
    EXPECT_EQ(fast_, 12);
    EXPECT_GT(solid_, 100u);
}

TEST_F(Packets, EmptyModelsAndRectangles) {
    const LatticeView lattice = quantiseView(viewAlong({1, 2, 3}, 1), {4, 4, 4}).value();
    const PacketCaster packets(Octree{}.view(), lattice);
    packets.cast(lattice.first, {3, 2}, *hits_);
    EXPECT_EQ(hits_->at(2, 1).material, 0);
    packets.cast(lattice.first, {0, 2}, *hits_);
}

}  // namespace
}  // namespace voxprite::test
