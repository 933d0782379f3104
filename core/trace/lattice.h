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
//
// What a second implementation may lean on (the shaders are one):
// - Mirroring. On an axis with D < 0 negate: O' = -O, D' = -D, face k' = -k, cell c' = -1 - c. Then
//   the cell after face k' is k', as for D > 0, and neither times nor ties change.
// - The cell right after a crossing (t = N_a / D_a, axis a) on another axis b with D_b > 0, all
//   mirrored: floor((O_b * D_a + N_a * D_b - (b > a ? 1 : 0)) / (D_a * 2^P)).
// - D_b = 0: set the lowest bit of O_b. That never changes its cell and keeps it off every face, so
//   that no formula needs a special case.
// - Faces of nodes are clamped to the model's box before their crossings are compared. Then every
//   face that is ever looked at lies in the box, and fitsNarrow bounds every product.
// - The box entered is the model's, cut with the root cube: a live octree's bounds may reach beyond
//   its root, and what lies there is empty.
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

// Quantises a view of a model of `modelSize` voxels (0 ... 65,536 an axis). D is the integer vector
// within directionBits that is nearest in angle to `forward`, over all scales (the shortest of
// equals); U and V follow from right and up. Fails on non-finite input, axes that are not
// orthonormal, sigma out of range, or a buffer of more than kMaxBufferPixels (the message names the
// limit). An empty model has size (0,0).
[[nodiscard]] Result<LatticeView> quantiseView(const OrthoView& view, glm::ivec3 modelSize);

// The pixels that the model can cover, and one more all round for the outline.
struct PixelBounds {
    glm::ivec2 first{0};
    glm::ivec2 size{0};
    bool operator==(const PixelBounds&) const = default;
};

// What `first` and `size` of a lattice have to be: computed from bits, C, D, U and V alone,
// exactly. No ray outside ever meets the box [0, modelSize]. Fails when the integers are out of
// range, U, V and D do not span space, or the buffer is too large; (0,0) for an empty model.
[[nodiscard]] Result<PixelBounds> pixelBounds(const LatticeView& lattice, glm::ivec3 modelSize);

// For a view that came from elsewhere: pixelBounds succeeds and gives this first and size.
[[nodiscard]] Status validateLattice(const LatticeView& lattice, glm::ivec3 modelSize);

// Do all products of the walk fit 31 bits when coordinates are taken from the model's centre corner
// floor(size / 2) and faces are clamped to the model's box? That is, with O the start of any ray of
// the buffer and N_a = face - O_a: |i * U_a|, |j * V_a|, their sum, and N_a * |D_b| for all axes a
// and b. True for 128 cubed at every sigma and for 256 cubed up to sigma 16. Then GLSL casts with
// plain int; else it needs the wide path. (C++ always uses 64 bits.)
[[nodiscard]] bool fitsNarrow(const LatticeView& lattice, glm::ivec3 modelSize);

}  // namespace voxprite
