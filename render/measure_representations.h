// What the representations of one model are worth: how far each is off the exact sprite, and what
// it costs, by size on the screen. Measured by drawing them (core/lod/representation.h says what
// error and cost are).
//
// Each size is looked at from the same seeded views, round about and from a little below to well
// above: the error is the worst of them. The camera is that of a game, 45 degrees high over
// kReferenceHeightPx lines. Cost is the time that a crowd takes which the camera goes round so
// fast that each frame shows other views; it is this machine's, and no two runs give quite the
// same.
//
// In steps: one is a picture or two, so that an editor measures between its frames.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/result.h"
#include "render/scene_choice.h"

namespace voxprite {

inline constexpr int kReferenceHeightPx = 720;

// Everything is read until the measuring is done.
struct MeasuredModel {
    const GpuOctree* octree = nullptr;
    const Palette* palette = nullptr;
    PlacedEntity placed;  // its place does not matter
    const GpuModelLevels* levels = nullptr;
    const ViewSet* views = nullptr;
    double clusterBudgetPx = 1.0;
};

struct MeasuringPlan {
    std::vector<double> sizesPx{4, 8, 16, 32, 64, 128};  // ascending, 1 ... 512
    int views = 6;
    unsigned seed = 1;
    // Without, all cost nothing, and the table is the same every time.
    bool costs = true;
};

// A square picture of this edge holds the model and its outline.
[[nodiscard]] int edgeAtSize(double sizePx);
// The camera that shows a model of this radius, at the origin, as large as that: a part of the
// game's picture, from its middle.
[[nodiscard]] Camera cameraAtSize(double radiusMetres, double sizePx, const OrbitAngles& view,
                                  glm::ivec2 viewportPx);
// The model alone over nothing, `edgeAtSize` wide and high.
[[nodiscard]] Result<Image> pictureAtSize(SceneRenderer& renderer, const MeasuredModel& model,
                                          const GameProfile& profile, RepresentationChoice choice,
                                          double sizePx, const OrbitAngles& view);
[[nodiscard]] std::vector<OrbitAngles> viewsOf(const MeasuringPlan& plan);

class RepresentationMeter {
  public:
    RepresentationMeter(const MeasuredModel& model, const GameProfile& profile,
                        const MeasuringPlan& plan = {});
    ~RepresentationMeter();
    RepresentationMeter(RepresentationMeter&&) noexcept;
    RepresentationMeter& operator=(RepresentationMeter&&) noexcept;

    [[nodiscard]] bool done() const;
    [[nodiscard]] double share() const;  // of the steps, 0 ... 1
    // Needs the renderer's GL context. After a failure there is nothing more to do.
    [[nodiscard]] Status step(SceneRenderer& renderer);
    // Of all choicesOf() the model; complete once done.
    [[nodiscard]] const RepresentationTable& table() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// All steps at once.
[[nodiscard]] Result<RepresentationTable> measureRepresentations(SceneRenderer& renderer,
                                                                 const MeasuredModel& model,
                                                                 const GameProfile& profile,
                                                                 const MeasuringPlan& plan = {});

}  // namespace voxprite
