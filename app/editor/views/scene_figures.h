// What the last pictures of the sprite view cost.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>

#include "render/scene_renderer.h"

namespace voxprite::editor {

// Milliseconds of the newest frames, oldest first.
class FrameTimes {
  public:
    static constexpr std::size_t kKept = 96;
    void push(float ms) {
        if (count_ < kKept) {
            ms_[count_++] = ms;
            return;
        }
        std::shift_left(ms_.begin(), ms_.end(), 1);
        ms_.back() = ms;
    }
    [[nodiscard]] std::span<const float> all() const { return {ms_.data(), count_}; }

  private:
    std::array<float, kKept> ms_{};
    std::size_t count_ = 0;
};

// What one representation has of a picture.
struct RepresentationShare {
    int entities = 0;           // in view
    double microseconds = 0.0;  // what they cost, by what was measured; 0 where nothing was
};
using RepresentationShares = std::array<RepresentationShare, kRepresentations>;

struct SceneFigures {
    std::size_t entities = 1;
    SceneStats stats;             // of all cells together
    double cpuMs = 0.0;           // until all commands were given
    std::optional<double> gpuMs;  // of the newest picture that the GPU is done with
    FrameTimes cpuTimes;
    RepresentationShares shares{};
    std::string progress;  // of what is built and measured behind the view
};

}  // namespace voxprite::editor
