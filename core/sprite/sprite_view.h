// From entity, camera and game profile to one sprite: which lattice view is cast, and where its
// pixels land on the screen. Everything in double; what reaches a GPU is camera-relative.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "core/model/game_profile.h"
#include "core/sprite/camera.h"
#include "core/sprite/placed_entity.h"
#include "core/sprite/sprite_buffer.h"
#include "core/trace/lattice.h"

namespace voxprite {

// What a viewer remembers of one entity from frame to frame; nothing of it enters the pixels except
// through the snapped view and the sigma in force.
struct ViewHistory {
    std::optional<glm::dmat3> basis;         // last good right, up, forward in voxel space
    std::optional<glm::ivec3> snappedSteps;  // of yaw, pitch, roll, for view snapping
    std::optional<int> halvings;             // of sigma, for minification
    std::optional<int> viewOfSet;            // that was shown, for viewSnapshot
};

// One sprite of one frame.
struct SpriteView {
    LatticeView lattice;
    OrthoView ortho;            // what the lattice was quantised from (voxel space)
    double sigmaInForce = 4.0;  // without the entity's scale
    FaceLights light8;          // of the faces that the rays see
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
    // What the sprite writes. Depth rule perPixel: the nearest that any pixel may write.
    double depthMetres = 1.0;
    // Depth rule perPixel: a point p of the model (voxels) lies at the depth
    // planeDepthMetres + dot(depthPerVoxelMetres, p - centreVoxels).
    glm::dvec3 depthPerVoxelMetres{0.0};
    glm::dvec3 centreVoxels{0.0};  // of the model, as its entity has it
    double screenPxPerPx = 1.0;    // screen pixels a virtual pixel at the centre
    // The proxy box, camera-relative: centreFromEyeMetres +- boxHalfMetres along the columns of
    // boxAxes. With ProxyShape::box the sprite shows only where an eye ray meets it.
    ProxyShape proxy = ProxyShape::quad;
    glm::dmat3 boxAxes{1.0};
    glm::dvec3 boxHalfMetres{0.0};
    // Of viewSnapshot: the view that is shown, and by how much it is off the true one.
    std::optional<int> viewOfSet;
    double degreesOff = 0.0;
};

class LatticeMemo;
class ViewSet;

enum class Unseen : std::uint8_t {
    emptyModel,
    cameraInside,
    behindCamera,
    subPixel  // of viewSnapshot: the sphere around the model has a radius under one screen pixel
};

// Not seen (and why), or the view. Fails on non-finite input and over-large buffers; with
// minification sigma is halved until the buffer is small enough instead. `lattices` may remember
// what views were quantised to (core/sprite/lattice_memo.h); it changes no result.
struct SpriteViewResult {
    std::optional<SpriteView> view;
    std::optional<Unseen> unseen;
};
[[nodiscard]] Result<SpriteViewResult> viewSprite(const PlacedEntity& entity, const Camera& camera,
                                                  const GameProfile& profile,
                                                  ViewHistory* history = nullptr,
                                                  LatticeMemo* lattices = nullptr);

// The same seen from the nearest view of a set (core/sprite/view_set.h), whatever the view step.
// All entities that show one view of one model share one sprite, bit for bit that of the view; its
// plane is the true view's, in which it is turned as views.roll says. At one of its views this is
// viewSprite's result.
[[nodiscard]] Result<SpriteViewResult> viewSnapshot(
    const PlacedEntity& entity, const Camera& camera, const GameProfile& profile,
    const ViewSet& views, ViewHistory* history = nullptr, LatticeMemo* lattices = nullptr);

// The way from the screen to virtual pixels: for p = M * (screenPx.x, screenPx.y, 1) the screen
// position lies in pixel floor(p.xy / p.z), provided that p.z > 0 (else the eye ray runs away from
// the sprite plane). The eye ray is met with the sprite plane, whatever its tilt.
[[nodiscard]] glm::dmat3 pixelFromScreen(const SpriteView& view, const Camera& camera);

// The virtual pixel (i, j) under a screen position, if the eye ray meets the sprite plane ahead.
[[nodiscard]] std::optional<glm::ivec2> pixelUnder(const SpriteView& view, const Camera& camera,
                                                   glm::dvec2 screenPx);

// The corners of the pixels first ... first + size in the sprite plane, camera-relative metres:
// bottom left, bottom right, top left, top right. For view.lattice this is the quad to draw.
[[nodiscard]] std::array<glm::dvec3, 4> quadFromEye(const SpriteView& view, glm::ivec2 first,
                                                    glm::ivec2 size);

// The part of view.lattice that can show on the screen, and a pixel more all round: what a scene
// needs to cast. Size (0, 0) when nothing can.
[[nodiscard]] LatticeView visibleLattice(const SpriteView& view, const Camera& camera);

// Does the eye ray (camera-relative) meet the proxy box ahead of the eye?
[[nodiscard]] bool meetsProxyBox(const SpriteView& view, const Camera::Ray& rayFromEye);

// For the depth rule perPixel: the depth in metres of every pixel of `buffer`, that of its voxel's
// face, an outline pixel that of its nearest opaque neighbour; infinity where empty.
[[nodiscard]] std::vector<float> pixelDepths(const SpriteView& view, const OctreeView& octree,
                                             const SpriteBuffer& buffer, int threads = 0);

}  // namespace voxprite
