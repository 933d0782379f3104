// The integer lattice: one view of one model quantised so that casting is exact.
//
// Once a frame and entity, a view is turned into integers, in double precision with + - * / and
// square root alone. From then on the picture is a pure function of these integers: every CPU and
// GPU gives the same sprite buffer bit for bit.
//
// Space   voxel space of the octree (Z up, minimum corner at 0), positions scaled by
// 2^positionBits. Ray (i, j) of the buffer starts at   C + ((i * U + j * V) >> kStepShift)   and
// runs along D. i counts to the right, j counts up; >> rounds down. The start lies in the sprite
// plane, inside the model more often than not: the ray is an infinite line, met from its far end (t
// may be negative).
//
// The walk, exactly (Amanatides & Woo 1987, in integers after Liu, Zalik & Yang 2004). On axis a
// with D[a] != 0 the line crosses the face at integer k at the time t = (k * 2^P - O[a]) / D[a].
// All crossings are ordered by (t, axis): ties go to the lowest axis first. Between two crossings
// the line is in one cell: on an axis with D > 0 the cell after crossing face k is k, with D < 0 it
// is k - 1; on an axis with D = 0 it is floor(O / 2^P) always. The first solid cell inside the
// model's size, in that order, is the hit; the face is that of the last crossing before it. Any
// walk that skips empty nodes must give this cell and face. Comparing times is comparing products
// of integers: N_a * |D_b| against N_b * |D_a|.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/base/result.h"

namespace voxprite {

inline constexpr int kStepShift = 12;  // U and V carry this many bits more than positions
inline constexpr std::int64_t kMaxBufferPixels = std::int64_t{1} << 24;

// A view of a model, before quantisation, in voxel space: three orthonormal axes and a scale.
struct OrthoView {
    glm::dvec3 right{1, 0, 0};
    glm::dvec3 up{0, 0, 1};
    glm::dvec3 forward{0, 1, 0};  // the way the rays run
    double sigmaInForce = 4.0;    // virtual pixels a voxel: sigma * scale, 1/64 ... 64
};

struct LatticeView {
    int positionBits = 8;    // P: lattice steps a voxel = 2^P, so that a vpx spans >= 16 of them
    int directionBits = 13;  // |D| <= 2^directionBits on every axis
    glm::ivec3 C{0};         // lattice units from the model's minimum corner
    glm::ivec3 D{0, 1, 0};
    glm::ivec3 U{0};  // 2^(P + kStepShift) a voxel
    glm::ivec3 V{0};
    glm::ivec2 first{0};  // (i, j) of the buffer's left and bottom
    glm::ivec2 size{0};   // the padded bounds: every hit, plus one for the outline
    bool operator==(const LatticeView&) const = default;
};

// Where sample (0,0) lies from the lattice corner nearest the model centre, floor(size / 2), in
// virtual pixels along both U and V: 1/2 for whole sigma, half a voxel for sigma below 1, else 1/3.
[[nodiscard]] double sampleOffsetPx(double sigmaInForce);

// Quantises a view of a model of `modelSize` voxels. D is the integer vector within directionBits
// that is nearest in angle to `forward`, over all scales (the shortest of equals); U and V follow
// from right and up. Fails on non-finite input, sigma out of range, or a buffer of more than
// kMaxBufferPixels (the message names the limit). An empty model has size (0,0).
[[nodiscard]] Result<LatticeView> quantiseView(const OrthoView& view, glm::ivec3 modelSize);

// Recomputes first and size, for a view that came from elsewhere; checks ranges.
[[nodiscard]] Status validateLattice(const LatticeView& lattice, glm::ivec3 modelSize);

// Do all products of the walk fit 31 bits when coordinates are taken from the model's centre
// corner? Then GLSL casts with plain int; else it needs the wide path. (C++ always uses 64 bits.)
[[nodiscard]] bool fitsNarrow(const LatticeView& lattice, glm::ivec3 modelSize);

}  // namespace voxprite
