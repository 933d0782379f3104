// What was measured of one setting (setting.h): plain figures.
//
// Three yardsticks, each for another question:
//   numbers      the ideal caster (core/trace/ideal_caster.h), for what rounding costs
//   sprite       the exact sprite that the game asks for (its own profile, views not snapped, the
//                proxy a quad), from the same view: for what a cheaper way of drawing gives up
//   perspective  the voxels themselves, a ray through each screen pixel, in the same light: for
//                what the style leaves out; never 0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/trade/setting.h"

namespace voxprite::trade {

enum class Yardstick : std::uint8_t { sprite, perspective };
[[nodiscard]] const char* nameOf(Yardstick yardstick);

// Of pictures of the screen. Means over the views, but for flipWorst. Shares are 0 ... 1, of the
// pixels that the model covers in either picture unless another is named.
struct PictureErrors {
    double mismatch = 0.0;         // of another colour
    std::optional<double> voxels;  // of another voxel; none where cells are no voxels
    // In one silhouette alone, over the yardstick's area: more than 1 where it is missed by that
    // much, infinite where it is empty.
    double silhouette = 0.0;
    double iou = 1.0;                   // of the silhouettes
    double boundaryIou = 1.0;           // of their borders
    std::optional<double> outlineKept;  // recall: of the yardstick's outline; none if it has none
    std::optional<double> outlineTrue;  // precision: of the outline shown
    double flip = 0.0;                  // FLIP, mean over the covered pixels
    double flipWorst = 0.0;             // the same from the worst view
    std::optional<double> psnr;         // dB; none when every view is equal
    double ssim = 1.0;
};

// Of the lattice's rays, whatever their colours: shares of the samples that hit anything.
struct NumberErrors {
    std::uint64_t samples = 0;
    double voxels = 0.0;      // another voxel
    double silhouette = 0.0;  // hit here and missed there
};

// Of the pictures of a camera on its way. Shares are of the pixels covered.
struct TimeErrors {
    double changedADegree = 0.0;  // of another colour than the frame before, a degree of turn
    double flipsADegree = 0.0;    // back to the colour of two frames ago, having been another
    double crawlADegree = 0.0;    // of the silhouette's border, that came or went
};

// Over the repeats, all of them warm.
struct Spread {
    double least = 0.0;
    double median = 0.0;
    double most = 0.0;
    int runs = 0;
};
[[nodiscard]] Spread spreadOf(std::vector<double> values);
// Of runs over the same work, each by its parts: median and most are those of whole runs, the least
// is that of every part, together, for what else a machine does seldom falls upon the same part
// twice. Every run has the same parts.
[[nodiscard]] Spread spreadOfParts(const std::vector<std::vector<double>>& runs);

// Of one frame of a camera on its way past views that it has not seen yet; what was cast stays.
// Every run goes along the whole way, from its start.
struct Costs {
    // Of every run, section by section; each is its share of the mean frame of the way. On the
    // processor the thread's own time, by OpenGL until all is drawn.
    std::vector<std::vector<double>> runsMilliseconds;
    Spread milliseconds;  // of those, spreadOfParts()
    double rays = 0.0;    // a frame; the same on every machine
    double casts = 0.0;   // sprites or snapshots made, a frame
    double bytes = 0.0;   // octree or mesh, and what is kept of its pictures; all of a set of views
    double prepareMilliseconds = 0.0;  // to make what is kept beforehand: levels, meshes, sets
    std::string backend;               // "cpu", one thread, or "gl"
};

struct AtSize {
    double sizePx = 0.0;  // radius of the model's sphere on the screen
    // Of the lattice, and the width of its virtual pixels; none where no lattice is drawn.
    std::optional<double> sigmaInForce;
    std::optional<double> screenPxPerPx;
    PictureErrors sprite;
    PictureErrors perspective;
    std::optional<NumberErrors> numbers;  // none where no lattice is cast
    TimeErrors time;
    std::optional<Costs> costs;  // none where they were not asked for

    [[nodiscard]] const PictureErrors& against(Yardstick yardstick) const {
        return yardstick == Yardstick::sprite ? sprite : perspective;
    }
};

struct Point {
    Axis axis = Axis::game;
    Setting setting;
    std::string name;            // describe()
    std::vector<AtSize> bySize;  // ascending; never empty

    // The error that fronts and budgets go by: FLIP, the mean over the sizes.
    [[nodiscard]] double error(Yardstick yardstick) const;
    // Milliseconds and rays a frame, the means over the sizes; infinite where the cost was not
    // measured. Of the repeats the least (spreadOfParts): what else a machine does only ever adds.
    [[nodiscard]] double milliseconds() const;
    [[nodiscard]] double rays() const;
};

// All that was measured of a model.
struct Curve {
    std::string model;
    GameProfile profile;  // the game's own
    std::string backend;  // that costs were measured with
    std::vector<Point> points;
};

}  // namespace voxprite::trade
