// Which of two ways to draw one model is the faster on this machine: known from the frames that
// were drawn, since it turns on the driver, the model and how large it is shown.
#pragma once

#include <array>
#include <cstddef>

namespace voxprite::editor {

enum class DrawingWay : std::size_t { rays, clusters };

class DrawingTimes {
  public:
    // For a model whose sphere has this radius on the screen. A way of which too few frames are
    // known at this size comes first; but clusters are not tried where so many triangles could make
    // the window stall. They are then kept, or left, by a clear margin.
    [[nodiscard]] DrawingWay faster(double radiusPx, std::size_t triangles) const;
    // A frame took so long. The first of each way pays for what drivers put off, and counts as
    // none.
    void took(DrawingWay way, double radiusPx, double milliseconds);
    // Another model: nothing is known of it.
    void forget() { *this = {}; }

  private:
    static constexpr int kFrames = 2;          // what is known of a size after so many
    static constexpr std::size_t kSizes = 20;  // by powers of two
    struct Known {
        int frames = 0;
        double fastestMs = 0.0;
    };
    [[nodiscard]] static std::size_t sizeOf(double radiusPx);
    std::array<std::array<Known, kSizes>, 2> known_{};
    std::array<bool, 2> warm_{};
};

}  // namespace voxprite::editor
