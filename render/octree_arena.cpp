#include "render/octree_arena.h"

#include <glad/gl.h>

#include <algorithm>

namespace voxprite {

namespace {

void copyRows(std::uint32_t from, int fromRow, std::uint32_t to, int toRow, int rows) {
    glCopyImageSubData(from, GL_TEXTURE_2D, 0, 0, fromRow, 0, to, GL_TEXTURE_2D, 0, 0, toRow, 0,
                       GpuOctree::kWidth, rows, 1);
}

}  // namespace

void OctreeArena::arrange(std::span<const GpuOctree* const> octrees) {
    for (Resident& resident : residents_) resident.wanted = false;
    if (octrees.size() > 1) {
        std::vector<const GpuOctree*> missing;
        for (const GpuOctree* octree : octrees) {
            const auto found =
                std::ranges::find(residents_, octree->revision(), &Resident::revision);
            if (found == residents_.end()) {
                missing.push_back(octree);
            } else {
                found->wanted = true;
            }
        }
        for (const GpuOctree* octree : missing) {
            if (!add(*octree)) break;
        }
    }
    at_.clear();
    for (const Resident& resident : residents_) {
        if (resident.wanted) at_.emplace_back(resident.revision, resident.firstRow);
    }
    std::ranges::sort(at_);
}

OctreePlace OctreeArena::placeOf(const GpuOctree& octree) const {
    const auto found =
        std::ranges::lower_bound(at_, octree.revision(), {}, &std::pair<std::uint64_t, int>::first);
    if (found == at_.end() || found->first != octree.revision()) {
        return {octree.texture(), 0, octree.payloadOffset()};
    }
    const auto first = static_cast<std::uint32_t>(found->second) * GpuOctree::kWidth;
    return {texture_.id(), first, first + octree.payloadOffset()};
}

bool OctreeArena::add(const GpuOctree& octree) {
    const int rows = octree.rows();
    const auto gapFor = [&] {
        int row = 0;
        auto next = residents_.begin();
        while (next != residents_.end() && next->firstRow - row < rows) {
            row = next->firstRow + next->rows;
            ++next;
        }
        return std::pair(next, row);
    };
    auto [next, row] = gapFor();
    if (row + rows > rows_) {
        std::erase_if(residents_, [](const Resident& resident) { return !resident.wanted; });
        std::tie(next, row) = gapFor();
    }
    if (row + rows > rows_ && !grow(row + rows)) return false;
    residents_.insert(next, {octree.revision(), row, rows, true});
    copyRows(octree.texture(), 0, texture_.id(), row, rows);
    return true;
}

bool OctreeArena::grow(int rows) {
    if (rows > mostRows_) return false;
    const int before = rows_;
    rows_ = std::min(std::max(rows, 2 * rows_), mostRows_);
    gl::Texture larger = gl::createTexture2d();
    glTextureStorage2D(larger.id(), 1, GL_R32UI, GpuOctree::kWidth, rows_);
    glTextureParameteri(larger.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(larger.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    if (before > 0) copyRows(texture_.id(), 0, larger.id(), 0, before);
    texture_ = std::move(larger);
    return true;
}

std::uint64_t OctreeArena::bytes() const {
    return std::uint64_t{4} * GpuOctree::kWidth * static_cast<std::uint64_t>(rows_);
}

}  // namespace voxprite
