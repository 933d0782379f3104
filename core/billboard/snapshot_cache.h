// The snapshots of one model: made when they are first asked for, kept within a bound of memory,
// and forgotten when an edit changes them.
//
// Not for several threads at once; what it hands out may be used anywhere, and stays valid when the
// cache forgets it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "core/billboard/snapshot.h"

namespace voxprite {

struct SnapshotCacheOptions {
    SnapshotKind kind = SnapshotKind::seed;
    int sizePx = kUsualSnapshotPx;  // kind seed: the edge, 1 ... kMostSnapshotPx
    // Snapshots asked for longest ago go first; the newest stays, however large it is.
    std::size_t mostBytes = std::size_t{64} << 20;
};

class SnapshotCache {
  public:
    // Fails when sizePx is out of range.
    [[nodiscard]] static Result<SnapshotCache> create(ViewSet views, SnapshotLight light,
                                                      const SnapshotCacheOptions& options = {});

    // The snapshot of a view, cast on all cores if it is not held. `sigmaInForce` (sigma times the
    // entity's scale) is the resolution of kind `sprite`, where each has its own snapshots; kind
    // `seed` takes no notice of it. The octree is the one that edited() was told of, if it ever
    // changed; an octree of another size or root makes the cache forget all.
    [[nodiscard]] Result<std::shared_ptr<const Snapshot>> at(int view, const OctreeView& octree,
                                                             double sigmaInForce = 1.0);
    // All of the set, in order.
    [[nodiscard]] Status build(const OctreeView& octree, double sigmaInForce = 1.0);
    // Of the snapshots that are held, the one whose view is nearest (ViewSet's rule for ties);
    // null when there is none, or no direction. What a renderer that may not wait shows.
    [[nodiscard]] std::shared_ptr<const Snapshot> nearestHeld(glm::dvec3 towardEye,
                                                              double sigmaInForce = 1.0) const;

    // Other colours or light; forgets all unless they are the same.
    void setLight(SnapshotLight light);

    // The octree was edited, inside `boxes` alone (voxels from its minimum corner). Forgets exactly
    // those snapshots of which a pixel is another now, so that what stays equals a fresh one bit
    // for bit: of each snapshot the pixels that the boxes can reach are cast again and compared,
    // until one differs. Those are the pixels that a box covers, where faces ask what stands around
    // them (occlusion) a box grown by as far as they look, and with shadows all.
    struct EditReport {
        int kept = 0;
        int forgotten = 0;
        std::uint64_t rays = 0;
    };
    EditReport edited(const OctreeView& octree, std::span<const IBox> boxes);

    [[nodiscard]] const ViewSet& views() const { return views_; }
    [[nodiscard]] const SnapshotCacheOptions& options() const { return options_; }
    [[nodiscard]] int held() const { return static_cast<int>(entries_.size()); }
    [[nodiscard]] std::size_t bytes() const { return bytes_; }  // of all that is held
    [[nodiscard]] std::uint64_t cast() const { return cast_; }  // snapshots, ever
    void clear();

  private:
    // Where the octree lies; its content is known by edited() alone.
    struct Shape {
        glm::ivec3 size{0};
        int maxDepth = 0;
        glm::ivec3 treeFromVoxel{0};
        bool operator==(const Shape&) const = default;
    };
    using Key = std::pair<int, double>;  // view and sigma; sigma 0 for kind seed
    struct Entry {
        std::shared_ptr<const Snapshot> snapshot;
        std::uint64_t lastUse = 0;
    };

    SnapshotCache(ViewSet views, SnapshotLight light, const SnapshotCacheOptions& options)
        : views_(std::move(views)), light_(std::move(light)), options_(options) {}
    [[nodiscard]] double sigmaOfKey(double sigmaInForce) const {
        return options_.kind == SnapshotKind::seed ? 0.0 : sigmaInForce;
    }
    void note(const OctreeView& octree);
    void forgetOldest();
    [[nodiscard]] bool changed(const OctreeView& octree, const Key& key, const Snapshot& snapshot,
                               const IBox& box, std::uint64_t& rays) const;
    [[nodiscard]] bool seedChanged(const OctreeView& octree, const Snapshot& snapshot,
                                   const IBox& box, std::uint64_t& rays) const;
    [[nodiscard]] bool spriteChanged(const OctreeView& octree, double sigma,
                                     const Snapshot& snapshot, const IBox& box,
                                     std::uint64_t& rays) const;

    ViewSet views_;
    SnapshotLight light_;
    SnapshotCacheOptions options_;
    Shape shape_;
    std::map<Key, Entry> entries_;
    std::size_t bytes_ = 0;
    std::uint64_t uses_ = 0;
    std::uint64_t cast_ = 0;
};

}  // namespace voxprite
