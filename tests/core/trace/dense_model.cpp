#include "tests/core/trace/dense_model.h"

#include <bit>
#include <cmath>

#include "core/base/box.h"

namespace voxprite::test {

DenseModel::DenseModel(std::string modelName, glm::ivec3 modelSize)
    : name(std::move(modelName)),
      size(modelSize),
      voxels(static_cast<std::size_t>(modelSize.x) * modelSize.y * modelSize.z) {}

std::uint8_t DenseModel::at(glm::ivec3 v) const {
    if (!IBox{glm::ivec3(0), size}.contains(v)) return 0;
    return voxels[v.x + static_cast<std::size_t>(size.x) *
                            (v.y + static_cast<std::size_t>(size.y) * v.z)];
}

std::uint8_t& DenseModel::operator[](glm::ivec3 v) {
    return voxels[v.x + static_cast<std::size_t>(size.x) *
                            (v.y + static_cast<std::size_t>(size.y) * v.z)];
}

namespace {

class Builder {
  public:
    Builder(const DenseModel& model, glm::ivec3 treeFromVoxel, Octree& octree)
        : model_(model), treeFromVoxel_(treeFromVoxel), octree_(octree) {}

    // The word of the cube of edge 2^level at `corner`; its children are appended depth first.
    std::uint32_t build(glm::ivec3 corner, int level) {
        if (level == 0) return model_.at(corner - treeFromVoxel_);
        std::uint32_t words[8];
        std::uint32_t mask = 0;
        bool equal = true;
        for (int o = 0; o < 8; ++o) {
            const glm::ivec3 bits{o & 1, o >> 1 & 1, o >> 2 & 1};
            words[o] = build(corner + bits * (1 << (level - 1)), level - 1);
            if (words[o] != 0) mask |= 1u << o;
            equal = equal && words[o] == words[0] && words[o] <= 255;
        }
        if (equal) return words[0];
        if (level == 1) {
            std::uint64_t payload = 0;
            for (int o = 0; o < 8; ++o) payload |= std::uint64_t{words[o]} << (8 * o);
            octree_.payloads.push_back(payload);
            return node::brick(static_cast<std::uint32_t>(octree_.payloads.size() - 1));
        }
        const auto base = static_cast<std::uint32_t>(octree_.nodes.size());
        for (int o = 0; o < 8; ++o)
            if (words[o] != 0) octree_.nodes.push_back(words[o]);
        return node::internal(base, mask);
    }

  private:
    const DenseModel& model_;
    glm::ivec3 treeFromVoxel_;
    Octree& octree_;
};

}  // namespace

NaiveOctree::NaiveOctree(const DenseModel& model, int maxDepth, glm::ivec3 offset)
    : treeFromVoxel(offset) {
    octree.size = model.size;
    octree.maxDepth = maxDepth;
    if (maxDepth == 0) {
        octree.maxDepth = 1;
        while ((1 << octree.maxDepth) < std::max({model.size.x, model.size.y, model.size.z}))
            ++octree.maxDepth;
    }
    octree.nodes[0] = Builder(model, offset, octree).build(glm::ivec3(0), octree.maxDepth);
}

OctreeView NaiveOctree::view() const {
    OctreeView view = octree.view();
    view.treeFromVoxel = treeFromVoxel;
    return view;
}

DenseModel solid(glm::ivec3 size, std::uint8_t material) {
    DenseModel model("solid", size);
    for (std::uint8_t& voxel : model.voxels) voxel = material;
    return model;
}

DenseModel randomVoxels(glm::ivec3 size, double density, unsigned seed) {
    DenseModel model("random " + std::to_string(density), size);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> chance(0.0, 1.0);
    std::uniform_int_distribution<int> material(1, 255);
    for (std::uint8_t& voxel : model.voxels)
        if (chance(random) < density) voxel = static_cast<std::uint8_t>(material(random));
    return model;
}

DenseModel shell(int edge) {
    DenseModel model("shell", glm::ivec3(edge));
    const double radius = edge / 2.0;
    for (int z = 0; z < edge; ++z)
        for (int y = 0; y < edge; ++y)
            for (int x = 0; x < edge; ++x) {
                const double distance = std::sqrt((x + 0.5 - radius) * (x + 0.5 - radius) +
                                                  (y + 0.5 - radius) * (y + 0.5 - radius) +
                                                  (z + 0.5 - radius) * (z + 0.5 - radius));
                if (distance < radius && distance >= radius - 1.5)
                    model[{x, y, z}] = static_cast<std::uint8_t>(1 + (x * 7 + y * 5 + z * 3) % 255);
            }
    return model;
}

DenseModel figure(int unit) {
    DenseModel model("figure", glm::ivec3(16, 8, 32) * unit);
    const auto part = [&](glm::ivec3 min, glm::ivec3 max, std::uint8_t material) {
        for (int z = min.z * unit; z < max.z * unit; ++z)
            for (int y = min.y * unit; y < max.y * unit; ++y)
                for (int x = min.x * unit; x < max.x * unit; ++x)
                    model[{x, y, z}] = static_cast<std::uint8_t>(material + (x ^ y ^ z) % 4);
    };
    part({4, 2, 0}, {7, 6, 12}, 10);
    part({9, 2, 0}, {12, 6, 12}, 20);
    part({4, 1, 12}, {12, 7, 23}, 30);
    part({0, 3, 12}, {3, 6, 22}, 40);
    part({13, 3, 12}, {16, 6, 22}, 50);
    part({5, 1, 24}, {11, 7, 32}, 60);
    return model;
}

}  // namespace voxprite::test
