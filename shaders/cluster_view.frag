// The voxels as clusters show them, lit and shaded as rays show them.

#include "shared/octree_block.glsl"
#include "shared/voxel_view.glsl"
#include "shared/voxel_walk.glsl"
#include "shared/voxel_shading.glsl"

layout(location = 0) flat in int face;
layout(location = 1) flat in int face_plane;
layout(location = 2) flat in uint material;
layout(location = 3) flat in vec4 tint;

layout(location = 0) out vec4 colour;

// Where the eye ray meets the plane of the face.
Hit hitOnFace(vec3 origin, vec3 direction) {
    int middle = 1 << (int(svo_max_depth) - 1);
    Hit hit;
    hit.material = material;
    hit.axis = face % 3;
    hit.t = (float(face_plane - middle) - along(origin, hit.axis)) / along(direction, hit.axis);
    hit.cell = ivec3(floor(origin + direction * hit.t)) + middle;
    hit.cell[hit.axis] = face < 3 ? face_plane - 1 : face_plane;
    return hit;
}

void main() {
    vec2 screen = gl_FragCoord.xy;
    vec3 origin = voxelRayOrigin(screen);
    vec3 direction = voxelRayDirection(screen);
    Hit hit = hitOnFace(origin, direction);
    Cursor cursor;
    startAtRoot(cursor);
    vec3 shaded = voxelColour(hit, facePoint(hit, screen, origin, direction), cursor);
    float brightness = dot(shaded, vec3(0.30, 0.59, 0.11));
    colour = vec4(mix(shaded, tint.rgb * (0.35 + 0.65 * brightness), tint.a), 1.0);
}
