#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/plot/lettering.h"
#include "app/plot/plot.h"

namespace voxprite::plot {
namespace {

constexpr Rgba8 kGround{250, 250, 249, 255};
constexpr Rgba8 kInk{32, 34, 38, 255};
constexpr Rgba8 kDim{96, 100, 108, 255};
constexpr Rgba8 kHair{226, 227, 229, 255};

Rgba8 colourOf(const Shape& shape) {
    switch (shape.ink) {
        case Ink::ink:
            return kInk;
        case Ink::dim:
            return kDim;
        case Ink::hair:
            return kHair;
        case Ink::own:
            break;
    }
    return {shape.colour.x, shape.colour.y, shape.colour.z, 255};
}

void mix(Rgba8& pixel, Rgba8 colour, double cover) {
    for (int channel = 0; channel < 3; ++channel)
        pixel[channel] = static_cast<std::uint8_t>(
            std::lround(pixel[channel] * (1.0 - cover) + colour[channel] * cover));
}

// Fills where distance(point) is below 0, softened over a pixel.
template <class Distance>
void fill(Image& picture, glm::dvec2 least, glm::dvec2 most, Rgba8 colour, Distance distance) {
    const glm::ivec2 first = glm::max(glm::ivec2(glm::floor(least - 1.0)), glm::ivec2(0));
    const glm::ivec2 last =
        glm::min(glm::ivec2(glm::ceil(most + 1.0)), glm::ivec2(picture.width, picture.height));
    for (int y = first.y; y < last.y; ++y)
        for (int x = first.x; x < last.x; ++x) {
            const double cover = std::clamp(0.5 - distance(glm::dvec2(x, y) + 0.5), 0.0, 1.0);
            if (cover > 0.0) mix(picture.at(x, y), colour, cover);
        }
}

double toSegment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 along = b - a;
    const double length = glm::dot(along, along);
    const double t = length > 0.0 ? std::clamp(glm::dot(p - a, along) / length, 0.0, 1.0) : 0.0;
    return glm::length(p - a - along * t);
}

void drawLine(Image& picture, glm::dvec2 a, glm::dvec2 b, double width, Rgba8 colour) {
    fill(picture, glm::min(a, b) - width, glm::max(a, b) + width, colour,
         [&](glm::dvec2 p) { return toSegment(p, a, b) - 0.5 * width; });
}

void drawMark(Image& picture, const Shape& shape, double scale) {
    const glm::dvec2 centre = shape.a * scale;
    const double r = shape.size * scale;
    const auto around = [&](auto distance) {
        fill(picture, centre - 1.5 * r, centre + 1.5 * r, colourOf(shape),
             [&](glm::dvec2 p) { return distance(p - centre); });
    };
    switch (shape.mark) {
        case Mark::disc:
            return around([&](glm::dvec2 p) { return glm::length(p) - r; });
        case Mark::ring:
            return around(
                [&](glm::dvec2 p) { return std::abs(glm::length(p) - r + 0.8 * scale) - scale; });
        case Mark::square:
            return around(
                [&](glm::dvec2 p) { return std::max(std::abs(p.x), std::abs(p.y)) - 0.9 * r; });
        case Mark::diamond:
            return around([&](glm::dvec2 p) {
                return (std::abs(p.x) + std::abs(p.y) - 1.25 * r) * std::sqrt(0.5);
            });
        case Mark::triangle:
            return around([&](glm::dvec2 p) {
                const double side = (std::abs(p.x) * 2.1 + (p.y + 1.2 * r) * -1.15) / 2.394;
                return std::max(p.y - 0.9 * r, side);
            });
        case Mark::cross: {
            const double d = 0.9 * r;
            return around([&](glm::dvec2 p) {
                return std::min(toSegment(p, {-d, -d}, {d, d}), toSegment(p, {-d, d}, {d, -d})) -
                       1.1 * scale;
            });
        }
    }
}

}  // namespace

Image pictureOf(const Drawing& drawing, double scale) {
    const glm::ivec2 size(glm::round(glm::dvec2(drawing.size) * scale));
    Image picture(size.x, size.y, kGround);
    const Lettering regular = Lettering::regular(), bold = Lettering::bold();
    for (const Shape& shape : drawing.shapes) {
        if (shape.kind == Shape::Kind::line) {
            drawLine(picture, shape.a * scale, shape.b * scale, shape.size * scale,
                     colourOf(shape));
        } else if (shape.kind == Shape::Kind::mark) {
            drawMark(picture, shape, scale);
        } else {
            const Lettering& letters = shape.bold ? bold : regular;
            const auto height = static_cast<float>(shape.size * scale);
            const double width = letters.widthOf(height, shape.text);
            const double back = shape.anchor == Anchor::start    ? 0.0
                                : shape.anchor == Anchor::middle ? 0.5 * width
                                                                 : width;
            letters.draw(picture, static_cast<int>(std::lround(shape.a.x * scale - back)),
                         static_cast<int>(std::lround(shape.a.y * scale)), height, colourOf(shape),
                         shape.text);
        }
    }
    return picture;
}

}  // namespace voxprite::plot
