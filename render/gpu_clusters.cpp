#include "render/gpu_clusters.h"

#include <glad/gl.h>

#include <span>
#include <vector>

#include "render/revision.h"

namespace voxprite {

namespace {

constexpr unsigned kFaceBits = 3;  // of the last byte of a vertex; the level is above them

// A quad is of one page, and a page of one level.
std::vector<ClusterVertex> withLevels(const ClusterMesh& mesh) {
    std::vector<ClusterVertex> vertices = mesh.vertices;
    for (std::size_t page = 0; page < mesh.pages.size(); ++page) {
        const auto level = static_cast<std::uint8_t>(mesh.pageLevels[page] << kFaceBits);
        const std::size_t first = mesh.pages[page].firstIndex;
        const std::size_t count = mesh.pages[page].indexCount;
        for (std::size_t k = first; k < first + count; k += 6) {
            const std::size_t quad = mesh.indices[k] / 4 * 4;
            for (std::size_t corner = quad; corner < quad + 4; ++corner) {
                vertices[corner].face = static_cast<std::uint8_t>(vertices[corner].face | level);
            }
        }
    }
    return vertices;
}

template <class Item>
gl::Buffer bufferOf(const std::vector<Item>& items) {
    gl::Buffer buffer = gl::createBuffer();
    const std::span<const Item> all(items);
    // GL has no buffers of nothing.
    const auto bytes = static_cast<GLsizeiptr>(all.empty() ? sizeof(Item) : all.size_bytes());
    glNamedBufferStorage(buffer.id(), bytes, all.empty() ? nullptr : all.data(), 0);
    return buffer;
}

}  // namespace

void GpuClusters::upload(const ClusterMesh& mesh) {
    vertices_ = bufferOf(withLevels(mesh));
    indices_ = bufferOf(mesh.indices);
    pages_ = bufferOf(mesh.pages);
    revision_ = nextRevision();
    bytes_ = mesh.bytes();
    pageCount_ = static_cast<std::uint32_t>(mesh.pages.size());
    indexCount_ = mesh.indices.size();
    reach_ = mesh.reach;
    treeFromVoxel_ = mesh.treeFromVoxel;
}

}  // namespace voxprite
