// The cubes of a CSM text while it is read: shared, turned and mirrored without being copied, so
// that a reference costs nothing however much it stands for.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/model/placement.h"

namespace voxprite::csm {

// One value all through, or eight children; seen turned. Small, passed by value.
struct Cube {
    static constexpr std::uint32_t kFirstNode = 256;
    std::uint32_t index = 0;  // below kFirstNode: the value of a solid; 0 is empty
    SignedPermutation turned;

    [[nodiscard]] bool solid() const { return index < kFirstNode; }
    [[nodiscard]] static Cube of(std::uint8_t value) { return {value, {}}; }
};

// What '/' and '^' do: child `octant` of the result is child from[octant] of the cube, itself
// turned by `inside`.
struct Turn {
    std::array<std::uint8_t, 8> from{0, 1, 2, 3, 4, 5, 6, 7};
    SignedPermutation inside;

    [[nodiscard]] static Turn all(const SignedPermutation& rotation);
    // Exchanges the two halves along an axis, each as it is.
    [[nodiscard]] static Turn halves(unsigned axis);
};
// First b, then a.
[[nodiscard]] Turn operator*(const Turn& a, const Turn& b);

class Cubes {
  public:
    // Octants as in core/svo/octree.h, everywhere.
    [[nodiscard]] Cube node(const std::array<Cube, 8>& children);
    [[nodiscard]] Cube child(Cube cube, unsigned octant) const;
    [[nodiscard]] Cube turned(Cube cube, const Turn& turn);
    // `cube` with `part` at the path. Changes nodes made since the last seal() in place: they must
    // have no other place.
    [[nodiscard]] Cube replaced(Cube cube, std::span<const std::uint8_t> path, Cube part);
    // From now on every cube there is may be used several times.
    void seal() { firstOwn_ = nodes_.size(); }

    // Nodes made so far.
    [[nodiscard]] std::size_t count() const { return nodes_.size(); }
    // Levels of children below the cube, solid ones included.
    [[nodiscard]] int levels(Cube cube) const;
    // Nodes with children when each use is counted; stops counting somewhere beyond 2^32.
    [[nodiscard]] std::uint64_t unfolded(Cube cube) const;

  private:
    struct Node {
        std::array<Cube, 8> children;
        std::uint64_t unfolded = 1;
        int levels = 1;
    };
    [[nodiscard]] Node& at(Cube cube) { return nodes_[cube.index - Cube::kFirstNode]; }
    [[nodiscard]] const Node& at(Cube cube) const { return nodes_[cube.index - Cube::kFirstNode]; }
    void measure(Node& node) const;

    std::vector<Node> nodes_;
    std::size_t firstOwn_ = 0;
};

}  // namespace voxprite::csm
