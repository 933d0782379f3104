// Anti-aliased lines of a grid on a plane.

// How much of the pixel lines at whole multiples of `cell` cover. `footprint` is the pixel's extent
// on the plane along both axes; lines finer than the footprint melt into their mean.
float gridCoverage(vec2 position, float cell, float width, vec2 footprint) {
    vec2 wide = max(vec2(width), footprint);
    vec2 from_line = abs(fract(position / cell - 0.5) - 0.5) * cell;
    vec2 line = (1.0 - smoothstep(0.5 * wide - 0.5 * footprint, 0.5 * wide + 0.5 * footprint,
                                  from_line)) * (width / wide);
    return max(line.x, line.y) * clamp(1.5 - max(footprint.x, footprint.y) / (0.4 * cell), 0.0, 1.0);
}
