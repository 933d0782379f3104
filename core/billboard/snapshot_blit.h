// Snapshots on the screen, on the CPU: which are shown, where, and their pixels into a picture.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/image.h"
#include "core/billboard/snapshot.h"
#include "core/sprite/sprite_view.h"

namespace voxprite {

enum class SnapshotDepth : std::uint8_t {
    centre,   // that of the model's centre: a flat disk, as the snapshot cache has it
    perPixel  // each pixel its own, from the snapshot's depths
};

struct SnapshotChoice {
    SnapshotDepth depth = SnapshotDepth::centre;
    bool blend = false;  // kind seed: mix the nearest views instead of showing one
};

// A snapshot to be drawn: `plane` says where its pixels land (SpriteView's mapping), pixel (0, 0)
// of a `seed` snapshot being that of the left and bottom.
struct ShownSnapshot {
    int view = 0;
    double weight = 1.0;  // of a blend, summing to 1
    SpriteView plane;
};
struct SeenSnapshots {
    std::vector<ShownSnapshot> shown;  // nearest first; empty when unseen
    std::optional<Unseen> unseen;
    double degreesOff = 0.0;  // of the nearest from the true view
};

// Snapshots of kind `seed`, on the plane through the model's centre that faces the camera. Not
// seen: an empty model, one whose centre is not before the near plane, and one whose sphere has a
// radius under a screen pixel. The eye may be inside the model: a far away picture has no inside.
// (Kind `sprite` is viewSnapshot's.) Fails on input that is not finite.
[[nodiscard]] Result<SeenSnapshots> seeSnapshots(const PlacedEntity& entity, const Camera& camera,
                                                 const ViewSet& views, int sizePx,
                                                 const SnapshotChoice& choice,
                                                 ViewHistory* history = nullptr);

// A picture and how near it is: reversed depths as Camera::reversedDepth gives them, 0 where there
// is nothing.
struct SnapshotCanvas {
    Image colours;
    std::vector<float> depths;

    SnapshotCanvas(glm::ivec2 sizePx, Rgba8 background);
};

// Draws over the canvas where it is nearer than what is there; of equal depths what is there stays.
// A screen pixel shows the snapshot's pixel under its middle, and nothing where that is sky. Of
// several snapshots it shows the mean of those that are not sky, by weight, where these make up
// half of all weight; its depth is that of the heaviest of them, and never nearer than the plane's
// depthMetres. `metresPerVoxel` is the entity's.
struct BlitSource {
    const Snapshot* snapshot = nullptr;
    const SpriteView* plane = nullptr;
    double weight = 1.0;
};
void blitSnapshots(std::span<const BlitSource> sources, double metresPerVoxel, SnapshotDepth depth,
                   const Camera& camera, SnapshotCanvas& canvas);

}  // namespace voxprite
