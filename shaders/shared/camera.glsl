// The camera of a picture in metres, camera-relative (the eye at the origin), world axes. A ray's
// direction advances one metre along the camera's forward for each unit of t.

layout(std140, binding = 3) uniform CameraBlock {
    vec4 ray_origin[3];     // per x, per y, constant: of a screen position from the middle
    vec4 ray_direction[3];  // likewise
    vec2 viewport_px;
};

vec3 eyeRayOrigin(vec2 screen) {
    vec2 p = screen - 0.5 * viewport_px;
    return ray_origin[0].xyz * p.x + ray_origin[1].xyz * p.y + ray_origin[2].xyz;
}

vec3 eyeRayDirection(vec2 screen) {
    vec2 p = screen - 0.5 * viewport_px;
    return ray_direction[0].xyz * p.x + ray_direction[1].xyz * p.y + ray_direction[2].xyz;
}
