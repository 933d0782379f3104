// The rule of core/trace/lattice.h word for word: list every crossing with every face of the box as
// an exact fraction, sort by (time, axis), and look into the cell behind each.
#pragma once

#include "core/trace/lattice_caster.h"
#include "tests/core/trace/dense_model.h"

namespace voxprite::test {

[[nodiscard]] LatticeHit castExact(const DenseModel& model, const LatticeRay& ray);
// The same of a ray: only what lies at its origin or ahead of it counts. One that starts `inside`
// the box is first in the cell behind all crossings up to its origin; faceAxis is 3 if that is
// solid. One that starts outside misses if it runs away from the box on any axis.
[[nodiscard]] LatticeHit castExactRay(const DenseModel& model, const LatticeRay& ray, bool inside);
// In the box, whose minimum faces belong to it and whose maximum faces do not.
[[nodiscard]] bool startsInside(const DenseModel& model, const LatticeRay& ray);

// So that failures print what was hit.
[[nodiscard]] bool sameHit(const LatticeHit& a, const LatticeHit& b);
[[nodiscard]] std::string describe(const LatticeHit& hit);
[[nodiscard]] std::string describe(const LatticeRay& ray);

}  // namespace voxprite::test
