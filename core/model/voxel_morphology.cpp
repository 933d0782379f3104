#include "core/model/voxel_morphology.h"

#include <openvdb/Types.h>
#include <openvdb/tools/Morphology.h>
#include <openvdb/tree/Tree.h>

#include <algorithm>
#include <array>
#include <exception>
#include <string>

namespace voxprite {

namespace {

// Solidity alone, divided as a VoxelGrid is.
using Topology = openvdb::tree::Tree4<openvdb::ValueMask, 3, 3, 3>::Type;
using Leaf = Topology::LeafNodeType;

constexpr int kLeafEdge = 8;
constexpr openvdb::Index kLeafVoxels = 512;
// OpenVDB's morphology divides large uniform blocks down to leaves of some 100 bytes.
constexpr std::uint64_t kMaxLeaves = std::uint64_t{1} << 21;

openvdb::Coord coord(glm::ivec3 v) {
    return {v.x, v.y, v.z};
}

glm::ivec3 vector(const openvdb::Coord& c) {
    return {c.x(), c.y(), c.z()};
}

Status checkSize(const VoxelGrid& voxels) {
    const std::uint64_t leaves = voxels.cubeCount();
    if (leaves <= kMaxLeaves) return {};
    return fail("The model is too large for this: it has " + std::to_string(leaves) +
                " blocks of 8 voxels cubed; at most " + std::to_string(kMaxLeaves) + " can be");
}

Topology topologyOf(const VoxelGrid& voxels) {
    Topology topology;
    voxels.forEachBlock([&](const VoxelBlock& block) {
        if (block.voxels == nullptr) {
            topology.sparseFill({coord(block.origin), coord(block.origin + (block.edgeVoxels - 1))},
                                true, true);
            return;
        }
        Leaf::NodeMaskType solid;
        for (openvdb::Index n = 0; n < kLeafVoxels; ++n) solid.set(n, block.voxels[n] != 0);
        topology.touchLeaf(coord(block.origin))->setValueMask(solid);
    });
    topology.voxelizeActiveTiles();
    return topology;
}

void dilate(Topology& topology) {
    openvdb::tools::dilateActiveValues(topology, 1, openvdb::tools::NN_FACE,
                                       openvdb::tools::EXPAND_TILES);
}

void erode(Topology& topology, int layers) {
    openvdb::tools::erodeActiveValues(topology, layers, openvdb::tools::NN_FACE,
                                      openvdb::tools::EXPAND_TILES);
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

// The active voxels of `topology` that are empty in `voxels` take a colour from it.
void addLayer(VoxelGrid& voxels, const Topology& topology) {
    const VoxelGrid before = voxels;
    const VoxelGrid::Reader reader(before);
    for (auto leaf = topology.cbeginLeaf(); leaf; ++leaf) {
        for (auto voxel = leaf->cbeginValueOn(); voxel; ++voxel) {
            const glm::ivec3 v = vector(voxel.getCoord());
            if (reader.get(v) == 0) voxels.set(v, colourFromFaces(reader, v));
        }
    }
}

// Of the voxels those that are active in `topology`, or those that are not.
VoxelGrid voxelsWhere(const VoxelGrid& voxels, const Topology& topology, bool active) {
    VoxelGrid result;
    std::array<std::uint8_t, kLeafVoxels> values;
    const auto keepLeaf = [&](glm::ivec3 origin, const VoxelBlock& block) {
        const Leaf* leaf = topology.probeConstLeaf(coord(origin));
        for (openvdb::Index n = 0; n < kLeafVoxels; ++n) {
            const bool isActive = leaf != nullptr && leaf->isValueOn(n);
            const std::uint8_t value =
                block.voxels == nullptr ? block.uniformValue : block.voxels[n];
            values[n] = isActive == active ? value : 0;
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

// Runs `work`, with OpenVDB's exceptions (memory) as errors.
template <class Work>
Result<VoxelGrid> guarded(const VoxelGrid& voxels, const Work& work) {
    if (Status s = checkSize(voxels); !s) return tl::unexpected(s.error());
    try {
        return work();
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
    return guarded(voxels, [&] {
        Topology topology = topologyOf(voxels);
        VoxelGrid result = voxels;
        for (int layer = 0; layer < layers; ++layer) {
            dilate(topology);
            addLayer(result, topology);
        }
        return result;
    });
}

Result<VoxelGrid> eroded(const VoxelGrid& voxels, int layers) {
    if (Status s = checkLayers("layers", layers); !s) return tl::unexpected(s.error());
    return guarded(voxels, [&] {
        Topology topology = topologyOf(voxels);
        erode(topology, layers);
        return voxelsWhere(voxels, topology, true);
    });
}

Result<VoxelGrid> hollowed(const VoxelGrid& voxels, int wall) {
    if (Status s = checkLayers("wall", wall); !s) return tl::unexpected(s.error());
    return guarded(voxels, [&] {
        Topology inside = topologyOf(voxels);
        erode(inside, wall);
        return voxelsWhere(voxels, inside, false);
    });
}

}  // namespace voxprite
