#include "core/edit/voxel_changes.h"

#include <algorithm>
#include <tuple>

namespace voxprite {

namespace {

bool changeComesBefore(const VoxelChange& a, const VoxelChange& b) {
    return std::tie(a.position.x, a.position.y, a.position.z) <
           std::tie(b.position.x, b.position.y, b.position.z);
}

// Joins neighbours of one position: the first before, the last after.
void joinRuns(std::vector<VoxelChange>& sorted) {
    auto kept = sorted.begin();
    for (auto change = sorted.begin(); change != sorted.end();) {
        VoxelChange joined = *change++;
        while (change != sorted.end() && change->position == joined.position) {
            joined.after = (change++)->after;
        }
        *kept++ = joined;
    }
    sorted.erase(kept, sorted.end());
}

}  // namespace

std::vector<VoxelChange> uniqueChanges(std::vector<VoxelChange> changes) {
    if (!std::is_sorted(changes.begin(), changes.end(), changeComesBefore)) {
        std::stable_sort(changes.begin(), changes.end(), changeComesBefore);
    }
    joinRuns(changes);
    return changes;
}

void dropUnchanged(std::vector<VoxelChange>& changes) {
    std::erase_if(changes, [](const VoxelChange& change) { return change.before == change.after; });
}

void mergeChanges(std::vector<VoxelChange>& earlier, const std::vector<VoxelChange>& later) {
    const auto known = static_cast<std::ptrdiff_t>(earlier.size());
    for (const VoxelChange& change : later) {
        const auto end = earlier.begin() + known;
        const auto found = std::lower_bound(earlier.begin(), end, change, changeComesBefore);
        if (found != end && found->position == change.position) {
            found->after = change.after;
        } else {
            earlier.push_back(change);
        }
    }
    std::inplace_merge(earlier.begin(), earlier.begin() + known, earlier.end(), changeComesBefore);
    dropUnchanged(earlier);
}

}  // namespace voxprite
