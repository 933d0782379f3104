// What the tests of this folder look at: small models, placed with a game profile, and cameras.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "core/model/document.h"
#include "core/sprite/sprite_buffer.h"
#include "core/sprite/sprite_view.h"
#include "core/svo/octree.h"

namespace voxprite::test {

// A baked model with an entity to place it.
struct Subject {
    Octree octree;
    Entity entity;

    [[nodiscard]] PlacedEntity placed(const GameProfile& profile) const;
    // The entity stands so that the model's centre lies at `centreMetres`.
    [[nodiscard]] PlacedEntity centredAt(glm::dvec3 centreMetres, const GameProfile& profile) const;
};

// Every voxel of a box of `size`, by a rule (0 is empty).
Subject subjectFrom(glm::ivec3 size, const std::function<std::uint8_t(glm::ivec3)>& material);
Subject solidBox(glm::ivec3 size);
// Legs, body, arms and head: 32 x 16 x 64 voxels.
Subject figure();
// A 5 x 5 x 7 block of material 1 with F on its -Y face (material 2), R on +X (3), and a P on +Z
// (4) that is upright when +Y is up.
Subject letterBlock();

// Colours that differ from each other and from black, white and transparent.
Palette plainColours();
LitPalette plainPalette(std::array<std::uint8_t, 3> light8 = {255, 255, 255});

// viewSprite, where failure and not being seen fail the test.
SpriteView mustView(const PlacedEntity& entity, const Camera& camera, const GameProfile& profile,
                    ViewHistory* history = nullptr);

// A camera that looks at the world's origin.
Camera orbit(double yaw, double pitch, double distance, double roll = 0.0);

// The buffer as text, rows from the top: '.' empty, 'o' outline, else '0' + the voxel's material.
std::vector<std::string> textOf(const SpriteBuffer& buffer, const Octree& octree);

// The voxel that an id names.
glm::ivec3 voxelOf(std::uint32_t id, glm::ivec3 size);

// Where virtual pixel coordinates (not floored) lie under a screen position.
glm::dvec2 pixelAt(const SpriteView& view, const Camera& camera, glm::dvec2 screenPx);

// Every material and the outline in one colour: a sprite that is a silhouette.
[[nodiscard]] inline LitPalette paint(Rgba8 colour) {
    LitPalette lit;
    lit.faces = LitPalette::allFaces(colour);
    lit.outline.colour = colour;
    return lit;
}

}  // namespace voxprite::test
