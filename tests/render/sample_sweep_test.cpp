// Every sample, from 200 random views and all axis, diagonal and isometric ones: the CPU and both
// ways on the GPU give the same sprite buffer.
//
// Run as part of the suite, each view meets the next of the six sigmas and the next frame (and the
// largest sample, whose sprites have millions of pixels, only some of the views). With
// VOXPRITE_SWEEP=full in the environment every view meets every sigma (`./dev sweep`: long). One
// view in nineteen has occlusion and shadows.
#include <array>
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

constexpr std::size_t kShadedEvery = 19;  // meets all sigmas in turn
constexpr double kShadedSigma = 2.0;      // at most, as part of the suite

struct Sample {
    const char* file;
    std::size_t every = 1;  // of the views, as part of the suite
};
void PrintTo(const Sample& sample, std::ostream* out) {
    *out << sample.file;
}

struct CastFrame {
    Octree octree;
    GpuOctree gpu;
};

class SampleSweep : public test::GlTest, public testing::WithParamInterface<Sample> {};

TEST_P(SampleSweep, AllWaysGiveTheSameSpriteBuffer) {
    const Sample& sample = GetParam();
    const std::filesystem::path path =
        std::filesystem::path(VOXPRITE_SOURCE_DIR) / "samples" / sample.file;
    const Document document = must(loadDocument(path)).document;
    std::vector<CastFrame> frames(static_cast<std::size_t>(frameCount(document)));
    for (std::size_t f = 0; f < frames.size(); ++f) {
        frames[f].octree = must(bake(flatten(document, static_cast<int>(f))));
        frames[f].gpu.upload(frames[f].octree.view());
    }
    SceneRenderer renderer = must(SceneRenderer::create());
    const std::array<LitPalette, 2> lights{
        litPalette(document.palette, {255, 190, 120}, Outline{}),
        litPalette(document.palette, test::shadedLights({0.4, -0.6, 0.8}), Outline{})};

    const char* sweep = std::getenv("VOXPRITE_SWEEP");
    const bool full = sweep != nullptr && std::string_view(sweep) == "full";
    const std::vector<OrbitAngles> views = test::allKindsOfViews(200, 2026);
    std::uint64_t opaque = 0;
    std::size_t next = 0;
    for (std::size_t v = 0; v < views.size(); v += full ? 1 : sample.every) {
        const OrbitAngles& angles = views[v];
        for (std::size_t k = 0; k < (full ? kSigmas.size() : 1); ++k) {
            const CastFrame& frame = frames[next % frames.size()];
            const double sigma = kSigmas[next++ % kSigmas.size()];
            const LatticeView lattice =
                must(quantiseView(test::orthoView(angles, sigma), frame.octree.size));
            const bool shaded = v % kShadedEvery == 0 && (full || sigma <= kShadedSigma);
            const LitPalette& lit = lights[shaded ? 1 : 0];
            const SpriteBuffer cpu = castSprite(frame.octree.view(), lattice, lit);
            opaque += cpu.opaqueCount();
            for (const SpriteMode mode : {SpriteMode::spriteBuffer, SpriteMode::singlePass}) {
                const SpriteBuffer gl = must(renderer.castBuffer(frame.gpu, lattice, lit, mode));
                ASSERT_EQ(gl.sha256(), cpu.sha256())
                    << sample.file << " at yaw " << angles.yawDegrees << ", pitch "
                    << angles.pitchDegrees << ", roll " << angles.rollDegrees << ", sigma " << sigma
                    << ", mode " << static_cast<int>(mode);
                ASSERT_EQ(gl.idsSha256(), cpu.idsSha256());
            }
        }
    }
    EXPECT_GT(opaque, 0U);
}

INSTANTIATE_TEST_SUITE_P(Samples, SampleSweep,
                         testing::Values(Sample{"knight.vox"}, Sample{"oak.vox"},
                                         Sample{"cottage.vox"}, Sample{"truck.vox"},
                                         Sample{"letters.vox"}, Sample{"walk.voxprite"},
                                         Sample{"village.voxprite", 20}));

}  // namespace
}  // namespace voxprite
