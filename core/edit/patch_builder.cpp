#include "core/edit/patch_builder.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <tuple>

namespace voxprite {

namespace {

// Of solid cubes, 32 times what a patch may change.
constexpr std::uint64_t kMaxCubes = std::uint64_t{1} << 21;

bool comesBefore(glm::ivec3 a, glm::ivec3 b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

Failure tooMany(const std::string& what) {
    return fail("The edit is too large: it " + what + "; at most " +
                std::to_string(kMaxPatchVoxels) + " voxels change at once");
}

}  // namespace

Failure tooManyChanges(std::uint64_t voxels) {
    return tooMany("would change " + std::to_string(voxels) + " voxels");
}

CubeBytes cubeBytes(const VoxelGrid& voxels, glm::ivec3 origin) {
    const VoxelBlock block = voxels.blockAt(origin);
    CubeBytes bytes;
    if (block.voxels == nullptr) {
        bytes.fill(block.uniformValue);
    } else {
        std::memcpy(bytes.data(), block.voxels, bytes.size());
    }
    return bytes;
}

PatchBuilder::PatchBuilder(const Document& document, int model, const EditLimits& limits)
    : voxels_(document.voxelsOf(model)), model_(model), limits_(limits) {}

void PatchBuilder::set(glm::ivec3 origin, CubeBytes after) {
    Cube cube{origin, before(origin), after};
    keepWithinLimits(cube);
    std::uint64_t changes = 0;
    for (std::size_t i = 0; i < cube.after.size(); ++i) changes += cube.after[i] != cube.before[i];
    changes_ += changes;
    // Past the limit only the number counts.
    if (changes == 0 || changes_ > kMaxPatchVoxels) return;
    cubes_.push_back(std::make_unique<Cube>(cube));
}

void PatchBuilder::keepWithinLimits(Cube& cube) const {
    IBox box = limits_.box ? limits_.box->intersected(voxelRange()) : voxelRange();
    box = box.intersected({cube.origin, cube.origin + kCubeEdge});
    CubeBits allowed = boxBits(box, cube.origin);
    if (limits_.only != nullptr) {
        allowed = allowed & solidBits(limits_.only->grid(), cube.origin);
    }
    if (allBits(allowed)) return;
    for (std::size_t i = 0; i < cube.after.size(); ++i) {
        if (((allowed[i >> 6] >> (i & 63)) & 1) == 0) cube.after[i] = cube.before[i];
    }
}

Result<VoxelPatch> PatchBuilder::finish() {
    if (changes_ > kMaxPatchVoxels) {
        return tooManyChanges(changes_);
    }
    std::sort(cubes_.begin(), cubes_.end(),
              [](const auto& a, const auto& b) { return comesBefore(a->origin, b->origin); });
    VoxelPatch patch{model_, {}};
    patch.changes.reserve(changes_);

    // Ascending positions: layer by layer across x through all cubes of one origin.x, row by row
    // through those of one origin.y, and along each row from cube to cube.
    const auto endOfRun = [&](auto first, auto last, int axis) {
        return std::find_if(first, last, [&](const auto& cube) {
            return cube->origin[axis] != (*first)->origin[axis];
        });
    };
    const auto addRow = [&](const Cube& cube, int x, int y) {
        const auto row = static_cast<std::size_t>((x << 6) | (y << 3));
        if (std::memcmp(&cube.before[row], &cube.after[row], kCubeEdge) == 0) return;
        for (int z = 0; z < kCubeEdge; ++z) {
            const std::uint8_t from = cube.before[row + static_cast<std::size_t>(z)];
            const std::uint8_t to = cube.after[row + static_cast<std::size_t>(z)];
            if (from != to) patch.changes.push_back({cube.origin + glm::ivec3(x, y, z), from, to});
        }
    };
    const auto end = cubes_.end();
    for (auto slab = cubes_.begin(); slab != end;) {
        const auto slabEnd = endOfRun(slab, end, 0);
        for (int x = 0; x < kCubeEdge; ++x) {
            for (auto rod = slab; rod != slabEnd;) {
                const auto rodEnd = endOfRun(rod, slabEnd, 1);
                for (int y = 0; y < kCubeEdge; ++y) {
                    for (auto cube = rod; cube != rodEnd; ++cube) addRow(**cube, x, y);
                }
                rod = rodEnd;
            }
        }
        slab = slabEnd;
    }
    return patch;
}

Result<std::vector<glm::ivec3>> cubesOf(const VoxelGrid& a) {
    return cubesOf(a, VoxelGrid());
}

Result<std::vector<glm::ivec3>> cubesOf(const VoxelGrid& a, const VoxelGrid& b) {
    const std::uint64_t count = a.cubeCount() + b.cubeCount();
    if (count > kMaxCubes) {
        return tooMany("goes over " + std::to_string(count) + " blocks of 8 voxels cubed");
    }
    std::vector<glm::ivec3> cubes;
    cubes.reserve(count);
    const auto add = [&](const VoxelBlock& block) {
        for (int x = 0; x < block.edgeVoxels; x += kCubeEdge) {
            for (int y = 0; y < block.edgeVoxels; y += kCubeEdge) {
                for (int z = 0; z < block.edgeVoxels; z += kCubeEdge) {
                    cubes.push_back(block.origin + glm::ivec3(x, y, z));
                }
            }
        }
    };
    a.forEachBlock(add);
    b.forEachBlock(add);
    std::sort(cubes.begin(), cubes.end(), comesBefore);
    cubes.erase(std::unique(cubes.begin(), cubes.end()), cubes.end());
    return cubes;
}

}  // namespace voxprite
