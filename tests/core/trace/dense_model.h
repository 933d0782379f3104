// Small models as plain arrays, and their octrees by a builder of the tests' own: what the casters
// are checked against must not come from the code that they are built with.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <random>
#include <string>
#include <vector>

#include "core/svo/octree.h"

namespace voxprite::test {

struct DenseModel {
    std::string name;
    glm::ivec3 size{0};
    std::vector<std::uint8_t> voxels;

    DenseModel(std::string modelName, glm::ivec3 modelSize);
    [[nodiscard]] std::uint8_t at(glm::ivec3 v) const;  // 0 outside
    std::uint8_t& operator[](glm::ivec3 v);
};

// The octree of a model whose minimum corner lies at `treeFromVoxel` (negative too: what does not
// fit the root cube is left out).
struct NaiveOctree {
    Octree octree;
    glm::ivec3 treeFromVoxel{0};

    explicit NaiveOctree(const DenseModel& model, int maxDepth = 0,
                         glm::ivec3 treeFromVoxel = glm::ivec3(0));
    [[nodiscard]] OctreeView view() const;
};

DenseModel solid(glm::ivec3 size, std::uint8_t material);
DenseModel randomVoxels(glm::ivec3 size, double density, unsigned seed);
// The surface of the ball that fills a cube.
DenseModel shell(int edge);
// Legs, body, arms and head, much as a game's figure: 32 x 16 x 64 at unit 2.
DenseModel figure(int unit);

}  // namespace voxprite::test
