// The octants of CSM text are the letters a ... h with the bits (x, y, z), x the high one; those of
// our octrees have z in the high bit (core/svo/octree.h). Here, and nowhere else, one becomes the
// other: the bits change places, which is its own inverse.
#pragma once

namespace voxprite::csm {

[[nodiscard]] constexpr unsigned octantFromCsm(unsigned csm) {
    return (csm >> 2 & 1u) | (csm & 2u) | (csm & 1u) << 2;
}
[[nodiscard]] constexpr unsigned octantFromLetter(char letter) {
    return octantFromCsm(static_cast<unsigned>(letter - 'a'));
}
[[nodiscard]] constexpr char letterOf(unsigned octant) {
    return static_cast<char>('a' + octantFromCsm(octant));
}

}  // namespace voxprite::csm
