#include "core/lod/cluster_mesh.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <string>

#include "core/base/check.h"
#include "core/base/parallel.h"
#include "core/lod/brick_quads.h"
#include "core/lod/cluster_cut.h"
#include "core/lod/octree_boxes.h"
#include "core/lod/validate_clusters.h"
#include "core/svo/coarsen.h"

namespace voxprite {
namespace {

// A brick that holds anything, and what it draws.
struct Brick {
    glm::ivec3 at{0};  // in bricks of its level, from the tree's origin
    std::vector<ClusterVertex> vertices;
    bool hasSurface = false;  // some finest brick within draws something
};

// Finds the bricks of a level in the tree, depth first and in octant order: so the bricks that one
// of the next level covers stand together, and parents are in the order of their children.
class BrickFinder {
  public:
    BrickFinder(const OctreeView& octree, int log2Edge) : octree_(octree), log2Edge_(log2Edge) {}

    std::vector<Brick> run() {
        visit(octree_.nodes[0], glm::ivec3(0), octree_.maxDepth);
        return std::move(bricks_);
    }

  private:
    void visit(std::uint32_t word, glm::ivec3 min, int log2Edge) {
        if (node::isEmpty(word)) return;
        if (node::isUniform(word) && buried(min, 1 << log2Edge)) return;
        if (log2Edge <= log2Edge_) {
            bricks_.push_back({min >> log2Edge_, {}, false});
            return;
        }
        for (unsigned octant = 0; octant < 8; ++octant) {
            std::uint32_t child = word;
            if (node::isInternal(word)) {
                if (!node::hasChild(word, octant)) continue;
                child = octree_.nodes[node::childIndex(word, octant)];
            }
            visit(child, min + octantCorner(octant) * (1 << (log2Edge - 1)), log2Edge - 1);
        }
    }

    // Solid with solids all round, so that no level draws anything in it.
    [[nodiscard]] bool buried(glm::ivec3 min, int edge) const {
        for (int axis = 0; axis < 3; ++axis) {
            IBox across{min, min + edge};
            across.min[axis] -= 1;
            across.max[axis] += 1;
            if (!solidThroughout(octree_, across)) return false;
        }
        return true;
    }

    const OctreeView& octree_;
    int log2Edge_;
    std::vector<Brick> bricks_;
};

constexpr std::uint64_t kQuadBytes = 4 * sizeof(ClusterVertex) + 6 * sizeof(std::uint32_t);

float levelError(int level) {
    return static_cast<float>(std::numbers::sqrt3 * ((1 << level) - 1));
}

class Builder {
  public:
    Builder(const OctreeView& octree, const ClusterBuildOptions& options)
        : octree_(octree),
          options_(options),
          mostQuads_(std::min(options.mostBytes / kQuadBytes,
                              std::uint64_t{std::numeric_limits<std::uint32_t>::max()} / 6)) {}

    Result<ClusterMesh> run() {
        std::vector<std::vector<Brick>> levels;
        for (int level = 0; level <= octree_.maxDepth; ++level) {
            auto bricks = meshLevel(level);
            if (!bricks) return tl::unexpected(bricks.error());
            if (quads_ > mostQuads_)
                return fail(
                    "the model's surface is too large for clusters: they would take more than " +
                    std::to_string(mostQuads_ * kQuadBytes >> 20) + " MiB");
            if (level == 0) {
                for (Brick& brick : *bricks) brick.hasSurface = !brick.vertices.empty();
            } else {
                inheritSurface(levels.back(), *bricks);
            }
            std::erase_if(*bricks, [](const Brick& brick) { return !brick.hasSurface; });
            levels.push_back(std::move(*bricks));
        }
        return assemble(levels);
    }

  private:
    [[nodiscard]] int brickLog2(int level) const {
        return level + std::countr_zero(static_cast<unsigned>(options_.brickCells));
    }

    Result<std::vector<Brick>> meshLevel(int level) {
        BrickLevel source{octree_, octree_, glm::ivec3(0), level, options_.brickCells};
        Octree coarse;
        if (level > 0) {
            auto coarser = coarsen(octree_, octree_.treeFromVoxel, level);
            if (!coarser) return tl::unexpected(coarser.error());
            coarse = std::move(*coarser);
            source.cells = coarse.view();
            source.firstCell = coarse.origin;
        }
        std::vector<Brick> bricks = BrickFinder(octree_, brickLog2(level)).run();
        parallelFor(static_cast<int>(bricks.size()), options_.threads, [&](int first, int last) {
            BrickMesher mesher(source);
            for (int i = first; i < last; ++i) {
                Brick& brick = bricks[static_cast<std::size_t>(i)];
                // Whether it ends here does not depend on the order: more quads only come to it.
                if (quads_ > mostQuads_) return;
                brick.vertices = mesher.quads(brick.at);
                quads_ += brick.vertices.size() / 4;
            }
        });
        return bricks;
    }

    // Both in the same order, children beside each other.
    static void inheritSurface(const std::vector<Brick>& children, std::vector<Brick>& parents) {
        auto parent = parents.begin();
        for (const Brick& child : children) {
            while (parent->at != child.at >> 1) ++parent;
            parent->hasSurface = true;
        }
    }

    [[nodiscard]] ClusterMesh assemble(std::vector<std::vector<Brick>>& levels) {
        std::uint64_t vertexCount = 0;
        std::size_t pageCount = 0;
        for (const std::vector<Brick>& bricks : levels) {
            pageCount += bricks.size();
            for (const Brick& brick : bricks) vertexCount += brick.vertices.size();
        }
        mesh_.treeFromVoxel = octree_.treeFromVoxel;
        if (pageCount == 0) return std::move(mesh_);
        mesh_.vertices.reserve(vertexCount);
        mesh_.indices.reserve(vertexCount / 4 * 6);
        mesh_.pages.reserve(pageCount);
        mesh_.pageLevels.reserve(pageCount);
        for (int level = 0; level <= octree_.maxDepth; ++level) {
            std::vector<Brick>& bricks = levels[static_cast<std::size_t>(level)];
            ClusterLevel summary;
            summary.firstPage = static_cast<std::uint32_t>(mesh_.pages.size());
            summary.pageCount = static_cast<std::uint32_t>(bricks.size());
            summary.errorVoxels = levelError(level);
            for (Brick& brick : bricks) {
                summary.quadCount += static_cast<std::uint32_t>(brick.vertices.size() / 4);
                addPage(brick, level);
                brick.vertices = {};  // large meshes are not held twice
            }
            mesh_.levels.push_back(summary);
        }
        mesh_.reach = clusterReach(mesh_.pages);
        VOXPRITE_CHECK(validateClusters(mesh_.pages, mesh_.indices.size()).has_value());
        return std::move(mesh_);
    }

    // Around the part of a brick that lies in the root cube: such spheres hold those of the bricks
    // that they cover.
    struct Sphere {
        glm::vec3 centre{0.0f};
        float radius = 0.0f;
    };
    [[nodiscard]] Sphere sphereOf(glm::ivec3 brick, int level) const {
        const auto edge = static_cast<float>(1 << std::min(brickLog2(level), octree_.maxDepth));
        return {glm::vec3(brick) * edge + 0.5f * edge, std::numbers::sqrt3_v<float> * 0.5f * edge};
    }

    void addPage(const Brick& brick, int level) {
        const Sphere own = sphereOf(brick.at, level);
        const bool root = level == octree_.maxDepth;
        const Sphere parents = root ? own : sphereOf(brick.at >> 1, level + 1);
        ClusterPage page;
        page.lodBoundsCentre = own.centre;
        page.lodBoundsRadius = own.radius;
        page.lodError = levelError(level);
        page.parentBoundsCentre = parents.centre;
        page.parentBoundsRadius = parents.radius;
        page.parentError = root ? std::numeric_limits<float>::infinity() : levelError(level + 1);
        page.firstIndex = static_cast<std::uint32_t>(mesh_.indices.size());
        page.indexCount = static_cast<std::uint32_t>(brick.vertices.size() / 4 * 6);
        page.centre = own.centre;
        if (!brick.vertices.empty()) {
            glm::ivec3 low(std::numeric_limits<int>::max());
            glm::ivec3 high(0);
            for (const ClusterVertex& v : brick.vertices) {
                low = glm::min(low, {v.x, v.y, v.z});
                high = glm::max(high, {v.x, v.y, v.z});
            }
            page.centre = glm::vec3(low + high) * 0.5f;
            // Rounded up: nothing drawn lies outside.
            page.radius = std::nextafter(glm::length(glm::vec3(high - low)) * 0.5f, 1e9f);
            const bool first = mesh_.vertices.empty();
            mesh_.bounds.min = first ? low : glm::min(mesh_.bounds.min, low);
            mesh_.bounds.max = first ? high : glm::max(mesh_.bounds.max, high);
        }
        for (std::size_t i = 0; i < brick.vertices.size(); i += 4) {
            const auto base = static_cast<std::uint32_t>(mesh_.vertices.size() + i);
            // Counter-clockwise from outside: u, v and the axis are right-handed.
            if (brick.vertices[i].face < 3) {
                mesh_.indices.insert(mesh_.indices.end(),
                                     {base, base + 1, base + 2, base, base + 2, base + 3});
            } else {
                mesh_.indices.insert(mesh_.indices.end(),
                                     {base, base + 2, base + 1, base, base + 3, base + 2});
            }
        }
        mesh_.vertices.insert(mesh_.vertices.end(), brick.vertices.begin(), brick.vertices.end());
        mesh_.pages.push_back(page);
        mesh_.pageLevels.push_back(static_cast<std::uint8_t>(level));
    }

    const OctreeView& octree_;
    ClusterBuildOptions options_;
    std::uint64_t mostQuads_;
    std::atomic<std::uint64_t> quads_ = 0;  // of all levels so far
    ClusterMesh mesh_;
};

}  // namespace

std::uint64_t ClusterMesh::bytes() const {
    return vertices.size() * sizeof(ClusterVertex) + indices.size() * sizeof(std::uint32_t) +
           pages.size() * sizeof(ClusterPage) + pageLevels.size();
}

Result<ClusterMesh> buildClusters(const OctreeView& octree, const ClusterBuildOptions& options) {
    const int cells = options.brickCells;
    if (cells != 4 && cells != 8 && cells != 16 && cells != 32)
        return fail("a cluster has an edge of 4, 8, 16 or 32 cells, not " + std::to_string(cells));
    if (octree.maxDepth >= kMaxOctreeDepth)
        return fail("clusters are for octrees of less than 16 levels: up to 32,768 voxels an edge");
    return Builder(octree, options).run();
}

}  // namespace voxprite
