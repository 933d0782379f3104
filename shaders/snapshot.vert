// A flat quad for each snapshot, an instance each.

#include "shared/snapshot.glsl"

layout(location = 0) flat out int snapshot_index;

void main() {
    snapshot_index = gl_InstanceID;
    gl_Position = snapshots[gl_InstanceID].corners[gl_VertexID];
}
