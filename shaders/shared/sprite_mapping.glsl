// From a screen position to the virtual pixel under it: the only floating-point step of a sprite,
// one function for both modes, and `precise`, so that they agree in every pixel.

#include "shared/sprite_varyings.glsl"

// False outside the region. The cell counts from the region's left and bottom.
bool virtualPixel(vec2 screen, out ivec2 cell) {
    precise vec2 offset = screen - screen_reference;
    precise vec3 uvw = fma(pixel_from_screen_x, vec3(offset.x),
                           fma(pixel_from_screen_y, vec3(offset.y), pixel_from_screen_1));
    precise vec2 uv = floor(uvw.xy * (1.0 / uvw.z));
    cell = ivec2(uv);
    // Below zero is beyond the region's end, and what an int does not hold is either.
    return uvw.z > 0.0 && all(lessThan(uvec2(cell), uvec2(region_size)));
}
