// The records of core/lod/cluster_page.h, and the rule by which a cluster is chosen: the lines of
// core/lod/cluster_cut.cpp in the same order.

struct ClusterPage {
    vec3 centre;
    float radius;
    vec3 lod_bounds_centre;
    float lod_bounds_radius;
    vec3 parent_bounds_centre;
    float parent_bounds_radius;
    float lod_error;
    float parent_error;
    uint first_index;
    uint index_count;
};

struct ClusterCutParams {
    mat4 world_from_tree;  // [0][3] is the nearest distance
    vec3 camera_position;
    float tan_half_fov_y;
    float viewport_height;
    float pixel_budget;
    float world_scale;
    uint cluster_count;
};

const float kEndlessError = uintBitsToFloat(0x7F800000u);

float projectedError(float error, vec3 centre, float radius, ClusterCutParams params) {
    if (error == 0.0) return 0.0;
    if (error == kEndlessError) return kEndlessError;
    mat4 m = params.world_from_tree;
    precise vec3 world =
        m[0].xyz * centre.x + m[1].xyz * centre.y + m[2].xyz * centre.z + m[3].xyz;
    precise vec3 away = world - params.camera_position;
    precise float surface = sqrt(dot(away, away)) - radius * params.world_scale;
    precise float reach = max(surface, m[0].w);
    precise float shown = error * params.world_scale * (0.5 * params.viewport_height) /
                          (reach * params.tan_half_fov_y);
    return shown;
}

bool choosesCluster(ClusterPage page, ClusterCutParams params) {
    return projectedError(page.lod_error, page.lod_bounds_centre, page.lod_bounds_radius, params) <=
               params.pixel_budget &&
           params.pixel_budget < projectedError(page.parent_error, page.parent_bounds_centre,
                                                page.parent_bounds_radius, params);
}
