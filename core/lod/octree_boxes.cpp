#include "core/lod/octree_boxes.h"

#include <algorithm>

namespace voxprite {
namespace {

IBox modelBox(const OctreeView& octree) {
    const IBox model{octree.treeFromVoxel, octree.treeFromVoxel + octree.size};
    return model.intersected({glm::ivec3(0), glm::ivec3(1 << octree.maxDepth)});
}

class BoxReader {
  public:
    BoxReader(const OctreeView& octree, const IBox& box, std::span<std::uint8_t> out)
        : octree_(octree), box_(box), inside_(box.intersected(modelBox(octree))), out_(out) {}

    void read(std::uint32_t word, glm::ivec3 min, int edge) {
        const IBox part = inside_.intersected({min, min + edge});
        if (part.empty() || node::isEmpty(word)) return;
        if (node::isUniform(word)) {
            fill(part, static_cast<std::uint8_t>(word));
        } else if (node::isBrick(word)) {
            const std::uint64_t payload = octree_.payloads[node::payloadIndex(word)];
            for (unsigned octant = 0; octant < 8; ++octant) {
                const glm::ivec3 voxel = min + octantCorner(octant);
                if (part.contains(voxel)) *at(voxel) = payloadMaterial(payload, octant);
            }
        } else {
            for (unsigned octant = 0; octant < 8; ++octant) {
                if (!node::hasChild(word, octant)) continue;
                read(octree_.nodes[node::childIndex(word, octant)],
                     min + octantCorner(octant) * (edge / 2), edge / 2);
            }
        }
    }

  private:
    [[nodiscard]] std::uint8_t* at(glm::ivec3 voxel) const {
        const glm::ivec3 v = voxel - box_.min;
        const glm::ivec3 size = box_.size();
        return out_.data() + (std::ptrdiff_t{v.z} * size.y + v.y) * size.x + v.x;
    }
    void fill(const IBox& part, std::uint8_t material) const {
        for (int z = part.min.z; z < part.max.z; ++z) {
            for (int y = part.min.y; y < part.max.y; ++y)
                std::fill_n(at({part.min.x, y, z}), part.size().x, material);
        }
    }

    const OctreeView& octree_;
    IBox box_;
    IBox inside_;
    std::span<std::uint8_t> out_;
};

// visit(part) for the empty parts until it returns false; whether it never did.
template <class Visit>
bool visitEmpty(const OctreeView& octree, std::uint32_t word, glm::ivec3 min, int edge,
                const IBox& box, const Visit& visit) {
    const IBox part = box.intersected({min, min + edge});
    if (part.empty() || node::isUniform(word)) return true;
    if (node::isEmpty(word)) return visit(part);
    if (node::isBrick(word)) {
        const std::uint64_t payload = octree.payloads[node::payloadIndex(word)];
        for (unsigned octant = 0; octant < 8; ++octant) {
            const glm::ivec3 voxel = min + octantCorner(octant);
            if (payloadMaterial(payload, octant) == 0 && part.contains(voxel) &&
                !visit(IBox{voxel, voxel + 1}))
                return false;
        }
        return true;
    }
    for (unsigned octant = 0; octant < 8; ++octant) {
        const std::uint32_t child =
            node::hasChild(word, octant) ? octree.nodes[node::childIndex(word, octant)] : 0;
        if (!visitEmpty(octree, child, min + octantCorner(octant) * (edge / 2), edge / 2, part,
                        visit))
            return false;
    }
    return true;
}

}  // namespace

void readBox(const OctreeView& octree, const IBox& box, std::span<std::uint8_t> out) {
    std::ranges::fill(out, std::uint8_t{0});
    BoxReader(octree, box, out).read(octree.nodes[0], glm::ivec3(0), 1 << octree.maxDepth);
}

void forEachEmptyPart(const OctreeView& octree, const IBox& box,
                      const std::function<void(const IBox& part)>& visit) {
    visitEmpty(octree, octree.nodes[0], glm::ivec3(0), 1 << octree.maxDepth, box,
               [&](const IBox& part) {
                   visit(part);
                   return true;
               });
}

bool solidThroughout(const OctreeView& octree, const IBox& box) {
    if (box.intersected(modelBox(octree)) != box) return false;
    return visitEmpty(octree, octree.nodes[0], glm::ivec3(0), 1 << octree.maxDepth, box,
                      [](const IBox&) { return false; });
}

}  // namespace voxprite
