// The arrays of a live octree: blocks of sibling nodes and single payloads come and go, what is
// free is used again, and every write is remembered for whoever keeps a copy (the GPU).
//
// Arrays that are taken over, and copies of a pool, keep room for half as much again: an array that
// has to move while it grows takes as long as all of it is large (26 MB for the costliest model of
// 256 cubed), and an edit of a single voxel would have to wait for that. Room that nothing was
// written to costs addresses, not memory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace voxprite {

// A run of elements [first, first + count) of an array.
struct ArrayRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    bool operator==(const ArrayRange&) const = default;
};

// What the GPU's copy must be told: merged runs, ascending. A run may cover a few elements that did
// not change, and the arrays may have grown since the last time.
struct OctreeChanges {
    bool everything = false;  // arrays were replaced: upload all
    std::vector<ArrayRange> nodes;
    std::vector<ArrayRange> payloads;
    void clear() { *this = {}; }
    [[nodiscard]] bool any() const { return everything || !nodes.empty() || !payloads.empty(); }
};

// Written elements of one array, gathered and merged.
class DirtyRanges {
  public:
    void add(std::uint32_t first, std::uint32_t count);
    void clear();
    [[nodiscard]] std::vector<ArrayRange> take();
    [[nodiscard]] std::size_t bytes() const { return ranges_.capacity() * sizeof(ArrayRange); }

  private:
    void merge();

    std::vector<ArrayRange> ranges_;
    std::size_t mergeAt_ = kFirstMerge;  // so that memory stays bounded by what really differs
    static constexpr std::size_t kFirstMerge = 4096;
};

class NodePool {
  public:
    NodePool() { replace({0}, {}); }
    ~NodePool() = default;
    NodePool(const NodePool& other);  // with room, too
    NodePool& operator=(const NodePool& other);
    NodePool(NodePool&&) noexcept = default;
    NodePool& operator=(NodePool&&) noexcept = default;

    [[nodiscard]] std::uint32_t node(std::uint32_t index) const { return nodes_[index]; }
    [[nodiscard]] std::uint64_t payload(std::uint32_t index) const { return payloads_[index]; }
    [[nodiscard]] const std::vector<std::uint32_t>& nodes() const { return nodes_; }
    [[nodiscard]] const std::vector<std::uint64_t>& payloads() const { return payloads_; }

    // New arrays without holes; node 0 is the root and never freed.
    void replace(std::vector<std::uint32_t> nodes, std::vector<std::uint64_t> payloads);

    void setNode(std::uint32_t index, std::uint32_t word);
    void setPayload(std::uint32_t index, std::uint64_t payload);

    // A block of words.size() (1 ... 8) nodes; its first index. The words must not lie in the pool.
    [[nodiscard]] std::uint32_t addNodes(std::span<const std::uint32_t> words);
    void freeNodes(std::uint32_t first, unsigned count);
    [[nodiscard]] std::uint32_t addPayload(std::uint64_t payload);
    void freePayload(std::uint32_t index) { freePayloads_.push_back(index); }

    [[nodiscard]] OctreeChanges takeChanges();
    // Bytes in use: without the room for growth.
    [[nodiscard]] std::size_t bytes() const;

  private:
    [[nodiscard]] std::uint32_t allocate(unsigned count);

    std::vector<std::uint32_t> nodes_;
    std::vector<std::uint64_t> payloads_;
    std::array<std::vector<std::uint32_t>, 9> freeBlocks_;  // by size; [0] is unused
    std::vector<std::uint32_t> freePayloads_;
    DirtyRanges dirtyNodes_;
    DirtyRanges dirtyPayloads_;
    bool replaced_ = false;
};

}  // namespace voxprite
