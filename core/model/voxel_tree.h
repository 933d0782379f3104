// How a VoxelGrid keeps its voxels. Private to voxel_grid.cpp: whoever includes it sees OpenVDB's
// headers with other settings than its library has.
#pragma once

// Leaves that load themselves from a file when they are touched: ours never do, and that part of
// OpenVDB is not in its headers. Before anything else of it.
#include <openvdb/version.h>
#undef OPENVDB_USE_DELAYED_LOADING

#include <openvdb/Types.h>
#include <openvdb/tree/InternalNode.h>
#include <openvdb/tree/LeafNode.h>
#include <openvdb/tree/RootNode.h>
#include <openvdb/tree/ValueAccessor.h>

#include <cstdint>

namespace voxprite::grid {

// Every level divides its cube by eight on each axis: leaves of 8, then 64, then 512 voxels, below
// a sorted map of 512-cubes. OpenVDB's usual 5-4-3 is for one big grid; here a model costs
// kilobytes and not megabytes, though its pivot at the origin makes it touch eight root cells. A
// voxel is active exactly when its value is not 0, tiles included.
//
// Values are palette indices, as a type that OpenVDB's library has no nodes of: that is compiled
// with leaves that load themselves, and a program may have one kind of a name alone.
enum Value : std::uint8_t {};
using Leaf = openvdb::tree::LeafNode<Value, 3>;
using Lower = openvdb::tree::InternalNode<Leaf, 3>;   // of 64 voxels an edge
using Upper = openvdb::tree::InternalNode<Lower, 3>;  // of 512

// What accessors ask of a tree, and no more. OpenVDB's own adds files and printing, through which a
// program would be bound to all of its library before it starts (core/volume).
class Tree {
  public:
    using RootNodeType = openvdb::tree::RootNode<Upper>;
    using LeafNodeType = Leaf;
    using ValueType = Value;
    static constexpr openvdb::Index DEPTH = RootNodeType::LEVEL + 1;

    [[nodiscard]] RootNodeType& root() { return root_; }
    [[nodiscard]] const RootNodeType& root() const { return root_; }
    // Accessors that are told when a tree lets go of nodes: ours are not.
    template <class Accessor>
    void attachAccessor(Accessor&) const {}
    template <class Accessor>
    void releaseAccessor(Accessor&) const {}

  private:
    RootNodeType root_{Value{}};
};

}  // namespace voxprite::grid
