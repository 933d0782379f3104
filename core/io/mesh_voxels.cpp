#include "core/io/mesh_voxels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <unordered_map>
#include <utility>

#include "core/base/parallel.h"
#include "core/io/colour_reduction.h"
#include "core/io/mesh_band.h"
#include "core/io/mesh_inside.h"
#include "core/io/nearest_triangle.h"
#include "core/model/range_check.h"

namespace voxprite {
namespace {

// What rounding may do to a surface that lies on the faces of voxels, in voxels.
constexpr double kSlack = 1e-3;
// Cells that triangles are compared with, in all: some ten seconds.
constexpr double kMostWork = 3e8;
// Cubes of 8 cells near the surface: each takes some 6 KB while the work lasts.
constexpr std::size_t kMostBlocks = std::size_t{1} << 18;
constexpr int kEdge = 8;
constexpr std::size_t kBlockCells = 512;
// From this depth on a cube of 8 cells has one colour.
constexpr double kDeep = 8.0;
// Whether cells inside stand for a point of the surface: their share around it.
constexpr double kStoodFor = 0.15;

struct Frame {
    glm::dvec3 origin{0.0};  // of the grid, in the file's space
    double edge = 1.0;       // of a voxel
    glm::ivec3 size{1};      // of the grid, in voxels
};

Result<Frame> frameOf(const TriangleMesh& mesh, const MeshReadOptions& options) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    glm::dvec3 low(kFar), high(-kFar);
    for (const MeshTriangle& triangle : mesh.triangles) {
        for (const MeshCorner& corner : triangle.corners) {
            low = glm::min(low, corner.position);
            high = glm::max(high, corner.position);
        }
    }
    const glm::dvec3 extent = high - low;
    const double longest = std::max({extent.x, extent.y, extent.z});
    if (!(longest > 0.0) || !std::isfinite(longest)) return fail("the mesh has no extent");
    Frame frame;
    frame.edge = options.voxelsPerUnit > 0.0 ? 1.0 / options.voxelsPerUnit
                                             : longest / static_cast<double>(options.resolution);
    if (!(frame.edge > 0.0) || longest / frame.edge > kMaxMeshResolution + 0.5) {
        return fail("the mesh would be " + textFromNumber(std::ceil(longest / frame.edge)) +
                    " voxels long; at most " + std::to_string(kMaxMeshResolution) + " are made");
    }
    for (int axis = 0; axis < 3; ++axis) {
        const double length = extent[axis] / frame.edge;
        const double voxels = std::max(1.0, std::ceil(length - kSlack));
        frame.size[axis] = static_cast<int>(voxels);
        // In the middle; not at all where only rounding is to blame.
        const double spare = voxels - length;
        frame.origin[axis] = low[axis] - (spare > kSlack ? spare / 2.0 : 0.0) * frame.edge;
    }
    return frame;
}

// Counts what OpenVDB will look at, before it does.
Status checkWork(const TriangleMesh& mesh, glm::ivec3 size) {
    double work = 0.0;
    const glm::ivec3 blocks = (size + kEdge - 1) / kEdge + 2;
    std::vector<bool> near(static_cast<std::size_t>(blocks.x) * static_cast<std::size_t>(blocks.y) *
                           static_cast<std::size_t>(blocks.z));
    std::size_t count = 0;
    const auto tooMuch = [] {
        return fail("the mesh has too much surface at this resolution; choose a lower one");
    };
    for (const MeshTriangle& triangle : mesh.triangles) {
        const glm::dvec3& a = triangle.corners[0].position;
        const glm::dvec3& b = triangle.corners[1].position;
        const glm::dvec3& c = triangle.corners[2].position;
        const glm::dvec3 low = glm::min(glm::min(a, b), c), high = glm::max(glm::max(a, b), c);
        const glm::dvec3 extent = high - low + 1.0;
        const glm::dvec3 across = glm::cross(b - a, c - a);
        const double area = glm::length(across) / 2.0;
        // OpenVDB's cells, and those that the lines of insideOf look at.
        work += 4.0 * area + 6.0 * (extent.x + extent.y + extent.z) +
                (extent.x * extent.y + extent.y * extent.z + extent.z * extent.x) / 4.0;
        if (work > kMostWork) return tooMuch();
        const glm::dvec3 normal = area > 0.0 ? across / (2.0 * area) : glm::dvec3(0.0);
        // Half a cube's diagonal, and how far the band reaches.
        constexpr double kReach = kEdge * 0.8660254 + 2.0;
        const glm::ivec3 first = glm::max(glm::ivec3(glm::floor((low - 2.0) / 8.0)) + 1, 0);
        const glm::ivec3 last =
            glm::min(glm::ivec3(glm::floor((high + 2.0) / 8.0)) + 1, blocks - 1);
        for (int z = first.z; z <= last.z; ++z) {
            for (int y = first.y; y <= last.y; ++y) {
                for (int x = first.x; x <= last.x; ++x) {
                    const glm::dvec3 centre = (glm::dvec3(x, y, z) - 0.5) * 8.0;
                    work += 1.0;
                    if (std::abs(glm::dot(centre - a, normal)) > kReach) continue;
                    const auto at =
                        (static_cast<std::size_t>(z) * static_cast<std::size_t>(blocks.y) +
                         static_cast<std::size_t>(y)) *
                            static_cast<std::size_t>(blocks.x) +
                        static_cast<std::size_t>(x);
                    if (near[at]) continue;
                    near[at] = true;
                    if (++count > kMostBlocks) return tooMuch();
                }
            }
        }
    }
    return {};
}

// Alpha of cells that have no open face: their colours do not compete for the palette.
constexpr std::uint8_t kHidden = 254;

// A cube of 8 cells: colours by cell, in VoxelBlock's order, alpha 0 for empty; or one for all.
struct ColouredBlock {
    glm::ivec3 origin{0};
    bool uniform = false;
    std::vector<Rgba8> colours;
};

class Voxeliser {
  public:
    Voxeliser(const TriangleMesh& mesh, glm::ivec3 size, bool solid, InsideCells inside,
              std::unique_ptr<NearestTriangles> band)
        : mesh_(mesh),
          size_(size),
          solid_(solid),
          closed_(inside.closed),
          inside_(std::move(inside.cells)),
          band_(std::move(band)),
          tree_(mesh.triangles) {}

    std::vector<ColouredBlock> run(int threads) {
        const glm::ivec3 blocks = (size_ + kEdge - 1) / kEdge;
        const int layer = blocks.x * blocks.y;
        std::vector<ColouredBlock> made(static_cast<std::size_t>(layer) *
                                        static_cast<std::size_t>(blocks.z));
        parallelFor(static_cast<int>(made.size()), threads, [&](int first, int last) {
            for (int k = first; k < last; ++k) {
                const glm::ivec3 block(k % blocks.x, k % layer / blocks.x, k / layer);
                made[static_cast<std::size_t>(k)] = blockAt(block * kEdge);
            }
        });
        std::erase_if(made, [](const ColouredBlock& block) { return block.colours.empty(); });
        return made;
    }

  private:
    [[nodiscard]] ColouredBlock blockAt(glm::ivec3 origin) const {
        ColouredBlock block;
        block.origin = origin;
        const std::int32_t* near = band_->blockAt(origin);
        if (near == nullptr) {
            const int inside = insideCount(origin);
            if (inside == 0) return block;
            if (inside == static_cast<int>(kBlockCells)) {
                const SurfacePoint deep = tree_.nearest(glm::dvec3(origin) + kEdge / 2.0);
                if (deep.squaredDistance > kDeep * kDeep) {
                    // Too deep for the surface's own: nothing here has an empty neighbour.
                    if (closed_ && !solid_) return block;
                    block.uniform = true;
                    block.colours = {hidden(colourOf(deep).value_or(Rgba8(0, 0, 0, 255)))};
                    return block;
                }
            }
        }
        std::vector<Rgba8> colours(kBlockCells, Rgba8(0));
        bool any = false;
        std::uint32_t hint = 0;
        for (std::size_t k = 0; k < kBlockCells; ++k) {
            const glm::ivec3 cell =
                origin + glm::ivec3(static_cast<int>(k >> 6), static_cast<int>(k >> 3 & 7),
                                    static_cast<int>(k & 7));
            const std::int32_t triangle = near == nullptr ? -1 : near[k];
            if (triangle >= 0) hint = static_cast<std::uint32_t>(triangle);
            colours[k] = cellColour(cell, triangle, hint);
            any = any || colours[k].w != 0;
        }
        if (any) block.colours = std::move(colours);
        return block;
    }

    [[nodiscard]] int insideCount(glm::ivec3 origin) const {
        int count = 0;
        for (int z = 0; z < kEdge; ++z) {
            for (int y = 0; y < kEdge; ++y) {
                for (int x = 0; x < kEdge; ++x) count += inside_.at(origin + glm::ivec3(x, y, z));
            }
        }
        return count;
    }

    // Alpha 0: there is no voxel. Leaves in `hint` a triangle that is near to the next cell.
    [[nodiscard]] Rgba8 cellColour(glm::ivec3 cell, std::int32_t triangle,
                                   std::uint32_t& hint) const {
        if (glm::any(glm::greaterThanEqual(cell, size_))) return Rgba8(0);
        const glm::dvec3 centre = glm::dvec3(cell) + 0.5;
        const bool inside = inside_.at(cell);
        std::optional<SurfacePoint> near;
        if (triangle >= 0) {
            const auto index = static_cast<std::uint32_t>(triangle);
            near = nearestOnTriangle(mesh_.triangles[index], index, centre);
        }
        const bool kept = inside ? !closed_ || solid_ || isOpen(cell)
                                 : near && touches(*near, centre) && !isStoodFor(near->position);
        if (!kept) return Rgba8(0);
        // The band knows the nearest triangle only of cells that the surface is close to.
        constexpr double kSure = 0.86;
        if (!near || near->squaredDistance > kSure * kSure) near = tree_.nearest(centre, hint);
        if (inside && closed_ && !isBehind(mesh_.triangles[near->triangle], *near, centre)) {
            near = tree_.nearestFromBehind(centre, *near, kSlack);
        }
        hint = near->triangle;
        const Rgba8 colour = colourOf(*near).value_or(Rgba8(0));
        return colour.w != 0 && inside && !isOpen(cell) ? hidden(colour) : colour;
    }

    [[nodiscard]] static Rgba8 hidden(Rgba8 colour) {
        colour.w = kHidden;
        return colour;
    }

    // Whether the surface passes within half a voxel; at just half, whether the cell is behind it.
    [[nodiscard]] bool touches(const SurfacePoint& near, const glm::dvec3& centre) const {
        const double distance = std::sqrt(near.squaredDistance);
        if (std::abs(distance - 0.5) > kSlack) return distance < 0.5;
        return isBehind(mesh_.triangles[near.triangle], near, centre);
    }

    // Whether cells inside already show this point of a closed surface.
    [[nodiscard]] bool isStoodFor(const glm::dvec3& point) const {
        if (!closed_) return false;
        const glm::dvec3 at = point - 0.5;
        const glm::ivec3 low(glm::floor(at));
        const glm::dvec3 share = at - glm::dvec3(low);
        double sum = 0.0;
        for (int k = 0; k < 8; ++k) {
            const glm::ivec3 step(k & 1, k >> 1 & 1, k >> 2);
            if (!inside_.at(low + step)) continue;
            double weight = 1.0;
            for (int axis = 0; axis < 3; ++axis) {
                weight *= step[axis] == 1 ? share[axis] : 1.0 - share[axis];
            }
            sum += weight;
        }
        return sum >= kStoodFor;
    }

    [[nodiscard]] bool isOpen(glm::ivec3 cell) const {
        for (int axis = 0; axis < 3; ++axis) {
            for (const int step : {-1, 1}) {
                glm::ivec3 beside = cell;
                beside[axis] += step;
                if (!inside_.at(beside)) return true;
            }
        }
        return false;
    }

    [[nodiscard]] std::optional<Rgba8> colourOf(const SurfacePoint& point) const {
        return colourAt(mesh_, mesh_.triangles[point.triangle], point.weights);
    }

    const TriangleMesh& mesh_;
    glm::ivec3 size_;
    bool solid_;
    bool closed_;
    CellMask inside_;
    std::unique_ptr<NearestTriangles> band_;
    NearestTriangle tree_;
};

// Where the file's origin lies, unless that is too far from the model to be meant.
std::optional<glm::dvec3> anchorFrom(const Frame& frame) {
    const glm::dvec3 size(frame.size);
    const double reach = 2.0 * std::max({size.x, size.y, size.z});
    glm::dvec3 anchor = -frame.origin / frame.edge;
    for (int axis = 0; axis < 3; ++axis) {
        // What rounding did to halves of voxels.
        const double half = std::round(anchor[axis] * 2.0) / 2.0;
        if (std::abs(anchor[axis] - half) < kSlack) anchor[axis] = half;
        if (anchor[axis] < -reach || anchor[axis] > size[axis] + reach) return std::nullopt;
    }
    if (anchor == glm::dvec3(size.x / 2.0, size.y / 2.0, 0.0)) return std::nullopt;
    return anchor;
}

void setBlocks(const std::vector<ColouredBlock>& blocks, LoadedDocument& loaded) {
    ColourCount count;
    for (const ColouredBlock& block : blocks) {
        // Neighbours mostly look alike: counted run by run.
        const auto end = block.colours.end();
        for (auto first = block.colours.begin(); first != end;) {
            const Rgba8 colour = *first;
            const auto last = std::find_if(first, end, [&](Rgba8 c) { return c != colour; });
            if (colour.w == 255) count.add(colour, static_cast<std::uint64_t>(last - first));
            first = last;
        }
    }
    const ReducedColours reduced = reduceColours(count);
    loaded.document.palette = reduced.palette;
    if (const auto warning = reduced.warning()) loaded.warnings.push_back(*warning);

    // What was not counted takes the nearest colour, which is looked for once.
    std::unordered_map<std::uint32_t, std::uint8_t> indices;
    const auto indexOf = [&](Rgba8 colour) -> std::uint8_t {
        if (colour.w == 0) return 0;
        const auto key = static_cast<std::uint32_t>(colour.x << 16 | colour.y << 8 | colour.z);
        const auto [found, fresh] = indices.try_emplace(key, std::uint8_t{0});
        if (fresh) found->second = reduced.indexOf(Rgba8(colour.x, colour.y, colour.z, 255));
        return found->second;
    };
    VoxelGrid& voxels = loaded.document.models[0].voxels;
    std::array<std::uint8_t, kBlockCells> values{};
    for (const ColouredBlock& block : blocks) {
        if (block.uniform) {
            voxels.fill({block.origin, block.origin + kEdge}, indexOf(block.colours[0]));
            continue;
        }
        Rgba8 last(0);
        std::uint8_t index = 0;
        for (std::size_t k = 0; k < kBlockCells; ++k) {
            const Rgba8 colour = block.colours[k];
            if (colour != last) index = indexOf(colour);
            last = colour;
            values[k] = index;
        }
        voxels.setBlock(block.origin, values.data());
    }
}

}  // namespace

Status validate(const MeshReadOptions& options) {
    if (options.resolution < 1 || options.resolution > kMaxMeshResolution) {
        return fail("the resolution is " + std::to_string(options.resolution) +
                    "; it must be between 1 and " + std::to_string(kMaxMeshResolution));
    }
    if (options.voxelsPerUnit == 0.0) return {};
    return checkRange("voxels per unit", options.voxelsPerUnit, 1e-6, 1e6);
}

Result<LoadedDocument> voxelsOf(TriangleMesh mesh, const MeshReadOptions& options) {
    if (Status s = validate(options); !s) return Failure(s.error());
    if (mesh.triangles.empty()) return fail("the file holds no triangles");
    const Result<Frame> frame = frameOf(mesh, options);
    if (!frame) return Failure(frame.error());
    for (MeshTriangle& triangle : mesh.triangles) {
        for (MeshCorner& corner : triangle.corners) {
            corner.position = (corner.position - frame->origin) / frame->edge;
        }
    }
    if (Status s = checkWork(mesh, frame->size); !s) return Failure(s.error());
    // The lowest index wins from here on.
    std::ranges::reverse(mesh.triangles);

    LoadedDocument loaded{.document = Document::withEmptyModel()};
    InsideCells inside = insideOf(mesh.triangles, frame->size);
    if (!inside.closed) {
        loaded.warnings.emplace_back(
            options.solid
                ? "the mesh is not closed: it is filled where a flood from outside does not reach"
                : "the mesh is not closed: its surface alone is made into voxels");
        if (options.solid) {
            Result<CellMask> flooded = floodedInside(mesh.triangles, frame->size);
            if (!flooded) return Failure(flooded.error());
            inside.cells = std::move(*flooded);
        }
    }
    Result<std::unique_ptr<NearestTriangles>> band = surfaceBand(mesh.triangles);
    if (!band) return Failure(band.error());
    Voxeliser voxeliser(mesh, frame->size, options.solid, std::move(inside), std::move(*band));
    setBlocks(voxeliser.run(options.threads), loaded);
    if (loaded.document.models[0].voxels.empty()) return fail("the mesh touches no voxel");
    loaded.document.entity.anchorVoxels = anchorFrom(*frame);
    if (frame->edge >= 1e-6 && frame->edge <= 1e6) {
        loaded.document.authored.voxelSizeMetres = frame->edge;
    }
    return loaded;
}

}  // namespace voxprite
