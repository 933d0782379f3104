// What `voxprite trade FILES -o DIR` has measured, before it is written.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/trade/choice.h"
#include "app/trade/meter.h"

namespace voxprite::trade {

using cli::Json;

// All of one model's settings. `light` is a series of its own: its yardsticks have the full light
// (kFullLight of both), which the settings leave out; only where the profile has none itself.
struct Skipped {
    std::string name;    // describe() of the setting
    std::string reason;  // that it cannot be drawn
};
struct ModelReport {
    std::string file;
    glm::ivec3 size{0};
    std::uint64_t voxels = 0;
    std::uint64_t octreeBytes = 0;
    Plan plan;
    Curve curve;
    std::optional<Curve> light;
    std::vector<Skipped> skipped;
    int settings = 0;  // that were to be measured, in both
    [[nodiscard]] int measured() const {
        return static_cast<int>(curve.points.size() + (light ? light->points.size() : 0));
    }
};
inline constexpr double kFullLight = 0.6;

// A cost against what it grows with, over several sizes; and the exponent k of cost = c * size^k
// (least squares of the logarithms).
struct Growth {
    struct Sample {
        double size = 0.0;
        Spread milliseconds;
        double rays = 0.0;
        double bytes = 0.0;
    };
    std::string key;    // "model_size"
    std::string title;  // "Model size"
    std::string unit;   // "voxels an edge"
    std::string what;   // what was drawn, and how
    std::vector<Sample> samples;
    std::string notRun;  // why there are none, or fewer
};
[[nodiscard]] std::optional<double> exponentOf(const Growth& growth,
                                               double (*cost)(const Growth::Sample&));
[[nodiscard]] double millisecondsOf(const Growth::Sample& sample);
[[nodiscard]] double raysOf(const Growth::Sample& sample);
[[nodiscard]] double bytesOf(const Growth::Sample& sample);

struct TradeReport {
    Json machine;  // of bench: cpu, cores, simd; with gl, or null
    std::string commit;
    std::string backend;
    std::vector<ModelReport> models;
    std::vector<Growth> growth;
    std::vector<Error> failures;  // models that could not be measured at all, costs that grow
    bool finished = true;
};

// The schema of trade.json. Version 1:
//   {"schema": "voxprite-trade", "version": 1, "finished": bool,
//    "program": {"version", "commit"}, "machine": {"cpu", "cores", "simd", "gl"}, "backend",
//    "models": [{"name", "file", "size", "voxels", "octree_bytes", "settings", "profile": {...},
//       "plan": {"seed", "views", "sizes_px", "frames", "degrees_a_frame",
//          "recorded_frames", "flip_pixels_a_degree"},          0: no way was given
//       "skipped": [{"name", "reason"}],                       settings that cannot be drawn
//       "points": [{"series": "game" or "light", "axis", "name", "setting": {...},
//          "flip": {"sprite", "perspective"}, "ms", "rays",        means over the sizes
//          "front": {"sprite", "perspective"},                     on the Pareto front?
//          "sizes": [{"size_px", "sigma_in_force", "screen_px_a_virtual_px",
//             "sprite": {errors}, "perspective": {errors}, "numbers": {...} or null,
//             "time": {...}, "costs": {...} or null}]}]}],
//    "growth": [{"key", "title", "unit", "what", "not_run", "samples": [...],
//       "exponents": {"ms", "rays", "bytes"}}]}
// What stands in {errors}, {...} and the units: app/trade/figures.h, whose fields they are. What is
// not known is null.
inline constexpr int kSchemaVersion = 1;
[[nodiscard]] Json jsonOf(const TradeReport& report);
[[nodiscard]] Json jsonOf(const Setting& setting);
// A row for each point and size, all figures of it.
[[nodiscard]] std::string csvOf(const TradeReport& report);
// ", drawn at sigma 1" where minification halves the setting's own at a size; else nothing.
[[nodiscard]] std::string minifiedText(const Point& point);
// One page that needs nothing else; `plots` are in the order of plotsOf().
[[nodiscard]] std::string htmlOf(const TradeReport& report);
// The costs that grow, as Markdown.
[[nodiscard]] std::string growthTable(const TradeReport& report);
// The front of each model, as Markdown.
[[nodiscard]] std::string frontTable(const TradeReport& report);

// Writes trade.json, trade.csv, report.html and the plots as PNG into a folder that is there.
// Returns the files written.
[[nodiscard]] Result<std::vector<std::string>> writeReport(const TradeReport& report,
                                                           const std::string& folder);

}  // namespace voxprite::trade
