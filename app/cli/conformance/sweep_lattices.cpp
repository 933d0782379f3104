// Views that came from elsewhere (`render --lattice`), and sizes: integers out of place.
#include <array>
#include <functional>
#include <limits>

#include "app/cli/conformance/gpu_probe.h"
#include "app/cli/conformance/stability.h"

namespace voxprite::conformance {
namespace {

constexpr int kLeast = std::numeric_limits<int>::min();
constexpr int kMost = std::numeric_limits<int>::max();
constexpr std::array kOddIntegers{0,       1,          -1,      2,          kMost,      kMost - 1,
                                  kLeast,  kLeast + 1, 1 << 13, -(1 << 13), 1 << 22,    -(1 << 22),
                                  1 << 28, -(1 << 28), 65'536,  65'537,     16'777'216, -12'345};

std::vector<std::function<int&(LatticeView&)>> everyInteger() {
    std::vector<std::function<int&(LatticeView&)>> all{
        [](LatticeView& l) -> int& { return l.positionBits; },
        [](LatticeView& l) -> int& { return l.directionBits; },
        [](LatticeView& l) -> int& { return l.first.x; },
        [](LatticeView& l) -> int& { return l.first.y; },
        [](LatticeView& l) -> int& { return l.size.x; },
        [](LatticeView& l) -> int& { return l.size.y; }};
    for (int axis = 0; axis < 3; ++axis) {
        all.emplace_back([axis](LatticeView& l) -> int& { return l.C[axis]; });
        all.emplace_back([axis](LatticeView& l) -> int& { return l.D[axis]; });
        all.emplace_back([axis](LatticeView& l) -> int& { return l.U[axis]; });
        all.emplace_back([axis](LatticeView& l) -> int& { return l.V[axis]; });
    }
    return all;
}

// The view as it is, and with the bounds that its integers have: either is refused with a reason,
// or can be cast.
void countLattice(Sweep& sweep, GpuProbe& probe, const Subject& subject, LatticeView lattice) {
    const Status given = validateLattice(lattice, subject.octree.size);
    if (given)
        probe.compareWindow(subject, lattice);
    else
        ++sweep.refused;
    sweep.count(given || !given.error().message.empty(), subject.name);
    const auto bounds = pixelBounds(lattice, subject.octree.size);
    if (bounds) {
        lattice.first = bounds->first;
        lattice.size = bounds->size;
        probe.compareWindow(subject, lattice);
    } else {
        ++sweep.refused;
    }
    sweep.count(bounds ? validateLattice(lattice, subject.octree.size).has_value()
                       : !bounds.error().message.empty(),
                subject.name);
}

void sweepSizes(Sweep& sweep, const Subject& subject) {
    const GameProfile profile = plainProfile();
    for (const int odd : kOddIntegers)
        for (int number = 0; number < 5; ++number) {
            PlacedEntity entity = subject.centredAt(glm::dvec3(0.0), profile);
            Camera camera = orbit(30, 20, 4);
            if (number < 3)
                entity.modelSize[number] = odd;
            else
                camera.viewportPx[number - 3] = odd;
            const auto result = viewSprite(entity, camera, profile);
            sweep.refused += result ? 0 : 1;
            sweep.count(result ? result->view || result->unseen : !result.error().message.empty(),
                        "a size of " + std::to_string(odd));
        }
}

}  // namespace

Sweep sweepLattices(GpuProbe& probe) {
    Sweep sweep{"integers",
                "0, -1, powers of two and the largest integers in every integer of a view that is "
                "given, of a model's size and of a viewport"};
    for (const Subject& subject : {letters(), noise(32)})
        for (const double sigma : {0.5, 4.0})
            for (const auto& integer : everyInteger())
                for (const int odd : kOddIntegers) {
                    LatticeView lattice =
                        quantised(orthoView({33, 21, 7}, sigma), subject.octree.size);
                    integer(lattice) = odd;
                    countLattice(sweep, probe, subject, lattice);
                }
    sweepSizes(sweep, letters());
    return sweep;
}

}  // namespace voxprite::conformance
