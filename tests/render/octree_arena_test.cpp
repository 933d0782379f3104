// Octrees side by side in one texture: each is found whole, whatever came and went.
#include "render/octree_arena.h"

#include <glad/gl.h>

#include "tests/render/gl_test.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::must;

class OctreeArenas : public test::GlTest {
  protected:
    void SetUp() override {
        test::GlTest::SetUp();
        for (int k = 0; k < 6; ++k) {
            octrees_.push_back(
                must(bake(test::randomVoxels(20 + k, {30 + 6 * k, 40, 30}, 0.2, 9))));
            gpu_.emplace_back().upload(octrees_.back().view());
        }
    }
    void TearDown() override {
        gpu_.clear();
        test::GlTest::TearDown();
    }

    static std::vector<std::uint32_t> texels(const OctreePlace& place) {
        GLint height = 0;
        glGetTextureLevelParameteriv(place.texture, 0, GL_TEXTURE_HEIGHT, &height);
        std::vector<std::uint32_t> all(static_cast<std::size_t>(height) * GpuOctree::kWidth);
        glGetTextureImage(place.texture, 0, GL_RED_INTEGER, GL_UNSIGNED_INT,
                          static_cast<GLsizei>(4 * all.size()), all.data());
        return all;
    }
    void expectWhole(const OctreeArena& arena, std::size_t k) {
        const OctreePlace place = arena.placeOf(gpu_[k]);
        const std::vector<std::uint32_t> all = texels(place);
        const OctreeView view = octrees_[k].view();
        ASSERT_LE(place.payloadOffset + 2 * view.payloads.size(), all.size());
        for (std::size_t i = 0; i < view.nodes.size(); ++i) {
            ASSERT_EQ(all[place.nodeOffset + i], view.nodes[i]) << "octree " << k;
        }
        for (std::size_t i = 0; i < view.payloads.size(); ++i) {
            ASSERT_EQ(all[place.payloadOffset + 2 * i],
                      static_cast<std::uint32_t>(view.payloads[i]));
            ASSERT_EQ(all[place.payloadOffset + 2 * i + 1],
                      static_cast<std::uint32_t>(view.payloads[i] >> 32));
        }
    }
    void arrange(OctreeArena& arena, const std::vector<std::size_t>& which) {
        std::vector<const GpuOctree*> wanted;
        for (const std::size_t k : which) wanted.push_back(&gpu_[k]);
        arena.arrange(wanted);
        for (const std::size_t k : which) expectWhole(arena, k);
    }

    std::vector<Octree> octrees_;
    std::vector<GpuOctree> gpu_;
};

TEST_F(OctreeArenas, OneAloneIsReadWhereItIs) {
    OctreeArena arena;
    arrange(arena, {2});
    EXPECT_EQ(arena.placeOf(gpu_[2]).texture, gpu_[2].texture());
    EXPECT_EQ(arena.bytes(), 0U);
}

TEST_F(OctreeArenas, SeveralShareOneTexture) {
    OctreeArena arena;
    arrange(arena, {0, 1});
    EXPECT_NE(arena.placeOf(gpu_[0]).texture, gpu_[0].texture());
    EXPECT_EQ(arena.placeOf(gpu_[0]).texture, arena.placeOf(gpu_[1]).texture);
    // It grows, and what comes back is still there.
    arrange(arena, {0, 1, 2, 3, 4, 5});
    arrange(arena, {5, 0});
    EXPECT_EQ(arena.placeOf(gpu_[5]).texture, arena.placeOf(gpu_[0]).texture);
}

TEST_F(OctreeArenas, ComingsAndGoingsStayWithinTheRoom) {
    const int rows = gpu_[0].rows() + gpu_[1].rows() + gpu_[2].rows();
    OctreeArena arena(rows);
    for (const std::vector<std::size_t>& which : {std::vector<std::size_t>{0, 1},
                                                  {0, 2},
                                                  {1, 2},
                                                  {0, 1, 2},
                                                  {3, 0},
                                                  {4, 1, 0},
                                                  {2, 5, 4}}) {
        arrange(arena, which);
        EXPECT_LE(arena.bytes(), 4ULL * GpuOctree::kWidth * static_cast<unsigned>(rows));
    }
    // What finds no room is read from its own texture.
    arrange(arena, {0, 1, 2, 3, 4, 5});
    EXPECT_EQ(arena.placeOf(gpu_[5]).texture, gpu_[5].texture());
}

TEST_F(OctreeArenas, AChangedOctreeIsCopiedAgain) {
    OctreeArena arena;
    arrange(arena, {0, 1});
    octrees_[0] = must(bake(test::randomVoxels(99, {30, 40, 30}, 0.2, 9)));
    gpu_[0].upload(octrees_[0].view());
    arrange(arena, {0, 1});
    EXPECT_EQ(arena.placeOf(gpu_[0]).texture, arena.placeOf(gpu_[1]).texture);
}

}  // namespace
}  // namespace voxprite
