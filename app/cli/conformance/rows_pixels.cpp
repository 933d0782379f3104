// Rows 8, 9 and 16: which voxel a pixel shows.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "app/cli/conformance/conformance.h"
#include "app/cli/conformance/literal.h"
#include "app/cli/conformance/subjects.h"
#include "app/trade/fp32_walk.h"

namespace voxprite::conformance {
namespace {

using Point = std::array<long double, 3>;

bool differ(const LatticeHit& a, const LatticeHit& b) {
    return a.material != b.material || a.voxel != b.voxel;
}

LatticeHit castSample(const OctreeView& octree, const OrthoView& view, const Point& at) {
    return castCells(octree, at, {view.forward.x, view.forward.y, view.forward.z});
}

// The share of pixels whose voxel changes under the tiny turn, samples in exact arithmetic at
// `offsetPx` from the model's centre.
double flippedCentred(const Subject& subject, const OrthoView& view, double offsetPx) {
    const OctreeView octree = subject.octree.view();
    const OrthoView after = turned(view, kTinyTurnRadians);
    const LatticeView bounds = quantised(view, subject.octree.size);
    double shown = 0.0;
    double flipped = 0.0;
    for (int j = 0; j < bounds.size.y; ++j)
        for (int i = 0; i < bounds.size.x; ++i) {
            const glm::ivec2 pixel = bounds.first + glm::ivec2(i, j);
            const LatticeHit a =
                castSample(octree, view, centredSample(view, subject.octree.size, pixel, offsetPx));
            const LatticeHit b = castSample(
                octree, after, centredSample(after, subject.octree.size, pixel, offsetPx));
            shown += a.material != 0 ? 1.0 : 0.0;
            flipped += differ(a, b) ? 1.0 : 0.0;
        }
    return 100.0 * flipped / shown;
}

double flippedOurs(const Subject& subject, const OrthoView& view) {
    const LatticeView before = quantised(view, subject.octree.size);
    LatticeView after = quantised(turned(view, kTinyTurnRadians), subject.octree.size);
    after.first = before.first;
    after.size = before.size;
    const SpriteBuffer a = cast(subject.octree, before);
    const SpriteBuffer b = cast(subject.octree, after);
    double flipped = 0.0;
    for (std::size_t at = 0; at < a.ids.size(); ++at) flipped += a.ids[at] != b.ids[at] ? 1.0 : 0.0;
    return 100.0 * flipped / static_cast<double>(a.opaqueCount());
}

// The views with the most samples on faces: along axes and face diagonals.
std::vector<OrthoView> exactViews(double sigma) {
    return {orthoView({0, 0, 0}, sigma), orthoView({90, 0, 0}, sigma), orthoView({0, 90, 0}, sigma),
            orthoView({45, 0, 0}, sigma)};
}

void compareSamples(Comparisons& all) {
    const std::vector<Subject> subjects{cube32(), figure(), letters()};
    double literal = 0.0;
    double ours = 0.0;
    for (const Subject& subject : subjects)
        for (const double sigma : {1.0, 2.0, 4.0})
            for (const OrthoView& view : exactViews(sigma)) {
                literal = std::max(literal, flippedCentred(subject, view, 0.0));
                ours = std::max(ours, flippedOurs(subject, view));
            }
    all.push_back({8, "round", "pixels whose voxel changes under a turn of 1e-7 rad", literal, ours,
                   0.0, "%",
                   "cube, figure, letters; sigma 1, 2, 4; front, side, top, 45 degrees; worst"});
    const Subject cube = cube32();
    for (const double sigma : {0.5, 1.5}) {
        literal = 0.0;
        ours = 0.0;
        for (const OrthoView& view : exactViews(sigma)) {
            literal = std::max(literal, flippedCentred(cube, view, 0.5));
            ours = std::max(ours, flippedOurs(cube, view));
        }
        all.push_back({8, sigma < 1.0 ? "half_offset_sigma_1_2" : "half_offset_sigma_3_2",
                       "the same at sigma " + std::string(sigma < 1.0 ? "1/2" : "3/2") +
                           ", samples half a vpx off as for whole sigma",
                       literal, ours, 0.0, "%", "cube; front, side, top, 45 degrees; worst"});
    }
}

struct WrongPixels {
    double shown = 0.0;
    double fp32 = 0.0;
    double ours = 0.0;
};

// Both against castCells along the very rays of the lattice, whose integers it compares exactly.
void countWrong(const Subject& subject, const LatticeView& lattice, WrongPixels& wrong) {
    const OctreeView octree = subject.octree.view();
    const LatticeCaster caster(octree, lattice);
    const double stepsPerVoxel = std::ldexp(1.0, lattice.positionBits);
    const double away = 2.0 * std::max({octree.size.x, octree.size.y, octree.size.z});
    for (int j = 0; j < lattice.size.y; ++j)
        for (int i = 0; i < lattice.size.x; ++i) {
            const glm::ivec2 pixel = lattice.first + glm::ivec2(i, j);
            const LatticeRay ray = rayOf(lattice, pixel);
            const glm::dvec3 d(ray.direction);
            const double length = std::hypot(d.x, d.y, d.z);
            Point origin{};
            Point direction{};
            std::array<float, 3> origin32{};
            std::array<float, 3> direction32{};
            for (std::size_t a = 0; a < 3; ++a) {
                const int axis = static_cast<int>(a);
                origin[a] = static_cast<long double>(ray.origin[axis]);
                direction[a] = static_cast<long double>(d[axis]);
                direction32[a] = static_cast<float>(d[axis] / length);
                origin32[a] =
                    static_cast<float>(static_cast<double>(ray.origin[axis]) / stepsPerVoxel -
                                       d[axis] / length * away);
            }
            const LatticeHit truth = castCells(octree, origin, direction, stepsPerVoxel);
            wrong.shown += truth.material != 0 ? 1.0 : 0.0;
            wrong.fp32 +=
                differ(trade::castFp32Walk(octree, origin32, direction32), truth) ? 1.0 : 0.0;
            wrong.ours += differ(caster.cast(pixel), truth) ? 1.0 : 0.0;
        }
}

void compareWalks(Comparisons& all) {
    double front = 0.0;
    double frontOurs = 0.0;
    WrongPixels elsewhere;
    Sequence random(9);
    for (const Subject& subject : {figure(), vehicle(), letters(), noise(32)}) {
        WrongPixels wrong;
        countWrong(subject, quantised(orthoView({}, 4.0), subject.octree.size), wrong);
        front = std::max(front, 100.0 * wrong.fp32 / wrong.shown);
        frontOurs = std::max(frontOurs, 100.0 * wrong.ours / wrong.shown);
        for (int n = 0; n < 6; ++n) {
            const OrbitAngles angles{random.between(0, 360), random.between(-80, 80), 0.0};
            countWrong(subject, quantised(orthoView(angles, 4.0), subject.octree.size), elsewhere);
        }
    }
    const std::string how = "figure, vehicle, letters and noise, sigma 4";
    all.push_back({9, "fp32_walk_front",
                   "wrong pixels at an exact front view, fp32 walk with epsilon against integers",
                   front, frontOurs, 0.0, "%", how + "; the worst of them"});
    all.push_back({9, "fp32_walk_elsewhere", "the same from anywhere",
                   100.0 * elsewhere.fp32 / elsewhere.shown,
                   100.0 * elsewhere.ours / elsewhere.shown, 0.0, "%", how + ", six views each"});
}

Comparison compareOctants() {
    const Subject subject = letters();
    const OctreeView octree = subject.octree.view();
    const int edge = 1 << octree.maxDepth;
    double solid = 0.0;
    double literal = 0.0;
    double ours = 0.0;
    for (int z = 0; z < edge; ++z)
        for (int y = 0; y < edge; ++y)
            for (int x = 0; x < edge; ++x) {
                const glm::ivec3 v{x, y, z};
                const std::uint8_t truth = subject.voxels.get(v);
                solid += truth != 0 ? 1.0 : 0.0;
                literal += materialInProseOrder(octree, v) != truth ? 1.0 : 0.0;
                ours += materialAt(octree, v) != truth ? 1.0 : 0.0;
            }
    return {16,
            "octant_order",
            "voxels read wrong from the runtime's arrays",
            100.0 * literal / solid,
            100.0 * ours / solid,
            0.0,
            "%",
            "letters, octants numbered as seed 004's prose has them"};
}

}  // namespace

void comparePixels(Comparisons& all) {
    compareSamples(all);
    compareWalks(all);
    all.push_back(compareOctants());
}

}  // namespace voxprite::conformance
