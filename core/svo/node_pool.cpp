#include "core/svo/node_pool.h"

#include <algorithm>
#include <utility>

namespace voxprite {
namespace {

template <class T>
void keepRoom(std::vector<T>& values) {
    values.reserve(values.size() + values.size() / 2);
}

template <class T>
std::vector<T> roomyCopy(const std::vector<T>& values) {
    std::vector<T> copy;
    copy.reserve(values.size() + values.size() / 2);
    copy.insert(copy.end(), values.begin(), values.end());
    return copy;
}

}  // namespace

void DirtyRanges::add(std::uint32_t first, std::uint32_t count) {
    if (!ranges_.empty()) {
        ArrayRange& last = ranges_.back();
        if (first >= last.first && first <= last.first + last.count) {
            last.count = std::max(last.count, first + count - last.first);
            return;
        }
    }
    ranges_.push_back({first, count});
    if (ranges_.size() >= mergeAt_) {
        merge();
        mergeAt_ = std::max(kFirstMerge, 2 * ranges_.size());
    }
}

void DirtyRanges::clear() {
    ranges_.clear();
    mergeAt_ = kFirstMerge;
}

std::vector<ArrayRange> DirtyRanges::take() {
    merge();
    mergeAt_ = kFirstMerge;
    return std::exchange(ranges_, {});
}

void DirtyRanges::merge() {
    // An upload of its own costs more than these few elements.
    constexpr std::uint32_t kBridgedGap = 16;
    std::sort(ranges_.begin(), ranges_.end(),
              [](const ArrayRange& a, const ArrayRange& b) { return a.first < b.first; });
    std::size_t kept = 0;
    for (const ArrayRange& range : ranges_) {
        if (kept > 0) {
            ArrayRange& last = ranges_[kept - 1];
            if (range.first <= last.first + last.count + kBridgedGap) {
                last.count = std::max(last.count, range.first + range.count - last.first);
                continue;
            }
        }
        ranges_[kept++] = range;
    }
    ranges_.resize(kept);
}

NodePool::NodePool(const NodePool& other)
    : nodes_(roomyCopy(other.nodes_)),
      payloads_(roomyCopy(other.payloads_)),
      freeBlocks_(other.freeBlocks_),
      freePayloads_(other.freePayloads_),
      dirtyNodes_(other.dirtyNodes_),
      dirtyPayloads_(other.dirtyPayloads_),
      replaced_(other.replaced_) {}

NodePool& NodePool::operator=(const NodePool& other) {
    if (this != &other) *this = NodePool(other);
    return *this;
}

void NodePool::replace(std::vector<std::uint32_t> nodes, std::vector<std::uint64_t> payloads) {
    nodes_ = std::move(nodes);
    payloads_ = std::move(payloads);
    keepRoom(nodes_);
    keepRoom(payloads_);
    for (auto& blocks : freeBlocks_) blocks.clear();
    freePayloads_.clear();
    dirtyNodes_.clear();
    dirtyPayloads_.clear();
    replaced_ = true;
}

void NodePool::setNode(std::uint32_t index, std::uint32_t word) {
    nodes_[index] = word;
    dirtyNodes_.add(index, 1);
}

void NodePool::setPayload(std::uint32_t index, std::uint64_t payload) {
    payloads_[index] = payload;
    dirtyPayloads_.add(index, 1);
}

std::uint32_t NodePool::addNodes(std::span<const std::uint32_t> words) {
    const std::uint32_t first = allocate(static_cast<unsigned>(words.size()));
    std::copy(words.begin(), words.end(), nodes_.begin() + first);
    dirtyNodes_.add(first, static_cast<std::uint32_t>(words.size()));
    return first;
}

void NodePool::freeNodes(std::uint32_t first, unsigned count) {
    freeBlocks_[count].push_back(first);
}

std::uint32_t NodePool::addPayload(std::uint64_t payload) {
    if (freePayloads_.empty()) {
        freePayloads_.push_back(static_cast<std::uint32_t>(payloads_.size()));
        payloads_.push_back(0);
    }
    const std::uint32_t index = freePayloads_.back();
    freePayloads_.pop_back();
    setPayload(index, payload);
    return index;
}

std::uint32_t NodePool::allocate(unsigned count) {
    // The smallest free block that is large enough; what is left of it stays free.
    for (unsigned size = count; size < freeBlocks_.size(); ++size) {
        if (freeBlocks_[size].empty()) continue;
        const std::uint32_t first = freeBlocks_[size].back();
        freeBlocks_[size].pop_back();
        if (size > count) freeNodes(first + count, size - count);
        return first;
    }
    const auto first = static_cast<std::uint32_t>(nodes_.size());
    nodes_.resize(nodes_.size() + count);
    return first;
}

OctreeChanges NodePool::takeChanges() {
    OctreeChanges changes;
    changes.everything = std::exchange(replaced_, false);
    changes.nodes = dirtyNodes_.take();
    changes.payloads = dirtyPayloads_.take();
    if (changes.everything) {
        changes.nodes.clear();
        changes.payloads.clear();
    }
    return changes;
}

std::size_t NodePool::bytes() const {
    std::size_t total = nodes_.size() * sizeof(nodes_[0]) +
                        payloads_.size() * sizeof(payloads_[0]) +
                        freePayloads_.capacity() * sizeof(freePayloads_[0]) + dirtyNodes_.bytes() +
                        dirtyPayloads_.bytes();
    for (const auto& blocks : freeBlocks_) total += blocks.capacity() * sizeof(std::uint32_t);
    return total;
}

}  // namespace voxprite
