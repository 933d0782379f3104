#include "app/editor/views/representation_cells.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "app/editor/panels/trade_text.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/views/pill.h"
#include "app/editor/views/scene_representations.h"
#include "app/editor/window/icons.h"
#include "app/editor/window/imgui_names.h"
#include "core/measure/compare.h"

namespace voxprite::editor {
namespace {

constexpr double kFlightSeconds = 6.0;  // one way
constexpr int kStillPictures = 4;       // before errors are worked out
constexpr int kMostZoom = 8;
constexpr ImU32 kBackTop = IM_COL32(86, 98, 116, 255), kBackBottom = IM_COL32(128, 139, 150, 255);

// 0 near ... 1 far, and back.
double shareOf(double sizePx) {
    return std::log(kMostComparedPx / sizePx) / std::log(kMostComparedPx / kLeastComparedPx);
}
double sizeOf(double share) {
    return kMostComparedPx * std::pow(kLeastComparedPx / kMostComparedPx, share);
}

Image middleOf(const Image& image, int edgePx) {
    const glm::ivec2 size(std::min(edgePx, image.width), std::min(edgePx, image.height));
    const glm::ivec2 corner((image.width - size.x) / 2, (image.height - size.y) / 2);
    Image middle(size.x, size.y);
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) middle.at(x, y) = image.at(corner.x + x, corner.y + y);
    }
    return middle;
}

std::string costText(double microseconds) {
    std::array<char, 32> text{};
    const char* form = microseconds < 10.0    ? "%.1f µs"
                       : microseconds < 999.5 ? "%.0f µs"
                                              : "%.1f ms";
    std::snprintf(text.data(), text.size(), form,
                  microseconds < 999.5 ? microseconds : microseconds / 1000.0);
    return text.data();
}

}  // namespace

void RepresentationCells::advance(RepresentationSettings& settings, double seconds) {
    if (!settings.compared || !settings.flying) {
        // Goes on from wherever the artist has gone.
        flightSeconds_ = kFlightSeconds * shareOf(settings.comparedSizePx);
        return;
    }
    flightSeconds_ = std::fmod(flightSeconds_ + seconds, 2.0 * kFlightSeconds);
    const double way = flightSeconds_ / kFlightSeconds;
    settings.comparedSizePx = sizeOf(way <= 1.0 ? way : 2.0 - way);
}

Result<bool> RepresentationCells::render(SceneRenderer& renderer, const Subject& subject,
                                         const LevelLibrary& library,
                                         const RepresentationSettings& settings, glm::ivec2 viewPx,
                                         int gapPx) {
    const Shown wanted{subject.revision,
                       library.revision(),
                       subject.angles.yawDegrees,
                       subject.angles.pitchDegrees,
                       settings,
                       viewPx};
    if (shown_ == wanted) {
        if (++still_ < kStillPictures || !pending()) return false;
        if (const Status measured = measureNext(); !measured) return Failure(measured.error());
        return true;
    }
    areas_ = cellAreas(viewPx, static_cast<int>(kCells), gapPx);
    still_ = 0;
    if (const Status drawn = draw(renderer, subject, library, settings); !drawn) {
        return Failure(drawn.error());
    }
    shown_ = wanted;
    return true;
}

Status RepresentationCells::draw(SceneRenderer& renderer, const Subject& subject,
                                 const LevelLibrary& library,
                                 const RepresentationSettings& settings) {
    const double sizePx = settings.comparedSizePx;
    const GpuModelLevels* levels = library.levelsOf(subject.octree);
    const RepresentationTable& table = library.tableOf(subject.octree);
    edgePx_ = edgeAtSize(sizePx);
    const glm::ivec2 area = areas_.front().size;
    // The sphere around the model is larger than what shows of it.
    const int least = std::max(1, static_cast<int>(std::ceil(1.9 * sizePx)));
    zoom_ = std::clamp(std::min(area.x, area.y) / least, 1, kMostZoom);
    const glm::ivec2 framePx = (area + zoom_ - 1) / zoom_;
    SceneEntity exact{subject.octree, subject.palette, subject.placed};
    exact.placed.anchorMetres -= exact.placed.centreMetres();
    const double radius = exact.placed.radiusMetres();
    const Camera camera = cameraAtSize(radius, sizePx, subject.angles, framePx);
    distanceMetres_ = glm::length(camera.eyeMetres);

    ChoiceRules rules = settings.rules();
    rules.forced.reset();
    const RepresentationChoice best = choose(table, sizePx, rules, std::nullopt);
    chosen_ = table.empty() ? kCells : static_cast<std::size_t>(best.kind);
    for (std::size_t k = 0; k < kCells; ++k) {
        Cell& cell = cells_[k];
        const auto kind = static_cast<Representation>(k);
        const bool coarse = kind == Representation::coarse;
        cell.choice = {kind, !coarse             ? 0
                             : best.kind == kind ? best.levels
                                                 : settings.coarserLevels};
        cell.error.reset();
        cell.microseconds.reset();
        if (const RepresentationFigures* figures = figuresOf(table, cell.choice)) {
            cell.microseconds = microsecondsAt(*figures, sizePx);
        }
        Scene scene;
        scene.clusterBudgetPx = settings.clusterBudgetPx;
        scene.entities = {drawnBy(exact, cell.choice, levels, library.views())};
        cell.offered = scene.entities.front().representation == kind;
        if (!cell.offered) scene.entities.clear();
        if (!cell.frame || cell.frame->sizePx() != framePx) {
            leaving_.push_back(std::exchange(cell.frame, std::make_unique<Frame>(framePx)));
        }
        const Result<SceneStats> stats =
            renderer.draw(*cell.frame, scene, camera, subject.profile, subject.profile.mode);
        if (!stats) return Failure(stats.error());
        cell.stats = *stats;
    }
    return {};
}

void RepresentationCells::clear() {
    shown_.reset();
    areas_.clear();
    for (Cell& cell : cells_) {
        cell.offered = false;
        cell.error.reset();
    }
}

bool RepresentationCells::pending() const {
    return shown_ && std::ranges::any_of(
                         cells_, [](const Cell& cell) { return cell.offered && !cell.error; });
}

Status RepresentationCells::measureNext() {
    cells_.front().error = 0.0;
    const auto next =
        std::ranges::find_if(cells_, [](const Cell& cell) { return cell.offered && !cell.error; });
    if (next == cells_.end()) return {};
    const Result<double> error = flipInside(middleOf(cells_.front().frame->readColour(), edgePx_),
                                            middleOf(next->frame->readColour(), edgePx_));
    if (!error) return Failure(error.error());
    next->error = *error;
    return {};
}

void RepresentationCells::show(Ui& ui, const ViewCanvas& canvas, const LevelLibrary& library) {
    const Theme& theme = ui.theme;
    leaving_.clear();
    ImDrawList& draw = canvas.overlay();
    const ImVec2 min = canvas.toWindow({0, 0});
    const ImVec2 max = canvas.toWindow(glm::dvec2(canvas.sizePx()));
    draw.AddRectFilled(min, max, theme.window);
    for (std::size_t k = 0; k < std::min(areas_.size(), kCells); ++k) {
        const Cell& cell = cells_[k];
        const CellArea& area = areas_[k];
        const ImVec2 from = canvas.toWindow(glm::dvec2(area.min));
        const ImVec2 to = canvas.toWindow(glm::dvec2(area.min + area.size));
        draw.AddRectFilledMultiColor(from, to, kBackTop, kBackTop, kBackBottom, kBackBottom);
        if (cell.frame != nullptr && cell.offered) {
            const auto texture = reinterpret_cast<ImTextureID>(
                static_cast<std::uintptr_t>(cell.frame->colourTexture()));
            const glm::ivec2 shown = cell.frame->sizePx() * zoom_;
            const glm::ivec2 corner = area.min + (area.size - shown) / 2;
            draw.PushClipRect(from, to, true);
            // The texture's rows run upward.
            draw.AddImage(texture, canvas.toWindow(glm::dvec2(corner)),
                          canvas.toWindow(glm::dvec2(corner + shown)), {0, 1}, {1, 0});
            if (zoom_ > 1) {
                // As large as it is.
                const glm::dvec2 all(cell.frame->sizePx());
                const glm::dvec2 part = glm::min(glm::dvec2(edgePx_), all);
                const glm::dvec2 least = 0.5 - 0.5 * part / all, most = 0.5 + 0.5 * part / all;
                const float pad = theme.px(10);
                const ImVec2 low(from.x + pad, from.y + pad);
                const ImVec2 high(low.x + static_cast<float>(part.x),
                                  low.y + static_cast<float>(part.y));
                draw.AddRectFilled(low, high, kBackTop, theme.px(3));
                draw.AddImage(texture, low, high,
                              {static_cast<float>(least.x), static_cast<float>(most.y)},
                              {static_cast<float>(most.x), static_cast<float>(least.y)});
                draw.AddRect(low, high, IM_COL32(255, 255, 255, 60), theme.px(3));
            }
            draw.PopClipRect();
        }
        ui.probe.mark("represent." + std::to_string(k), from, to);
        caption(ui, cell, from, to, k == chosen_);
    }
    if (areas_.empty()) {
        const ImVec2 end(max.x, max.y - static_cast<float>(barPx(theme)));
        draw.AddRectFilledMultiColor(min, end, kBackTop, kBackTop, kBackBottom, kBackBottom);
        constexpr const char* kNothing = "No voxels to draw yet";
        const ImVec2 size = ImGui::CalcTextSize(kNothing);
        draw.AddText({std::round((min.x + end.x - size.x) * 0.5f),
                      std::round((min.y + end.y - size.y) * 0.5f)},
                     kPillText, kNothing);
    }
    const std::string progress = library.progress();
    if (!progress.empty()) {
        ImFont* small = theme.fonts.small;
        const ImVec2 text = small->CalcTextSizeA(small->FontSize, FLT_MAX, 0.0f, progress.c_str());
        const ImVec2 size(text.x + theme.px(16), text.y + theme.px(8));
        const ImVec2 at(max.x - theme.px(10) - size.x,
                        max.y - static_cast<float>(barPx(theme)) - theme.px(10) - size.y);
        draw.AddRectFilled(at, {at.x + size.x, at.y + size.y}, kPill, theme.px(6));
        draw.AddText(small, small->FontSize, {at.x + theme.px(8), at.y + theme.px(4)}, kPillDim,
                     progress.c_str());
    }
    drawBar(ui, {min.x, max.y - static_cast<float>(barPx(theme))}, max);
}

void RepresentationCells::caption(Ui& ui, const Cell& cell, ImVec2 min, ImVec2 max, bool chosen) {
    const Theme& theme = ui.theme;
    const RepresentationSettings& settings = ui.settings.scene.representations;
    const Representation kind = cell.choice.kind;
    std::string name = nameOf(kind);
    if (kind == Representation::coarse) {
        name += cell.choice.levels == 1 ? ", 1 level"
                                        : ", " + std::to_string(cell.choice.levels) + " levels";
    }
    std::string detail;
    if (!cell.offered) {
        detail = "not there (yet)";
    } else if (kind != Representation::sprite) {
        detail = cell.error ? percentText(*cell.error) + " off" : "…";
    } else if (cell.stats.drawn > 0) {
        std::array<char, 48> text{};
        std::snprintf(text.data(), text.size(), "%.3g px a vpx", cell.stats.screenPxPerPx);
        detail = text.data();
    }
    if (cell.offered && cell.microseconds) detail += "   " + costText(*cell.microseconds);

    ImDrawList& draw = *ImGui::GetWindowDrawList();
    ImFont *bold = theme.fonts.bold, *small = theme.fonts.small;
    const ImVec2 nameSize = bold->CalcTextSizeA(bold->FontSize, FLT_MAX, 0.0f, name.c_str());
    const ImVec2 detailSize = small->CalcTextSizeA(small->FontSize, FLT_MAX, 0.0f, detail.c_str());
    const std::string mark = chosen ? std::string(icon::kCheck) + " chosen" : "";
    const ImVec2 markSize = small->CalcTextSizeA(small->FontSize, FLT_MAX, 0.0f, mark.c_str());
    const float dot = theme.px(5), pad = theme.px(10);
    const float nameX = pad + 2 * dot + theme.px(8);
    const float markX = nameX + nameSize.x + theme.px(10);
    const float first = chosen ? markX + markSize.x : nameX + nameSize.x;
    const ImVec2 size(pad + std::max(first, pad + detailSize.x), theme.px(44));
    const ImVec2 at(min.x + pad, max.y - pad - size.y);
    draw.AddRectFilled(at, {at.x + size.x, at.y + size.y}, kPill, theme.px(6));
    const float line = at.y + theme.px(5);
    draw.AddCircleFilled({at.x + pad + dot, line + nameSize.y * 0.5f}, dot, toImU32(tintOf(kind)));
    draw.AddText(bold, bold->FontSize, {at.x + nameX, line}, kPillText, name.c_str());
    draw.AddText(small, small->FontSize,
                 {at.x + markX, line + std::round((nameSize.y - markSize.y) * 0.5f)}, theme.accent,
                 mark.c_str());
    const bool over = cell.error && *cell.error > settings.errorBudget;
    draw.AddText(small, small->FontSize, {at.x + pad, at.y + theme.px(24)},
                 over ? IM_COL32(255, 150, 130, 255) : kPillDim, detail.c_str());
    ui.probe.mark("represent.caption." + std::to_string(static_cast<int>(kind)), at,
                  {at.x + size.x, at.y + size.y});
    if (!chosen) return;
    const float width = theme.px(2), half = width * 0.5f;
    draw.AddRect({min.x + half, min.y + half}, {max.x - half, max.y - half}, theme.accent, 0.0f, 0,
                 width);
}

void RepresentationCells::drawBar(Ui& ui, ImVec2 min, ImVec2 max) {
    const Theme& theme = ui.theme;
    RepresentationSettings& settings = ui.settings.scene.representations;
    // A window of its own: what is pressed here is not pressed in the view.
    ImGui::SetCursorScreenPos(min);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, theme.panel);
    ImGui::BeginChild("represent.bar", {max.x - min.x, max.y - min.y}, false,
                      ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleColor();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float button = theme.px(28), gap = theme.px(8), pad = theme.px(8);
    ImGui::SetCursorScreenPos({min.x + pad, min.y + std::round((max.y - min.y - button) * 0.5f)});
    commandButton(ui, CommandId::flyRepresentations, settings.flying ? Lit::filled : Lit::off,
                  button);
    ImGui::SameLine(0.0f, gap);
    std::array<char, 64> text{};
    const char* form = distanceMetres_ < 100.0 ? "%.1f m   %.0f px high" : "%.0f m   %.0f px high";
    std::snprintf(text.data(), text.size(), form, distanceMetres_, 2.0 * settings.comparedSizePx);
    const float textX =
        max.x - pad - button - gap - ImGui::CalcTextSize("9999.9 m   999 px high").x;
    auto share = static_cast<float>(shareOf(settings.comparedSizePx));
    const float middle = (min.y + max.y) * 0.5f;
    const float sliderX = ImGui::GetCursorScreenPos().x;
    ImGui::SetCursorScreenPos({sliderX, std::round(middle - ImGui::GetFrameHeight() * 0.5f)});
    ImGui::SetNextItemWidth(std::max(theme.px(60), textX - sliderX - gap));
    if (ImGui::SliderFloat("##distance", &share, 0.0f, 1.0f, "", ImGuiSliderFlags_NoInput)) {
        settings.comparedSizePx = sizeOf(static_cast<double>(share));
        settings.flying = false;
    }
    ui.probe.markItem("represent.distance");
    tooltip(ui, "From near to far: how large the model shows on the game's screen");
    draw.AddText({textX, std::round(middle - ImGui::GetFontSize() * 0.5f)}, theme.textDim,
                 text.data());
    ImGui::SetCursorScreenPos({max.x - pad - button, std::round(middle - button * 0.5f)});
    if (iconButton(ui, "represent.close", icon::kClose, Lit::off, button, "Back to the scene")) {
        ui.commands.ask(CommandId::compareRepresentations);
    }
    ImGui::EndChild();
}

}  // namespace voxprite::editor
