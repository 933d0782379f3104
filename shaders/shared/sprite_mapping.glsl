// From a screen position to the virtual pixel under it: the only floating-point step of a sprite,
// one function for both modes, and `precise`, so that they agree in every pixel.

#include "shared/sprite_varyings.glsl"

// False outside the region. The cell counts from the region's left and bottom.
bool virtualPixel(vec2 screen, out ivec2 cell) {
    precise vec2 offset = screen - screen_reference;
    precise vec3 uvw = pixel_from_screen_x * offset.x + pixel_from_screen_y * offset.y +
                       pixel_from_screen_1;
    precise vec2 uv = floor(uvw.xy / uvw.z);
    if (!(uvw.z > 0.0) || any(lessThan(uv, vec2(0))) ||
        any(greaterThanEqual(uv, vec2(region_size)))) {
        return false;
    }
    cell = ivec2(uv);
    return true;
}
