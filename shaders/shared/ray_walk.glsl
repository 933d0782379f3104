// A ray quantised, walked exactly: the twin of castQuantised of core/trace/raycast.h, bit for bit
// for the same integers. In tree space: steps from the root's minimum corner.
//
// Products need 43 bits: exact in doubles. Who includes this declares what octree.glsl asks for.

#define LATTICE_WIDE
int position_bits = 0;

#include "shared/lattice_point.glsl"
#include "shared/octree.glsl"
#include "shared/lattice_walk.glsl"

const int kRayEdgeBits = 21;       // steps of the root's edge
const int kRayDirectionBits = 19;  // the largest component of a direction is 2^19

// [low, high): the box, whole nodes of the leaf level. Met axis 3: the ray starts in what it meets.
Meeting castQuantised(ivec3 origin, ivec3 direction, bool inside, ivec3 low, ivec3 high,
                      out Cursor cursor) {
    startAtRoot(cursor);
    position_bits = kRayEdgeBits - int(svo_max_depth);
    mirrorLines(direction, low, high, ivec3(0));
    dvec3 start = dvec3(mirror_sign * origin);
    Crossing crossing = latest(box_low, start);
    // From inside, every crossing up to the start has been made.
    if (inside && crossing.numerator <= 0.0LF) crossing = Crossing(3, 0.0LF, 1.0LF);
    Meeting met = walkLine(crossing, start, cursor);
    if (leafLevel() > 0 && met.material != 0u) {
        met.material = firstMaterial(path_words[cursor.shift]);
    }
    return met;
}

// The model's box in tree coordinates, grown to whole nodes of the leaf level.
void castableBox(out ivec3 low, out ivec3 high) {
    int edge = 1 << int(svo_max_depth);
    low = clamp(tree_from_voxel, 0, edge);
    high = clamp(tree_from_voxel + ivec3(svo_model_size), 0, edge);
    low = (low >> leafLevel()) << leafLevel();
    high = (((high - 1) >> leafLevel()) + 1) << leafLevel();
}
