// The point of a mesh that is nearest to another: a tree of boxes over the triangles.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "core/io/triangle_mesh.h"

namespace voxprite {

struct SurfacePoint {
    std::uint32_t triangle = 0;
    glm::dvec3 weights{1.0, 0.0, 0.0};  // of the corners: at least 0, together 1
    glm::dvec3 position{0.0};
    double squaredDistance = 0.0;
};

// Of one triangle (Ericson, "Real-Time Collision Detection", 2005, 5.1.5).
[[nodiscard]] SurfacePoint nearestOnTriangle(const MeshTriangle& triangle, std::uint32_t index,
                                             const glm::dvec3& point);

// Whether `point`, to which `nearest` is the nearest point of the triangle, is on its inner side.
[[nodiscard]] bool isBehind(const MeshTriangle& triangle, const SurfacePoint& nearest,
                            const glm::dvec3& point);

// Reading from several threads at once is safe. The triangles must outlive it, unchanged.
class NearestTriangle {
  public:
    explicit NearestTriangle(std::span<const MeshTriangle> triangles);  // at least one

    // Of equally near ones the triangle with the lowest index. `hint`, any triangle, changes how
    // soon the answer is found and never what it is.
    [[nodiscard]] SurfacePoint nearest(const glm::dvec3& point, std::uint32_t hint = 0) const;

    // For a point inside of touching bodies, whose sides lie on each other: of the triangles that
    // are at most `slack` farther away than `nearest`, the first that the point is behind;
    // `nearest` itself where there is none.
    [[nodiscard]] SurfacePoint nearestFromBehind(const glm::dvec3& point,
                                                 const SurfacePoint& nearest, double slack) const;

  private:
    struct Node {
        glm::dvec3 low, high;
        std::uint32_t first = 0;  // of order_, in a leaf; else the node of the upper half
        std::uint32_t count =
            0;  // of triangles, in a leaf; else 0: the lower half is the next node
    };
    std::uint32_t build(std::uint32_t first, std::uint32_t last);

    std::span<const MeshTriangle> triangles_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace voxprite
