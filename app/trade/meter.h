// Measures settings of one model: errors over seeded views and sizes, costs over a camera's way.
//
//   auto meter = Meter::create(model, plan);                  // any thread
//   for (const AxisSetting& each : settingsAlong(allAxes(), plan.profile, meter->mostLevels(), e))
//       auto point = meter->measure(each, progress);          // the same thread; nothing: stopped
//
// The same plan gives the same errors, rays and bytes on every run and with both backends; only
// milliseconds are the machine's. A meter is of one thread at a time, and without a GlStage touches
// no OpenGL: the editor keeps one on a thread of its own.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/trade/figures.h"
#include "core/base/image.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/measure/plane.h"
#include "core/model/document.h"
#include "core/model/palette.h"
#include "core/sprite/camera.h"
#include "core/svo/octree.h"

namespace voxprite::trade {

class GlStage;

inline constexpr std::size_t kMostWayFrames = 10000;

// What is measured. The octree as bake() gives it (its origin in entity space).
struct Model {
    std::string name;
    Octree octree;
    Palette palette;
    Entity entity;
};

struct Plan {
    GameProfile profile;                   // the game's own: the sprite yardstick is drawn by it
    std::vector<double> sizesPx{48, 128};  // radii on the screen, ascending, 1 ... 512
    int views = 4;                         // for errors, at each size
    std::uint64_t seed = 1;
    // The camera's way, for costs and errors over time: so many frames, each turned by so much. A
    // quarter round at least, so that wide view steps and small sets of views come to change.
    int frames = 120;
    double degreesAFrame = 0.75;
    // Recorded elsewhere, a frame each (2 ... kMostWayFrames): instead of the two above.
    std::vector<OrbitAngles> recordedWay;
    // Errors alone, and the same every time, without.
    bool costs = true;
    // Every repeat goes along the whole way again, having forgotten what it cast.
    int leastRepeats = 1;
    double repeatMilliseconds = 300.0;  // more repeats until this has passed; at most 50
    double flipPixelsPerDegree = 67.0;
    int idealSamples = 4000;  // rays asked of the ideal caster, at most, for each view
    int threads = 1;          // for the perspective yardstick; what is timed has one; 0: all cores
};

// For an editor that measures while the artist draws: a second or two a curve of a small model.
[[nodiscard]] Plan quickPlan(const GameProfile& profile);

// A picture of the screen: what shows at each pixel. Ids are those of the model's own voxels
// (core/sprite/sprite_buffer.h), or empty when the cells shown are no voxels of it.
struct Shown {
    Image image;  // transparent where nothing is
    std::vector<std::uint32_t> ids;
    double sigmaInForce = 0.0;   // 0 where no lattice is drawn
    double screenPxPerPx = 0.0;  // 0 where there are no virtual pixels
};

class Meter {
  public:
    // `gl` draws and times instead of the processor, when it is given; it outlives the meter, and
    // its context is current wherever the meter is called. Fails on an empty model or a plan out of
    // range.
    [[nodiscard]] static Result<Meter> create(std::shared_ptr<const Model> model, Plan plan,
                                              GlStage* gl = nullptr);
    ~Meter();
    Meter(Meter&&) noexcept;
    Meter& operator=(Meter&&) noexcept;

    [[nodiscard]] const Plan& plan() const;
    [[nodiscard]] int mostLevels() const;  // that can be left out of the octree
    // Can it be drawn at all? Clusters need a GlStage, levels must be there.
    [[nodiscard]] bool offers(const Setting& setting) const;

    // Nothing when it was stopped. Fails where !offers(setting), or as drawing fails.
    [[nodiscard]] Result<std::optional<Point>> measure(const AxisSetting& setting,
                                                       const Progress& progress = {});

    // More repeats of the costs of a point that it measured: the more apart in time, the less what
    // else the machine does falls upon one setting alone. False when it was stopped; what was
    // added until then stays.
    [[nodiscard]] Result<bool> timeAgain(Point& point, const Progress& progress = {});

    // The cameras that errors are measured from, of one size (an index into plan().sizesPx).
    [[nodiscard]] std::vector<Camera> cameras(std::size_t size) const;
    // That shows the model this large from there, in a square that holds it.
    [[nodiscard]] Camera camera(const OrbitAngles& view, double sizePx) const;
    // The model by a setting; the yardsticks. Cameras look at the origin, where its centre is.
    [[nodiscard]] Result<Shown> show(const Setting& setting, const Camera& camera);
    [[nodiscard]] Result<Shown> showYardstick(Yardstick yardstick, const Camera& camera);

  private:
    struct Impl;
    explicit Meter(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

// Where two pictures of one size differ: FLIP a pixel, 0 ... 1, for heat maps.
[[nodiscard]] Result<Plane> errorMap(const Shown& yardstick, const Shown& test,
                                     double flipPixelsPerDegree = 67.0);

}  // namespace voxprite::trade
