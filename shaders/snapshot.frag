// The snapshot's pixel under a fragment, or the mean of several snapshots'.

#include "shared/snapshot.glsl"

layout(location = 0) flat in int snapshot_index;

layout(binding = 4) uniform sampler2DArray snapshot_colours;
layout(binding = 5) uniform sampler2DArray snapshot_depths;  // reversed; 0 where there is sky

layout(location = 0) out vec4 colour;

// As in sprite_mapping.glsl. False outside the picture; pixels count from the left and bottom.
bool snapshotPixel(SnapshotLayer one, out ivec2 pixel) {
    precise vec2 offset = gl_FragCoord.xy - one.screen_reference;
    precise vec3 uvw = fma(one.pixel_from_screen[0].xyz, vec3(offset.x),
                           fma(one.pixel_from_screen[1].xyz, vec3(offset.y),
                               one.pixel_from_screen[2].xyz));
    precise vec2 uv = floor(uvw.xy * (1.0 / uvw.z));
    pixel = ivec2(uv);
    return uvw.z > 0.0 && all(lessThan(uvec2(pixel), uvec2(snapshot_size_px)));
}

void main() {
    vec3 sum = vec3(0.0);
    float weight = 0.0;
    float covered = 0.0;
    float heaviest = 0.0;
    float metres = snapshots[snapshot_index].nearest_metres;
    for (int k = 0; k < snapshots[snapshot_index].layer_count; ++k) {
        SnapshotLayer one = snapshots[snapshot_index].layers[k];
        weight += one.weight;
        ivec2 pixel;
        if (!snapshotPixel(one, pixel)) continue;
        float depth = texelFetch(snapshot_depths, ivec3(pixel, one.layer), 0).r;
        if (depth == 0.0) continue;
        sum += one.weight * texelFetch(snapshot_colours, ivec3(pixel, one.layer), 0).rgb;
        covered += one.weight;
        if (one.weight <= heaviest) continue;
        heaviest = one.weight;
        float behind = snapshots[snapshot_index].near_voxels / depth -
                       snapshots[snapshot_index].eye_voxels;
        metres = dot(one.metres_from_pixel, vec4(pixel, behind, 1.0));
    }
    if (!(covered > 0.0 && 2.0 * covered >= weight)) discard;
    colour = vec4(sum / covered, 1.0);
    if (depth_per_pixel != 0) {
        metres = max(metres, snapshots[snapshot_index].nearest_metres);
        gl_FragDepth =
            (snapshot_depth_from_metres.x * metres + snapshot_depth_from_metres.y) /
            (snapshot_depth_from_metres.z * metres + snapshot_depth_from_metres.w);
    } else {
        gl_FragDepth = gl_FragCoord.z;
    }
}
