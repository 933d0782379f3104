// Speed against accuracy: the curve of the open model, where the settings in force stand on it, and
// what is chosen from it.
#include <array>
#include <cmath>

#include "app/editor/panels/panels.h"
#include "app/editor/panels/trade_plot.h"
#include "app/editor/panels/trade_text.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/session/trade_moves.h"
#include "app/editor/window/icons.h"
#include "app/trade/choice.h"

namespace voxprite::editor {
namespace {

constexpr std::array kYardsticks{
    Choice{"Exact sprite", "Against the exact sprite by the reference: what cheaper ways give up"},
    Choice{"Voxels",
           "Against the voxels themselves in perspective: what the style leaves out, "
           "too; never 0"}};
constexpr std::array kCosts{
    Choice{"Time", "Milliseconds a frame, of a camera on its way past new views"},
    Choice{"Rays", "Rays a frame: the same on every machine"}};

// Two figures of a number are enough.
double snapPercent(double percent) {
    const double step = std::pow(10.0, std::floor(std::log10(std::max(percent, 1e-3))) - 1.0);
    return std::round(percent / step) * step;
}

void use(Ui& ui, const trade::Setting& setting) {
    const std::string title = titleOf(setting, ui.context.study.reference());
    if (auto step = profileStep(ui.session, setting, title)) ui.edits.push(std::move(*step));
    RepresentationSettings& representations = ui.settings.scene.representations;
    representations = representationsWith(representations, setting);
}

void smallLine(Ui& ui, const std::string& text, ImU32 colour) {
    ImGui::PushFont(ui.theme.fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

std::string measuredText(const TradeStudy& study) {
    const trade::Plan& plan = study.plan();
    return std::to_string(study.curve().points.size()) +
           " settings, measured on this machine: one thread of the processor, " +
           std::to_string(plan.views) + " views at " + std::to_string(plan.sizesPx.size()) +
           (plan.sizesPx.size() == 1 ? " size" : " sizes");
}

// What goes on, with a bar; or what was measured, and how.
void drawProgress(Ui& ui) {
    const Theme& theme = ui.theme;
    const TradeStudy& study = ui.context.study;
    const float square = theme.px(22), width = ImGui::GetContentRegionAvail().x;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::BeginGroup();
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width - square - theme.px(4));
    ImGui::PushFont(theme.fonts.small);
    ImGui::PushStyleColor(ImGuiCol_Text, study.problem().empty() ? theme.textDim : theme.danger);
    if (!study.problem().empty()) {
        ImGui::TextUnformatted(study.problem().c_str());
    } else if (study.busy()) {
        ImGui::Text("Measuring, %d %%", static_cast<int>(100.0 * study.share()));
    } else if (study.cancelled()) {
        ImGui::Text("Stopped at %d %%", static_cast<int>(100.0 * study.share()));
    } else if (!study.curve().points.empty()) {
        ImGui::TextUnformatted(measuredText(study).c_str());
    } else {
        ImGui::TextUnformatted("There is no voxel to measure");
    }
    ImGui::PopStyleColor();
    ImGui::PopFont();
    ImGui::PopTextWrapPos();
    ImGui::EndGroup();
    ui.probe.markItem("trade.progress");
    const float below = ImGui::GetItemRectMax().y;
    if (study.busy()) {
        const float y = below + theme.px(3), right = corner.x + width - square - theme.px(8);
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        const auto share = static_cast<float>(study.share());
        draw.AddRectFilled({corner.x, y}, {right, y + theme.px(3)}, theme.field, theme.px(2));
        draw.AddRectFilled({corner.x, y}, {corner.x + share * (right - corner.x), y + theme.px(3)},
                           theme.accent, theme.px(2));
    }
    ImGui::SetCursorScreenPos({corner.x + width - square, corner.y - theme.px(3)});
    ImGui::PushStyleColor(ImGuiCol_Text, theme.textDim);
    if (study.busy()) {
        if (iconButton(ui, "trade.cancel", icon::kClose, Lit::off, square, "Stop measuring")) {
            ui.commands.ask(CommandId::cancelMeasuring);
        }
    } else if (iconButton(ui, "trade.again", icon::kRepeat, Lit::off, square, "Measure again")) {
        ui.commands.ask(CommandId::measureAgain);
    }
    ImGui::PopStyleColor();
    ImGui::SetCursorScreenPos({corner.x, std::max(below + theme.px(8), corner.y + square)});
}

void drawBudget(Ui& ui) {
    const Theme& theme = ui.theme;
    TradeSettings& settings = ui.settings.trade;
    const TradeStudy& study = ui.context.study;
    double percent = 100.0 * settings.errorBudget;
    if (logSliderRow(ui, "trade.budget", "My error", percent, 0.5, 100.0 * kMostTradeError,
                     snapPercent,
                     "How far off what is chosen may be: FLIP, the mean over the model. From some "
                     "10 % on one sees it when flipping between the two",
                     {100.0 * kLeastTradeError, 100.0 * kMostTradeError, 0.1, "%.3g %%"})) {
        settings.errorBudget = percent / 100.0;
    }
    const trade::Point* best = cheapestWithinMyError(study, settings);
    const ImVec2 size(ImGui::GetContentRegionAvail().x, theme.px(30));
    if (best == nullptr) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.5f);
    if (primaryButton(ui, "Cheapest within my error", size)) {
        ui.commands.ask(CommandId::cheapestWithin);
    }
    ui.probe.markItem("trade.cheapest");
    if (best == nullptr) ImGui::PopStyleVar();
    if (best != nullptr) {
        tooltip(ui, ("One step, which can be undone: " + titleOf(best->setting, study.reference()))
                        .c_str());
        smallLine(
            ui,
            titleOf(best->setting, study.reference()) + "\n" + figureText(best, settings.yardstick),
            theme.textDim);
    } else {
        smallLine(ui, study.busy() ? "The curve is being measured" : "Nothing is within it",
                  theme.textDim);
    }
    ui.probe.markItem("trade.choice");
}

// A badge, what the side is, and its figures.
void drawSideRow(Ui& ui, const char* letter, ImU32 colour, const std::string& title,
                 const std::string& figures, const char* name) {
    const Theme& theme = ui.theme;
    const float badge = theme.px(20), width = ImGui::GetContentRegionAvail().x;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 middle(corner.x + badge * 0.5f, corner.y + theme.px(17));
    draw.AddCircleFilled(middle, badge * 0.5f, colour);
    ImFont* bold = theme.fonts.bold;
    const ImVec2 wide = bold->CalcTextSizeA(bold->FontSize, FLT_MAX, 0.0f, letter);
    draw.AddText(bold, bold->FontSize,
                 {std::round(middle.x - wide.x * 0.5f), std::round(middle.y - wide.y * 0.5f)},
                 IM_COL32(16, 17, 19, 255), letter);
    const float x = corner.x + badge + theme.px(10);
    const ImVec4 clip(corner.x, corner.y, corner.x + width, corner.y + theme.px(40));
    draw.AddText(theme.fonts.text, theme.fonts.text->FontSize, {x, corner.y}, theme.text,
                 title.c_str(), nullptr, 0.0f, &clip);
    draw.AddText(theme.fonts.small, theme.fonts.small->FontSize, {x, corner.y + theme.px(19)},
                 theme.textDim, figures.c_str(), nullptr, 0.0f, &clip);
    ImGui::Dummy({width, theme.px(38)});
    ui.probe.markItem(name);
    tooltip(ui, title.c_str());
}

void drawSides(Ui& ui, const trade::Setting& inForce) {
    const Theme& theme = ui.theme;
    const TradeSettings& settings = ui.settings.trade;
    const TradeStudy& study = ui.context.study;
    drawSideRow(ui, "A", theme.accent, "In force: " + titleOf(inForce, study.reference()),
                figureText(study.find(inForce), settings.yardstick), "trade.row.a");
    if (!settings.b) {
        smallLine(ui, "Click a point of the curve to see it as B", theme.textDim);
        return;
    }
    drawSideRow(ui, "B", kSideB, titleOf(*settings.b, study.reference()),
                figureText(study.find(*settings.b), settings.yardstick), "trade.row.b");
    using enum CommandId;
    struct Button {
        const char* label;
        CommandId id;
        bool on;
    };
    const std::array buttons{Button{"Flip", flipSides, settings.side == SideShown::b},
                             Button{"Wipe", wipeSides, settings.side == SideShown::both},
                             Button{"Swap", swapSides, false}, Button{"Use B", applyB, false}};
    const float gap = theme.px(4);
    const float width = std::floor(
        (ImGui::GetContentRegionAvail().x - gap * static_cast<float>(buttons.size() - 1)) /
        static_cast<float>(buttons.size()));
    for (const Button& button : buttons) {
        if (button.on) {
            ImGui::PushStyleColor(ImGuiCol_Button, theme.accentSoft);
            ImGui::PushStyleColor(ImGuiCol_Text, theme.accent);
        }
        if (ImGui::Button(button.label, {width, theme.px(26)})) ui.commands.ask(button.id);
        if (button.on) ImGui::PopStyleColor(2);
        ui.probe.markItem("trade." + std::string(commandOf(button.id).tag));
        tooltip(ui, nameWithKey(button.id, ui.settings.input.keys).c_str());
        ImGui::SameLine(0.0f, gap);
    }
    ImGui::NewLine();
}

void drawTerms(Ui& ui) {
    if (!section(ui, "What is measured")) return;
    TradeSettings& settings = ui.settings.trade;
    const TradeStudy& study = ui.context.study;
    rowLabel(ui, "Against", "What errors are against");
    static_cast<void>(enumRow(ui, "trade.yardstick", nullptr, settings.yardstick, kYardsticks));
    rowLabel(ui, "Cost", "What is paid");
    static_cast<void>(enumRow(ui, "trade.cost", nullptr, settings.cost, kCosts));
    static_cast<void>(switchRow(ui, "trade.profileOnly", "Only profile", settings.profileOnly,
                                "Choose only what the game profile can say. Else snapshots and "
                                "coarser octrees, too, which a scene chooses"));
    rowLabel(ui, "Reference",
             "The settings whose exact sprite errors are against: those that were "
             "in force when measuring began");
    std::string text = "–";
    if (study.reference()) text = trade::describe(*study.reference(), trade::Setting{});
    const float square = ui.theme.px(24);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float right = corner.x + ImGui::GetContentRegionAvail().x - square;
    const ImVec4 clip(corner.x, corner.y, right, corner.y + square);
    ImFont* font = ui.theme.fonts.text;
    ImGui::GetWindowDrawList()->AddText(font, font->FontSize, {corner.x, corner.y + ui.theme.px(4)},
                                        ui.theme.text, text.c_str(), nullptr, 0.0f, &clip);
    ImGui::SetCursorScreenPos({right, corner.y});
    commandButton(ui, CommandId::pinReference, Lit::off, square);
}

void drawSaved(Ui& ui) {
    if (!section(ui, "Saved settings")) return;
    const Theme& theme = ui.theme;
    TradeSettings& settings = ui.settings.trade;
    const float square = theme.px(24);
    for (std::size_t k = 0; k < settings.saved.size(); ++k) {
        const SavedSetting& saved = settings.saved[k];
        ImGui::PushID(static_cast<int>(k));
        const float width = ImGui::GetContentRegionAvail().x - square;
        const bool isB = settings.b == saved.setting;
        if (textSelectable(saved.name, isB, {width, square})) {
            settings.b = saved.setting;
            if (settings.side == SideShown::a) settings.side = SideShown::b;
        }
        ui.probe.markItem("trade.saved." + std::to_string(k));
        tooltip(ui, "Look at it as B");
        ImGui::SameLine(0.0f, 0.0f);
        ImGui::PushStyleColor(ImGuiCol_Text, theme.textDim);
        const bool remove = iconButton(ui, "remove", icon::kClose, Lit::off, square, "Forget it");
        ImGui::PopStyleColor();
        ImGui::PopID();
        if (remove) {
            settings.saved.erase(settings.saved.begin() + static_cast<std::ptrdiff_t>(k));
            break;
        }
    }
    if (ImGui::Button("Save what is in force", {ImGui::GetContentRegionAvail().x, theme.px(26)})) {
        ui.commands.ask(CommandId::saveSettingA);
    }
    ui.probe.markItem("trade.save");
}

}  // namespace

void drawTrade(Ui& ui) {
    const Theme& theme = ui.theme;
    TradeSettings& settings = ui.settings.trade;
    const trade::Setting inForce =
        settingInForce(ui.session.profile(), ui.settings.scene.representations);
    ImGui::BeginChild("trade");
    drawProgress(ui);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    // What is done with the curve stays in sight below it.
    const float below = theme.px(settings.b ? 302 : 240);
    const float height =
        std::clamp(std::min(room.x * 0.62f, room.y - below), theme.px(132), theme.px(280));
    const PlotAnswer answer = drawTradePlot(ui, inForce, {room.x, height});
    if (answer.looked) {
        settings.b = answer.looked;
        if (settings.side == SideShown::a) settings.side = SideShown::b;
    }
    if (answer.taken) use(ui, *answer.taken);
    drawTradeLegend(ui);
    drawBudget(ui);
    ImGui::Dummy({0, theme.px(4)});
    drawSides(ui, inForce);
    drawTerms(ui);
    drawSaved(ui);
    ImGui::EndChild();
}

}  // namespace voxprite::editor
