// An octree on the GPU: node words and payload words in one R32UI texture, as svo-format has it
// (nodes first, then payloads as low and high words; linear index i at i % width, i / width).
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "core/base/result.h"
#include "core/svo/live_octree.h"
#include "core/svo/octree.h"
#include "render/gl/handles.h"
#include "render/gpu_blocks.h"

namespace voxprite {

class GpuOctree {
  public:
    static constexpr int kWidth = 4096;  // of the texture: kWidthBits of shaders/shared/octree.glsl

    GpuOctree();
    // Uploads all of it. Room is left for growth. An octree larger than the driver's textures is
    // not uploaded (there is no texture then), and status says so.
    void upload(const OctreeView& octree);
    // Uploads only `changes` (all, when they say so or the room is used up).
    void update(const OctreeView& octree, const OctreeChanges& changes);

    [[nodiscard]] const Status& status() const { return status_; }

    // Changes with every upload, and is never the same for two octrees: equal revisions hold equal
    // voxels.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }
    [[nodiscard]] std::uint64_t bytesUploaded() const { return bytesUploaded_; }
    [[nodiscard]] glm::ivec3 size() const { return size_; }
    [[nodiscard]] glm::ivec3 treeFromVoxel() const { return treeFromVoxel_; }
    [[nodiscard]] int maxDepth() const { return maxDepth_; }
    [[nodiscard]] std::uint32_t payloadOffset() const { return payloadOffset_; }  // in texels
    [[nodiscard]] std::uint32_t texture() const { return texture_.id(); }
    [[nodiscard]] int rows() const { return rows_; }  // of the texture
    [[nodiscard]] OctreeBlock block() const;          // what shaders need to read it

  private:
    [[nodiscard]] bool makeRoom(const OctreeView& octree);
    void uploadRuns(const OctreeView& octree, const OctreeChanges& changes);

    gl::Texture texture_;
    Status status_;
    glm::ivec3 size_{0};
    glm::ivec3 treeFromVoxel_{0};
    int maxDepth_ = 1;
    int rows_ = 0;
    std::uint32_t payloadOffset_ = 0;
    std::uint32_t nodeCapacity_ = 0;  // words, whole rows of the texture
    std::uint32_t payloadCapacity_ = 0;
    std::uint64_t revision_ = 0;
    std::uint64_t bytesUploaded_ = 0;
};

}  // namespace voxprite
