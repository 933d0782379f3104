#include "core/svo/bake.h"

#include <atomic>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/svo/bake_on_threads.h"
#include "core/svo/region_baker.h"
#include "core/svo/tree_builder.h"

namespace voxprite {
namespace {

constexpr int kRegionEdge = RegionBaker::kEdge;
// Below this many blocks of the grid, waking other threads costs more than they save.
constexpr std::size_t kBlocksForThreads = 4096;
// So that one thread's long run does not keep the others waiting.
constexpr std::size_t kRunsAThread = 4;

std::int64_t volume(const IBox& box) {
    const glm::ivec3 size = box.size();
    return std::int64_t{size.x} * size.y * size.z;
}

// Goes down from the root with the grid's regions that touch each cube. They need not be aligned to
// the cubes: those across a border go to both sides. Cubes of kRegionEdge are each a RegionBaker's,
// and those that follow one another may be baked by different threads.
class Baker {
  public:
    Baker(const VoxelGrid& voxels, const IBox& bounds)
        : bounds_(bounds), builder_(depthForSize(bounds.size())) {
        voxels.forEachRegion([this](const VoxelRegion& region) { addSource(region); });
    }

    Result<Octree> run(int threads) {
        const bool small = threads <= 0 && blocks_ < kBlocksForThreads;
        if (small || threads == 1 || builder_.maxDepth() < 7) {
            RegionBaker regions(bounds_, builder_);
            builder_.reserve(blocks_);
            const std::uint32_t root = cube(builder_, 0, glm::ivec3(0), 0, [&](const Job& job) {
                return regions.bake(job.min, job.sources);
            });
            return builder_.finish(root, bounds_.size(), bounds_.min);
        }
        return runOnThreads(threads);
    }

  private:
    void addSource(const VoxelRegion& region) {
        const IBox box = bounds_.intersected({region.origin, region.origin + region.edgeVoxels});
        if (box.empty()) return;
        pending_.push_back({{box.min - bounds_.min, box.max - bounds_.min}, region});
        blocks_ += static_cast<std::size_t>(region.blockCount);
    }

    // A region of the grid, and what of it lies within the bounds, in tree space.
    struct Source {
        IBox box;
        VoxelRegion region;
    };
    // A cube of kRegionEdge voxels (or the whole tree, if that is smaller).
    struct Job {
        glm::ivec3 min;
        std::vector<VoxelRegion> sources;
    };

    Result<Octree> runOnThreads(int threads) {
        // Which cubes there are is found out by going down once for nothing.
        std::vector<Job> jobs;
        TreeBuilder sketch(builder_.maxDepth());
        static_cast<void>(cube(sketch, 0, glm::ivec3(0), 0, [&](Job job) {
            jobs.push_back(std::move(job));
            return node::brick(0);
        }));
        if (sketch.full()) return sketch.finish(0, bounds_.size(), bounds_.min);

        // Runs of cubes of about as many blocks.
        const auto workers = static_cast<std::size_t>(threads > 0 ? threads : hardwareThreads());
        const std::size_t blocksARun = blocks_ / (workers * kRunsAThread) + 1;
        std::vector<std::size_t> runs{0};
        std::vector<std::size_t> blocksOfRuns;
        std::size_t blocks = 0;
        for (std::size_t k = 0; k < jobs.size(); ++k) {
            for (const VoxelRegion& source : jobs[k].sources) {
                blocks += static_cast<std::size_t>(source.blockCount);
            }
            if (blocks < blocksARun && k + 1 < jobs.size()) continue;
            runs.push_back(k + 1);
            blocksOfRuns.push_back(std::exchange(blocks, 0U));
        }

        std::vector<TreeBuilder> parts;
        while (parts.size() + 1 < runs.size()) parts.emplace_back(builder_.maxDepth());
        std::vector<std::uint32_t> words(jobs.size());
        std::atomic<std::uint64_t> nodes{0};
        parallelFor(static_cast<int>(parts.size()), threads, [&](int first, int last) {
            for (auto part = static_cast<std::size_t>(first); part < static_cast<std::size_t>(last);
                 ++part) {
                RegionBaker regions(bounds_, parts[part]);
                parts[part].reserve(blocksOfRuns[part]);
                for (std::size_t k = runs[part]; k < runs[part + 1]; ++k) {
                    if (nodes > kMaxOctreeNodes) return;  // finish() says so
                    const std::uint64_t before = parts[part].nodeCount();
                    words[k] = regions.bake(jobs[k].min, jobs[k].sources);
                    nodes += parts[part].nodeCount() - before;
                }
            }
        });

        // Now the nodes above them; their children come after those of the parts before.
        const int childDepth = builder_.maxDepth() - 5;
        std::size_t next = 0, part = 0;
        std::uint32_t childrenBefore = 0;
        const std::uint32_t root = cube(builder_, 0, glm::ivec3(0), 0, [&](const Job&) {
            while (next == runs[part + 1]) {
                childrenBefore += static_cast<std::uint32_t>(parts[part++].nodesAt(childDepth));
            }
            const std::uint32_t word = words[next++];
            return node::isInternal(word) ? word + (childrenBefore << 8) : word;
        });
        return builder_.finish(root, bounds_.size(), bounds_.min, parts, threads);
    }

    // The word of a cube at `min`; pending_[first, end) are the sources that touch it. Those of
    // kRegionEdge that are not of one material are bakeRegion's.
    template <class BakeRegion>
    [[nodiscard]] std::uint32_t cube(TreeBuilder& builder, int depth, glm::ivec3 min,
                                     std::size_t first, const BakeRegion& bakeRegion) {
        const std::size_t last = pending_.size();
        if (first == last || builder.full()) return 0;
        const int edge = 1 << (builder.maxDepth() - depth);
        if (const std::uint8_t value = coveringValue({min, min + edge}, first); value != 0) {
            return node::uniform(value);
        }
        if (edge <= kRegionEdge) {
            Job job{min, {}};
            for (std::size_t i = first; i < last; ++i) job.sources.push_back(pending_[i].region);
            return bakeRegion(std::move(job));
        }
        return builder.internal(depth, [&](unsigned octant) {
            const glm::ivec3 childMin = min + octantCorner(octant) * (edge / 2);
            const glm::ivec3 childMax = childMin + edge / 2;
            for (std::size_t i = first; i < last; ++i) {
                const IBox& b = pending_[i].box;
                if (b.min.x < childMax.x && b.max.x > childMin.x && b.min.y < childMax.y &&
                    b.max.y > childMin.y && b.min.z < childMax.z && b.max.z > childMin.z) {
                    const Source source = pending_[i];
                    pending_.push_back(source);
                }
            }
            const std::uint32_t word = cube(builder, depth + 1, childMin, last, bakeRegion);
            pending_.resize(last);
            return word;
        });
    }

    // The material that fills the whole cube, or 0. Sources do not overlap, so volumes tell.
    [[nodiscard]] std::uint8_t coveringValue(const IBox& box, std::size_t first) const {
        const std::uint8_t value = pending_[first].region.uniformValue;
        std::int64_t covered = 0;
        for (std::size_t i = first; i < pending_.size(); ++i) {
            const Source& source = pending_[i];
            if (source.region.blocks != nullptr || source.region.uniformValue != value) return 0;
            covered += volume(source.box.intersected(box));
        }
        return covered == volume(box) ? value : std::uint8_t{0};
    }

    IBox bounds_;
    TreeBuilder builder_;
    std::size_t blocks_ = 0;
    std::vector<Source> pending_;  // all of them, then those of the cubes on the way down
};

void unpack(const Octree& octree, std::uint32_t word, int depth, glm::ivec3 min,
            VoxelGrid& voxels) {
    const int edge = 1 << (octree.maxDepth - depth);
    if (node::isUniform(word)) {
        voxels.fill({min, min + edge}, static_cast<std::uint8_t>(word));
    } else if (node::isBrick(word)) {
        const std::uint64_t payload = octree.payloads[node::payloadIndex(word)];
        for (unsigned octant = 0; octant < 8; ++octant) {
            const std::uint8_t material = payloadMaterial(payload, octant);
            if (material != 0) voxels.set(min + octantCorner(octant), material);
        }
    } else if (node::isInternal(word)) {
        for (unsigned octant = 0; octant < 8; ++octant) {
            if (!node::hasChild(word, octant)) continue;
            unpack(octree, octree.nodes[node::childIndex(word, octant)], depth + 1,
                   min + octantCorner(octant) * (edge / 2), voxels);
        }
    }
}

}  // namespace

Result<Octree> bake(const VoxelGrid& voxels, const IBox& bounds) {
    return bakeOnThreads(voxels, bounds, 0);
}

Result<Octree> bakeOnThreads(const VoxelGrid& voxels, const IBox& bounds, int threads) {
    if (bounds.empty()) return Octree{};
    if (auto fits = checkOctreeSize(bounds.size()); !fits) return tl::unexpected(fits.error());
    return Baker(voxels, bounds).run(threads);
}

Result<Octree> bake(const VoxelGrid& voxels) {
    return bake(voxels, voxels.bounds());
}

VoxelGrid toVoxels(const Octree& octree) {
    VoxelGrid voxels;
    unpack(octree, octree.nodes[0], 0, octree.origin, voxels);
    return voxels;
}

}  // namespace voxprite
