// From entity, camera and game profile to one sprite: which lattice view is cast, and where its
// pixels land on the screen. Everything in double; what reaches a GPU is camera-relative.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "core/model/document.h"
#include "core/model/game_profile.h"
#include "core/sprite/camera.h"
#include "core/sprite/sprite_buffer.h"
#include "core/trace/lattice.h"

namespace voxprite {

// An entity as it stands in the world. `modelSize` and `anchor` in voxels from the minimum corner
// of the entity's bounds.
struct PlacedEntity {
    glm::ivec3 modelSize{0};
    glm::dvec3 anchor{0.0};
    glm::dmat3 worldFromVoxelAxes{1.0};  // rotation and axis swizzle; orthonormal, no scale
    double scale = 1.0;
    glm::dvec3 anchorMetres{0.0};  // where the anchor stands
    double voxelSizeMetres = 0.1;

    [[nodiscard]] double metresPerVoxel() const { return voxelSizeMetres * scale; }
    [[nodiscard]] glm::dvec3 worldFromVoxel(glm::dvec3 voxel) const;
    [[nodiscard]] glm::dvec3 centreMetres() const;
    [[nodiscard]] double radiusMetres() const;  // of the sphere around the model's box
};

[[nodiscard]] PlacedEntity placeEntity(const Entity& entity, const IBox& bounds,
                                       const GameProfile& profile);
// The rotation of Entity (yaw, pitch, roll) in voxel space, exact at multiples of 90.
[[nodiscard]] glm::dmat3 entityRotation(const Entity& entity);

// What a viewer remembers of one entity from frame to frame; nothing of it enters the pixels except
// through the snapped view and the sigma in force.
struct ViewHistory {
    std::optional<glm::dmat3> basis;  // last good right, up, forward in voxel space
    std::optional<int> halvings;      // of sigma, for minification
};

// One sprite of one frame.
struct SpriteView {
    LatticeView lattice;
    OrthoView ortho;            // what the lattice was quantised from
    double sigmaInForce = 4.0;  // without the entity's scale
    std::array<std::uint8_t, 3> light8{255, 255, 255};
    // The sprite plane: through the model centre, spanned by right and up (world axes, unit).
    glm::dvec3 centreFromEyeMetres{0.0};
    glm::dvec3 right{1, 0, 0};
    glm::dvec3 up{0, 1, 0};
    glm::dvec3 forward{0, 0, -1};
    double metresPerPx = 0.025;  // width of a virtual pixel
    // A point at (x, y) metres from the centre along right and up lies in virtual pixel
    // floor((x, y) / metresPerPx + pixelFromCentre).
    glm::dvec2 pixelFromCentre{0.0};
    // Registration at the anchor: the sprite moves by this much in its plane (already in
    // pixelFromCentre; kept for markers).
    glm::dvec2 registrationShiftPx{0.0};
    double planeDepthMetres = 1.0;  // of the centre along the camera's forward
    double depthMetres = 1.0;       // what the sprite writes (depth rules centre, groundSafe)
    double screenPxPerPx = 1.0;     // screen pixels a virtual pixel at the centre
};

enum class Unseen : std::uint8_t { emptyModel, cameraInside, behindCamera };

// Not seen (and why), or the view. Fails on non-finite input and over-large buffers.
struct SpriteViewResult {
    std::optional<SpriteView> view;
    std::optional<Unseen> unseen;
};
[[nodiscard]] Result<SpriteViewResult> viewSprite(const PlacedEntity& entity, const Camera& camera,
                                                  const GameProfile& profile,
                                                  ViewHistory* history = nullptr);

// The virtual pixel (i, j) under a screen position, if the eye ray meets the sprite plane ahead.
[[nodiscard]] std::optional<glm::ivec2> pixelUnder(const SpriteView& view, const Camera& camera,
                                                   glm::dvec2 screenPx);

// The proxy box: the model's bounds plus a margin of one virtual pixel all round (the artist's
// handle and cull volume). Eight corners in world metres, octant order.
[[nodiscard]] std::array<glm::dvec3, 8> proxyCorners(const PlacedEntity& entity,
                                                     double sigmaInForce);

}  // namespace voxprite
