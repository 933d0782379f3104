// A, the settings in force, and B, those they are held against: flipped between, or with a bar that
// is wiped across; and the error map of what shows.
#include <algorithm>
#include <array>
#include <cmath>

#include "app/editor/panels/trade_text.h"
#include "app/editor/session/trade_moves.h"
#include "app/editor/views/pill.h"
#include "app/editor/views/sprite_viewport.h"
#include "app/editor/window/imgui_names.h"

namespace voxprite::editor {
namespace {

constexpr float kGrip = 9.0f;  // of the bar, to either side

// A letter on its colour, what the side is, and what was measured of it.
void drawLabel(Ui& ui, const ViewCanvas& canvas, bool isB, bool onRight, float room) {
    const Theme& theme = ui.theme;
    const TradeStudy& study = ui.context.study;
    const trade::Setting setting =
        isB ? *ui.settings.trade.b
            : settingInForce(ui.session.profile(), ui.settings.scene.representations);
    const std::string title = titleOf(setting, study.reference());
    std::string figures = figureText(study.find(setting), ui.settings.trade.yardstick);
    ImFont *text = theme.fonts.text, *small = theme.fonts.small, *bold = theme.fonts.bold;
    const float pad = theme.px(10), badge = theme.px(22);
    const float most = room - 3 * pad - badge - theme.px(18);
    // In a narrow view the error has a line of its own, and what it costs the next.
    const float wide = small->CalcTextSizeA(small->FontSize, FLT_MAX, 0.0f, figures.c_str()).x;
    const std::size_t gap = figures.find("  ");
    if (wide > most && gap != std::string::npos) {
        figures[gap] = '\n';
        figures.erase(gap + 1, 1);
    }
    const auto sizeOf = [&](ImFont* font, const std::string& line) {
        return font->CalcTextSizeA(font->FontSize, FLT_MAX, most, line.c_str());
    };
    const ImVec2 titleSize = sizeOf(text, title), figuresSize = sizeOf(small, figures);
    const ImVec2 size(std::max(titleSize.x, figuresSize.x) + badge + 3 * pad,
                      std::max(badge, titleSize.y + theme.px(2) + figuresSize.y) + theme.px(14));
    const ImVec2 corner = canvas.toWindow({onRight ? canvas.sizePx().x : 0, canvas.sizePx().y});
    const ImVec2 at(onRight ? corner.x - pad - size.x : corner.x + pad, corner.y - pad - size.y);
    ImDrawList& draw = canvas.overlay();
    draw.AddRectFilled(at, {at.x + size.x, at.y + size.y}, kPill, theme.px(8));
    const ImVec2 middle(at.x + pad + badge * 0.5f, at.y + size.y * 0.5f);
    draw.AddCircleFilled(middle, badge * 0.5f, isB ? kSideB : theme.accent);
    const char* letter = isB ? "B" : "A";
    const ImVec2 letterSize = bold->CalcTextSizeA(bold->FontSize, FLT_MAX, 0.0f, letter);
    draw.AddText(
        bold, bold->FontSize,
        {std::round(middle.x - letterSize.x * 0.5f), std::round(middle.y - letterSize.y * 0.5f)},
        IM_COL32(16, 17, 19, 255), letter);
    const float x = at.x + 2 * pad + badge;
    const float y = at.y + std::round((size.y - titleSize.y - figuresSize.y - theme.px(2)) * 0.5f);
    draw.AddText(text, text->FontSize, {x, y}, kPillText, title.c_str(), nullptr, most);
    draw.AddText(small, small->FontSize, {x, y + titleSize.y + theme.px(2)}, kPillDim,
                 figures.c_str(), nullptr, most);
    ui.probe.mark(isB ? "sprite.side.b" : "sprite.side.a", at, {at.x + size.x, at.y + size.y});
}

}  // namespace

void SpriteViewport::drawWipeBar(Ui& ui) {
    const Theme& theme = ui.theme;
    TradeSettings& settings = ui.settings.trade;
    const auto width = static_cast<float>(canvas_.sizePx().x);
    const float grip = theme.px(kGrip);
    const ImVec2 top = canvas_.toWindow({0, 0});
    const ImVec2 bottom = canvas_.toWindow(glm::dvec2(canvas_.sizePx()));
    float x = std::round(top.x + width * static_cast<float>(settings.wipe));
    // A window of its own: what is pressed here is not pressed in the view.
    ImGui::SetCursorScreenPos({x - grip, top.y});
    ImGui::BeginChild("sprite.wipe", {2 * grip, bottom.y - top.y}, false,
                      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoBackground);
    ImGui::InvisibleButton("bar", {2 * grip, bottom.y - top.y});
    ui.probe.markItem("sprite.wipe");
    const bool lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
    if (lit) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ImGui::IsItemActive()) {
        const float share = (ImGui::GetIO().MousePos.x - top.x) / width;
        settings.wipe = std::clamp(static_cast<double>(share), 0.02, 0.98);
        x = std::round(top.x + width * static_cast<float>(settings.wipe));
    }
    ImGui::EndChild();
    ImDrawList& draw = canvas_.overlay();
    const float half = theme.px(1);
    draw.AddRectFilled({x - half - 1, top.y}, {x + half + 1, bottom.y}, IM_COL32(16, 17, 19, 130));
    draw.AddRectFilled({x - half, top.y}, {x + half, bottom.y}, kPillText);
    const ImVec2 knob(x, std::round((top.y + bottom.y) * 0.5f));
    const float radius = theme.px(13), arrow = theme.px(4), out = theme.px(7);
    draw.AddCircleFilled(knob, radius, lit ? theme.accent : kPillText);
    draw.AddCircle(knob, radius, IM_COL32(16, 17, 19, 130), 0, theme.px(1));
    const ImU32 ink = IM_COL32(16, 17, 19, 255);
    draw.AddTriangleFilled({x - out, knob.y}, {x - out + arrow, knob.y - arrow},
                           {x - out + arrow, knob.y + arrow}, ink);
    draw.AddTriangleFilled({x + out, knob.y}, {x + out - arrow, knob.y + arrow},
                           {x + out - arrow, knob.y - arrow}, ink);
}

void SpriteViewport::showSides(Ui& ui) {
    const TradeSettings& settings = ui.settings.trade;
    const bool both = settings.side == SideShown::both;
    const ImVec2 min = canvas_.toWindow({0, 0});
    const ImVec2 max = canvas_.toWindow(glm::dvec2(canvas_.sizePx()));
    const float width = max.x - min.x;
    const float from = both ? std::round(min.x + width * static_cast<float>(settings.wipe)) : min.x;
    if (cellB_.frame && cellB_.problem.empty()) {
        cellB_.frame->resize(canvas_.sizePx());  // as it will be drawn in a moment
        const float share = (from - min.x) / width;
        // The texture's rows run upward.
        canvas_.overlay().AddImage(imguiTexture(cellB_.frame->colourTexture()), {from, min.y}, max,
                                   {share, 1}, {1, 0});
    }
    if (both) drawWipeBar(ui);
    const float room = both ? width * 0.5f : width;
    if (both) drawLabel(ui, canvas_, false, false, room);
    drawLabel(ui, canvas_, true, both, room);
}

Status SpriteViewport::renderB(const Session& session, const GpuOctree& octree,
                               const EditorSettings& settings) {
    const trade::Setting& b = *settings.trade.b;
    const GameProfile profile = trade::profileWith(session.profile(), b);
    if (!cellB_.frame) cellB_.frame = std::make_unique<Frame>(canvas_.sizePx());
    cellB_.frame->resize(canvas_.sizePx());
    prepare(cellB_);
    if (viewsBName_ != b.viewSet) {
        viewsB_ = ViewSet::named(b.viewSet).value_or(ViewSet());
        viewsBName_ = b.viewSet;
    }
    Scene scene = scene_.make(session, octree, settings.view, profile, cellB_.histories);
    scene.clusterBudgetPx = b.clusterBudgetPx;
    for (SceneEntity& entity : scene.entities) {
        entity = drawnBy(entity, choiceOf(b), library_->levelsOf(entity.octree), viewsB_);
    }
    const Camera camera = camera_.camera(canvas_.sizePx());
    const Result<SceneStats> stats =
        renderer_.draw(*cellB_.frame, scene, camera, profile, profile.mode);
    if (!stats) return Failure(stats.error());
    cellB_.stats = *stats;
    return {};
}

bool SpriteViewport::wantsHeat(const Session& session, const EditorSettings& settings) const {
    const bool other = areas_.size() > 1 || settings.scene.representations.compared;
    const bool bothSides = showsSides(settings.trade) && settings.trade.side == SideShown::both;
    return settings.trade.heat && !other && !bothSides && !session.bounds().empty() &&
           !session.previews();
}

Status SpriteViewport::followHeat(const Session& session, const GpuOctree& octree,
                                  const EditorSettings& settings) {
    const bool isB = showsSides(settings.trade);
    const SpriteCell& cell = isB ? cellB_ : cells_.front();
    const RepresentationSettings& representations = settings.scene.representations;
    const trade::Setting setting =
        isB ? *settings.trade.b : settingInForce(session.profile(), representations);
    RepresentationChoice choice = choiceOf(setting);
    // Whatever the rule chose for the model itself.
    if (!isB && !cell.chosen.empty() && cell.chosen.front()) choice = *cell.chosen.front();
    const GameProfile reference =
        trade::profileWith(session.profile(), reference_.value_or(setting));
    ErrorHeat::Terms terms{octree.revision(),
                           session.revision(),
                           library_->revision(),
                           trade::profileWith(session.profile(), setting),
                           reference,
                           camera_,
                           canvas_.sizePx(),
                           choice,
                           setting.viewSet,
                           setting.clusterBudgetPx,
                           settings.trade.heatYardstick};
    ErrorHeat::Subject subject;
    subject.octree = &octree;
    subject.placed = session.placedInGame();
    subject.placed.anchorMetres.y +=
        groundClearanceMetres(terms.profile) - groundClearanceMetres(session.profile());
    ViewHistory history;
    if (!cell.histories.empty()) history = cell.histories.front();
    const SceneEntity exact{&octree, &session.shownPalette(), subject.placed, &history};
    subject.shown =
        drawnBy(exact, choice, library_->levelsOf(&octree), isB ? viewsB_ : library_->views());
    subject.camera = camera_.camera(canvas_.sizePx());
    return heat_->follow(terms, subject, renderer_);
}

}  // namespace voxprite::editor
