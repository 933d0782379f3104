#include "core/billboard/snapshot_cache.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <string>

namespace voxprite {

namespace {

// Rows that are cast and compared at one go: a change is mostly found in the first.
constexpr int kRowsAtOnce = 8;

// The pixels of a `seed` snapshot whose rays can meet a box, and one more all round. The rays walk
// at most raySlack() beside where they are aimed.
PixelRect reachedBy(const IBox& box, const SnapshotCamera& camera, double slack) {
    glm::dvec2 low(std::numeric_limits<double>::infinity());
    glm::dvec2 high = -low;
    for (unsigned octant = 0; octant < 8; ++octant) {
        const glm::dvec3 side(octantCorner(octant));
        const glm::dvec3 corner =
            glm::mix(glm::dvec3(box.min) - slack, glm::dvec3(box.max) + slack, side);
        const glm::dvec2 pixel = camera.project(corner);
        low = glm::min(low, pixel);
        high = glm::max(high, pixel);
    }
    const glm::dvec2 edge(camera.sizePx);
    return {glm::ivec2(glm::clamp(glm::floor(low) - 1.0, glm::dvec2(0.0), edge)),
            glm::ivec2(glm::clamp(glm::ceil(high) + 1.0, glm::dvec2(0.0), edge))};
}

// The part of a lattice whose rays can meet a box, exactly: that of a model which is the box.
Result<PixelBounds> reachedBy(const IBox& box, LatticeView lattice) {
    lattice.C -= box.min * (1 << lattice.positionBits);
    return pixelBounds(lattice, box.size());
}

std::size_t indexIn(const SpriteBuffer& buffer, int column, int row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(buffer.size.x) +
           static_cast<std::size_t>(column);
}

// Does row `row` of `part`, so many pixels wide, lie in `all` from (column, line) on?
template <class Array>
bool sameRow(const Array& part, int row, int width, const Array& all, std::size_t from) {
    const auto first = part.begin() + static_cast<std::ptrdiff_t>(row) * width;
    return std::equal(first, first + width, all.begin() + static_cast<std::ptrdiff_t>(from));
}

}  // namespace

Result<SnapshotCache> SnapshotCache::create(ViewSet views, SnapshotLight light,
                                            const SnapshotCacheOptions& options) {
    if (options.sizePx < 1 || options.sizePx > kMostSnapshotPx) {
        return fail("a snapshot is 1 ... " + std::to_string(kMostSnapshotPx) +
                    " pixels wide, not " + std::to_string(options.sizePx));
    }
    return SnapshotCache(std::move(views), std::move(light), options);
}

void SnapshotCache::clear() {
    entries_.clear();
    bytes_ = 0;
}

void SnapshotCache::note(const OctreeView& octree) {
    const Shape shape{octree.size, octree.maxDepth, octree.treeFromVoxel};
    if (shape != shape_) clear();
    shape_ = shape;
}

void SnapshotCache::setLight(SnapshotLight light) {
    if (light == light_) return;
    light_ = std::move(light);
    clear();
}

Result<std::shared_ptr<const Snapshot>> SnapshotCache::at(int view, const OctreeView& octree,
                                                          double sigmaInForce) {
    note(octree);
    const Key key{view, sigmaOfKey(sigmaInForce)};
    const auto found = entries_.find(key);
    if (found != entries_.end()) {
        found->second.lastUse = ++uses_;
        return found->second.snapshot;
    }
    std::shared_ptr<const Snapshot> snapshot;
    if (options_.kind == SnapshotKind::seed) {
        snapshot =
            std::make_shared<Snapshot>(castSnapshot(octree, light_, views_, view, options_.sizePx));
    } else {
        Result<Snapshot> sprite = castSpriteSnapshot(octree, light_, views_, view, sigmaInForce);
        if (!sprite) return Failure(sprite.error());
        snapshot = std::make_shared<Snapshot>(std::move(*sprite));
    }
    ++cast_;
    bytes_ += snapshot->bytes();
    entries_.emplace(key, Entry{snapshot, ++uses_});
    while (bytes_ > options_.mostBytes && entries_.size() > 1) forgetOldest();
    return snapshot;
}

void SnapshotCache::forgetOldest() {
    const auto oldest = std::ranges::min_element(
        entries_, {}, [](const auto& item) { return item.second.lastUse; });
    bytes_ -= oldest->second.snapshot->bytes();
    entries_.erase(oldest);
}

Status SnapshotCache::build(const OctreeView& octree, double sigmaInForce) {
    for (int view = 0; view < views_.count(); ++view) {
        if (const auto made = at(view, octree, sigmaInForce); !made) return Failure(made.error());
    }
    return {};
}

std::shared_ptr<const Snapshot> SnapshotCache::nearestHeld(glm::dvec3 towardEye,
                                                           double sigmaInForce) const {
    const std::optional<int> wanted = views_.nearest(towardEye);
    if (!wanted) return nullptr;
    const double sigma = sigmaOfKey(sigmaInForce);
    const auto exact = entries_.find({*wanted, sigma});
    if (exact != entries_.end()) return exact->second.snapshot;
    std::shared_ptr<const Snapshot> nearest;
    double largest = -std::numeric_limits<double>::infinity();
    for (const auto& [key, entry] : entries_) {
        const double product = glm::dot(views_.direction(key.first), towardEye);
        if (key.second != sigma || product <= largest) continue;
        largest = product;
        nearest = entry.snapshot;
    }
    return nearest;
}

SnapshotCache::EditReport SnapshotCache::edited(const OctreeView& octree,
                                                std::span<const IBox> boxes) {
    EditReport report;
    const int before = held();
    note(octree);
    if (entries_.empty()) {
        report.forgotten = before;
        return report;
    }
    for (auto entry = entries_.begin(); entry != entries_.end();) {
        const Snapshot& snapshot = *entry->second.snapshot;
        const bool other = std::ranges::any_of(boxes, [&](const IBox& box) {
            return changed(octree, entry->first, snapshot, box, report.rays);
        });
        ++(other ? report.forgotten : report.kept);
        if (other) bytes_ -= snapshot.bytes();
        entry = other ? entries_.erase(entry) : std::next(entry);
    }
    return report;
}

bool SnapshotCache::changed(const OctreeView& octree, const Key& key, const Snapshot& snapshot,
                            const IBox& edit, std::uint64_t& rays) const {
    const FaceRays& asked = light_.along({0, 0, 1}).rays;
    const IBox model{glm::ivec3(0), octree.size};
    IBox box = edit;
    // From the cell in front of a face, and that is one from its voxel.
    if (asked.occlusion && !box.empty()) {
        box.min -= kOcclusionReach + 1;
        box.max += kOcclusionReach + 1;
    }
    box = asked.shadows() && !box.empty() ? model : box.intersected(model);
    if (box.empty()) return false;
    return options_.kind == SnapshotKind::seed
               ? seedChanged(octree, snapshot, box, rays)
               : spriteChanged(octree, key.second, snapshot, box, rays);
}

bool SnapshotCache::seedChanged(const OctreeView& octree, const Snapshot& snapshot, const IBox& box,
                                std::uint64_t& rays) const {
    const SnapshotCamera camera(views_, snapshot.view, octree.size, options_.sizePx);
    const PixelRect all = reachedBy(box, camera, 2.0 * raySlack(octree));
    const int width = all.max.x - all.min.x;
    for (int first = all.min.y; first < all.max.y; first += kRowsAtOnce) {
        const PixelRect rows{{all.min.x, first},
                             {all.max.x, std::min(first + kRowsAtOnce, all.max.y)}};
        const SnapshotPixels now = castSnapshotPixels(octree, light_, camera, rows);
        rays += now.ids.size();
        for (int row = 0; row < rows.max.y - rows.min.y; ++row) {
            const std::size_t from = indexIn(snapshot.buffer, rows.min.x, rows.min.y + row);
            if (!sameRow(now.ids, row, width, snapshot.buffer.ids, from) ||
                !sameRow(now.colours, row, width, snapshot.buffer.colours, from) ||
                !sameRow(now.depth, row, width, snapshot.depth, from)) {
                return true;
            }
        }
    }
    return false;
}

bool SnapshotCache::spriteChanged(const OctreeView& octree, double sigma, const Snapshot& snapshot,
                                  const IBox& box, std::uint64_t& rays) const {
    Result<LatticeView> lattice = snapshotLattice(views_, snapshot.view, sigma, octree.size);
    const Result<PixelBounds> reached =
        lattice ? reachedBy(box, *lattice) : Failure(lattice.error());
    if (!reached) return true;
    // The rows of the buffer run downward, those of the lattice upward.
    const glm::ivec2 low = glm::max(reached->first, lattice->first);
    const glm::ivec2 high =
        glm::min(reached->first + reached->size, lattice->first + lattice->size);
    LitPalette lit = light_.along(glm::dvec3(lattice->D));
    lit.outline.enabled = false;
    const int top = lattice->first.y + lattice->size.y;
    for (int end = high.y; end > low.y; end -= kRowsAtOnce) {
        LatticeView part = *lattice;
        part.first = {low.x, std::max(low.y, end - kRowsAtOnce)};
        part.size = {std::max(0, high.x - low.x), end - part.first.y};
        const SpriteBuffer now = castSprite(octree, part, lit);
        rays += now.ids.size();
        for (int row = 0; row < part.size.y; ++row) {
            for (int column = 0; column < part.size.x; ++column) {
                const std::size_t here = indexIn(now, column, row);
                const std::size_t there =
                    indexIn(snapshot.buffer, low.x - lattice->first.x + column, top - end + row);
                // Outlines follow from what is hit, and so do depths.
                const bool hit = now.ids[here] >= kIdFirstVoxel;
                const bool wasHit = snapshot.buffer.ids[there] >= kIdFirstVoxel;
                if (hit != wasHit) return true;
                if (hit && (now.ids[here] != snapshot.buffer.ids[there] ||
                            now.colours[here] != snapshot.buffer.colours[there])) {
                    return true;
                }
            }
        }
    }
    return false;
}

}  // namespace voxprite
