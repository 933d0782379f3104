// Views and sizes, against the ideal caster.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/cli/conformance/gpu_probe.h"
#include "app/cli/conformance/stability.h"
#include "app/cli/conformance/subjects.h"
#include "core/trace/ideal_caster.h"
#include "core/trace/lattice_caster.h"

namespace voxprite::conformance {
namespace {

// A share of fewer pixels than this says nothing.
constexpr double kLeastShown = 1000.0;

struct Difference {
    double shown = 0.0;
    double silhouette = 0.0;
    double voxel = 0.0;

    Difference& operator+=(const Difference& other) {
        shown += other.shown;
        silhouette += other.silhouette;
        voxel += other.voxel;
        return *this;
    }
};

double percent(double part, double whole) {
    return whole > 0.0 ? 100.0 * part / whole : 0.0;
}

// At `samples` pixels of the buffer, anywhere.
Difference differenceToIdeal(const Octree& octree, const OrthoView& view,
                             const LatticeView& lattice, int samples, Sequence& random) {
    Difference difference;
    const LatticeCaster caster(octree.view(), lattice);
    for (int n = 0; n < samples; ++n) {
        const glm::ivec2 pixel =
            lattice.first + glm::ivec2(static_cast<int>(random.unit() * lattice.size.x),
                                       static_cast<int>(random.unit() * lattice.size.y));
        const LatticeHit ideal = castIdeal(octree.view(), view, pixel);
        const LatticeHit own = caster.cast(pixel);
        difference.shown += ideal.material != 0 ? 1.0 : 0.0;
        if ((ideal.material == 0) != (own.material == 0))
            ++difference.silhouette;
        else if (ideal.material != 0 && ideal.voxel != own.voxel)
            ++difference.voxel;
    }
    return difference;
}

// The share of pixels that another lattice changes.
double changedPercent(const Octree& octree, const LatticeView& before, LatticeView after) {
    after.first = before.first;
    after.size = before.size;
    if (after == before) return 0.0;
    const SpriteBuffer a = cast(octree, before);
    const SpriteBuffer b = cast(octree, after);
    double changed = 0.0;
    for (std::size_t at = 0; at < a.ids.size(); ++at) changed += a.ids[at] != b.ids[at] ? 1.0 : 0.0;
    return percent(changed, static_cast<double>(a.opaqueCount()));
}

struct NamedView {
    const char* name;
    OrbitAngles angles;
};

std::vector<NamedView> exactViews() {
    const double isometric = std::atan(std::sqrt(0.5)) * 180.0 / std::numbers::pi;
    return {{"front", {0, 0, 0}},
            {"side", {90, 0, 0}},
            {"top", {0, 90, 0}},
            {"45 degrees", {45, 0, 0}},
            {"isometric", {45, isometric, 0}}};
}

}  // namespace

Sweep sweepTurns(GpuProbe& probe) {
    Sweep sweep{"turns",
                "front, side, top, 45 degrees and isometric, turned by 0 and 1e-9 ... 1e-2 rad; "
                "cube, figure, letters and noise; sigma 0.5 ... 16"};
    Sequence random(1);
    Difference solid;
    Difference noisy;
    double worstVoxel = 0.0;
    double exactChanged = 0.0;
    double turnedChanged = 0.0;
    for (const Subject& subject : {cube32(), figure(), letters(), noise(32)})
        for (const NamedView& view : exactViews())
            for (const double sigma : {0.5, 1.0, 1.5, 3.0, 4.0, 7.3, 16.0})
                for (const double turn : {0.0, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
                    const OrthoView ortho = turned(orthoView(view.angles, sigma), turn);
                    const auto lattice = quantiseView(ortho, subject.octree.size);
                    sweep.count(lattice.has_value(), subject.name + ", " + view.name);
                    if (!lattice) continue;
                    probe.compareWindow(subject, *lattice);
                    const Difference one =
                        differenceToIdeal(subject.octree, ortho, *lattice, 2000, random);
                    (subject.name == "noise" ? noisy : solid) += one;
                    if (one.shown >= kLeastShown)
                        worstVoxel = std::max(worstVoxel, percent(one.voxel, one.shown));
                    const double changed = changedPercent(
                        subject.octree, *lattice,
                        quantised(turned(ortho, kTinyTurnRadians), subject.octree.size));
                    double& worst = turn == 0.0 ? exactChanged : turnedChanged;
                    worst = std::max(worst, changed);
                }
    sweep.figures = {
        {"silhouette", "silhouette off the ideal caster's", percent(solid.silhouette, solid.shown),
         0.02, "%"},
        {"silhouette_noise", "the same on noise", percent(noisy.silhouette, noisy.shown), 0.2, "%"},
        {"voxels", "voxels off the ideal caster's", percent(solid.voxel, solid.shown), 1.0, "%"},
        {"voxels_worst", "the same in the worst view", worstVoxel, 1.0, "%"},
        {"turn_exact", "pixels that a turn of 1e-7 rad changes, exact views; worst", exactChanged,
         0.0, "%"},
        {"turn_elsewhere", "the same across a step of the lattice; worst", turnedChanged, 1.0,
         "%"}};
    return sweep;
}

Sweep sweepSizes(GpuProbe& probe) {
    Sweep sweep{"sizes",
                "sigma 1/64 ... 64 on 1x1x1, 1x1x256, 256x1x1, 256 cubed, odd and even, empty and "
                "full"};
    Sequence random(2);
    Difference all;
    double worstVoxel = 0.0;
    double worstFine = 0.0;
    const std::vector<Subject> subjects{solidBox({1, 1, 1}),   solidBox({1, 1, 256}),
                                        solidBox({256, 1, 1}), solidBox(glm::ivec3(256)),
                                        solidBox({7, 7, 7}),   solidBox({8, 8, 8}),
                                        solidBox({5, 8, 3}),   figure()};
    for (const double sigma : {1.0 / 64, 1.0 / 48, 0.1, 0.25, 1.0 / 3, 0.5, 0.9, 1.0, 1.5, 2.0, 3.0,
                               4.0, 5.7, 8.0, 16.0, 31.3, 64.0}) {
        for (const Subject& subject : subjects)
            for (const OrbitAngles angles :
                 {OrbitAngles{0, 0, 0}, {0, 90, 0}, {45, 0, 0}, {33, 21, 7}, {200, -70, 0}}) {
                const OrthoView ortho = orthoView(angles, sigma);
                const auto lattice = quantiseView(ortho, subject.octree.size);
                if (!lattice) {
                    const bool names = lattice.error().message.find(
                                           std::to_string(kMaxBufferPixels)) != std::string::npos;
                    sweep.refused += names ? 1 : 0;
                    sweep.count(names, subject.name);
                    continue;
                }
                sweep.count(validateLattice(*lattice, subject.octree.size).has_value(),
                            subject.name);
                probe.compareWindow(subject, *lattice);
                const Difference one =
                    differenceToIdeal(subject.octree, ortho, *lattice, 2000, random);
                all += one;
                double& worst = sigma <= 16.0 ? worstVoxel : worstFine;
                if (one.shown >= kLeastShown)
                    worst = std::max(worst, percent(one.voxel, one.shown));
            }
        const auto empty = quantiseView(orthoView({33, 21, 7}, sigma), glm::ivec3(0));
        sweep.count(empty && empty->size == glm::ivec2(0), "empty");
    }
    sweep.figures = {
        {"silhouette", "silhouette off the ideal caster's", percent(all.silhouette, all.shown),
         0.02, "%"},
        {"voxels", "voxels off the ideal caster's", percent(all.voxel, all.shown), 1.0, "%"},
        {"voxels_worst", "the same in the worst case to sigma 16", worstVoxel, 1.0, "%"},
        {"voxels_worst_fine", "the same beyond", worstFine, std::numeric_limits<double>::infinity(),
         "%"}};
    return sweep;
}

}  // namespace voxprite::conformance
