#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <unordered_set>
#include <vector>

#include "core/model/voxel_morphology.h"

namespace voxprite {

namespace {

constexpr int kEdge = 8;
constexpr std::size_t kCubeVoxels = 512;
constexpr int kMajority = 14;  // of 27
constexpr std::uint64_t kMaxCubes = std::uint64_t{1} << 21;

// A cube of 8 with a rim of one voxel all around.
constexpr int kWindowEdge = kEdge + 2;
constexpr std::size_t kWindowVoxels = std::size_t{kWindowEdge} * kWindowEdge * kWindowEdge;
using Window = std::array<std::uint8_t, kWindowVoxels>;

std::size_t windowIndex(glm::ivec3 v) {
    return static_cast<std::size_t>((v.x * kWindowEdge + v.y) * kWindowEdge + v.z);
}
constexpr std::array<std::size_t, 3> kStride{std::size_t{kWindowEdge} * kWindowEdge, kWindowEdge,
                                             1};

glm::ivec3 directionOf(int i) {
    return {i / 9 - 1, i / 3 % 3 - 1, i % 3 - 1};
}

bool isFull(const VoxelBlock& block) {
    return block.voxels == nullptr ? block.uniformValue != 0
                                   : std::memchr(block.voxels, 0, kCubeVoxels) == nullptr;
}

// A cube of 8 and the 26 around it.
struct Surroundings {
    std::array<VoxelBlock, 27> blocks;

    Surroundings(const VoxelGrid& voxels, glm::ivec3 origin) {
        for (int i = 0; i < 27; ++i) {
            blocks[static_cast<std::size_t>(i)] = voxels.blockAt(origin + directionOf(i) * kEdge);
        }
    }
    // Deep inside nothing changes.
    [[nodiscard]] bool full() const { return std::all_of(blocks.begin(), blocks.end(), isFull); }

    [[nodiscard]] Window window() const {
        Window values;
        glm::ivec3 v;
        for (v.x = 0; v.x < kWindowEdge; ++v.x) {
            for (v.y = 0; v.y < kWindowEdge; ++v.y) {
                for (v.z = 0; v.z < kWindowEdge; ++v.z) values[windowIndex(v)] = at(v);
            }
        }
        return values;
    }

  private:
    // `v` counts from the rim: the cube begins at 1.
    [[nodiscard]] std::uint8_t at(glm::ivec3 v) const {
        const glm::ivec3 shifted = v + (kEdge - 1);
        const glm::ivec3 cube = shifted / kEdge;
        const VoxelBlock& block =
            blocks[static_cast<std::size_t>(cube.x * 9 + cube.y * 3 + cube.z)];
        if (block.voxels == nullptr) return block.uniformValue;
        const glm::ivec3 within = shifted % kEdge;
        return block.voxels[(within.x << 6) | (within.y << 3) | within.z];
    }
};

// Solid voxels in the cube of 3 around each voxel of the window but its rim, axis by axis.
Window solidAround(const Window& values) {
    Window counts;
    for (std::size_t i = 0; i < kWindowVoxels; ++i) counts[i] = values[i] != 0;
    for (const std::size_t stride : kStride) {
        const Window along = counts;
        for (std::size_t i = stride; i + stride < kWindowVoxels; ++i) {
            counts[i] = static_cast<std::uint8_t>(along[i - stride] + along[i] + along[i + stride]);
        }
    }
    return counts;
}

std::uint8_t mostFrequentColour(const Window& values, glm::ivec3 centre) {
    std::array<std::uint8_t, 256> counts{};
    for (int i = 0; i < 27; ++i) ++counts[values[windowIndex(centre + directionOf(i))]];
    return static_cast<std::uint8_t>(std::max_element(counts.begin() + 1, counts.end()) -
                                     counts.begin());
}

struct OriginHash {
    std::size_t operator()(glm::ivec3 v) const {
        return (static_cast<std::size_t>(v.x) * 73'856'093u) ^
               (static_cast<std::size_t>(v.y) * 19'349'663u) ^
               (static_cast<std::size_t>(v.z) * 83'492'791u);
    }
};

// Every cube of 8 with something solid in it or beside it.
std::unordered_set<glm::ivec3, OriginHash> cubesAround(const VoxelGrid& voxels) {
    std::unordered_set<glm::ivec3, OriginHash> cubes;
    voxels.forEachBlock([&](const VoxelBlock& block) {
        for (int x = -kEdge; x <= block.edgeVoxels; x += kEdge) {
            for (int y = -kEdge; y <= block.edgeVoxels; y += kEdge) {
                for (int z = -kEdge; z <= block.edgeVoxels; z += kEdge) {
                    const glm::ivec3 origin = block.origin + glm::ivec3(x, y, z);
                    if (isInVoxelRange(origin)) cubes.insert(origin);
                }
            }
        }
    });
    return cubes;
}

VoxelGrid smoothedOnce(const VoxelGrid& voxels) {
    VoxelGrid result = voxels;
    std::array<std::uint8_t, kCubeVoxels> after;
    for (const glm::ivec3 origin : cubesAround(voxels)) {
        const Surroundings surroundings(voxels, origin);
        if (surroundings.full()) continue;
        const Window values = surroundings.window();
        const Window counts = solidAround(values);
        for (std::size_t i = 0; i < kCubeVoxels; ++i) {
            const glm::ivec3 v = glm::ivec3(i >> 6, (i >> 3) & 7, i & 7) + 1;
            const std::uint8_t value = values[windowIndex(v)];
            if (counts[windowIndex(v)] < kMajority) {
                after[i] = 0;
            } else {
                after[i] = value != 0 ? value : mostFrequentColour(values, v);
            }
        }
        result.setBlock(origin, after.data());
    }
    return result;
}

}  // namespace

Result<VoxelGrid> smoothed(const VoxelGrid& voxels, int passes) {
    if (passes < 1 || passes > kMaxMorphologyLayers) {
        return fail("passes is " + std::to_string(passes) + "; it must be between 1 and " +
                    std::to_string(kMaxMorphologyLayers));
    }
    const std::uint64_t cubes = voxels.cubeCount();
    if (cubes > kMaxCubes) {
        return fail("The model is too large to smooth: it has " + std::to_string(cubes) +
                    " blocks of 8 voxels cubed; at most " + std::to_string(kMaxCubes) + " can be");
    }
    VoxelGrid result = voxels;
    for (int pass = 0; pass < passes; ++pass) result = smoothedOnce(result);
    return result;
}

}  // namespace voxprite
