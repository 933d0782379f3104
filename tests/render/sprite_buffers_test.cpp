// The promise of the integer lattice: CPU, GL sprite_buffer and GL single_pass give the same sprite
// buffer, bit for bit.
#include <cmath>

#include "render/scene_renderer.h"
#include "render/sprite_blocks.h"
#include "tests/render/gl_test.h"
#include "tests/render/views.h"
#include "tests/support/random.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::allKindsOfViews;
using test::GpuModel;
using test::must;

// Keeps software drawing quick; the refusal beyond kMaxBufferPixels is core/trace's.
constexpr std::int64_t kMostPixels = 100'000;

class SpriteBuffers : public test::GlTest {
  protected:
    void SetUp() override {
        test::GlTest::SetUp();
        renderer_.emplace(must(SceneRenderer::create()));
        lit_ = litPalette(Palette::standard(), {255, 190, 120}, Outline{});
    }
    void TearDown() override {
        EXPECT_GT(opaque_, 0U);
        renderer_.reset();
        test::GlTest::TearDown();
    }

    // Counts the lattices compared, by the path that the shaders take.
    void compare(const GpuModel& model, const LatticeView& lattice, const std::string& what) {
        const SpriteBuffer cpu = castSprite(model.octree.view(), lattice, lit_);
        opaque_ += cpu.opaqueCount();
        for (const SpriteMode mode : {SpriteMode::spriteBuffer, SpriteMode::singlePass}) {
            const SpriteBuffer gl = must(renderer_->castBuffer(model.gpu, lattice, lit_, mode));
            ASSERT_EQ(gl.size, cpu.size) << what;
            EXPECT_EQ(gl.first, cpu.first) << what;
            EXPECT_EQ(gl.sha256(), cpu.sha256()) << what << ", mode " << static_cast<int>(mode);
            EXPECT_EQ(gl.idsSha256(), cpu.idsSha256())
                << what << ", mode " << static_cast<int>(mode);
        }
        ++(castsNarrow(lattice, model.octree.size) ? narrow_ : wide_);
    }

    void compareViews(const VoxelGrid& voxels, const std::string& name,
                      const std::vector<OrbitAngles>& views, const std::vector<double>& sigmas) {
        const GpuModel model(voxels);
        std::size_t next = 0;
        for (const OrbitAngles& angles : views) {
            // Each view at the next sigma that keeps the buffer small: all pairs are met in turn.
            for (std::size_t tries = 0; tries < sigmas.size(); ++tries) {
                const double sigma = sigmas[next++ % sigmas.size()];
                const Result<LatticeView> lattice =
                    quantiseView(test::orthoView(angles, sigma), model.octree.size);
                if (!lattice || std::int64_t{lattice->size.x} * lattice->size.y > kMostPixels) {
                    continue;
                }
                compare(model, *lattice,
                        name + " at yaw " + std::to_string(angles.yawDegrees) + ", pitch " +
                            std::to_string(angles.pitchDegrees) + ", roll " +
                            std::to_string(angles.rollDegrees) + ", sigma " +
                            std::to_string(sigma));
                break;
            }
        }
    }

    int narrow_ = 0;
    int wide_ = 0;
    std::uint64_t opaque_ = 0;
    std::optional<SceneRenderer> renderer_;
    LitPalette lit_;
};

const double kIsometricPitch = std::atan(std::sqrt(0.5)) * 180.0 / 3.14159265358979323846;
const std::vector<double> kSigmas{1.0, 2.0, 3.0, 4.0, 7.5, 16.0, 0.5};

VoxelGrid scattered(std::uint64_t seed, glm::ivec3 size, int count) {
    VoxelGrid voxels;
    test::Random random(seed);
    for (int i = 0; i < count; ++i) {
        const glm::ivec3 v = random.voxel(0, 1 << 20) % size;
        voxels.fill(IBox::around(v, glm::min(v + random.voxel(0, 12), size - 1)),
                    static_cast<std::uint8_t>(random.between(1, 255)));
    }
    // The corners fix the size.
    voxels.set(glm::ivec3(0), 1);
    voxels.set(size - 1, 2);
    return voxels;
}

// A view whose products outgrow 31 bits.
LatticeView finest(const OrbitAngles& angles, glm::ivec3 modelSize) {
    LatticeView lattice = must(quantiseView(test::orthoView(angles, 1.0), modelSize));
    const int finer = 1 << (13 - lattice.positionBits);
    lattice.positionBits = 13;
    lattice.C *= finer;
    lattice.U *= finer;
    lattice.V *= finer;
    const PixelBounds bounds = must(pixelBounds(lattice, modelSize));
    lattice.first = bounds.first;
    lattice.size = bounds.size;
    return lattice;
}

// Light that picks from the palette: the shaders only look up, so nothing can differ.
TEST_F(SpriteBuffers, ShadingWithinThePalette) {
    Palette palette = Palette::standard();
    palette.ramps = {{"", {255, 250, 247}}, {"", {1, 40, 90}}};
    lit_ = litPalette(palette, {240, 170, 140}, Outline{}, Shading::palette);
    EXPECT_NE(lit_, litPalette(palette, {240, 170, 140}, Outline{}));
    compareViews(test::asymmetric(), "asymmetric", allKindsOfViews(4, 6), {4.0});
}

// Faces that cast rays of their own: toward lights along axes and diagonals, where rays meet edges
// and corners, and anywhere; alone and together.
TEST_F(SpriteBuffers, OcclusionAndShadows) {
    test::Random random(77);
    const VoxelGrid models[] = {test::asymmetric(), test::randomVoxels(9, {12, 12, 12}, 0.3, 255)};
    std::uint64_t seed = 50;
    for (const VoxelGrid& voxels : models) {
        for (const glm::dvec3 toward :
             {glm::dvec3(0, 0, 1), glm::dvec3(-1, 1, 1), glm::dvec3(1, 0, 1),
              glm::dvec3(random.voxel(-999, 999)), glm::dvec3(random.voxel(-999, 999))}) {
            FaceLights lights = test::shadedLights(toward);
            if (seed % 4 == 1) lights.rays.occlusion = false;
            if (seed % 4 == 2) lights.rays.towardLight = glm::ivec3(0);
            lit_ = litPalette(Palette::standard(), lights, Outline{});
            ASSERT_EQ(lit_.faces.size(), lights.rays.shadows() ? 24U : 12U);
            std::vector<OrbitAngles> views = allKindsOfViews(2, seed);
            views.erase(views.begin(), views.end() - 4);  // one of them from below
            compareViews(voxels, "shaded " + std::to_string(seed), views, {2.0, 1.0, 0.5});
            ++seed;
        }
    }
    EXPECT_EQ(narrow_, 40);
    // The wide path asks the same of its faces.
    const GpuModel ball(test::shellSphere(64));
    compare(ball, finest({33.0, 21.0, 0.0}, ball.octree.size), "wide");
    EXPECT_EQ(wide_, 1);
    // The longest rays there are.
    lit_ = litPalette(Palette::standard(), test::shadedLights({-1.0, 0.001, 0.002}), Outline{});
    compareViews(scattered(11, {65'536, 40, 700}, 60), "long slab", {{80.0, 5.0, 0.0}},
                 {1.0 / 64.0});
    EXPECT_EQ(narrow_ + wide_, 42);
}

TEST_F(SpriteBuffers, AsymmetricModelFromEverywhere) {
    compareViews(test::asymmetric(), "asymmetric", allKindsOfViews(40, 1), kSigmas);
    EXPECT_GE(narrow_, 88);
}

TEST_F(SpriteBuffers, FigureFromEverywhere) {
    compareViews(test::figure(), "figure", allKindsOfViews(40, 2), kSigmas);
    EXPECT_GE(narrow_, 88);
}

TEST_F(SpriteBuffers, NoiseHasATieAtEveryTurn) {
    compareViews(test::randomVoxels(7, {21, 18, 33}, 0.06, 255), "noise", allKindsOfViews(20, 3),
                 kSigmas);
    compareViews(test::randomVoxels(8, {64, 64, 64}, 0.01, 255), "sparse noise",
                 allKindsOfViews(10, 4), kSigmas);
    EXPECT_GE(narrow_, 120);
}

// Rays that start on a lattice corner and run along diagonals meet edges and corners all the way:
// which cell comes first is a matter of the rules for ties alone.
TEST_F(SpriteBuffers, RaysThroughEdgesAndCorners) {
    const GpuModel model(test::randomVoxels(15, {14, 13, 12}, 0.15, 255));
    for (int code = 0; code < 27; ++code) {
        const glm::ivec3 direction(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
        if (direction == glm::ivec3(0)) continue;
        const int along = direction.x != 0 ? 0 : direction.y != 0 ? 1 : 2;
        LatticeView lattice;
        lattice.C = model.octree.size / 2 * 256;
        lattice.D = direction * (1 + code % 4);
        // Steps of half a voxel along the other two axes.
        lattice.U[(along + 1) % 3] = 128 << kStepShift;
        lattice.V[(along + 2) % 3] = 128 << kStepShift;
        const PixelBounds bounds = must(pixelBounds(lattice, model.octree.size));
        lattice.first = bounds.first;
        lattice.size = bounds.size;
        compare(model, lattice, "direction code " + std::to_string(code));
        // The same through the middles of the cells: other axes tie.
        lattice.C += glm::ivec3(128, 0, 0);
        const PixelBounds shifted = must(pixelBounds(lattice, model.octree.size));
        lattice.first = shifted.first;
        lattice.size = shifted.size;
        compare(model, lattice, "shifted, direction code " + std::to_string(code));
    }
    EXPECT_EQ(narrow_, 52);
}

TEST_F(SpriteBuffers, OneVoxelAndARod) {
    compareViews(test::solidBox({1, 1, 1}, 9), "one voxel", allKindsOfViews(20, 5),
                 {1.0, 2.0, 3.0, 4.0, 7.5, 16.0, 0.5, 64.0, 1.0 / 64.0});
    compareViews(test::solidBox({1, 1, 256}, 9), "rod", allKindsOfViews(20, 6), kSigmas);
    compareViews(test::solidBox({256, 1, 1}, 9), "lying rod", allKindsOfViews(5, 7), kSigmas);
    EXPECT_GE(narrow_, 150);
}

TEST_F(SpriteBuffers, LargeModels) {
    const std::vector<OrbitAngles> views{{0, 0, 0},   {45, 0, 0},    {45, kIsometricPitch, 0},
                                         {0, 90, 0},  {225, -45, 0}, {17.3, 41.1, 0},
                                         {211, -9, 5}};
    compareViews(scattered(9, {256, 256, 256}, 60), "256 cubed", views, {0.5, 1.0});
    compareViews(scattered(10, {300, 300, 300}, 60), "300 cubed", views, {0.5, 1.0});
    compareViews(scattered(11, {65'536, 40, 700}, 60), "long slab", views, {1.0 / 64.0});
    EXPECT_GE(narrow_ + wide_, 16);
    EXPECT_GE(wide_, 3);
}

// The finest lattices there are: too fine for 31 bits.
TEST_F(SpriteBuffers, FineLatticesTakeTheWidePath) {
    const GpuModel model(test::shellSphere(64));
    for (const OrbitAngles& angles : allKindsOfViews(6, 12)) {
        compare(model, finest(angles, model.octree.size),
                "yaw " + std::to_string(angles.yawDegrees));
    }
    EXPECT_GE(wide_, 20);
}

// Short directions keep products small while positions are large: then a quotient taken in single
// precision would be off by more than one, and the wide path must be taken.
TEST_F(SpriteBuffers, LargePositionsAndShortDirections) {
    const GpuModel model(scattered(14, {900, 30, 700}, 80));
    for (const glm::ivec3 direction :
         {glm::ivec3(0, 1, 0), glm::ivec3(1, 1, 0), glm::ivec3(1, -2, 1), glm::ivec3(-1, 3, 2)}) {
        LatticeView lattice;
        lattice.positionBits = 13;
        lattice.C = model.octree.size / 2 * (1 << 13) + 1234;
        lattice.D = direction;
        lattice.U = {1 << 28, 0, 0};
        lattice.V = {0, 0, 1 << 28};
        // The middle of the picture, as a scene casts what is on the screen.
        lattice.first = {-3, -3};
        lattice.size = {6, 6};
        EXPECT_TRUE(fitsNarrow(lattice, model.octree.size));
        compare(model, lattice, "direction of z " + std::to_string(direction.z));
    }
    EXPECT_EQ(wide_, 4);
}

// The live octree keeps an origin of its own; bounds may even reach beyond its root.
TEST_F(SpriteBuffers, LiveOctreesWithTheirOwnOrigin) {
    LiveOctree live;
    const VoxelGrid figure = test::figure();
    ASSERT_TRUE(live.rebuild(figure));
    const std::vector<LiveOctree::Edit> edits{{{-9, 3, 5}, 7}, {{20, -4, 2}, 8}, {{3, 3, 40}, 9}};
    ASSERT_TRUE(live.apply(edits));
    GpuOctree gpu;
    for (const IBox& bounds : {IBox{{-9, -4, 0}, {21, 8, 41}}, IBox{{-60, -50, -40}, {70, 80, 90}},
                               IBox{{0, 0, 0}, {16, 8, 32}}, IBox{{2, 1, 3}, {11, 6, 25}}}) {
        const OctreeView view = live.view(bounds);
        gpu.upload(view);
        for (const OrbitAngles& angles : allKindsOfViews(4, 13)) {
            const LatticeView lattice =
                must(quantiseView(test::orthoView(angles, 1.0), bounds.size()));
            const SpriteBuffer cpu = castSprite(view, lattice, lit_);
            const SpriteBuffer gl =
                must(renderer_->castBuffer(gpu, lattice, lit_, SpriteMode::spriteBuffer));
            EXPECT_EQ(gl.idsSha256(), cpu.idsSha256());
            opaque_ += cpu.opaqueCount();
        }
    }
}

TEST_F(SpriteBuffers, WithoutOutline) {
    lit_.outline.enabled = false;
    compareViews(test::figure(), "figure", {{30, 20, 0}, {0, 0, 0}}, {4.0, 1.0});
    lit_.outline = {true, {200, 10, 250, 255}};
    compareViews(test::figure(), "figure", {{30, 20, 0}, {0, 0, 0}}, {4.0, 1.0});
}

// Larger than a tile of the caster in one direction: the seams must not show.
TEST_F(SpriteBuffers, BuffersOfSeveralTiles) {
    const GpuModel model(test::solidBox({1, 1, 300}, 3));
    for (const OrbitAngles& angles : {OrbitAngles{0, 0, 0}, OrbitAngles{20, 10, 90}}) {
        const LatticeView lattice =
            must(quantiseView(test::orthoView(angles, 16.0), model.octree.size));
        ASSERT_GT(std::max(lattice.size.x, lattice.size.y), 2 * 2048);
        compare(model, lattice, "tiles");
    }
}

}  // namespace
}  // namespace voxprite
