// No ray that meets the model passes through the triangles of a cut, however its levels are mixed.
// Rays and triangles are integers, and every comparison is one of exact fractions: nothing leaks
// through an edge by rounding, and nothing is saved by it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

#include "core/lod/cluster_cut.h"
#include "core/lod/cluster_mesh.h"
#include "core/svo/bake.h"
#include "tests/support/must.h"
#include "tests/support/random.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::must;
using test::Random;
using Vector = glm::vec<3, std::int64_t>;

// Rays, voxels and triangles in steps of 1/256 voxel, so that a voxel has an inside.
constexpr std::int64_t kVoxel = 256;

struct Ray {
    Vector origin{0};
    Vector direction{0};
};

// A time along a ray: numerator / denominator, the latter above 0.
struct Time {
    std::int64_t numerator = 0;
    std::int64_t denominator = 1;
    bool operator<(const Time& other) const {
        return numerator * other.denominator < other.numerator * denominator;
    }
};

// When the ray enters the inside of a voxel, if it does: by three intervals between planes.
std::optional<Time> entersVoxel(const Ray& ray, const Vector& corner) {
    Time enter{-1, 1};
    Time leave{std::int64_t{1} << 40, 1};
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t o = ray.origin[axis];
        const std::int64_t d = ray.direction[axis];
        const std::int64_t low = corner[axis];
        const std::int64_t high = low + kVoxel;
        if (d == 0) {
            if (o <= low || o >= high) return {};
            continue;
        }
        const std::int64_t sign = d > 0 ? 1 : -1;
        enter = std::max(enter, Time{((d > 0 ? low : high) - o) * sign, d * sign});
        leave = std::min(leave, Time{((d > 0 ? high : low) - o) * sign, d * sign});
    }
    // Grazing an edge or a corner is no meeting.
    if (!(enter < leave) || enter < Time{0, 1}) return {};
    return enter;
}

// When the ray comes to the front of a triangle, whose edges belong to it. For triangles in planes
// of one coordinate.
std::optional<Time> hitsTriangle(const Ray& ray, const Vector (&at)[3]) {
    const Vector e1 = at[1] - at[0];
    const Vector e2 = at[2] - at[0];
    const Vector normal(e1.y * e2.z - e1.z * e2.y, e1.z * e2.x - e1.x * e2.z,
                        e1.x * e2.y - e1.y * e2.x);
    const int axis = normal.x != 0 ? 0 : normal.y != 0 ? 1 : 2;
    const std::int64_t d = ray.direction[axis];
    if (d == 0 || (d > 0) == (normal[axis] > 0)) return {};
    const std::int64_t sign = d > 0 ? 1 : -1;
    const Time time{(at[0][axis] - ray.origin[axis]) * sign, d * sign};
    if (time < Time{0, 1}) return {};
    // The point in the plane, times the denominator; on which side of the edges it lies.
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const std::int64_t pu = ray.origin[u] * time.denominator + ray.direction[u] * time.numerator;
    const std::int64_t pv = ray.origin[v] * time.denominator + ray.direction[v] * time.numerator;
    bool left = false;
    bool right = false;
    for (int k = 0; k < 3; ++k) {
        const Vector& from = at[k];
        const Vector& to = at[(k + 1) % 3];
        const std::int64_t side = (to[u] - from[u]) * (pv - from[v] * time.denominator) -
                                  (to[v] - from[v]) * (pu - from[u] * time.denominator);
        left = left || side > 0;
        right = right || side < 0;
    }
    if (left && right) return {};
    return time;
}

// The earliest, over all triangles of the cut that `drawn` lets through.
template <class Drawn>
std::optional<Time> firstTriangle(const Ray& ray, const ClusterMesh& mesh,
                                  const std::vector<std::uint32_t>& cut, const Drawn& drawn) {
    std::optional<Time> first;
    for (const std::uint32_t i : cut) {
        const ClusterPage& page = mesh.pages[i];
        for (std::uint32_t index = 0; index < page.indexCount; index += 3) {
            const std::uint32_t* corners = &mesh.indices[page.firstIndex + index];
            if (!drawn(mesh.pageLevels[i], corners[0])) continue;
            Vector at[3];
            for (int k = 0; k < 3; ++k) {
                const ClusterVertex& vertex = mesh.vertices[corners[k]];
                at[k] = Vector(vertex.x, vertex.y, vertex.z) * kVoxel;
            }
            const std::optional<Time> time = hitsTriangle(ray, at);
            if (time && (!first || *time < *first)) first = time;
        }
    }
    return first;
}

// From outside of everything toward the inside of a voxel, one of its faces, edges or corners,
// often along an axis or a diagonal.
Ray rayToward(Random& random, const IBox& bounds, const Vector& corner) {
    Ray ray;
    const int from = random.between(0, 5);
    const int straight = random.between(0, 3);
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t target =
            corner[axis] + (random.chance(0.3) ? kVoxel * random.between(0, 1)
                                               : random.between(0, static_cast<int>(kVoxel)));
        std::int64_t away = random.between(-9000, 9000);
        if (straight == 1) away = 0;
        if (straight == 2) away = kVoxel * 64 * random.between(-1, 1);
        ray.origin[axis] = target + away;
        if (axis == from % 3) {
            const int beyond =
                straight == 2 ? 64 * static_cast<int>(kVoxel) : random.between(1, 9000);
            ray.origin[axis] =
                from < 3 ? bounds.max[axis] * kVoxel + beyond : bounds.min[axis] * kVoxel - beyond;
        }
        ray.direction[axis] = target - ray.origin[axis];
    }
    return ray;
}

// Any cut there is: every region descends as far as chance will have it.
std::vector<std::uint32_t> randomCut(Random& random, const ClusterMesh& mesh) {
    const auto replaces = [](const ClusterPage& coarse, const ClusterPage& fine) {
        return fine.parentError == coarse.lodError &&
               fine.parentBoundsCentre == coarse.lodBoundsCentre &&
               fine.parentBoundsRadius == coarse.lodBoundsRadius;
    };
    std::vector<std::uint32_t> open{static_cast<std::uint32_t>(mesh.pages.size() - 1)};
    std::vector<std::uint32_t> cut;
    while (!open.empty()) {
        const std::uint32_t page = open.back();
        open.pop_back();
        if (mesh.pageLevels[page] == 0 || random.chance(0.25)) {
            cut.push_back(page);
            continue;
        }
        const ClusterLevel& finer = mesh.levels[mesh.pageLevels[page] - 1u];
        for (std::uint32_t i = finer.firstPage; i < finer.firstPage + finer.pageCount; ++i) {
            if (replaces(mesh.pages[page], mesh.pages[i])) open.push_back(i);
        }
    }
    return cut;
}

struct Subject {
    std::string name;
    ClusterMesh mesh;
    test::VoxelMap voxels;  // in tree space
};

Subject subjectOf(std::string name, const VoxelGrid& voxels) {
    const Octree octree = must(bake(voxels));
    Subject subject{std::move(name), must(buildClusters(octree.view(), {.brickCells = 4})), {}};
    for (const auto& [at, material] : test::mapOf(voxels)) {
        const auto& [x, y, z] = at;
        subject.voxels[{x - octree.origin.x, y - octree.origin.y, z - octree.origin.z}] = material;
    }
    return subject;
}

std::vector<Subject> subjects() {
    std::vector<Subject> all;
    all.push_back(subjectOf("figure", test::figure()));
    all.push_back(subjectOf("shell", test::shellSphere(17)));
    all.push_back(subjectOf("box", test::solidBox({13, 9, 16})));
    all.push_back(subjectOf("sparse", test::randomVoxels(1, {14, 16, 10}, 0.05, 3)));
    all.push_back(subjectOf("noise", test::randomVoxels(2, {11, 12, 9}, 0.5, 3)));
    all.push_back(subjectOf("holes", test::randomVoxels(3, {12, 12, 12}, 0.97, 2)));
    return all;
}

struct Leaks {
    int met = 0;     // rays that meet a voxel
    int leaked = 0;  // of those, before or without the front of a triangle
};

template <class Drawn>
Leaks castThrough(Random& random, const Subject& subject, const std::vector<std::uint32_t>& cut,
                  int rays, const Drawn& drawn) {
    std::vector<Vector> solid;
    for (const auto& [at, material] : subject.voxels) {
        const auto& [x, y, z] = at;
        solid.push_back(Vector(x, y, z) * kVoxel);
    }
    Leaks result;
    for (int i = 0; i < rays; ++i) {
        const Ray ray = rayToward(random, subject.mesh.bounds, solid[random.next() % solid.size()]);
        std::optional<Time> met;
        for (const Vector& voxel : solid) {
            const std::optional<Time> time = entersVoxel(ray, voxel);
            if (time && (!met || *time < *met)) met = time;
        }
        if (!met) continue;
        ++result.met;
        const std::optional<Time> shown = firstTriangle(ray, subject.mesh, cut, drawn);
        if (!shown || *met < *shown) ++result.leaked;
    }
    return result;
}

constexpr auto kEverything = [](int, std::uint32_t) { return true; };

TEST(ClusterRays, NoneLeaksThroughAnyMixOfLevels) {
    Random random(11);
    for (const Subject& subject : subjects()) {
        Leaks all;
        for (int round = 0; round < 12; ++round) {
            const auto cut = randomCut(random, subject.mesh);
            const Leaks some = castThrough(random, subject, cut, 150, kEverything);
            EXPECT_EQ(some.leaked, 0) << subject.name << " round " << round;
            all.met += some.met;
        }
        EXPECT_GT(all.met, 1000) << subject.name;
    }
}

TEST(ClusterRays, NoneLeaksThroughTheCutsOfCameras) {
    Random random(12);
    for (const Subject& subject : subjects()) {
        const auto size = static_cast<double>(subject.mesh.bounds.max.x);
        for (int round = 0; round < 12; ++round) {
            ClusterView view;
            view.cameraPosition = {size * (random.unit() * 4 - 2), size * (random.unit() * 4 - 2),
                                   size * (random.unit() * 4 - 2)};
            view.viewportHeightPx = 1000.0;
            view.pixelBudget = 2000.0 * random.unit() * random.unit();
            std::vector<std::uint32_t> cut;
            selectCutPerCluster(subject.mesh.pages, clusterCutParams(view, subject.mesh.reach, 0),
                                cut);
            EXPECT_EQ(castThrough(random, subject, cut, 100, kEverything).leaked, 0)
                << subject.name << " round " << round;
        }
    }
}

// The rule that meshes of one level get away with, dropping faces between cells that are both
// solid, does leak where levels meet: the neighbour may be shown finer.
TEST(ClusterRays, LeakWhereBordersAreDroppedByTheCellsOfTheirOwnLevel) {
    Random random(13);
    int leaked = 0;
    for (const Subject& subject : subjects()) {
        // Quads of which no cell lies beside an empty one of its level.
        const auto drawn = [&](int level, std::uint32_t firstVertex) {
            const ClusterVertex* corners = &subject.mesh.vertices[firstVertex / 4 * 4];
            const int axis = corners[0].face % 3;
            glm::ivec3 low(corners[0].x, corners[0].y, corners[0].z);
            glm::ivec3 high(corners[2].x, corners[2].y, corners[2].z);
            if (corners[0].face >= 3) low[axis] -= 1 << level;
            high[axis] = low[axis] + (1 << level);
            const int edge = 1 << level;
            for (int x = low.x; x < high.x; x += edge) {
                for (int y = low.y; y < high.y; y += edge) {
                    for (int z = low.z; z < high.z; z += edge) {
                        bool solid = false;
                        for (int i = 0; i < edge * edge * edge; ++i)
                            solid =
                                solid || subject.voxels.contains({x + i % edge, y + i / edge % edge,
                                                                  z + i / edge / edge});
                        if (!solid) return true;
                    }
                }
            }
            return false;
        };
        for (int round = 0; round < 4; ++round) {
            leaked +=
                castThrough(random, subject, randomCut(random, subject.mesh), 40, drawn).leaked;
        }
    }
    EXPECT_GT(leaked, 3);
}

}  // namespace
}  // namespace voxprite
