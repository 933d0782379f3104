// Partial uploads leave the GPU with the same octree as uploading everything.
#include "render/gpu_octree.h"

#include <glad/gl.h>

#include "core/svo/live_octree.h"
#include "render/scene_renderer.h"
#include "tests/render/gl_test.h"
#include "tests/support/random.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::must;

class GpuOctrees : public test::GlTest {
  protected:
    // The words that shaders can reach, read back.
    struct Words {
        std::vector<std::uint32_t> nodes, payloads;
        bool operator==(const Words&) const = default;
    };
    static Words wordsOf(const GpuOctree& gpu, const OctreeView& octree) {
        GLint width = 0;
        GLint height = 0;
        glGetTextureLevelParameteriv(gpu.texture(), 0, GL_TEXTURE_WIDTH, &width);
        glGetTextureLevelParameteriv(gpu.texture(), 0, GL_TEXTURE_HEIGHT, &height);
        std::vector<std::uint32_t> all(static_cast<std::size_t>(width) *
                                       static_cast<std::size_t>(height));
        glGetTextureImage(gpu.texture(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT,
                          static_cast<GLsizei>(4 * all.size()), all.data());
        const auto first = all.begin();
        const auto payloads = first + gpu.payloadOffset();
        const auto nodeCount = static_cast<std::ptrdiff_t>(octree.nodes.size());
        const auto payloadTexels = static_cast<std::ptrdiff_t>(2 * octree.payloads.size());
        return {{first, first + nodeCount}, {payloads, payloads + payloadTexels}};
    }
    static Words wordsOf(const OctreeView& octree) {
        Words words{{octree.nodes.begin(), octree.nodes.end()}, {}};
        for (const std::uint64_t payload : octree.payloads) {
            words.payloads.push_back(static_cast<std::uint32_t>(payload));
            words.payloads.push_back(static_cast<std::uint32_t>(payload >> 32));
        }
        return words;
    }
};

TEST_F(GpuOctrees, UploadPutsNodesAndPayloadsWhereTheFormatSays) {
    const Octree octree = must(bake(test::randomVoxels(5, {70, 60, 50}, 0.3, 200)));
    ASSERT_GT(octree.nodes.size(), 4096U);  // more than a row of the texture
    GpuOctree gpu;
    EXPECT_EQ(gpu.texture(), 0U);
    gpu.upload(octree.view());
    EXPECT_TRUE(wordsOf(gpu, octree.view()) == wordsOf(octree.view()));
    EXPECT_EQ(gpu.size(), octree.size);
    EXPECT_EQ(gpu.maxDepth(), octree.maxDepth);
    EXPECT_EQ(gpu.bytesUploaded(), 4 * octree.nodes.size() + 8 * octree.payloads.size());
}

TEST_F(GpuOctrees, ThousandsOfEditsByPartsEqualOneUploadOfAll) {
    LiveOctree live;
    ASSERT_TRUE(live.rebuild(test::randomVoxels(6, {40, 40, 40}, 0.2, 9)));
    const IBox bounds{{-20, -20, -20}, {90, 90, 90}};
    GpuOctree gpu;
    gpu.update(live.view(bounds), live.takeChanges());
    test::Random random(7);
    std::uint64_t partly = 0;
    for (int step = 0; step < 120; ++step) {
        std::vector<LiveOctree::Edit> edits;
        const glm::ivec3 corner = random.voxel(0, 30);
        for (int i = 0; i < 25; ++i) {
            edits.push_back({corner + random.voxel(0, step < 60 ? 6 : 40),
                             static_cast<std::uint8_t>(random.between(0, 9))});
        }
        ASSERT_TRUE(live.apply(edits));
        const std::uint64_t before = gpu.bytesUploaded();
        const std::uint64_t revision = gpu.revision();
        const OctreeChanges changes = live.takeChanges();
        gpu.update(live.view(bounds), changes);
        EXPECT_EQ(gpu.revision() != revision, changes.any());
        const OctreeView view = live.view(bounds);
        const std::uint64_t whole = 4 * view.nodes.size() + 8 * view.payloads.size();
        if (gpu.bytesUploaded() - before < whole / 4) ++partly;
        ASSERT_TRUE(wordsOf(gpu, view) == wordsOf(view)) << "after step " << step;
    }
    EXPECT_GT(partly, 60U);
}

TEST_F(GpuOctrees, PicturesFollowPartialUpdates) {
    SceneRenderer renderer = must(SceneRenderer::create());
    const LitPalette lit = litPalette(Palette::standard(), {255, 190, 120}, Outline{});
    LiveOctree live;
    ASSERT_TRUE(live.rebuild(test::figure()));
    const IBox bounds{{-8, -8, -8}, {40, 40, 40}};
    const LatticeView lattice =
        must(quantiseView(test::orthoView({25, 30, 0}, 1.0), bounds.size()));
    GpuOctree gpu;
    gpu.upload(live.view(bounds));
    EXPECT_TRUE(live.takeChanges().any());
    std::string before;
    for (int z = 0; z < 6; ++z) {
        ASSERT_TRUE(live.apply(std::vector<LiveOctree::Edit>{{{10 + z, -6, 20 + 3 * z}, 5}}));
        gpu.update(live.view(bounds), live.takeChanges());
        const SpriteBuffer gl =
            must(renderer.castBuffer(gpu, lattice, lit, SpriteMode::spriteBuffer));
        const SpriteBuffer cpu = castSprite(live.view(bounds), lattice, lit);
        EXPECT_EQ(gl.sha256(), cpu.sha256());
        EXPECT_NE(gl.idsSha256(), before);
        before = gl.idsSha256();
    }
}

TEST_F(GpuOctrees, WhatNoTextureHoldsIsRefusedAndDrawnNever) {
    const Octree small = must(bake(test::figure()));
    // As many nodes as it says are never looked at.
    OctreeView huge = small.view();
    huge.nodes = std::span(huge.nodes.data(), std::size_t{1} << 30);
    GpuOctree gpu;
    gpu.upload(huge);
    ASSERT_FALSE(gpu.status());
    EXPECT_NE(gpu.status().error().message.find("1073741824 nodes"), std::string::npos);
    EXPECT_EQ(gpu.texture(), 0U);

    SceneRenderer renderer = must(SceneRenderer::create());
    const LatticeView lattice = must(quantiseView(test::orthoView({25, 30, 0}, 1.0), small.size));
    EXPECT_FALSE(renderer.castBuffer(gpu, lattice, LitPalette{}, SpriteMode::spriteBuffer));
    const Palette palette = Palette::standard();
    const GameProfile profile;
    const PlacedEntity placed = placeEntity(Entity{}, {glm::ivec3(0), small.size}, profile);
    Scene scene;
    scene.entities = {{&gpu, &palette, placed, nullptr}};
    Frame frame({64, 64});
    const Camera camera = orbitCamera({10, 20, 0}, {0, 1, 0}, 9.0, 45.0, {64, 64});
    const auto refused = renderer.draw(frame, scene, camera, profile, SpriteMode::spriteBuffer);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message, gpu.status().error().message);
    // A smaller one takes its place.
    gpu.upload(small.view());
    ASSERT_TRUE(gpu.status());
    const auto drawn = renderer.draw(frame, scene, camera, profile, SpriteMode::spriteBuffer);
    ASSERT_TRUE(drawn);
    EXPECT_EQ(drawn->drawn, 1);
    gpu.upload(huge);
    EXPECT_FALSE(renderer.draw(frame, scene, camera, profile, SpriteMode::spriteBuffer));
}

TEST_F(GpuOctrees, RevisionsOfDifferentOctreesDiffer) {
    const Octree octree = must(bake(test::figure()));
    GpuOctree a;
    GpuOctree b;
    a.upload(octree.view());
    b.upload(octree.view());
    EXPECT_NE(a.revision(), b.revision());
    const std::uint64_t before = a.revision();
    a.update(octree.view(), OctreeChanges{});
    EXPECT_EQ(a.revision(), before);
    OctreeView moved = octree.view();
    moved.size.z += 1;
    a.update(moved, OctreeChanges{});
    EXPECT_NE(a.revision(), before);
}

}  // namespace
}  // namespace voxprite
