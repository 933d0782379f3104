// Shapes that fill a box of voxels exactly: they touch all six sides of it and equal their own
// mirror images, for odd and even edges alike.
//
// A voxel belongs to a round shape when its centre lies within the ellipsoid (or ellipse) that the
// box encloses. In integers, with offsets measured in half voxels from the centre:
//   sum over the axes of (2 i + 1 - n)^2 / n^2 <= 1,  n the edge on that axis.
// A circle of diameter 8 has rows of 4 6 8 8 8 8 6 4. The one exception is a circle of diameter 3,
// where the rule would give the full square: it is a cross.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "core/base/result.h"
#include "core/edit/brush.h"
#include "core/edit/voxel_set.h"

namespace voxprite {

enum class ShapeKind : std::uint8_t {
    box,
    ellipsoid,  // a sphere in a cube
    cylinder    // elliptic, along `axis`
};

inline constexpr int kMaxShapeEdge = 1024;

struct Shape {
    ShapeKind kind = ShapeKind::box;
    IBox box;             // what it fills
    int axis = 2;         // 0, 1 or 2; of a cylinder
    bool hollow = false;  // only the wall: voxels with a face toward the outside
    bool operator==(const Shape&) const = default;
};

// Fails when an edge exceeds kMaxShapeEdge or the box leaves the range of coordinates. An empty box
// gives an empty set.
[[nodiscard]] Result<VoxelSet> shapeVoxels(const Shape& shape);

// The tip swept along voxelLine(a, b). Fails when it is longer than kMaxShapeEdge.
[[nodiscard]] Result<VoxelSet> lineVoxels(const BrushTip& tip, glm::ivec3 a, glm::ivec3 b);

}  // namespace voxprite
