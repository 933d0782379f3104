#include "tests/core/sprite/subject.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string_view>

#include "core/svo/bake.h"

namespace voxprite::test {

namespace {

using Glyph = std::array<std::string_view, 5>;
constexpr Glyph kF{"###", "#..", "##.", "#..", "#.."};
constexpr Glyph kR{"##.", "#.#", "##.", "#.#", "#.#"};
constexpr Glyph kP{"...", "##.", "##.", "#..", "..."};  // the middle three rows count

bool inked(const Glyph& glyph, int column, int rowFromTop) {
    if (column < 0 || column > 2 || rowFromTop < 0 || rowFromTop > 4) return false;
    return glyph[static_cast<std::size_t>(rowFromTop)][static_cast<std::size_t>(column)] == '#';
}

}  // namespace

PlacedEntity Subject::placed(const GameProfile& profile) const {
    return placeEntity(entity, {glm::ivec3(0), octree.size}, profile);
}

PlacedEntity Subject::centredAt(glm::dvec3 centreMetres, const GameProfile& profile) const {
    PlacedEntity result = placed(profile);
    result.anchorMetres = glm::dvec3(0.0);
    result.anchorMetres = centreMetres - result.centreMetres();
    return result;
}

Subject subjectFrom(glm::ivec3 size, const std::function<std::uint8_t(glm::ivec3)>& material) {
    VoxelGrid grid;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                if (const auto value = material({x, y, z})) grid.set({x, y, z}, value);
    auto octree = bake(grid, {glm::ivec3(0), size});
    EXPECT_TRUE(octree.has_value());
    return {octree.value_or(Octree{}), Entity{}};
}

Subject solidBox(glm::ivec3 size) {
    return subjectFrom(size, [](glm::ivec3) { return std::uint8_t{1}; });
}

Subject figure() {
    return subjectFrom({32, 16, 64}, [](glm::ivec3 v) -> std::uint8_t {
        const bool leg =
            v.z < 26 && ((v.x >= 9 && v.x < 15) || (v.x >= 17 && v.x < 23)) && v.y >= 5 && v.y < 12;
        const bool foot = v.z < 3 && v.x >= 9 && v.x < 23 && v.x / 16 != 0 && v.y < 12;
        const bool body = v.z >= 26 && v.z < 46 && v.x >= 8 && v.x < 24 && v.y >= 4 && v.y < 13;
        const bool arm = v.z >= 24 && v.z < 45 && (v.x < 5 || v.x >= 27) && v.y >= 6 && v.y < 11;
        const bool shoulder = v.z >= 42 && v.z < 46 && v.y >= 6 && v.y < 11;
        const glm::dvec3 head = glm::dvec3(v) + 0.5 - glm::dvec3(16.0, 8.0, 55.0);
        const bool ball = std::hypot(head.x, head.y, head.z) < 9.1;
        if (ball) return 2;
        if (body || shoulder) return 3;
        if (arm) return 4;
        if (foot) return 5;
        return leg ? 1 : 0;
    });
}

Subject letterBlock() {
    return subjectFrom({5, 5, 7}, [](glm::ivec3 v) -> std::uint8_t {
        if (v.y == 0 && inked(kF, v.x - 1, 5 - v.z)) return 2;
        if (v.x == 4 && inked(kR, v.y - 1, 5 - v.z)) return 3;
        if (v.z == 6 && inked(kP, v.x - 1, 4 - v.y)) return 4;
        return 1;
    });
}

Palette plainColours() {
    Palette palette;
    for (int index = 1; index < 256; ++index)
        palette.colours[static_cast<std::size_t>(index)] =
            Rgba8(index, (index * 37) % 255, 255 - index, 255);
    return palette;
}

LitPalette plainPalette(std::array<std::uint8_t, 3> light8) {
    Outline outline;
    outline.colour = Rgba8(250, 0, 250, 255);
    return litPalette(plainColours(), light8, outline);
}

SpriteView mustView(const PlacedEntity& entity, const Camera& camera, const GameProfile& profile,
                    ViewHistory* history) {
    const auto result = viewSprite(entity, camera, profile, history);
    EXPECT_TRUE(result.has_value()) << (result ? "" : result.error().describe());
    EXPECT_TRUE(result && result->view.has_value());
    return result && result->view ? *result->view : SpriteView{};
}

Camera orbit(double yaw, double pitch, double distance, double roll) {
    return orbitCamera({yaw, pitch, roll}, glm::dvec3(0.0), distance, 45.0, {512, 512});
}

glm::ivec3 voxelOf(std::uint32_t id, glm::ivec3 size) {
    const int index = static_cast<int>(id - kIdFirstVoxel);
    return {index % size.x, index / size.x % size.y, index / (size.x * size.y)};
}

std::vector<std::string> textOf(const SpriteBuffer& buffer, const Octree& octree) {
    std::vector<std::string> rows;
    for (int row = 0; row < buffer.size.y; ++row) {
        std::string text;
        for (int column = 0; column < buffer.size.x; ++column) {
            const std::uint32_t id =
                buffer.ids[static_cast<std::size_t>(row * buffer.size.x + column)];
            if (id == kIdEmpty)
                text += '.';
            else if (id == kIdOutline)
                text += 'o';
            else
                text +=
                    static_cast<char>('0' + materialAt(octree.view(), voxelOf(id, octree.size)));
        }
        rows.push_back(text);
    }
    return rows;
}

glm::dvec2 pixelAt(const SpriteView& view, const Camera& camera, glm::dvec2 screenPx) {
    const glm::dvec3 p = pixelFromScreen(view, camera) * glm::dvec3(screenPx, 1.0);
    EXPECT_GT(p.z, 0.0);
    return glm::dvec2(p.x, p.y) / p.z;
}

}  // namespace voxprite::test
