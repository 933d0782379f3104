#include "core/edit/shapes.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/edit/cube_bits.h"

namespace voxprite {

namespace {

// Offset of the voxel `i` of `edge` from the middle, in half voxels.
int offsetOf(int i, int edge) {
    return 2 * i + 1 - edge;
}

bool isMiddle(int i, int edge) {
    return std::abs(offsetOf(i, edge)) <= 1;
}

// The square of an edge as the rule of the ellipse takes it. A circle of 3 would be a full square.
std::int64_t squaredEdge(int edge, bool circleOfThree) {
    return circleOfThree ? 7 : std::int64_t{edge} * edge;
}

// The largest run of voxels around the middle of `edge`, of the same parity, for which
// `inside(offset)` holds at its ends; 0 when there is none.
template <class Inside>
int centredRun(int edge, const Inside& inside) {
    // Binary search over the half length: the runs inside are nested.
    int inLength = edge % 2 == 0 ? 0 : -1;
    int outLength = edge + 2;
    while (outLength - inLength > 2) {
        const int length = inLength + (outLength - inLength) / 4 * 2;
        (inside(length - 1) ? inLength : outLength) = length;
    }
    return std::max(inLength, 0);
}

// Every shape here is convex and symmetric: over the voxel (x, y) of the box it is a run along z
// around the middle, of so many voxels.
class Profile {
  public:
    explicit Profile(const Shape& shape) : shape_(shape), size_(shape.box.size()) {
        runs_.resize(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y));
        for (int x = 0; x < size_.x; ++x) {
            for (int y = 0; y < size_.y; ++y) runs_[index(x, y)] = runOf(x, y);
        }
    }

    // 0 outside.
    [[nodiscard]] int run(int x, int y) const {
        if (x < 0 || y < 0 || x >= size_.x || y >= size_.y) return 0;
        return runs_[index(x, y)];
    }
    // Of those voxels all of whose six neighbours belong to the shape.
    [[nodiscard]] int innerRun(int x, int y) const {
        return std::max(0, std::min({run(x, y) - 2, run(x - 1, y), run(x + 1, y), run(x, y - 1),
                                     run(x, y + 1)}));
    }

  private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(x) * static_cast<std::size_t>(size_.y) +
               static_cast<std::size_t>(y);
    }

    [[nodiscard]] int runOf(int x, int y) const {
        switch (shape_.kind) {
            case ShapeKind::box:
                return size_.z;
            case ShapeKind::ellipsoid:
                return ellipsoidRun(x, y);
            case ShapeKind::cylinder:
                return cylinderRun(x, y);
        }
        return 0;
    }

    [[nodiscard]] int ellipsoidRun(int x, int y) const {
        const glm::ivec3 n = size_;
        const bool ofThree = n.x * n.y * n.z == 9 && n.x + n.y + n.z == 7;  // 3 x 3 x 1
        std::int64_t squared[3];
        for (int axis = 0; axis < 3; ++axis) {
            squared[axis] = squaredEdge(n[axis], ofThree && n[axis] == 3);
        }
        const std::int64_t ox = offsetOf(x, n.x);
        const std::int64_t oy = offsetOf(y, n.y);
        const std::int64_t all = squared[0] * squared[1] * squared[2];
        const std::int64_t used =
            ox * ox * squared[1] * squared[2] + oy * oy * squared[0] * squared[2];
        const int run = centredRun(
            n.z, [&](std::int64_t oz) { return used + oz * oz * squared[0] * squared[1] <= all; });
        return std::max(run, spine(x, y));
    }

    // The rows through the middle run the full length, however thin the shape.
    [[nodiscard]] int spine(int x, int y) const {
        const bool middleX = isMiddle(x, size_.x);
        const bool middleY = isMiddle(y, size_.y);
        if (middleX && middleY) return size_.z;
        return middleX || middleY ? 2 - size_.z % 2 : 0;
    }

    // An ellipse of the axes a and b: the run of b at the voxel i of a.
    [[nodiscard]] static int ellipseRun(int i, int edgeA, int edgeB) {
        if (isMiddle(i, edgeA)) return edgeB;
        const bool ofThree = edgeA == 3 && edgeB == 3;
        const std::int64_t a = squaredEdge(edgeA, ofThree);
        const std::int64_t b = squaredEdge(edgeB, ofThree);
        const std::int64_t offset = offsetOf(i, edgeA);
        const int run = centredRun(edgeB, [&](std::int64_t across) {
            return offset * offset * b + across * across * a <= a * b;
        });
        return std::max(run, 2 - edgeB % 2);
    }

    [[nodiscard]] int cylinderRun(int x, int y) const {
        if (shape_.axis == 0) return ellipseRun(y, size_.y, size_.z);
        if (shape_.axis == 1) return ellipseRun(x, size_.x, size_.z);
        const int inRow = ellipseRun(x, size_.x, size_.y);
        return std::abs(offsetOf(y, size_.y)) < inRow ? size_.z : 0;
    }

    Shape shape_;
    glm::ivec3 size_;
    std::vector<int> runs_;
};

// The voxels of a centred run, from the box's lower end.
struct Range {
    int first = 0;
    int end = 0;
};
Range centredRange(int edge, int run) {
    return {(edge - run) / 2, (edge + run) / 2};
}

// Bits first ... end - 1 of a row of eight that begins at `rowStart`.
std::uint64_t rowBits(Range range, int rowStart) {
    const int first = std::clamp(range.first - rowStart, 0, 8);
    const int end = std::clamp(range.end - rowStart, 0, 8);
    return (std::uint64_t{1} << end) - (std::uint64_t{1} << first);
}

CubeBits cubeBitsOf(const Profile& profile, const Shape& shape, glm::ivec3 origin) {
    CubeBits bits{};
    const glm::ivec3 corner = origin - shape.box.min;
    const int edge = shape.box.size().z;
    for (int x = 0; x < kCubeEdge; ++x) {
        for (int y = 0; y < kCubeEdge; ++y) {
            const int run = profile.run(corner.x + x, corner.y + y);
            std::uint64_t row = rowBits(centredRange(edge, run), corner.z);
            if (shape.hollow && row != 0) {
                const int inner = profile.innerRun(corner.x + x, corner.y + y);
                row &= ~rowBits(centredRange(edge, inner), corner.z);
            }
            bits[static_cast<std::size_t>(x)] |= row << (8 * y);
        }
    }
    return bits;
}

Status checkEdges(const IBox& box) {
    const glm::ivec3 size = box.size();
    const int longest = std::max({size.x, size.y, size.z});
    if (longest > kMaxShapeEdge) {
        return fail("A shape of " + std::to_string(size.x) + " x " + std::to_string(size.y) +
                    " x " + std::to_string(size.z) + " voxels is too large: an edge has at most " +
                    std::to_string(kMaxShapeEdge));
    }
    if (!isInVoxelRange(box.min) || !isInVoxelRange(box.max - 1)) {
        return fail("The shape reaches beyond +-" + std::to_string(kMaxCoordinate) + " voxels");
    }
    return {};
}

}  // namespace

Result<VoxelSet> shapeVoxels(const Shape& shape) {
    VoxelSet set;
    if (shape.box.empty()) return set;
    if (Status s = checkEdges(shape.box); !s) return tl::unexpected(s.error());
    if (shape.kind == ShapeKind::box && !shape.hollow) return VoxelSet(shape.box);
    const Profile profile(shape);
    const glm::ivec3 first = cubeOf(shape.box.min);
    for (int x = first.x; x < shape.box.max.x; x += kCubeEdge) {
        for (int y = first.y; y < shape.box.max.y; y += kCubeEdge) {
            for (int z = first.z; z < shape.box.max.z; z += kCubeEdge) {
                const glm::ivec3 origin(x, y, z);
                insertBits(set, origin, cubeBitsOf(profile, shape, origin));
            }
        }
    }
    return set;
}

Result<VoxelSet> lineVoxels(const BrushTip& tip, glm::ivec3 a, glm::ivec3 b) {
    const IBox reach = tipBox(tip, a).united(tipBox(tip, b));
    if (Status s = checkEdges(reach); !s) return tl::unexpected(s.error());
    BrushTrail trail(tip);
    trail.startAt(a);
    trail.lineTo(b);
    return trail.covered();
}

}  // namespace voxprite
