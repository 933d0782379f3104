// Of each sprite: its rays and the octree that they meet.

#include "shared/flat_inputs.glsl"

layout(location = 5, component = 3) Flat int palette_row;
layout(location = 6) Flat ivec3 lattice_origin;  // C from the centre corner
layout(location = 6, component = 3) Flat int position_bits;
layout(location = 7) Flat ivec3 lattice_right;      // U
layout(location = 8) Flat ivec3 lattice_up;         // V
layout(location = 9) Flat ivec3 lattice_direction;  // D
layout(location = 10) Flat uvec3 svo_model_size;
layout(location = 10, component = 3) Flat uint svo_max_depth;
layout(location = 11) Flat ivec3 tree_from_voxel;
layout(location = 13) Flat uint node_offset;
layout(location = 13, component = 1) Flat uint payload_offset;
#ifdef FACE_SHADE
layout(location = 14) Flat ivec3 toward_light;
#endif
