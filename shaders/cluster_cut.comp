// Which clusters stand for the instances of one mesh: one invocation a page (x) and instance (y).
//
// Every pair has a place of its own among the commands; what is not drawn draws no instance. So the
// order of drawing is always the same, nothing is counted, and nothing is read back.

#include "shared/cluster_page.glsl"

layout(local_size_x = 64) in;

layout(std140, binding = 8) uniform ClusterCutBlock {
    uint first_instance;  // of the mesh
    uint page_count;
    uint first_command;
    uint culled;  // 1: clusters beside the picture are left out
};

layout(std430, binding = 3) readonly buffer Pages {
    ClusterPage pages[];
};

struct Cut {
    ClusterCutParams params;
    vec4 planes[5];  // of the picture, in tree space, inward: what lies below 0 is not shown
};

layout(std430, binding = 4) readonly buffer Cuts {
    Cut cuts[];
};

// As glMultiDrawElementsIndirect reads it.
struct DrawCommand {
    uint index_count;
    uint instance_count;
    uint first_index;
    int base_vertex;
    uint base_instance;
};

layout(std430, binding = 5) writeonly buffer Commands {
    DrawCommand commands[];
};

bool inPicture(ClusterPage page, uint instance) {
    // Room for the rounding of planes and sphere.
    float radius = page.radius + 1e-4 * (page.radius + length(page.centre)) + 0.5;
    for (int k = 0; k < 5; ++k) {
        vec4 plane = cuts[instance].planes[k];
        if (dot(plane.xyz, page.centre) + plane.w < -radius) return false;
    }
    return true;
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= page_count) return;
    uint instance = first_instance + gl_WorkGroupID.y;
    ClusterPage page = pages[index];
    bool chosen = page.index_count > 0u && choosesCluster(page, cuts[instance].params) &&
                  (culled == 0u || inPicture(page, instance));
    uint slot = first_command + gl_WorkGroupID.y * page_count + index;
    commands[slot] = DrawCommand(page.index_count, chosen ? 1u : 0u, page.first_index, 0, instance);
}
