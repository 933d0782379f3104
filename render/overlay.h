// Lines and filled triangles over a frame, for wireframes, markers, previews and gizmos. World
// positions in metres, double; made camera-relative here.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/sprite/camera.h"
#include "render/frame.h"

namespace voxprite {

struct OverlayLine {
    glm::dvec3 a{0.0}, b{0.0};
    Rgba8 colour{255, 255, 255, 255};
    float widthPx = 1.5f;
};

struct OverlayTriangle {
    glm::dvec3 a{0.0}, b{0.0}, c{0.0};
    Rgba8 colour{255, 255, 255, 64};
};

struct OverlayShapes {
    std::vector<OverlayLine> lines;
    std::vector<OverlayTriangle> triangles;
    void addBox(std::span<const glm::dvec3, 8> cornersInOctantOrder, Rgba8 colour, float widthPx);
};

enum class OverlayDepth : std::uint8_t {
    test,         // hidden by what is nearer
    faintBehind,  // what is hidden shows at a quarter of its opacity
    always        // on top
};

class Overlay {
  public:
    Overlay();  // needs a current GL 4.5 context
    ~Overlay();
    Overlay(Overlay&&) noexcept;
    Overlay& operator=(Overlay&&) noexcept;
    void draw(Frame& frame, const OverlayShapes& shapes, const Camera& camera, OverlayDepth depth);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace voxprite
