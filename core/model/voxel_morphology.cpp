#include "core/model/voxel_morphology.h"

#include <algorithm>
#include <array>
#include <bit>
#include <exception>
#include <string>

#include "core/volume/volume_library.h"

namespace voxprite {

namespace {

constexpr int kLeafEdge = 8;
constexpr int kLeafVoxels = 512;
// OpenVDB's morphology divides large uniform blocks down to leaves of some 100 bytes.
constexpr std::uint64_t kMaxLeaves = std::uint64_t{1} << 21;

Status checkSize(const VoxelGrid& voxels) {
    const std::uint64_t leaves = voxels.cubeCount();
    if (leaves <= kMaxLeaves) return {};
    return fail("The model is too large for this: it has " + std::to_string(leaves) +
                " blocks of 8 voxels cubed; at most " + std::to_string(kMaxLeaves) + " can be");
}

std::unique_ptr<SolidVoxels> solidOf(const VolumeLibrary& library, const VoxelGrid& voxels) {
    std::unique_ptr<SolidVoxels> solid = library.solidVoxels();
    voxels.forEachBlock([&](const VoxelBlock& block) {
        if (block.voxels == nullptr) {
            solid->fill(block.box());
        } else {
            solid->setBlock(block.origin, block.solid);
        }
    });
    return solid;
}

// The colour of most of the six neighbours that are solid, of several the lowest.
std::uint8_t colourFromFaces(const VoxelGrid::Reader& reader, glm::ivec3 v) {
    std::array<std::uint8_t, 6> colours;
    for (int i = 0; i < 6; ++i) {
        glm::ivec3 neighbour = v;
        neighbour[i / 2] += i % 2 == 0 ? -1 : 1;
        colours[static_cast<std::size_t>(i)] = reader.get(neighbour);
    }
    std::sort(colours.begin(), colours.end());
    std::uint8_t best = 0;
    std::ptrdiff_t mostFaces = 0;
    for (auto first = colours.begin(); first != colours.end();) {
        const auto last = std::upper_bound(first, colours.end(), *first);
        if (*first != 0 && last - first > mostFaces) {
            mostFaces = last - first;
            best = *first;
        }
        first = last;
    }
    return best;
}

// The voxels of `solid` that are empty in `voxels` take a colour from it.
void addLayer(VoxelGrid& voxels, const SolidVoxels& solid) {
    const VoxelGrid before = voxels;
    const VoxelGrid::Reader reader(before);
    solid.forEachBlock([&](glm::ivec3 origin, const std::uint64_t* words) {
        for (int x = 0; x < kLeafEdge; ++x) {
            for (std::uint64_t rest = words[x]; rest != 0; rest &= rest - 1) {
                const int bit = std::countr_zero(rest);
                const glm::ivec3 v = origin + glm::ivec3(x, bit >> 3, bit & 7);
                if (reader.get(v) == 0) voxels.set(v, colourFromFaces(reader, v));
            }
        }
    });
}

// Of the voxels those that are in `kept`, or those that are not.
VoxelGrid voxelsWhere(const VoxelGrid& voxels, const SolidVoxels& kept, bool in) {
    VoxelGrid result;
    std::array<std::uint8_t, kLeafVoxels> values;
    const auto keepLeaf = [&](glm::ivec3 origin, const VoxelBlock& block) {
        const std::uint64_t* words = kept.blockAt(origin);
        for (std::size_t n = 0; n < kLeafVoxels; ++n) {
            const bool isIn = words != nullptr && (words[n >> 6] >> (n & 63) & 1) != 0;
            const std::uint8_t value =
                block.voxels == nullptr ? block.uniformValue : block.voxels[n];
            values[n] = isIn == in ? value : 0;
        }
        result.setBlock(origin, values.data());
    };
    voxels.forEachBlock([&](const VoxelBlock& block) {
        for (int x = 0; x < block.edgeVoxels; x += kLeafEdge) {
            for (int y = 0; y < block.edgeVoxels; y += kLeafEdge) {
                for (int z = 0; z < block.edgeVoxels; z += kLeafEdge) {
                    keepLeaf(block.origin + glm::ivec3(x, y, z), block);
                }
            }
        }
    });
    return result;
}

// work(solid voxels), with OpenVDB's exceptions (memory) as errors.
template <class Work>
Result<VoxelGrid> guarded(const VoxelGrid& voxels, const Work& work) {
    if (Status s = checkSize(voxels); !s) return tl::unexpected(s.error());
    const Result<const VolumeLibrary*> library = volumeLibrary();
    if (!library) return tl::unexpected(library.error());
    try {
        const std::unique_ptr<SolidVoxels> solid = solidOf(**library, voxels);
        return work(*solid);
    } catch (const std::exception& e) {
        return fail(std::string("OpenVDB: ") + e.what());
    }
}

Status checkLayers(const std::string& what, int layers) {
    if (layers >= 1 && layers <= kMaxMorphologyLayers) return {};
    return fail(what + " is " + std::to_string(layers) + "; it must be between 1 and " +
                std::to_string(kMaxMorphologyLayers));
}

}  // namespace

Result<VoxelGrid> dilated(const VoxelGrid& voxels, int layers) {
    if (Status s = checkLayers("layers", layers); !s) return tl::unexpected(s.error());
    const IBox bounds = voxels.bounds();
    if (bounds.empty()) return VoxelGrid();
    if (!isInVoxelRange(bounds.min - layers) || !isInVoxelRange(bounds.max - 1 + layers)) {
        return fail("The voxels would lie beyond +-" + std::to_string(kMaxCoordinate));
    }
    return guarded(voxels, [&](SolidVoxels& solid) {
        VoxelGrid result = voxels;
        for (int layer = 0; layer < layers; ++layer) {
            solid.dilate();
            addLayer(result, solid);
        }
        return result;
    });
}

Result<VoxelGrid> eroded(const VoxelGrid& voxels, int layers) {
    if (Status s = checkLayers("layers", layers); !s) return tl::unexpected(s.error());
    return guarded(voxels, [&](SolidVoxels& solid) {
        solid.erode(layers);
        return voxelsWhere(voxels, solid, true);
    });
}

Result<VoxelGrid> hollowed(const VoxelGrid& voxels, int wall) {
    if (Status s = checkLayers("wall", wall); !s) return tl::unexpected(s.error());
    return guarded(voxels, [&](SolidVoxels& solid) {
        solid.erode(wall);
        return voxelsWhere(voxels, solid, false);
    });
}

}  // namespace voxprite
