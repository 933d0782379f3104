// The row of a sprite's palette that colours a face. Who includes this includes lattice.glsl and
// sprite_draw.glsl before.

#ifdef FACE_SHADE
#include "shared/face_shade.glsl"
#endif

int shadedRow(LatticeHit hit) {
    int row = palette_row + hit.face_axis;
#ifdef FACE_SHADE
    int side = lattice_direction[hit.face_axis] < 0 ? 1 : -1;
    ivec3 front = hit.voxel + tree_from_voxel + axisUnit(hit.face_axis) * side;
    Cursor cursor;
    startAtRoot(cursor);
    int state = 0;
    if (occlusion_shown != 0) {
        state = occlusionLevel(blockedRays(front, hit.face_axis, side, cursor));
    }
    if (shadows_shown != 0 && faceInShadow(front, hit.face_axis, side, toward_light, cursor)) {
        state += kOcclusionLevels;
    }
    row += 3 * state;
#endif
    return row;
}
