// Snapshots as they are drawn: up to three layers of two texture arrays, each where its plane is.

struct SnapshotLayer {
    vec4 pixel_from_screen[3];  // per x, per y, constant: of a position from screen_reference, y up
    vec4 metres_from_pixel;     // along the camera: x * pixel.x + y * pixel.y + z * behind + w
    vec2 screen_reference;
    float weight;
    int layer;
};

struct ShownSnapshot {
    vec4 corners[4];  // clip space
    SnapshotLayer layers[3];
    int layer_count;
    float nearest_metres;  // no pixel is nearer
    float near_voxels;     // of the snapshot's eye: its depths are near_voxels / depth
    float eye_voxels;      // of the eye from the model's centre
};

layout(std430, binding = 6) readonly buffer Snapshots {
    ShownSnapshot snapshots[];
};

layout(std140, binding = 10) uniform SnapshotDraw {
    vec4 snapshot_depth_from_metres;  // depth = (x * metres + y) / (z * metres + w)
    int snapshot_size_px;
    int depth_per_pixel;
};
