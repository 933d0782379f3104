// The clusters of one model on the GPU. Colours live apart (a quad knows its material alone), so
// that a change of the palette uploads nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

#include "core/lod/cluster_mesh.h"
#include "render/gl/handles.h"

namespace voxprite {

class GpuClusters {
  public:
    GpuClusters() = default;
    void upload(const ClusterMesh& mesh);  // needs a current context

    // Changes with every upload, and is never the same for two meshes.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }
    [[nodiscard]] std::uint32_t pageCount() const { return pageCount_; }
    [[nodiscard]] std::size_t indexCount() const { return indexCount_; }
    [[nodiscard]] double reach() const { return reach_; }  // of the pages' spheres
    [[nodiscard]] glm::ivec3 treeFromVoxel() const { return treeFromVoxel_; }
    [[nodiscard]] std::uint64_t bytes() const { return bytes_; }

    // 8 bytes each: x, y, z as 16 bits, the material, then the face in three bits and the level.
    [[nodiscard]] std::uint32_t vertices() const { return vertices_.id(); }
    [[nodiscard]] std::uint32_t indices() const { return indices_.id(); }  // 32 bits
    [[nodiscard]] std::uint32_t pages() const { return pages_.id(); }      // ClusterPage

  private:
    gl::Buffer vertices_, indices_, pages_;
    std::uint64_t revision_ = 0;
    std::uint64_t bytes_ = 0;
    std::uint32_t pageCount_ = 0;
    std::size_t indexCount_ = 0;
    double reach_ = 0.0;
    glm::ivec3 treeFromVoxel_{0};
};

}  // namespace voxprite
