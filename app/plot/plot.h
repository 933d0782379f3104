// A plot: points and lines between two axes, with a legend. Laid out once as shapes, which are then
// written as SVG (for pages) or drawn as a picture; both show the same.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/image.h"

namespace voxprite::plot {

enum class Mark : std::uint8_t { disc, square, diamond, triangle, ring, cross };

struct Datum {
    double x = 0.0;
    double y = 0.0;
    std::optional<glm::dvec2> spreadX;  // from least to most
    std::string tip;                    // said when the mouse is on it
    std::string label;                  // written beside it, where there is room
};

struct Series {
    std::string name;
    Rgba8 colour{0, 0, 0, 255};
    Mark mark = Mark::disc;
    bool line = false;       // joins the points in order
    bool marks = true;       // shows them
    bool staircase = false;  // the line goes right, then down: a front of what is best
    std::vector<Datum> data;
};

struct PlotAxis {
    std::string label;
    bool logarithmic = false;  // what is not above 0 is left out
    bool fromZero = false;     // linear: the axis starts at 0
};

struct Plot {
    std::string title;
    PlotAxis x, y;
    std::vector<Series> series;  // those without data are not in the legend
};

// What is drawn. Ink and hair are the page's own colours of text and of lines behind.
enum class Ink : std::uint8_t { ink, dim, hair, own };
enum class Anchor : std::uint8_t { start, middle, end };
struct Shape {
    enum class Kind : std::uint8_t { line, mark, text };
    Kind kind = Kind::line;
    glm::dvec2 a{0.0};
    glm::dvec2 b{0.0};  // line: its end
    double size = 1.0;  // width of the line, radius of the mark, height of the letters
    Ink ink = Ink::ink;
    Rgba8 colour{0, 0, 0, 255};  // Ink::own
    Mark mark = Mark::disc;
    Anchor anchor = Anchor::start;
    bool bold = false;
    std::string text;  // of a mark: its tip
};

struct Drawing {
    glm::ivec2 size{0};
    std::vector<Shape> shapes;
};

[[nodiscard]] Drawing layOut(const Plot& plot, glm::ivec2 size = {760, 440});
// One <svg> element; its colours of ink are the CSS variables --ink, --dim and --hair.
[[nodiscard]] std::string svgOf(const Drawing& drawing);
// On a light ground, each unit `scale` pixels wide.
[[nodiscard]] Image pictureOf(const Drawing& drawing, double scale = 2.0);

// At about `wanted` round values from `from` to `to`; by decades (1, 2, 5) when logarithmic.
[[nodiscard]] std::vector<double> ticksOf(double from, double to, bool logarithmic, int wanted);
// "0.05", "20 000", "3e-07"
[[nodiscard]] std::string tickText(double value);

}  // namespace voxprite::plot
