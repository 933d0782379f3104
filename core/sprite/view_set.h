// Sets of directions from which a model is seen: what snapshots are taken from, and what a sprite
// may be snapped to instead of steps of yaw and pitch.
//
// Voxel space (Z up). A direction is a unit vector from the model's centre toward the eye. With it
// go the axes of its picture: forward is its opposite, right = forward x Z, up = right x forward;
// straight from above and below +X is up.
//
//   canonical26   the 26 of the snapshot cache, in its order: +x -x +y -y +z -z; the 12 between two
//                 axes, for each pair of signs a, b from - to + (a, b, 0), (a, 0, b), (0, a, b);
//                 the 8 corners, x slowest.
//   octahedral    the middles of N x N cells of the octahedral map of the sphere (Cigolle et al.
//                 2014), row by row; no two are equal.
//   hemisphere    the N x N corners of the octahedral map of the upper half sphere, turned by 45
//                 degrees (Brucks 2018): its border is the horizon, its corners are +-x and +-y.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace voxprite {

// How a view's picture is turned in the plane that it is drawn in.
enum class SnapshotRoll : std::uint8_t {
    matched,  // so that the model's points lie near their true places, see rolledToMatch
    own       // not at all: upright wherever the camera is, and off by any angle near the poles
};

class ViewSet {
  public:
    enum class Layout : std::uint8_t { canonical26, octahedral, hemisphere };
    static constexpr int kLeastEdge = 2;
    static constexpr int kMostEdge = 64;

    // The 26.
    ViewSet();
    // N x N; fails when N is not within kLeastEdge ... kMostEdge.
    [[nodiscard]] static Result<ViewSet> octahedral(int edge);
    [[nodiscard]] static Result<ViewSet> hemisphere(int edge);
    // "canonical26", "octahedral:N" or "hemisphere:N", as name() gives it.
    [[nodiscard]] static Result<ViewSet> named(std::string_view name);
    [[nodiscard]] std::string name() const;

    [[nodiscard]] Layout layout() const { return layout_; }
    [[nodiscard]] int count() const { return static_cast<int>(directions_.size()); }
    [[nodiscard]] const glm::dvec3& direction(int view) const {
        return directions_[static_cast<std::size_t>(view)];
    }
    // right, up and forward, orthonormal.
    [[nodiscard]] glm::dmat3 axes(int view) const;
    // The angle in radians between neighbours if all were equally far apart.
    [[nodiscard]] double spacing() const;

    SnapshotRoll roll = SnapshotRoll::matched;

    // The view with the largest dot product with `towardEye` (any length); of equals the first in
    // order. A half sphere is asked from the horizon for what lies below it, and with -y for
    // straight below. Nothing for a vector of length zero, or that is not finite. Takes 26 dot
    // products, or 25 in a grid of any size.
    [[nodiscard]] std::optional<int> nearest(glm::dvec3 towardEye) const;
    // The same with hysteresis: `before` stays until the direction is past the middle between it
    // and another by a tenth of spacing().
    [[nodiscard]] std::optional<int> nearest(glm::dvec3 towardEye,
                                             const std::optional<int>& before) const;

    // Views to mix, nearest first, their weights summing to 1. The three nearest, each weighing
    // (f - a) / a where a is its angle and f that of the fourth: so weights change without a step
    // when views come and go, and at a view it alone counts. Empty where nearest gives nothing.
    struct Weighted {
        int view = 0;
        double weight = 1.0;
    };
    [[nodiscard]] std::vector<Weighted> blend(glm::dvec3 towardEye) const;

  private:
    ViewSet(Layout layout, int edge);
    [[nodiscard]] int nearestInGrid(glm::dvec3 direction) const;
    [[nodiscard]] glm::dvec3 asked(glm::dvec3 towardEye) const;

    Layout layout_ = Layout::canonical26;
    int edge_ = 0;  // of a grid
    std::vector<glm::dvec3> directions_;
};

}  // namespace voxprite
