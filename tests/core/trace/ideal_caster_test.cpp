#include "core/trace/ideal_caster.h"

#include <gtest/gtest.h>

#include "tests/core/trace/dense_model.h"
#include "tests/core/trace/exact_caster.h"
#include "tests/core/trace/views.h"

namespace voxprite::test {
namespace {

TEST(IdealCaster, KnownAnswers) {
    DenseModel model("three", {4, 4, 4});
    model[{1, 0, 2}] = 3;
    model[{1, 3, 2}] = 4;
    model[{2, 2, 2}] = 5;
    const NaiveOctree tree(model);
    const auto cast = [&](glm::dvec3 forward, glm::ivec2 pixel) {
        return describe(castIdeal(tree.view(), viewAlong(forward, 1), pixel));
    };
    // Pixel (i, j) at sigma 1 looks through the middle of a voxel, counted from the centre corner.
    EXPECT_EQ(cast({0, 1, 0}, {-1, 0}), "material 3 at 1,0,2 through axis 1");
    EXPECT_EQ(cast({0, 1, 0}, {0, 0}), "material 5 at 2,2,2 through axis 1");
    EXPECT_EQ(cast({0, 1, 0}, {1, 0}), "nothing");
    EXPECT_EQ(cast({0, 1, 0}, {0, 9}), "nothing");
    // From behind right is toward -x.
    EXPECT_EQ(cast({0, -1, 0}, {0, 0}), "material 4 at 1,3,2 through axis 1");
    EXPECT_EQ(cast({0, -1, 0}, {-1, 0}), "material 5 at 2,2,2 through axis 1");
    // From above up is toward +y; from the left right is toward -y.
    EXPECT_EQ(cast({0, 0, -1}, {0, 0}), "material 5 at 2,2,2 through axis 2");
    EXPECT_EQ(cast({0, 0, -1}, {-1, 1}), "material 4 at 1,3,2 through axis 2");
    EXPECT_EQ(cast({1, 0, 0}, {1, 0}), "material 3 at 1,0,2 through axis 0");
    EXPECT_EQ(cast({1, 0, 0}, {-1, 0}), "material 5 at 2,2,2 through axis 0");
}

// The walk against sampling the line densely: the first solid sample's voxel is the hit, unless the
// line only grazes it between two samples.
TEST(IdealCaster, AgreesWithDenseSampling) {
    const DenseModel model = randomVoxels({10, 12, 9}, 0.03, 1);
    const NaiveOctree tree(model);
    std::mt19937 random(2);
    int hits = 0;
    int differences = 0;
    for (int n = 0; n < 1500; ++n) {
        const OrthoView view = randomView(random, 2);
        std::uniform_int_distribution<int> pixel(-14, 14);
        const glm::ivec2 at{pixel(random), pixel(random)};
        const glm::dvec2 px = (glm::dvec2(at) + 0.5) / 2.0;
        const glm::dvec3 start = glm::dvec3(model.size / 2) + px.x * view.right + px.y * view.up;
        std::uint8_t seen = 0;
        for (int step = -12000; step < 12000 && seen == 0; ++step)
            seen = model.at(glm::ivec3(glm::floor(start + view.forward * (step * 0.001))));
        const std::uint8_t found = castIdeal(tree.view(), view, at).material;
        hits += seen != 0;
        differences += seen != found;
    }
    EXPECT_GT(hits, 200);
    EXPECT_LE(differences, 3);
}

// How far the integer lattice is off: in percent of the model's pixels.
struct Difference {
    double silhouettePercent = 0.0;
    double voxelPercent = 0.0;
};

Difference measure(const NaiveOctree& tree, double sigma, int views, int pixelsAView,
                   unsigned seed) {
    std::mt19937 random(seed);
    int opaque = 0;
    int silhouette = 0;
    int voxels = 0;
    for (int n = 0; n < views; ++n) {
        const OrthoView view = randomView(random, sigma);
        const Result<LatticeView> lattice = quantiseView(view, tree.octree.size);
        EXPECT_TRUE(lattice.has_value());
        const LatticeCaster caster(tree.view(), *lattice);
        std::uniform_int_distribution<int> column(0, lattice->size.x - 1);
        std::uniform_int_distribution<int> row(0, lattice->size.y - 1);
        for (int k = 0; k < pixelsAView; ++k) {
            const glm::ivec2 pixel = lattice->first + glm::ivec2(column(random), row(random));
            const LatticeHit exact = caster.cast(pixel);
            const LatticeHit ideal = castIdeal(tree.view(), view, pixel);
            opaque += ideal.material != 0;
            if ((exact.material == 0) != (ideal.material == 0)) {
                ++silhouette;
            } else if (ideal.material != 0 && exact.voxel != ideal.voxel) {
                ++voxels;
            }
        }
    }
    return {100.0 * silhouette / opaque, 100.0 * voxels / opaque};
}

void expectWithin(const DenseModel& model, std::initializer_list<double> sigmas,
                  double silhouettePercent, double voxelPercent) {
    const NaiveOctree tree(model);
    for (const double sigma : sigmas) {
        const Difference difference = measure(tree, sigma, 25, 2000, 9);
        EXPECT_LE(difference.silhouettePercent, silhouettePercent) << model.name << " " << sigma;
        EXPECT_LE(difference.voxelPercent, voxelPercent) << model.name << " " << sigma;
    }
}

TEST(LatticeAccuracy, SmallModelsAreWithinAFiftiethOfAPercent) {
    expectWithin(figure(2), {0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 7.5, 16.0}, 0.02, 0.2);
    expectWithin(shell(32), {0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 7.5, 16.0}, 0.02, 0.2);
}

TEST(LatticeAccuracy, NoiseIsWithinAFifthOfAPercent) {
    expectWithin(randomVoxels({64, 64, 64}, 0.03, 3), {1.0, 4.0, 16.0}, 0.2, 0.5);
}

TEST(LatticeAccuracy, LargeModelsAreWithinAPercent) {
    expectWithin(shell(128), {1.0, 4.0}, 0.02, 0.5);
    expectWithin(shell(256), {0.5, 4.0, 9.0}, 0.02, 1.0);
}

}  // namespace
}  // namespace voxprite::test
