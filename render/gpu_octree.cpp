#include "render/gpu_octree.h"

#include <glad/gl.h>

#include <algorithm>
#include <bit>
#include <string>
#include <utility>

#include "render/revision.h"

namespace voxprite {

namespace {

constexpr std::uint32_t kWidth = GpuOctree::kWidth;

// Payloads are uploaded as they lie in memory: low word first.
static_assert(std::endian::native == std::endian::little);

// With half as much room again.
std::size_t roomy(std::size_t texels) {
    return texels + texels / 2 + 1;
}

std::size_t wholeRows(std::size_t texels) {
    return (texels + kWidth - 1) / kWidth * kWidth;
}

void uploadRectangle(std::uint32_t texture, std::uint32_t x, std::uint32_t y, std::uint32_t width,
                     std::uint32_t height, const std::uint32_t* words) {
    glTextureSubImage2D(texture, 0, static_cast<GLint>(x), static_cast<GLint>(y),
                        static_cast<GLsizei>(width), static_cast<GLsizei>(height), GL_RED_INTEGER,
                        GL_UNSIGNED_INT, words);
}

// A run of texels: the rest of its first row, whole rows, the start of the last.
void uploadRun(std::uint32_t texture, std::uint32_t first, std::uint32_t count,
               const std::uint32_t* words) {
    while (count > 0) {
        const std::uint32_t x = first % kWidth;
        const bool wholeRows = x == 0 && count >= kWidth;
        const std::uint32_t width = wholeRows ? kWidth : std::min(kWidth - x, count);
        const std::uint32_t height = wholeRows ? count / kWidth : 1;
        uploadRectangle(texture, x, first / kWidth, width, height, words);
        first += width * height;
        count -= width * height;
        words += width * height;
    }
}

void copyRows(const gl::Texture& from, std::uint32_t fromRow, const gl::Texture& to,
              std::uint32_t toRow, std::uint32_t rows) {
    glCopyImageSubData(from.id(), GL_TEXTURE_2D, 0, 0, static_cast<GLint>(fromRow), 0, to.id(),
                       GL_TEXTURE_2D, 0, 0, static_cast<GLint>(toRow), 0, kWidth,
                       static_cast<GLsizei>(rows), 1);
}

}  // namespace

GpuOctree::GpuOctree() = default;

// A texture with room for the octree, and in it what the one before held.
bool GpuOctree::makeRoom(const OctreeView& octree) {
    const gl::Texture before = std::move(texture_);
    const std::uint32_t nodesBefore = nodeCapacity_;
    const std::uint32_t rowsBefore = static_cast<std::uint32_t>(rows_);
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    const std::size_t nodes = wholeRows(roomy(octree.nodes.size()));
    const std::size_t payloads = wholeRows(roomy(2 * octree.payloads.size()));
    // Odd, and so never a power of two: a software driver compiles the shaders anew for a texture
    // that is one and another that is not, just when a model outgrows its texture.
    const std::size_t rows = ((nodes + payloads) / kWidth) | 1U;
    revision_ = nextRevision();
    status_ = {};
    if (rows > static_cast<std::size_t>(most)) {
        status_ =
            fail("an octree of " + std::to_string(octree.nodes.size()) + " nodes and " +
                 std::to_string(octree.payloads.size()) + " bricks takes " + std::to_string(rows) +
                 " rows of a texture; this driver has " + std::to_string(most));
        return false;
    }
    nodeCapacity_ = static_cast<std::uint32_t>(nodes);
    payloadCapacity_ = static_cast<std::uint32_t>(payloads / 2);
    payloadOffset_ = nodeCapacity_;
    rows_ = static_cast<int>(rows);
    texture_ = gl::createTexture2d();
    glTextureStorage2D(texture_.id(), 1, GL_R32UI, static_cast<GLsizei>(kWidth), rows_);
    glTextureParameteri(texture_.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(texture_.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    if (before) {
        // What was there comes along without leaving the GPU.
        const std::uint32_t nodeRows = nodesBefore / kWidth;
        const std::uint32_t payloadRows = rowsBefore - nodeRows;
        const std::uint32_t offsetRows = payloadOffset_ / kWidth;
        copyRows(before, 0, texture_, 0, std::min(nodeRows, offsetRows));
        copyRows(before, nodeRows, texture_, offsetRows,
                 std::min(payloadRows, static_cast<std::uint32_t>(rows_) - offsetRows));
    }
    return true;
}

void GpuOctree::upload(const OctreeView& octree) {
    const bool roomLeft = texture_ && octree.nodes.size() <= nodeCapacity_ &&
                          octree.payloads.size() <= payloadCapacity_;
    if (!roomLeft) {
        texture_.reset();  // nothing of it is kept
        if (!makeRoom(octree)) return;
    }
    OctreeChanges all;
    all.nodes.push_back({0, static_cast<std::uint32_t>(octree.nodes.size())});
    all.payloads.push_back({0, static_cast<std::uint32_t>(octree.payloads.size())});
    uploadRuns(octree, all);
}

void GpuOctree::update(const OctreeView& octree, const OctreeChanges& changes) {
    if (changes.everything || !texture_) {
        upload(octree);
        return;
    }
    const bool roomLeft =
        octree.nodes.size() <= nodeCapacity_ && octree.payloads.size() <= payloadCapacity_;
    if (roomLeft || makeRoom(octree)) uploadRuns(octree, changes);
}

void GpuOctree::uploadRuns(const OctreeView& octree, const OctreeChanges& changes) {
    for (const ArrayRange& run : changes.nodes) {
        uploadRun(texture_.id(), run.first, run.count, octree.nodes.data() + run.first);
        bytesUploaded_ += std::uint64_t{4} * run.count;
    }
    for (const ArrayRange& run : changes.payloads) {
        const auto* words =
            reinterpret_cast<const std::uint32_t*>(octree.payloads.data() + run.first);
        uploadRun(texture_.id(), payloadOffset_ + 2 * run.first, 2 * run.count, words);
        bytesUploaded_ += std::uint64_t{8} * run.count;
    }
    const bool sameShape = size_ == octree.size && treeFromVoxel_ == octree.treeFromVoxel &&
                           maxDepth_ == octree.maxDepth;
    if (changes.any() || !sameShape) revision_ = nextRevision();
    size_ = octree.size;
    treeFromVoxel_ = octree.treeFromVoxel;
    maxDepth_ = octree.maxDepth;
}

OctreeBlock GpuOctree::block() const {
    OctreeBlock block;
    block.svo_model_size = glm::uvec3(size_);
    block.svo_max_depth = static_cast<std::uint32_t>(maxDepth_);
    block.tree_from_voxel = treeFromVoxel_;
    block.payload_offset = payloadOffset_;
    return block;
}

}  // namespace voxprite
