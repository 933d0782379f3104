// A cluster's quads in the voxel view, where each pixel finds its voxel on the face.

#include "shared/cluster_vertex.glsl"

layout(location = 0) flat out int face;
layout(location = 1) flat out int face_plane;  // tree coordinate along the face's axis
layout(location = 2) flat out uint material;
layout(location = 3) flat out vec4 tint;  // alpha: its strength

void main() {
    ClusterCorner corner = clusterCorner();
    gl_Position = clipPosition(corner);
    int axis = corner.face % 3;
    face = corner.face;
    face_plane = int(corner.from_eye_cell[axis]) + eye_cell[axis];
    material = corner.material;
    tint = vec4(levelColour(corner.level), level_tint);
}
