// For `voxprite bench`: the specification's single pass, in floating point. Every fragment casts a
// ray through the octree, and on a miss those of its four neighbours.

#include "shared/bench_seed.glsl"

layout(binding = 0) uniform usampler2D svo_texture;
layout(binding = 1) uniform sampler2D palette_texture;  // lit; column = material, row = face axis

layout(location = 0) out vec4 colour;

#ifdef COUNT_RAYS
layout(std430, binding = 1) buffer Count {
    uint rays;
};
#endif

const uint kWidthBits = 12u;
const float kEpsilon = 1e-4;
const int kMaxSteps = 1024;

uint svoTexel(uint index) {
    return texelFetch(svo_texture,
                      ivec2(int(index & ((1u << kWidthBits) - 1u)), int(index >> kWidthBits)), 0).r;
}

// The material of a cell, and the edge of the largest node known to be of one kind.
uint materialAt(ivec3 cell, out float edge) {
    uint word = svoTexel(node_offset);
    int bit = int(svo_max_depth);
    while ((word & 0x80000000u) != 0u) {
        --bit;
        ivec3 side = (cell >> bit) & 1;
        uint octant = uint(side.x | (side.y << 1) | (side.z << 2));
        uint children = word & 0xFFu;
        if (((children >> octant) & 1u) == 0u) {
            edge = float(1 << bit);
            return 0u;
        }
        word = svoTexel(node_offset + ((word & 0x7FFFFF00u) >> 8u) +
                        uint(bitCount(children & ((1u << octant) - 1u))));
    }
    if ((word & 0x40000000u) != 0u) {
        ivec3 side = cell & 1;
        uint payload = payload_offset + 2u * (word & 0x3FFFFFFFu) + uint(side.z);
        edge = 1.0;
        return (svoTexel(payload) >> uint(8 * (side.x | (side.y << 1)))) & 0xFFu;
    }
    edge = float(1 << bit);
    return word & 0xFFu;
}

// The material hit, or 0; and the axis of the face.
uint castRay(vec3 origin, out int axis) {
#ifdef COUNT_RAYS
    atomicAdd(rays, 1u);
#endif
    vec3 size = vec3(svo_model_size);
    vec3 inverse = 1.0 / ray_dir_local;
    vec3 a = -origin * inverse;
    vec3 b = (size - origin) * inverse;
    vec3 lower = min(a, b);
    vec3 upper = max(a, b);
    float t = max(max(lower.x, lower.y), lower.z);
    float leave = min(min(upper.x, upper.y), upper.z);
    axis = lower.x >= lower.y && lower.x >= lower.z ? 0 : (lower.y >= lower.z ? 1 : 2);
    vec3 ahead = vec3(greaterThan(ray_dir_local, vec3(0.0)));
    for (int k = 0; k < kMaxSteps && t < leave; ++k) {
        vec3 cell = floor(origin + ray_dir_local * (t + kEpsilon));
        if (any(lessThan(cell, vec3(0.0))) || any(greaterThanEqual(cell, size))) return 0u;
        float edge;
        uint material = materialAt(ivec3(cell), edge);
        if (material != 0u) return material;
        vec3 crossing = ((floor(cell / edge) + ahead) * edge - origin) * inverse;
        t = min(min(crossing.x, crossing.y), crossing.z);
        axis = crossing.x <= t ? 0 : (crossing.y <= t ? 1 : 2);
    }
    return 0u;
}

void main() {
    vec2 ndc = gl_FragCoord.xy / viewport_size * 2.0 - 1.0;
    vec2 offset = (ndc - center_ndc) * camera_distance * proj_scale / voxel_size;
    vec2 snapped = round(offset * sigma) / sigma;
    vec3 right = cross(ray_dir_local, camera_up_local);
    float longest = float(max(max(svo_model_size.x, svo_model_size.y), svo_model_size.z));
    vec3 origin = anchor_to_center + snapped.x * right + snapped.y * camera_up_local -
                  ray_dir_local * (2.0 * longest);
    gl_FragDepth = billboard_depth;
    int axis;
    uint material = castRay(origin, axis);
    if (material != 0u) {
        colour = texelFetch(palette_texture, ivec2(int(material), axis), 0);
        return;
    }
    vec3 across = right / sigma;
    vec3 upward = camera_up_local / sigma;
    if (castRay(origin - across, axis) == 0u && castRay(origin + across, axis) == 0u &&
        castRay(origin + upward, axis) == 0u && castRay(origin - upward, axis) == 0u) {
        discard;
    }
    colour = vec4(0.0, 0.0, 0.0, 1.0);
}
