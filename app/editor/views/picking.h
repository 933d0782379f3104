// What lies under the pointer in the edit view: a face of a voxel, or the ground.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "core/base/box.h"
#include "core/sprite/camera.h"
#include "core/svo/live_octree.h"

namespace voxprite::editor {

struct Pick {
    glm::ivec3 voxel{0};  // entity space; for the ground the cell under it
    glm::ivec3 normal{0, 0, 1};
    bool ground = false;

    [[nodiscard]] glm::ivec3 attachTo() const { return voxel + normal; }
    [[nodiscard]] int axis() const { return normal.x != 0 ? 0 : normal.y != 0 ? 1 : 2; }
    // The picked face lies in the plane of this coordinate of axis().
    [[nodiscard]] int facePlane() const {
        return normal[axis()] > 0 ? voxel[axis()] + 1 : voxel[axis()];
    }
    bool operator==(const Pick&) const = default;
};

// `ray` in the edit view's world, where a unit is a voxel and the origin that of entity space. The
// ground is the plane under `bounds`, as far as a model's length away from it.
[[nodiscard]] std::optional<Pick> pick(const LiveOctree& octree, const IBox& bounds,
                                       const Camera::Ray& ray);

// Where `ray` meets the plane in which coordinate `axis` of voxel space is `plane`.
[[nodiscard]] std::optional<glm::dvec3> meetPlane(const Camera::Ray& ray, int axis, double plane);

// Entity-space corners of the picked face, in order around it.
[[nodiscard]] std::array<glm::dvec3, 4> faceCorners(const Pick& pick);

}  // namespace voxprite::editor
