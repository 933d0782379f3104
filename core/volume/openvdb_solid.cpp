#include <openvdb/Types.h>
#include <openvdb/tools/Morphology.h>
#include <openvdb/tree/Tree.h>

#include "core/volume/openvdb_library.h"

namespace voxprite {
namespace {

// Divided as a VoxelGrid is.
using Topology = openvdb::tree::Tree4<openvdb::ValueMask, 3, 3, 3>::Type;
using Leaf = Topology::LeafNodeType;
using Mask = Leaf::NodeMaskType;
static_assert(sizeof(Mask) == 8 * sizeof(std::uint64_t));  // nothing but its words

openvdb::Coord coord(glm::ivec3 v) {
    return {v.x, v.y, v.z};
}

const std::uint64_t* wordsOf(const Leaf& leaf) {
    return reinterpret_cast<const std::uint64_t*>(&leaf.valueMask());
}

class OpenVdbSolid : public SolidVoxels {
  public:
    void fill(const IBox& box) override {
        topology_.sparseFill({coord(box.min), coord(box.max - 1)}, true, true);
    }
    void setBlock(glm::ivec3 origin, const std::uint64_t* solid) override {
        Mask mask;
        for (openvdb::Index word = 0; word < 8; ++word) {
            mask.getWord<openvdb::Index64>(word) = solid[word];
        }
        topology_.touchLeaf(coord(origin))->setValueMask(mask);
    }
    void dilate() override {
        topology_.voxelizeActiveTiles();
        openvdb::tools::dilateActiveValues(topology_, 1, openvdb::tools::NN_FACE,
                                           openvdb::tools::EXPAND_TILES);
    }
    void erode(int layers) override {
        topology_.voxelizeActiveTiles();
        openvdb::tools::erodeActiveValues(topology_, layers, openvdb::tools::NN_FACE,
                                          openvdb::tools::EXPAND_TILES);
    }
    const std::uint64_t* blockAt(glm::ivec3 origin) const override {
        const Leaf* leaf = topology_.probeConstLeaf(coord(origin));
        return leaf == nullptr ? nullptr : wordsOf(*leaf);
    }
    void forEachBlock(const std::function<void(glm::ivec3 origin, const std::uint64_t* solid)>&
                          visit) const override {
        for (auto leaf = topology_.cbeginLeaf(); leaf; ++leaf) {
            const openvdb::Coord& origin = leaf->origin();
            visit({origin.x(), origin.y(), origin.z()}, wordsOf(*leaf));
        }
    }

  private:
    Topology topology_;
};

}  // namespace

std::unique_ptr<SolidVoxels> openVdbSolidVoxels() {
    return std::make_unique<OpenVdbSolid>();
}

}  // namespace voxprite
