#include "core/trace/lattice.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/trace/nearest_direction.h"

namespace voxprite {
namespace {

constexpr double kMinSigma = 1.0 / 64.0;
constexpr double kMaxSigma = 64.0;
constexpr double kMinStepsPerPx = 16.0;
constexpr int kMaxSpritePositionBits = 12;
constexpr int kMaxModelEdge = 1 << 16;
constexpr int kMaxPositionBits = 13;
constexpr int kMaxDirectionBits = 13;
constexpr int kMaxLatticeCoordinate = 1 << 28;
constexpr std::int64_t kMaxStart = std::int64_t{1} << 30;  // of a ray, in lattice steps

// Determinants of a lattice's vectors take more than 64 bits.
__extension__ using Int128 = __int128;

Int128 floorDiv(Int128 numerator, Int128 denominator) {
    const Int128 quotient = numerator / denominator;
    const bool roundedUp = (numerator % denominator != 0) && ((numerator < 0) != (denominator < 0));
    return roundedUp ? quotient - 1 : quotient;
}

Int128 ceilDiv(Int128 numerator, Int128 denominator) {
    return -floorDiv(-numerator, denominator);
}

glm::i64vec3 cross(glm::ivec3 a, glm::ivec3 b) {
    const glm::i64vec3 p(a);
    const glm::i64vec3 q(b);
    return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

Int128 dot(glm::ivec3 a, glm::i64vec3 b) {
    return Int128{a.x} * b.x + Int128{a.y} * b.y + Int128{a.z} * b.z;
}

bool isEmpty(glm::ivec3 modelSize) {
    return modelSize.x == 0 || modelSize.y == 0 || modelSize.z == 0;
}

Status checkModelSize(glm::ivec3 modelSize) {
    for (int axis = 0; axis < 3; ++axis) {
        if (modelSize[axis] < 0 || modelSize[axis] > kMaxModelEdge)
            return fail("a model's edge of " + std::to_string(modelSize[axis]) +
                        " voxels is outside 0 ... " + std::to_string(kMaxModelEdge));
    }
    return {};
}

bool within(glm::ivec3 v, int limit) {
    return std::abs(std::int64_t{v.x}) <= limit && std::abs(std::int64_t{v.y}) <= limit &&
           std::abs(std::int64_t{v.z}) <= limit;
}

Status checkRanges(const LatticeView& lattice) {
    if (lattice.positionBits < 1 || lattice.positionBits > kMaxPositionBits)
        return fail("the lattice's position bits must be 1 ... " +
                    std::to_string(kMaxPositionBits) + ", not " +
                    std::to_string(lattice.positionBits));
    if (lattice.directionBits < 0 || lattice.directionBits > kMaxDirectionBits)
        return fail("the lattice's direction bits must be 0 ... " +
                    std::to_string(kMaxDirectionBits) + ", not " +
                    std::to_string(lattice.directionBits));
    if (!within(lattice.D, 1 << lattice.directionBits))
        return fail("the lattice's direction D needs more than its " +
                    std::to_string(lattice.directionBits) + " bits");
    if (!within(lattice.C, kMaxLatticeCoordinate) || !within(lattice.U, kMaxLatticeCoordinate) ||
        !within(lattice.V, kMaxLatticeCoordinate))
        return fail("a component of the lattice's C, U or V lies outside +-2^28");
    return {};
}

struct Interval {
    Int128 first = 0;
    Int128 last = 0;
};

// The integer pixel coordinates k with   low <= k * determinant / (normal * 2^kStepShift) <= high
// where low and high are the least and greatest of normal . (X - C) over the box.
//
// A ray starts at O = C + (iU + jV) / 2^kStepShift - e with 0 <= e < 1 on every axis, because >>
// rounds down. Where it meets the box at X = O + tD, the product with a normal of V and D (or of D
// and U) leaves i (or j) alone:   normal . (X + e - C) = i * determinant / 2^kStepShift. So growing
// the box upward by one lattice step accounts for the rounding, and no hit is lost.
Interval pixelInterval(const LatticeView& lattice, glm::ivec3 modelSize, glm::i64vec3 normal,
                       Int128 determinant) {
    Int128 low = 0;
    Int128 high = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const Int128 boxMin = -Int128{lattice.C[axis]};
        const Int128 boxMax = (Int128{modelSize[axis]} << lattice.positionBits) + 1 + boxMin;
        const Int128 a = normal[axis] * boxMin;
        const Int128 b = normal[axis] * boxMax;
        low += std::min(a, b);
        high += std::max(a, b);
    }
    if (determinant < 0) {
        std::swap(low, high);
    }
    const Int128 scale = Int128{1} << kStepShift;
    return {ceilDiv(low * scale, determinant), floorDiv(high * scale, determinant)};
}

// Rays start in the plane of U and V. Where that plane runs almost along D, a ray that meets the
// box may start far away; the walk's 64 bits have room for kMaxStart.
bool startsNearby(const LatticeView& lattice, const PixelBounds& bounds) {
    const glm::i64vec2 first(bounds.first);
    const glm::i64vec2 last = first + glm::i64vec2(bounds.size) - std::int64_t{1};
    for (int axis = 0; axis < 3; ++axis) {
        for (const std::int64_t i : {first.x, last.x}) {
            for (const std::int64_t j : {first.y, last.y}) {
                const std::int64_t offset = i * lattice.U[axis] + j * lattice.V[axis];
                if (std::abs(lattice.C[axis] + (offset >> kStepShift)) > kMaxStart) return false;
            }
        }
    }
    return true;
}

bool orthonormal(const OrthoView& view) {
    constexpr double kTolerance = 1e-6;
    const auto dotOf = [](glm::dvec3 a, glm::dvec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; };
    const glm::dvec3 axes[] = {view.right, view.up, view.forward};
    for (int a = 0; a < 3; ++a) {
        for (int b = 0; b <= a; ++b) {
            // Written so that NaN fails.
            if (!(std::abs(dotOf(axes[a], axes[b]) - (a == b ? 1.0 : 0.0)) <= kTolerance))
                return false;
        }
    }
    return true;
}

glm::ivec3 rounded(glm::dvec3 v) {
    return {static_cast<int>(std::floor(v.x + 0.5)), static_cast<int>(std::floor(v.y + 0.5)),
            static_cast<int>(std::floor(v.z + 0.5))};
}

// C, U, V and the bounds of a lattice whose positionBits and D are chosen.
Status quantisePositions(const OrthoView& view, glm::ivec3 modelSize, LatticeView& lattice) {
    const double stepsPerVoxel = std::ldexp(1.0, lattice.positionBits);
    const double pxVoxels = 1.0 / view.sigmaInForce;
    const double offsetVoxels = sampleOffsetPx(view.sigmaInForce) * pxVoxels;
    const glm::dvec3 corner(modelSize / 2);
    // Half a step more, because rays round their start down: so they are off by nothing on average.
    lattice.C = rounded((corner + (view.right + view.up) * offsetVoxels) * stepsPerVoxel + 0.5);
    const double stepsPerPx = pxVoxels * std::ldexp(stepsPerVoxel, kStepShift);
    lattice.U = rounded(view.right * stepsPerPx);
    lattice.V = rounded(view.up * stepsPerPx);
    const Result<PixelBounds> bounds = pixelBounds(lattice, modelSize);
    if (!bounds) return Failure(bounds.error());
    lattice.first = bounds->first;
    lattice.size = bounds->size;
    return {};
}

}  // namespace

double sampleOffsetPx(double sigmaInForce) {
    if (sigmaInForce < 1.0) return sigmaInForce / 2.0;
    return sigmaInForce == std::floor(sigmaInForce) ? 1.0 / 2.0 : 1.0 / 3.0;
}

Result<LatticeView> quantiseView(const OrthoView& view, glm::ivec3 modelSize) {
    if (Status ok = checkModelSize(modelSize); !ok) return Failure(ok.error());
    const double sigma = view.sigmaInForce;
    if (!(sigma >= kMinSigma && sigma <= kMaxSigma))
        return fail("sigma in force must be 1/64 ... 64 virtual pixels a voxel, not " +
                    std::to_string(sigma));
    if (!orthonormal(view)) return fail("the view's axes are not three orthonormal vectors");

    LatticeView lattice;
    lattice.D = nearestDirection(view.forward, lattice.directionBits);
    while (std::ldexp(1.0, lattice.positionBits) < kMinStepsPerPx * sigma) ++lattice.positionBits;
    if (Status ok = quantisePositions(view, modelSize, lattice); !ok) return Failure(ok.error());
    while (lattice.positionBits < kMaxSpritePositionBits) {
        LatticeView finer = lattice;
        ++finer.positionBits;
        if (!quantisePositions(view, modelSize, finer) || !fitsNarrow(finer, modelSize)) break;
        lattice = finer;
    }
    return lattice;
}

Result<PixelBounds> pixelBounds(const LatticeView& lattice, glm::ivec3 modelSize) {
    if (Status ok = checkModelSize(modelSize); !ok) return Failure(ok.error());
    if (Status ok = checkRanges(lattice); !ok) return Failure(ok.error());
    const glm::i64vec3 normalI = cross(lattice.V, lattice.D);
    const glm::i64vec3 normalJ = cross(lattice.D, lattice.U);
    const Int128 determinant = dot(lattice.U, normalI);
    if (determinant == 0) return fail("the lattice's U, V and D do not span space");
    if (isEmpty(modelSize)) return PixelBounds{};

    const Interval i = pixelInterval(lattice, modelSize, normalI, determinant);
    const Interval j = pixelInterval(lattice, modelSize, normalJ, determinant);
    const Int128 width = i.last - i.first + 3;  // one pixel more on either side
    const Int128 height = j.last - j.first + 3;
    const auto outside = [](Int128 k) { return k < -kMaxBufferPixels || k > kMaxBufferPixels; };
    if (outside(i.first) || outside(i.last) || outside(j.first) || outside(j.last) ||
        width * height > kMaxBufferPixels)
        return fail("this view needs a sprite buffer of more than the " +
                    std::to_string(kMaxBufferPixels) + " pixels allowed");
    const PixelBounds bounds{{static_cast<int>(i.first) - 1, static_cast<int>(j.first) - 1},
                             {static_cast<int>(width), static_cast<int>(height)}};
    if (!startsNearby(lattice, bounds))
        return fail("a ray of the lattice starts more than 2^30 steps from the model");
    return bounds;
}

Status validateLattice(const LatticeView& lattice, glm::ivec3 modelSize) {
    const Result<PixelBounds> bounds = pixelBounds(lattice, modelSize);
    if (!bounds) return Failure(bounds.error());
    if (*bounds == PixelBounds{lattice.first, lattice.size}) return {};
    const auto text = [](glm::ivec2 v) {
        return "(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ")";
    };
    return fail("the lattice's pixels start at " + text(lattice.first) + " with size " +
                text(lattice.size) + ", but for this model they start at " + text(bounds->first) +
                " with size " + text(bounds->size));
}

bool fitsNarrow(const LatticeView& lattice, glm::ivec3 modelSize) {
    constexpr std::int64_t kLimit = std::int64_t{1} << 31;
    const glm::i64vec3 centre(modelSize / 2);
    const glm::i64vec2 first(lattice.first);
    const glm::i64vec2 last = first + glm::i64vec2(lattice.size) - std::int64_t{1};
    const std::int64_t largestD =
        std::max({std::abs(lattice.D.x), std::abs(lattice.D.y), std::abs(lattice.D.z)});
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t c = lattice.C[axis] - (centre[axis] << lattice.positionBits);
        const std::int64_t halfEdge = std::max(centre[axis], modelSize[axis] - centre[axis])
                                      << lattice.positionBits;
        for (const std::int64_t i : {first.x, last.x}) {
            for (const std::int64_t j : {first.y, last.y}) {
                const std::int64_t iU = i * lattice.U[axis];
                const std::int64_t jV = j * lattice.V[axis];
                const std::int64_t origin = c + ((iU + jV) >> kStepShift);
                if (std::abs(iU) >= kLimit || std::abs(jV) >= kLimit ||
                    std::abs(iU + jV) >= kLimit ||
                    (std::abs(origin) + halfEdge) * largestD >= kLimit)
                    return false;
            }
        }
    }
    return true;
}

}  // namespace voxprite
