// Every sample, from 200 random views and all axis, diagonal and isometric ones: the CPU and both
// ways on the GPU give the same sprite buffer.
//
// Run as part of the suite, each view meets the next of the six sigmas. With
// VOXPRITE_SWEEP=full in the environment every view meets every sigma (`./dev sweep`: about a
// quarter of an hour on two cores).
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "core/io/formats.h"
#include "core/model/entity_voxels.h"
#include "render/scene_renderer.h"
#include "tests/render/gl_test.h"
#include "tests/render/views.h"

namespace voxprite {
namespace {

using test::must;

const std::vector<double> kSigmas{1.0, 2.0, 3.0, 4.0, 7.5, 16.0};

class SampleSweep : public test::GlTest, public testing::WithParamInterface<const char*> {};

TEST_P(SampleSweep, AllWaysGiveTheSameSpriteBuffer) {
    const std::filesystem::path path =
        std::filesystem::path(VOXPRITE_SOURCE_DIR) / "samples" / GetParam();
    const Document document = must(loadDocument(path)).document;
    const Octree octree = must(bake(flatten(document, 0)));
    GpuOctree gpu;
    gpu.upload(octree.view());
    SceneRenderer renderer = must(SceneRenderer::create());
    const LitPalette lit = litPalette(document.palette, {255, 190, 120}, Outline{});

    const char* sweep = std::getenv("VOXPRITE_SWEEP");
    const bool full = sweep != nullptr && std::string_view(sweep) == "full";
    const std::vector<OrbitAngles> views = test::allKindsOfViews(200, 2026);
    std::uint64_t opaque = 0;
    std::size_t next = 0;
    for (const OrbitAngles& angles : views) {
        for (std::size_t k = 0; k < (full ? kSigmas.size() : 1); ++k) {
            const double sigma = kSigmas[next++ % kSigmas.size()];
            const LatticeView lattice =
                must(quantiseView(test::orthoView(angles, sigma), octree.size));
            const SpriteBuffer cpu = castSprite(octree.view(), lattice, lit);
            opaque += cpu.opaqueCount();
            for (const SpriteMode mode : {SpriteMode::spriteBuffer, SpriteMode::singlePass}) {
                const SpriteBuffer gl = must(renderer.castBuffer(gpu, lattice, lit, mode));
                ASSERT_EQ(gl.sha256(), cpu.sha256())
                    << GetParam() << " at yaw " << angles.yawDegrees << ", pitch "
                    << angles.pitchDegrees << ", roll " << angles.rollDegrees << ", sigma " << sigma
                    << ", mode " << static_cast<int>(mode);
                ASSERT_EQ(gl.idsSha256(), cpu.idsSha256());
            }
        }
    }
    EXPECT_GT(opaque, 0U);
}

INSTANTIATE_TEST_SUITE_P(Samples, SampleSweep,
                         testing::Values("knight.vox", "oak.vox", "cottage.vox", "truck.vox",
                                         "letters.vox"));

}  // namespace
}  // namespace voxprite
