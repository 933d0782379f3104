#include "app/plot/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "app/plot/lettering.h"

namespace voxprite::plot {
namespace {

constexpr double kTitlePx = 19.0, kTextPx = 15.0, kSmallPx = 13.0;
constexpr double kLeft = 62.0, kTop = 60.0, kBottom = 46.0, kLegend = 186.0, kRight = 18.0;
constexpr double kMarkRadius = 4.5;

class Scale {
  public:
    Scale(const PlotAxis& axis, double from, double to) : log_(axis.logarithmic) {
        if (!(from <= to)) from = log_ ? 1.0 : 0.0, to = 1.0;
        if (axis.fromZero && !log_) from = std::min(0.0, from);
        const double a = at(from), b = at(to);
        const double room = b > a ? 0.06 * (b - a) : log_ ? 0.3 : std::max(0.5, 0.1 * std::abs(a));
        low_ = axis.fromZero && !log_ ? a : a - room;
        high_ = b + room;
    }
    // 0 ... 1 along the axis.
    [[nodiscard]] double share(double value) const { return (at(value) - low_) / (high_ - low_); }
    [[nodiscard]] double low() const { return log_ ? std::pow(10.0, low_) : low_; }
    [[nodiscard]] double high() const { return log_ ? std::pow(10.0, high_) : high_; }

  private:
    [[nodiscard]] double at(double value) const { return log_ ? std::log10(value) : value; }
    bool log_;
    double low_ = 0.0, high_ = 1.0;
};

bool shows(const Plot& plot, const Datum& datum) {
    return std::isfinite(datum.x) && std::isfinite(datum.y) &&
           (!plot.x.logarithmic || datum.x > 0.0) && (!plot.y.logarithmic || datum.y > 0.0);
}

Scale scaleOf(const Plot& plot, const PlotAxis& axis, double Datum::*value) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const Series& series : plot.series)
        for (const Datum& datum : series.data)
            if (shows(plot, datum)) {
                least = std::min(least, datum.*value);
                most = std::max(most, datum.*value);
            }
    return {axis, least, most};
}

class LayOut {
  public:
    LayOut(const Plot& plot, glm::ivec2 size)
        : plot_(plot),
          x_(scaleOf(plot, plot.x, &Datum::x)),
          y_(scaleOf(plot, plot.y, &Datum::y)),
          left_(kLeft),
          right_(size.x - kLegend - kRight),
          top_(kTop),
          bottom_(size.y - kBottom) {
        drawing_.size = size;
    }

    Drawing run() {
        text({16.0, 24.0}, kTitlePx, plot_.title, Ink::ink, Anchor::start, true);
        axes();
        for (const Series& series : plot_.series) lines(series);
        for (const Series& series : plot_.series) marks(series);
        for (const Series& series : plot_.series) labels(series);
        legend();
        return std::move(drawing_);
    }

  private:
    struct Box {
        glm::dvec2 min, max;
    };

    [[nodiscard]] glm::dvec2 at(double x, double y) const {
        return {left_ + x_.share(x) * (right_ - left_), bottom_ - y_.share(y) * (bottom_ - top_)};
    }
    void line(glm::dvec2 a, glm::dvec2 b, double width, Ink ink, Rgba8 colour = Rgba8(0)) {
        Shape shape;
        shape.a = a;
        shape.b = b;
        shape.size = width;
        shape.ink = ink;
        shape.colour = colour;
        drawing_.shapes.push_back(shape);
    }
    void text(glm::dvec2 where, double height, const std::string& what, Ink ink, Anchor anchor,
              bool bold = false) {
        Shape shape;
        shape.kind = Shape::Kind::text;
        shape.a = where;
        shape.size = height;
        shape.ink = ink;
        shape.anchor = anchor;
        shape.bold = bold;
        shape.text = what;
        drawing_.shapes.push_back(shape);
    }
    void mark(glm::dvec2 where, const Series& series, const std::string& tip) {
        Shape shape;
        shape.kind = Shape::Kind::mark;
        shape.a = where;
        shape.size = kMarkRadius;
        shape.ink = Ink::own;
        shape.colour = series.colour;
        shape.mark = series.mark;
        shape.text = tip;
        drawing_.shapes.push_back(shape);
    }

    void axes() {
        for (const double tick : ticksOf(x_.low(), x_.high(), plot_.x.logarithmic, 8)) {
            const double px = at(tick, y_.low()).x;
            line({px, top_}, {px, bottom_}, 1.0, Ink::hair);
            text({px, bottom_ + 17.0}, kSmallPx, tickText(tick), Ink::dim, Anchor::middle);
        }
        for (const double tick : ticksOf(y_.low(), y_.high(), plot_.y.logarithmic, 6)) {
            const double px = at(x_.low(), tick).y;
            line({left_, px}, {right_, px}, 1.0, Ink::hair);
            text({left_ - 7.0, px + 4.5}, kSmallPx, tickText(tick), Ink::dim, Anchor::end);
        }
        line({left_, top_}, {left_, bottom_}, 1.2, Ink::dim);
        line({left_, bottom_}, {right_, bottom_}, 1.2, Ink::dim);
        text({16.0, 46.0}, kTextPx, plot_.y.label, Ink::dim, Anchor::start);
        text({right_, bottom_ + 36.0}, kTextPx, plot_.x.label, Ink::dim, Anchor::end);
    }

    void lines(const Series& series) {
        if (!series.line) return;
        const Datum* before = nullptr;
        for (const Datum& datum : series.data) {
            if (!shows(plot_, datum)) continue;
            if (before != nullptr) {
                const glm::dvec2 a = at(before->x, before->y), b = at(datum.x, datum.y);
                if (series.staircase) {
                    line(a, {b.x, a.y}, 1.6, Ink::own, series.colour);
                    line({b.x, a.y}, b, 1.6, Ink::own, series.colour);
                } else {
                    line(a, b, 1.8, Ink::own, series.colour);
                }
            }
            before = &datum;
        }
    }

    void marks(const Series& series) {
        for (const Datum& datum : series.data) {
            if (!shows(plot_, datum)) continue;
            const glm::dvec2 where = at(datum.x, datum.y);
            if (datum.spreadX && (!plot_.x.logarithmic || datum.spreadX->x > 0.0)) {
                const double from = std::max(left_, at(datum.spreadX->x, datum.y).x);
                const double to = std::min(right_, at(datum.spreadX->y, datum.y).x);
                line({from, where.y}, {to, where.y}, 1.0, Ink::own, series.colour);
            }
            if (!series.marks) continue;
            mark(where, series, datum.tip);
            taken_.push_back({where - (kMarkRadius + 1.0), where + (kMarkRadius + 1.0)});
        }
    }

    // Beside its mark, on the first of some places that hides nothing.
    void labels(const Series& series) {
        for (const Datum& datum : series.data) {
            if (datum.label.empty() || !shows(plot_, datum)) continue;
            const double width = letters_.widthOf(static_cast<float>(kSmallPx), datum.label);
            const glm::dvec2 where = at(datum.x, datum.y);
            const std::array<glm::dvec2, 6> places{
                where + glm::dvec2(9.0, -5.0),           where + glm::dvec2(9.0, 13.0),
                where + glm::dvec2(-9.0 - width, -5.0),  where + glm::dvec2(-9.0 - width, 13.0),
                where + glm::dvec2(-0.5 * width, -11.0), where + glm::dvec2(-0.5 * width, 21.0)};
            for (const glm::dvec2 place : places) {
                const Box box{{place.x - 1.0, place.y - 10.0},
                              {place.x + width + 1.0, place.y + 3.0}};
                const bool inside = box.min.x >= left_ && box.max.x <= right_ + 10.0 &&
                                    box.min.y >= top_ - 6.0 && box.max.y <= bottom_;
                const auto hides = [&](const Box& other) {
                    return box.min.x < other.max.x && other.min.x < box.max.x &&
                           box.min.y < other.max.y && other.min.y < box.max.y;
                };
                if (!inside || std::any_of(taken_.begin(), taken_.end(), hides)) continue;
                text(place, kSmallPx, datum.label, Ink::ink, Anchor::start);
                taken_.push_back(box);
                break;
            }
        }
    }

    void legend() {
        double y = top_ + 6.0;
        const double x = right_ + 24.0;
        for (const Series& series : plot_.series) {
            if (series.data.empty() || series.name.empty()) continue;
            if (series.line) line({x - 9.0, y}, {x + 9.0, y}, 1.8, Ink::own, series.colour);
            if (series.marks) mark({x, y}, series, "");
            text({x + 17.0, y + 4.5}, kSmallPx + 1.0, series.name, Ink::ink, Anchor::start);
            y += 21.0;
        }
    }

    const Plot& plot_;
    Scale x_, y_;
    double left_, right_, top_, bottom_;
    Lettering letters_ = Lettering::regular();
    std::vector<Box> taken_;
    Drawing drawing_;
};

}  // namespace

std::vector<double> ticksOf(double from, double to, bool logarithmic, int wanted) {
    std::vector<double> ticks;
    if (!(from < to) || !std::isfinite(from) || !std::isfinite(to)) return ticks;
    if (logarithmic) {
        if (!(from > 0.0)) return ticks;
        const double decades = std::log10(to / from);
        const int every = std::max(1, static_cast<int>(std::ceil(decades / wanted)));
        for (int power = static_cast<int>(std::floor(std::log10(from)));
             std::pow(10.0, power) <= to; ++power) {
            if (power % every != 0) continue;
            for (const double digit : {1.0, 2.0, 5.0}) {
                if (digit != 1.0 && decades > 0.5 * wanted) continue;
                const double tick = digit * std::pow(10.0, power);
                if (tick >= from && tick <= to) ticks.push_back(tick);
            }
        }
        return ticks;
    }
    const double rough = (to - from) / wanted;
    const double decade = std::pow(10.0, std::floor(std::log10(rough)));
    double step = 10.0 * decade;
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * decade >= rough) {
            step = digit * decade;
            break;
        }
    for (double k = std::ceil(from / step - 1e-9); k * step <= to * (1.0 + 1e-12); ++k)
        ticks.push_back(k == 0.0 ? 0.0 : k * step);
    return ticks;
}

std::string tickText(double value) {
    std::array<char, 32> text{};
    const double size = std::abs(value);
    if (size >= 1e4 && size < 1e7 && value == std::floor(value)) {
        std::snprintf(text.data(), text.size(), "%.0f", value);
        std::string digits = text.data();
        for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3)
            digits.insert(static_cast<std::size_t>(at), 1, ' ');
        return digits;
    }
    std::snprintf(text.data(), text.size(), "%.4g", value);
    return text.data();
}

Drawing layOut(const Plot& plot, glm::ivec2 size) {
    return LayOut(plot, size).run();
}

}  // namespace voxprite::plot
