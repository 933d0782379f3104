#include "app/editor/panels/trade_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "app/editor/panels/trade_text.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/session/trade_moves.h"
#include "app/trade/choice.h"

namespace voxprite::editor {
namespace {

constexpr ImU32 kInk = IM_COL32(16, 17, 19, 255);
constexpr float kPointerReachPx = 12.0f;  // of the pointer

ImU32 colourOf(trade::Axis axis) {
    using enum trade::Axis;
    switch (axis) {
        case game:
            return IM_COL32(240, 241, 243, 255);
        case sigma:
            return IM_COL32(92, 172, 255, 255);
        case viewStep:
            return IM_COL32(112, 208, 130, 255);
        case mixed:
            return IM_COL32(64, 200, 196, 255);
        case snapshots:
            return IM_COL32(255, 120, 176, 255);
        case levels:
            return IM_COL32(180, 138, 255, 255);
        case light:
            return IM_COL32(250, 214, 96, 255);
        case proxy:
            return IM_COL32(206, 168, 128, 255);
        case registration:
            return IM_COL32(214, 226, 128, 255);
        case mode:
        case clusters:
        case walk:
            break;
    }
    return IM_COL32(160, 166, 176, 255);
}

// From figures to the window. Costs run by powers of ten, errors evenly from 0.
class PlotArea {
  public:
    PlotArea(Ui& ui, ImVec2 min, ImVec2 size) : theme_(ui.theme) {
        min_ = {min.x + theme_.px(40), min.y + theme_.px(10)};
        max_ = {min.x + size.x - theme_.px(12), min.y + size.y - theme_.px(26)};
    }
    void include(double cost, double error) {
        if (!std::isfinite(cost) || cost <= 0.0 || !std::isfinite(error)) return;
        low_ = std::min(low_, std::log10(cost));
        high_ = std::max(high_, std::log10(cost));
        most_ = std::max(most_, error);
    }
    void settle() {
        if (low_ > high_) low_ = -2.0, high_ = 1.0;
        const double air = std::max(0.12, 0.06 * (high_ - low_));
        low_ -= air;
        high_ += air;
        most_ = std::min(1.0, most_ * 1.12);
    }
    [[nodiscard]] float x(double cost) const {
        const double share = (std::log10(std::max(cost, 1e-12)) - low_) / (high_ - low_);
        return min_.x + static_cast<float>(std::clamp(share, 0.0, 1.0)) * (max_.x - min_.x);
    }
    [[nodiscard]] float y(double error) const {
        const double share = std::clamp(error / most_, 0.0, 1.0);
        return max_.y - static_cast<float>(share) * (max_.y - min_.y);
    }
    void drawGrid(ImDrawList& draw, trade::Cost cost) const;
    [[nodiscard]] ImVec2 min() const { return min_; }
    [[nodiscard]] ImVec2 max() const { return max_; }

  private:
    void drawColumns(ImDrawList& draw, trade::Cost cost) const;

    const Theme& theme_;
    ImVec2 min_, max_;
    double low_ = std::numeric_limits<double>::infinity();
    double high_ = -std::numeric_limits<double>::infinity();
    double most_ = 0.05;
};

std::string axisText(double cost, trade::Cost kind) {
    std::array<char, 32> text{};
    if (kind == trade::Cost::milliseconds) {
        const bool micro = cost < 0.9995;
        std::snprintf(text.data(), text.size(), micro ? "%.3g µs" : "%.3g ms",
                      micro ? 1000.0 * cost : cost);
    } else if (cost >= 999.5) {
        const bool mega = cost >= 999'500.0;
        std::snprintf(text.data(), text.size(), mega ? "%.3g M" : "%.3g k",
                      cost / (mega ? 1e6 : 1e3));
    } else {
        std::snprintf(text.data(), text.size(), "%.3g", cost);
    }
    return text.data();
}

void PlotArea::drawColumns(ImDrawList& draw, trade::Cost cost) const {
    ImFont* small = theme_.fonts.small;
    const bool dense = high_ - low_ < 1.6;
    float free = min_.x - theme_.px(30);
    for (int decade = static_cast<int>(std::floor(low_)); decade <= high_; ++decade) {
        for (const int step : {1, 2, 5}) {
            if (step != 1 && !dense) continue;
            const double value = step * std::pow(10.0, decade);
            const double place = std::log10(value);
            if (place < low_ || place > high_) continue;
            const float at = std::round(x(value));
            draw.AddLine({at, min_.y}, {at, max_.y}, withAlpha(theme_.text, 0.07f));
            const std::string text = axisText(value, cost);
            const float wide = small->CalcTextSizeA(small->FontSize, FLT_MAX, 0.0f, text.c_str()).x;
            const float left = std::clamp(at - std::round(wide * 0.5f), min_.x - theme_.px(30),
                                          max_.x + theme_.px(10) - wide);
            if (left < free) continue;
            draw.AddText(small, small->FontSize, {left, max_.y + theme_.px(6)}, theme_.textDim,
                         text.c_str());
            free = left + wide + theme_.px(10);
        }
    }
}

void PlotArea::drawGrid(ImDrawList& draw, trade::Cost cost) const {
    ImFont* small = theme_.fonts.small;
    constexpr std::array kSteps{0.01, 0.02, 0.05, 0.1, 0.2, 0.25};
    double step = kSteps.back();
    for (const double each : kSteps) {
        if (most_ / each > 5.0) continue;
        step = each;
        break;
    }
    for (double error = 0.0; error <= most_ + 1e-9; error += step) {
        const float at = std::round(y(error));
        draw.AddLine({min_.x, at}, {max_.x, at},
                     withAlpha(theme_.text, error > 0.0 ? 0.07f : 0.2f));
        std::array<char, 16> text{};
        std::snprintf(text.data(), text.size(), "%.0f %%", 100.0 * error);
        const float wide = small->CalcTextSizeA(small->FontSize, FLT_MAX, 0.0f, text.data()).x;
        draw.AddText(small, small->FontSize,
                     {min_.x - theme_.px(6) - wide, at - std::round(small->FontSize * 0.5f)},
                     theme_.textDim, text.data());
    }
    drawColumns(draw, cost);
}

// What an artist may allow: everything below a line.
void drawBudget(Ui& ui, ImDrawList& draw, const PlotArea& frame) {
    const Theme& theme = ui.theme;
    const float y = std::round(frame.y(ui.settings.trade.errorBudget));
    draw.AddRectFilled({frame.min().x, y}, frame.max(), withAlpha(theme.accent, 0.08f));
    const float dash = theme.px(5);
    for (float x = frame.min().x; x < frame.max().x; x += 2 * dash) {
        draw.AddLine({x, y}, {std::min(x + dash, frame.max().x), y}, withAlpha(theme.accent, 0.7f),
                     theme.px(1));
    }
}

// From point to point of the front, which falls as costs rise.
void drawFront(Ui& ui, ImDrawList& draw, const PlotArea& frame,
               const std::vector<std::size_t>& front) {
    const TradeSettings& settings = ui.settings.trade;
    const trade::Curve& curve = ui.context.study.curve();
    std::vector<ImVec2> line;
    for (const std::size_t k : front) {
        const trade::Point& point = curve.points[k];
        line.emplace_back(frame.x(trade::costOf(point, settings.cost)),
                          frame.y(point.error(settings.yardstick)));
    }
    draw.AddPolyline(line.data(), static_cast<int>(line.size()), withAlpha(ui.theme.accent, 0.75f),
                     0, ui.theme.px(2));
}

void drawSide(Ui& ui, ImDrawList& draw, ImVec2 at, const char* letter, ImU32 colour,
              const char* name) {
    const Theme& theme = ui.theme;
    const float radius = theme.px(8);
    draw.AddCircleFilled(at, radius + theme.px(2), theme.panel);
    draw.AddCircleFilled(at, radius, colour);
    ImFont* font = theme.fonts.bold;
    const float size = theme.fonts.small->FontSize;
    const ImVec2 wide = font->CalcTextSizeA(size, FLT_MAX, 0.0f, letter);
    draw.AddText(font, size, {std::round(at.x - wide.x * 0.5f), std::round(at.y - wide.y * 0.5f)},
                 kInk, letter);
    ui.probe.mark(name, {at.x - radius, at.y - radius}, {at.x + radius, at.y + radius});
}

void pointTooltip(Ui& ui, const trade::Point& point) {
    const Theme& theme = ui.theme;
    const TradeStudy& study = ui.context.study;
    const trade::AtSize& largest = point.bySize.back();
    std::string text = titleOf(point.setting, study.reference()) + "\n";
    text +=
        percentText(point.error(trade::Yardstick::sprite)) + " off the reference's exact sprite (";
    text += percentText(largest.sprite.flipWorst) + " in the worst view)\n";
    text +=
        percentText(point.error(trade::Yardstick::perspective)) + " off the voxels themselves\n";
    text += percentText(largest.sprite.silhouette) + " of the silhouette, " +
            percentText(largest.time.changedADegree) + " of its pixels change a degree\n";
    if (largest.costs) {
        const trade::Spread& spread = largest.costs->milliseconds;
        text += millisecondsText(point.milliseconds()) + " a frame (the median " +
                millisecondsText(spread.median) + " when large), " + countText(point.rays()) +
                " rays\n";
    }
    text += "Click: look at it as B. Double click: use it";
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, theme.px(10, 7));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, theme.px(6));
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(theme.px(330));
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    ImGui::PopStyleVar(2);
}

}  // namespace

PlotAnswer drawTradePlot(Ui& ui, const trade::Setting& inForce, ImVec2 size) {
    const Theme& theme = ui.theme;
    const TradeSettings& settings = ui.settings.trade;
    const TradeStudy& study = ui.context.study;
    const std::vector<trade::Point>& points = study.curve().points;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 end(corner.x + size.x, corner.y + size.y);
    ImGui::InvisibleButton("plot", size);
    ui.probe.markItem("trade.plot");
    const bool hovered = ImGui::IsItemHovered();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(corner, end, theme.field, theme.px(6));

    const auto errorOf = [&](const trade::Point& p) { return p.error(settings.yardstick); };
    const auto costOf = [&](const trade::Point& p) { return trade::costOf(p, settings.cost); };
    const trade::Point* a = study.find(inForce);
    const trade::Point* b = settings.b ? study.find(*settings.b) : nullptr;
    PlotArea frame(ui, corner, size);
    for (const trade::Point& point : points) frame.include(costOf(point), errorOf(point));
    for (const trade::Point* side : {a, b}) {
        if (side != nullptr) frame.include(costOf(*side), errorOf(*side));
    }
    frame.settle();
    frame.drawGrid(draw, settings.cost);
    drawBudget(ui, draw, frame);
    const std::vector<std::size_t> front =
        trade::paretoFront(study.curve(), settings.yardstick, settings.cost);
    drawFront(ui, draw, frame, front);

    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const trade::Point* nearest = nullptr;
    float reach = theme.px(kPointerReachPx);
    for (std::size_t k = 0; k < points.size(); ++k) {
        const trade::Point& point = points[k];
        if (!std::isfinite(costOf(point))) continue;
        const ImVec2 at(frame.x(costOf(point)), frame.y(errorOf(point)));
        const bool best = std::ranges::find(front, k) != front.end();
        const float radius = theme.px(best ? 4.5f : 3.5f);
        draw.AddCircleFilled(at, radius + theme.px(1), theme.field);
        draw.AddCircleFilled(at, radius,
                             best ? colourOf(point.axis) : withAlpha(colourOf(point.axis), 0.55f));
        ui.probe.mark("trade.point." + std::to_string(k), {at.x - radius, at.y - radius},
                      {at.x + radius, at.y + radius});
        const float away = std::hypot(mouse.x - at.x, mouse.y - at.y);
        if (!hovered || away > reach) continue;
        reach = away;
        nearest = &point;
    }
    if (b != nullptr) {
        drawSide(ui, draw, {frame.x(costOf(*b)), frame.y(errorOf(*b))}, "B", kSideB, "trade.b");
    }
    if (a != nullptr) {
        drawSide(ui, draw, {frame.x(costOf(*a)), frame.y(errorOf(*a))}, "A", theme.accent,
                 "trade.a");
    }
    PlotAnswer answer;
    if (nearest == nullptr) return answer;
    draw.AddCircle({frame.x(costOf(*nearest)), frame.y(errorOf(*nearest))}, theme.px(8), theme.text,
                   0, theme.px(1.5f));
    pointTooltip(ui, *nearest);
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        answer.taken = nearest->setting;
    } else if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        answer.looked = nearest->setting;
    }
    return answer;
}

void drawTradeLegend(Ui& ui) {
    const Theme& theme = ui.theme;
    std::vector<trade::Axis> axes;
    for (const trade::Point& point : ui.context.study.curve().points) {
        if (point.axis == trade::Axis::game) continue;  // where A starts
        if (std::ranges::find(axes, point.axis) == axes.end()) axes.push_back(point.axis);
    }
    ImFont* small = theme.fonts.small;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, line = theme.px(18);
    float x = 0.0f, y = 0.0f;
    for (const trade::Axis axis : axes) {
        const char* title = trade::titleOf(axis);
        const float wide = small->CalcTextSizeA(small->FontSize, FLT_MAX, 0.0f, title).x;
        if (x > 0.0f && x + theme.px(12) + wide > width) x = 0.0f, y += line;
        const ImVec2 at(corner.x + x, corner.y + y);
        draw.AddCircleFilled({at.x + theme.px(4), at.y + line * 0.5f}, theme.px(4), colourOf(axis));
        draw.AddText(small, small->FontSize,
                     {at.x + theme.px(12), at.y + std::round((line - small->FontSize) * 0.5f)},
                     theme.textDim, title);
        x += theme.px(12) + wide + theme.px(12);
    }
    ImGui::Dummy({width, axes.empty() ? line : y + line});
}

}  // namespace voxprite::editor
