#include "core/io/csm_cubes.h"

#include <algorithm>

#include "core/svo/octree.h"

namespace voxprite::csm {
namespace {

constexpr std::uint64_t kManyNodes = std::uint64_t{1} << 40;

// Where a turned cube's octant comes from.
unsigned octantBefore(const SignedPermutation& rotation, unsigned octant) {
    const glm::ivec3 corner = octantCorner(octant);
    unsigned before = 0;
    for (std::size_t row = 0; row < 3; ++row) {
        const bool upper = (corner[static_cast<int>(row)] != 0) == (rotation.sign[row] > 0);
        if (upper) before |= 1u << rotation.axis[row];
    }
    return before;
}

}  // namespace

Turn Turn::all(const SignedPermutation& rotation) {
    Turn turn;
    for (unsigned octant = 0; octant < 8; ++octant) {
        turn.from[octant] = static_cast<std::uint8_t>(octantBefore(rotation, octant));
    }
    turn.inside = rotation;
    return turn;
}

Turn Turn::halves(unsigned axis) {
    Turn turn;
    for (std::uint8_t& from : turn.from) from = static_cast<std::uint8_t>(from ^ (1u << axis));
    return turn;
}

Turn operator*(const Turn& a, const Turn& b) {
    Turn product;
    for (std::size_t octant = 0; octant < 8; ++octant)
        product.from[octant] = b.from[a.from[octant]];
    product.inside = a.inside * b.inside;
    return product;
}

Cube Cubes::node(const std::array<Cube, 8>& children) {
    nodes_.push_back({children});
    measure(nodes_.back());
    return {static_cast<std::uint32_t>(nodes_.size() - 1) + Cube::kFirstNode, {}};
}

Cube Cubes::child(Cube cube, unsigned octant) const {
    if (cube.solid()) return cube;
    Cube child = at(cube).children[octantBefore(cube.turned, octant)];
    child.turned = cube.turned * child.turned;
    return child;
}

Cube Cubes::turned(Cube cube, const Turn& turn) {
    if (cube.solid()) return cube;
    if (turn.from == Turn::all(turn.inside).from) {
        cube.turned = turn.inside * cube.turned;
        return cube;
    }
    std::array<Cube, 8> children;
    for (std::size_t octant = 0; octant < 8; ++octant) {
        children[octant] = turned(child(cube, turn.from[octant]), Turn::all(turn.inside));
    }
    return node(children);
}

Cube Cubes::replaced(Cube cube, std::span<const std::uint8_t> path, Cube part) {
    if (path.empty()) return part;
    const bool own = !cube.solid() && cube.index - Cube::kFirstNode >= firstOwn_ &&
                     cube.turned == SignedPermutation{};
    if (!own) {
        std::array<Cube, 8> children;
        for (unsigned octant = 0; octant < 8; ++octant) children[octant] = child(cube, octant);
        cube = node(children);
    }
    const Cube changed = replaced(at(cube).children[path[0]], path.subspan(1), part);
    at(cube).children[path[0]] = changed;
    measure(at(cube));
    return cube;
}

int Cubes::levels(Cube cube) const {
    return cube.solid() ? 0 : at(cube).levels;
}

std::uint64_t Cubes::unfolded(Cube cube) const {
    return cube.solid() ? 0 : at(cube).unfolded;
}

void Cubes::measure(Node& node) const {
    node.levels = 1;
    node.unfolded = 1;
    for (const Cube child : node.children) {
        node.levels = std::max(node.levels, 1 + levels(child));
        node.unfolded = std::min(node.unfolded + unfolded(child), kManyNodes);
    }
}

}  // namespace voxprite::csm
