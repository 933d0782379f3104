#include <array>
#include <cstdio>

#include "app/plot/plot.h"

namespace voxprite::plot {
namespace {

// Letters of Inter reach over 1.21 of their size.
constexpr double kLettersOverSize = 1.21;

std::string number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2f", value);
    return text.data();
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

std::string cssColourOf(const Shape& shape) {
    switch (shape.ink) {
        case Ink::ink:
            return "var(--ink)";
        case Ink::dim:
            return "var(--dim)";
        case Ink::hair:
            return "var(--hair)";
        case Ink::own:
            break;
    }
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", shape.colour.x, shape.colour.y,
                  shape.colour.z);
    return text.data();
}

std::string point(glm::dvec2 at) {
    return number(at.x) + "," + number(at.y);
}

std::string polygon(const Shape& shape, std::initializer_list<glm::dvec2> corners) {
    std::string points;
    for (const glm::dvec2 corner : corners) {
        points += (points.empty() ? "" : " ") + point(shape.a + corner * shape.size);
    }
    return "<polygon points=\"" + points + "\" fill=\"" + cssColourOf(shape) + "\"";
}

std::string markOf(const Shape& shape) {
    const std::string colour = cssColourOf(shape);
    switch (shape.mark) {
        case Mark::disc:
            return "<circle cx=\"" + number(shape.a.x) + "\" cy=\"" + number(shape.a.y) +
                   "\" r=\"" + number(shape.size) + "\" fill=\"" + colour + "\"";
        case Mark::ring:
            return "<circle cx=\"" + number(shape.a.x) + "\" cy=\"" + number(shape.a.y) +
                   "\" r=\"" + number(shape.size - 0.8) + "\" fill=\"none\" stroke=\"" + colour +
                   "\" stroke-width=\"2\"";
        case Mark::square:
            return polygon(shape, {{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}});
        case Mark::diamond:
            return polygon(shape, {{0, -1.25}, {1.25, 0}, {0, 1.25}, {-1.25, 0}});
        case Mark::triangle:
            return polygon(shape, {{0, -1.2}, {1.15, 0.9}, {-1.15, 0.9}});
        case Mark::cross:
            break;
    }
    const double r = 0.9 * shape.size;
    return "<path d=\"M" + point(shape.a + glm::dvec2(-r, -r)) + " L" +
           point(shape.a + glm::dvec2(r, r)) + " M" + point(shape.a + glm::dvec2(-r, r)) + " L" +
           point(shape.a + glm::dvec2(r, -r)) + "\" stroke=\"" + colour +
           "\" stroke-width=\"2.2\" fill=\"none\"";
}

std::string svgOf(const Shape& shape) {
    switch (shape.kind) {
        case Shape::Kind::line:
            return "<line x1=\"" + number(shape.a.x) + "\" y1=\"" + number(shape.a.y) + "\" x2=\"" +
                   number(shape.b.x) + "\" y2=\"" + number(shape.b.y) + "\" stroke=\"" +
                   cssColourOf(shape) + "\" stroke-width=\"" + number(shape.size) + "\"/>\n";
        case Shape::Kind::mark:
            return shape.text.empty()
                       ? markOf(shape) + "/>\n"
                       : markOf(shape) + "><title>" + escaped(shape.text) + "</title></" +
                             (shape.mark == Mark::disc || shape.mark == Mark::ring ? "circle"
                              : shape.mark == Mark::cross                          ? "path"
                                                                                   : "polygon") +
                             ">\n";
        case Shape::Kind::text:
            break;
    }
    const char* anchor = shape.anchor == Anchor::start    ? "start"
                         : shape.anchor == Anchor::middle ? "middle"
                                                          : "end";
    return "<text x=\"" + number(shape.a.x) + "\" y=\"" + number(shape.a.y) + "\" font-size=\"" +
           number(shape.size / kLettersOverSize) + "\" text-anchor=\"" + anchor + "\" fill=\"" +
           cssColourOf(shape) + "\"" + (shape.bold ? " font-weight=\"600\"" : "") + ">" +
           escaped(shape.text) + "</text>\n";
}

}  // namespace

std::string svgOf(const Drawing& drawing) {
    const std::string size = std::to_string(drawing.size.x) + " " + std::to_string(drawing.size.y);
    std::string svg = "<svg viewBox=\"0 0 " + size + "\" role=\"img\">\n";
    for (const Shape& shape : drawing.shapes) svg += svgOf(shape);
    return svg + "</svg>\n";
}

}  // namespace voxprite::plot
