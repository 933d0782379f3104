// What stands around a face of a voxel, and between it and the light: the twin of
// core/sprite/face_shade, bit for bit.
//
// Who includes this includes octree.glsl before, and declares svo_model_size and tree_from_voxel.
// Cells are tree coordinates; a face is told by the cell in front of it, its axis and its side (1:
// it looks along the axis, -1: against it).

layout(std140, binding = 5) uniform OcclusionRays {
    // xyz: offset; w: rays | next << 8; after the last step 0.
    ivec4 occlusion_steps[64];
};

const int kOcclusionRays = 16;
const int kOcclusionLevels = 4;

ivec3 axisUnit(int axis) {
    return ivec3(equal(ivec3(axis), ivec3(0, 1, 2)));
}

int blockedRays(ivec3 front, int axis, int side, inout Cursor cursor) {
    ivec3 edge = ivec3(1 << int(svo_max_depth));
    ivec3 low = clamp(tree_from_voxel, ivec3(0), edge);
    ivec3 high = clamp(tree_from_voxel + ivec3(svo_model_size), ivec3(0), edge);
    ivec3 u = axisUnit((axis + 1) % 3);
    ivec3 v = axisUnit((axis + 2) % 3);
    ivec3 outward = axisUnit(axis) * side;
    int blocked = 0;
    for (int k = 0; occlusion_steps[k].w != 0;) {
        ivec4 way = occlusion_steps[k];
        ivec3 cell = front + u * way.x + v * way.y + outward * way.z;
        bool outside = any(lessThan(cell, low)) || any(greaterThanEqual(cell, high));
        if (outside || regionAt(cell, cursor).material == 0u) {
            ++k;
        } else {
            blocked += way.w & 0xFF;
            k = way.w >> 8;
        }
    }
    return blocked;
}

int occlusionLevel(int blocked) {
    return max(0, blocked - 1) / 4;
}

// x / m rounded down, for -1 <= x, 0 < m and quotients below 2^22: those of the model's box.
ivec3 quotient(ivec3 x, int m) {
    ivec3 guess = ivec3(floor(vec3(x) / float(m)));
    ivec3 rest = x - guess * m;
    return guess - ivec3(lessThan(rest, ivec3(0))) + ivec3(greaterThanEqual(rest, ivec3(m)));
}

// The ray from the face's middle toward the light, in half voxels, mirrored so that it runs upwards
// on every axis. What is compared and divided stays below 2^31: the box has at most 2^17 half
// voxels, the direction 13 bits.
bool faceInShadow(ivec3 front, int axis, int side, ivec3 toward, inout Cursor cursor) {
    if (toward[axis] * side <= 0) return false;
    int edge = 1 << int(svo_max_depth);
    bvec3 mirrored = lessThan(toward, ivec3(0));
    ivec3 bits = ivec3(mirrored) * (edge - 1);
    ivec3 speed = abs(toward);
    ivec3 low = clamp(tree_from_voxel, ivec3(0), ivec3(edge));
    ivec3 high = clamp(tree_from_voxel + ivec3(svo_model_size), ivec3(0), ivec3(edge));
    ivec3 box_low = mix(low, edge - high, mirrored);
    ivec3 box_high = mix(high, edge - low, mirrored);
    ivec3 cell = ivec3(mirrored) * (edge - 1 - 2 * front) + front;
    ivec3 start = 2 * cell + 1 - axisUnit(axis);
    while (all(greaterThanEqual(cell, box_low)) && all(lessThan(cell, box_high))) {
        Region region = regionAt(cell ^ bits, cursor);
        if (region.material != 0u) return true;
        ivec3 ends = min(((cell >> region.shift) + 1) << region.shift, box_high);
        // The earliest crossing, of equals that of the lowest axis; axes that stand still have none.
        ivec3 way = mix(2 * ends - start, ivec3(1), equal(speed, ivec3(0)));
        int first = 0;
        if (way.y * speed.x < way.x * speed.y) first = 1;
        if (way.z * speed[first] < way[first] * speed.z) first = 2;
        // An axis above it has not yet crossed a face that it meets at the same time.
        ivec3 later = ivec3(greaterThan(ivec3(0, 1, 2), ivec3(first))) * min(speed, ivec3(1));
        ivec3 next = (start + quotient(way[first] * speed - later, speed[first])) >> 1;
        cell = mix(next, ends, equal(ivec3(first), ivec3(0, 1, 2)));
    }
    return false;
}
