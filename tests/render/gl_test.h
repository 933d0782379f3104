// Every test of this room runs in a headless context of its own. No context is a failure, and so is
// anything that the driver says with high severity.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "core/sprite/sprite_view.h"
#include "core/svo/bake.h"
#include "render/gl/context.h"
#include "render/gpu_octree.h"
#include "tests/support/must.h"

namespace voxprite::test {

class GlTest : public testing::Test {
  protected:
    void SetUp() override {
        Result<gl::HeadlessContext> context = gl::HeadlessContext::create();
        ASSERT_TRUE(context) << context.error().describe();
        context_.emplace(std::move(*context));
        EXPECT_EQ(gl::takeSevereMessages(), std::vector<std::string>{});
    }
    void TearDown() override {
        EXPECT_EQ(gl::takeSevereMessages(), std::vector<std::string>{});
        context_.reset();
    }

  private:
    std::optional<gl::HeadlessContext> context_;
};

// A model baked, on both sides.
struct GpuModel {
    Octree octree;
    GpuOctree gpu;
    Palette palette = Palette::standard();

    explicit GpuModel(const VoxelGrid& voxels) : octree(must(bake(voxels))) {
        gpu.upload(octree.view());
    }
    [[nodiscard]] PlacedEntity placedAt(glm::dvec3 anchorMetres, const GameProfile& profile,
                                        double yawDegrees = 0.0) const {
        Entity entity;
        entity.positionMetres = anchorMetres;
        entity.yawDegrees = yawDegrees;
        return placeEntity(entity, IBox{glm::ivec3(0), octree.size}, profile);
    }
};

// An orthographic view of a model from orbit angles, in voxel space.
[[nodiscard]] inline OrthoView orthoView(const OrbitAngles& angles, double sigma) {
    const glm::dmat3 basis = orbitBasis(angles);
    return {voxelFromWorld(basis[0]), voxelFromWorld(basis[1]), voxelFromWorld(basis[2]), sigma};
}

}  // namespace voxprite::test
