// Of each sprite: its rays and the octree that they meet.

#include "shared/flat_inputs.glsl"

Flat(5, 3) int palette_row;
Flat(6, 0) ivec3 lattice_origin;  // C from the centre corner
Flat(6, 3) int position_bits;
Flat(7, 0) ivec3 lattice_right;      // U
Flat(8, 0) ivec3 lattice_up;         // V
Flat(9, 0) ivec3 lattice_direction;  // D
Flat(10, 0) uvec3 svo_model_size;
Flat(10, 3) uint svo_max_depth;
Flat(11, 0) ivec3 tree_from_voxel;
Flat(13, 0) uint node_offset;
Flat(13, 1) uint payload_offset;
#ifdef FACE_SHADE
Flat(14, 0) ivec3 toward_light;
#endif
