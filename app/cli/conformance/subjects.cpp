#include "app/cli/conformance/subjects.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <string_view>

#include "core/svo/bake.h"

namespace voxprite::conformance {
namespace {

using Glyph = std::array<std::string_view, 5>;
constexpr Glyph kF{"####", "#...", "###.", "#...", "#..."};
constexpr Glyph kR{"###.", "#..#", "###.", "#.#.", "#..#"};
constexpr Glyph kP{"###.", "#..#", "###.", "#...", "#..."};

bool inked(const Glyph& glyph, int column, int row) {
    return column >= 0 && column < 4 && row >= 0 && row < 5 &&
           glyph[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] == '#';
}

template <class T>
T known(Result<T> result) {
    if (!result) throw std::logic_error(result.error().describe());
    return std::move(*result);
}

Subject made(std::string name, VoxelGrid grid, glm::ivec3 size) {
    Octree octree = known(bake(grid, {glm::ivec3(0), size}));
    return {std::move(name), std::move(grid), std::move(octree), Entity{}};
}

}  // namespace

PlacedEntity Subject::centredAt(glm::dvec3 centreMetres, const GameProfile& profile) const {
    PlacedEntity placed = placeEntity(entity, {glm::ivec3(0), octree.size}, profile);
    placed.anchorMetres = glm::dvec3(0.0);
    placed.anchorMetres = centreMetres - placed.centreMetres();
    return placed;
}

Subject subjectFrom(std::string name, glm::ivec3 size,
                    const std::function<std::uint8_t(glm::ivec3)>& material) {
    VoxelGrid grid;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                if (const std::uint8_t value = material({x, y, z})) grid.set({x, y, z}, value);
    return made(std::move(name), std::move(grid), size);
}

Subject solidBox(glm::ivec3 size) {
    VoxelGrid grid;
    grid.fill({glm::ivec3(0), size}, 1);
    const std::string name =
        std::to_string(size.x) + "x" + std::to_string(size.y) + "x" + std::to_string(size.z);
    return made(name, std::move(grid), size);
}

Subject cube32() {
    Subject cube = solidBox({32, 32, 32});
    cube.name = "cube";
    return cube;
}

Subject figure() {
    return subjectFrom("figure", {32, 16, 64}, [](glm::ivec3 v) -> std::uint8_t {
        const bool deep = v.y >= 4 && v.y < 13;
        const glm::dvec3 head = glm::dvec3(v) + 0.5 - glm::dvec3(16.0, 8.0, 56.0);
        if (glm::length(head) < 8.2) return 2;
        if (v.z >= 26 && v.z < 48 && v.x >= 8 && v.x < 24 && deep) return 3;
        if (v.z >= 24 && v.z < 47 && (v.x < 6 || v.x >= 26) && v.y >= 6 && v.y < 11) return 4;
        if (v.z >= 43 && v.z < 47 && v.y >= 6 && v.y < 11) return 4;
        const bool leg = (v.x >= 9 && v.x < 15) || (v.x >= 17 && v.x < 23);
        if (v.z < 26 && leg && v.y >= (v.z < 4 ? 0 : 5) && v.y < 12) return 1;
        return 0;
    });
}

Subject vehicle() {
    return subjectFrom("vehicle", {16, 40, 18}, [](glm::ivec3 v) -> std::uint8_t {
        const bool wheel =
            (v.x < 3 || v.x >= 13) && v.z < 7 &&
            (std::hypot(v.y - 7.5, v.z - 3.0) < 4.0 || std::hypot(v.y - 31.5, v.z - 3.0) < 4.0);
        if (wheel) return 1;
        if (v.z >= 3 && v.z < 10) return 2;
        return v.z >= 10 && v.y >= 10 && v.y < 34 && v.x >= 1 && v.x < 15 ? 3 : 0;
    });
}

Subject slab() {
    Subject flat = solidBox({64, 64, 8});
    flat.name = "slab";
    return flat;
}

Subject letters() {
    return subjectFrom("letters", {6, 6, 8}, [](glm::ivec3 v) -> std::uint8_t {
        if (v.y == 0 && inked(kF, v.x - 1, 6 - v.z)) return 2;
        if (v.x == 5 && inked(kR, v.y - 1, 6 - v.z)) return 3;
        if (v.z == 7 && inked(kP, v.x - 1, 5 - v.y)) return 4;
        return 1;
    });
}

Subject noise(int edge) {
    Sequence random(7);
    return subjectFrom("noise", glm::ivec3(edge), [&](glm::ivec3) -> std::uint8_t {
        const std::uint64_t value = random.next();
        return value % 100 < 3 ? static_cast<std::uint8_t>(1 + (value >> 32) % 255) : 0;
    });
}

GameProfile plainProfile() {
    GameProfile profile;
    profile.minification = false;
    return profile;
}

Camera orbit(double yawDegrees, double pitchDegrees, double distanceMetres, int viewportPx) {
    return orbitCamera({yawDegrees, pitchDegrees, 0.0}, glm::dvec3(0.0), distanceMetres, 45.0,
                       {viewportPx, viewportPx});
}

OrthoView turned(const OrthoView& view, double radians) {
    const double c = std::cos(radians);
    const double s = std::sin(radians);
    const auto about = [&](glm::dvec3 v) {
        return glm::dvec3(v.x * c - v.y * s, v.x * s + v.y * c, v.z);
    };
    return {about(view.right), about(view.up), about(view.forward), view.sigmaInForce};
}

OrthoView orthoView(const OrbitAngles& angles, double sigma) {
    const glm::dmat3 basis = orbitBasis(angles);
    return {voxelFromWorld(basis[0]), voxelFromWorld(basis[1]), voxelFromWorld(basis[2]), sigma};
}

SpriteView seen(const PlacedEntity& entity, const Camera& camera, const GameProfile& profile,
                ViewHistory* history) {
    const SpriteViewResult result = known(viewSprite(entity, camera, profile, history));
    if (!result.view) throw std::logic_error("the subject is not seen");
    return *result.view;
}

LatticeView quantised(const OrthoView& view, glm::ivec3 modelSize) {
    return known(quantiseView(view, modelSize));
}

SpriteBuffer cast(const Octree& octree, const LatticeView& lattice) {
    return castSprite(octree.view(), lattice, LitPalette{});
}

std::uint64_t Sequence::next() {
    std::uint64_t z = state_ += 0x9E37'79B9'7F4A'7C15u;
    z = (z ^ (z >> 30)) * 0xBF58'476D'1CE4'E5B9u;
    z = (z ^ (z >> 27)) * 0x94D0'49BB'1331'11EBu;
    return z ^ (z >> 31);
}

double Sequence::unit() {
    return static_cast<double>(next() >> 11) * 0x1p-53;
}

double Sequence::between(double from, double to) {
    return from + (to - from) * unit();
}

}  // namespace voxprite::conformance
