#include "app/editor/panels/sheet_dialog.h"

#include <imgui_stdlib.h>

#include <array>
#include <cmath>

#include "app/editor/commands/command_context.h"
#include "app/editor/panels/dialog_frame.h"
#include "app/editor/panels/number_text.h"
#include "app/editor/panels/sheet_picture.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/session/file_flow.h"
#include "app/editor/window/icons.h"

namespace voxprite::editor {
namespace {

constexpr float kSheetDialogWidth = 1120.0f, kSheetDialogHeight = 764.0f, kSettingsWidth = 312.0f;

constexpr const char* kBetweenFacts = "  ·  ";

constexpr std::array kUsualDirections{4, 8, 16, 32};
constexpr std::array kDirectionChoices{Choice{"4", "Front, right, back and left"}, Choice{"8", ""},
                                       Choice{"16", ""}, Choice{"32", ""}};
constexpr std::array kOutlines{Choice{"Game's", "As the game's profile has it"},
                               Choice{"On", "One virtual pixel around every sprite"},
                               Choice{"Off", "No outline"}};

constexpr std::array kTurntables{
    Choice{"PNG", "Animated PNG: every colour, clean edges"},
    Choice{"GIF", "Plays everywhere; at most 255 colours, and hundredths of a second"}};

void wholeRow(Ui& ui, const char* name, const char* label, int& value, int least, int most,
              const char* format, const char* hint) {
    double number = value;
    if (numberRow(ui, name, label, number,
                  {static_cast<double>(least), static_cast<double>(most), 0.1, format}, hint)) {
        value = static_cast<int>(std::lround(number));
    }
}

void textRow(Ui& ui, const char* name, const char* label, std::string& text, const char* empty,
             const char* hint) {
    rowLabel(ui, label, hint);
    ImGui::PushID(name);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    ImGui::InputTextWithHint("##text", empty, &text);
    ui.probe.markItem(name);
    ImGui::PopID();
}

std::optional<Turntable> turntableBeside(const std::filesystem::path& path,
                                         const SheetSettings& settings) {
    if (!settings.turntable) return std::nullopt;
    const bool gif = settings.turntableKind == TurntableKind::gif;
    const std::string name = path.stem().string() + (gif ? ".turntable.gif" : ".turntable.png");
    return Turntable{path.parent_path() / name, settings.turntableMilliseconds, settings.magnify};
}

}  // namespace

void SheetDialog::open(const Session& session, const std::filesystem::path& folder) {
    open_ = true;
    const auto beside = session.path() ? session.path()->parent_path() : folder;
    std::error_code ignored;
    file_ = std::filesystem::absolute(beside / (session.stem() + ".png"), ignored)
                .lexically_normal()
                .string();
    replace_.clear();
    problem_.clear();
    asked_.reset();
    zoom_ = 1.0f;
    pan_ = {0.0f, 0.0f};
}

void SheetDialog::close() {
    open_ = false;
    maker_.drop();
    textures_.clear();
    ImGui::CloseCurrentPopup();
}

// Asks for the preview of what is set, once it is set.
void SheetDialog::follow(Ui& ui) {
    const Asked now{ui.settings.sheet, ui.session.profile(), ui.session.contentsRevision()};
    if (asked_ != now) {
        asked_ = now;
        const Result<SheetOptions> options = sheetOptions(now.settings);
        wrong_ = options ? std::string() : options.error().message;
        if (options) {
            maker_.ask({ui.session.snapshot(), sheetProfile(now.settings, now.profile), *options});
        }
    }
    if (!maker_.update()) return;
    textures_.clear();
    for (const Image& image : maker_.made()->shown) textures_.emplace_back().set(image);
    picture_ = std::min(picture_, std::max(static_cast<int>(textures_.size()) - 1, 0));
}

void SheetDialog::drawViews(Ui& ui) {
    SheetSettings& sheet = ui.settings.sheet;
    if (!section(ui, "Views")) return;
    const auto usual = std::ranges::find(kUsualDirections, sheet.directions);
    int index =
        usual == kUsualDirections.end() ? -1 : static_cast<int>(usual - kUsualDirections.begin());
    if (choiceRow(ui, "sheet.usual", "Directions", index, kDirectionChoices)) {
        sheet.directions = kUsualDirections[static_cast<std::size_t>(index)];
    }
    wholeRow(ui, "sheet.directions", "", sheet.directions, 1, 360, "%.0f views round the model",
             "Evenly round the model");
    static_cast<void>(numberRow(ui, "sheet.firstYaw", "First from", sheet.firstYawDegrees,
                                {-360.0, 360.0, 0.5, "%.1f°"}, "The yaw of direction 0"));
    textRow(ui, "sheet.pitches", "Pitches", sheet.pitches, "30",
            "How high the eye is, in degrees. Each makes a round: 30, 60");
    if (ui.session.frames() > 1) {
        const std::string all = "all " + std::to_string(ui.session.frames());
        textRow(ui, "sheet.frames", "Frames", sheet.frames, all.c_str(),
                "Of the animation, from 0: 0, 2, 5-9. Empty: all");
    }
}

void SheetDialog::drawLook(Ui& ui) {
    SheetSettings& sheet = ui.settings.sheet;
    if (!section(ui, "Sprites")) return;
    double sigma = sheet.sigma > 0.0 ? sheet.sigma : ui.session.profile().sigma;
    if (logSliderRow(ui, "sheet.sigma", "Sigma σ", sigma, 0.25, 16.0, snapSigma,
                     "Virtual pixels a voxel. The game's, unless you change it here")) {
        sheet.sigma = sigma == ui.session.profile().sigma ? 0.0 : sigma;
    }
    static_cast<void>(enumRow(ui, "sheet.outline", "Outline", sheet.outline, kOutlines));
    static_cast<void>(
        switchRow(ui, "sheet.trim", "Trimmed", sheet.trim,
                  "Cut to what is seen. Off: every sprite on a whole cell, in a grid"));
    wholeRow(ui, "sheet.padding", "Padding", sheet.paddingPx, 0, 64, "%.0f px",
             "Transparent pixels between sprites");
    wholeRow(ui, "sheet.largest", "Largest edge", sheet.largestEdgePx, 16, 16384, "%.0f px",
             "Of the picture");
}

void SheetDialog::drawPicture(Ui& ui) {
    SheetSettings& sheet = ui.settings.sheet;
    if (!section(ui, "More pictures")) return;
    if (!ui.session.document().palette.variants.empty()) {
        static_cast<void>(switchRow(ui, "sheet.variants", "Variants", sheet.variants,
                                    "A sheet in the colours of each palette variant"));
    }
    static_cast<void>(switchRow(ui, "sheet.normals", "Normals", sheet.normals,
                                "Of the faces, toward right, up and the eye"));
    static_cast<void>(switchRow(ui, "sheet.depths", "Depths", sheet.depths, "White is nearest"));
    static_cast<void>(switchRow(ui, "sheet.indices", "Indices", sheet.indices,
                                "The number of each pixel's colour in the palette, as grey"));
}

void SheetDialog::drawTurntable(Ui& ui) {
    SheetSettings& sheet = ui.settings.sheet;
    if (!section(ui, "Turntable")) return;
    static_cast<void>(switchRow(ui, "sheet.turntable", "Animated", sheet.turntable,
                                "A picture of all sprites in turn, beside the sheet"));
    if (!sheet.turntable) return;
    static_cast<void>(
        enumRow(ui, "sheet.turntableKind", "Written as", sheet.turntableKind, kTurntables));
    wholeRow(ui, "sheet.turntableMs", "Each view", sheet.turntableMilliseconds, 1, 65535, "%.0f ms",
             "Where no clip says how long a frame lasts");
    wholeRow(ui, "sheet.magnify", "Magnified", sheet.magnify, 1, 32, "%.0f times",
             "Pixels a virtual pixel of the turntable");
}

void SheetDialog::drawSettings(Ui& ui) {
    const float gap = ui.theme.px(6);
    drawViews(ui);
    ImGui::Dummy({0, gap});
    drawLook(ui);
    ImGui::Dummy({0, gap});
    drawPicture(ui);
    ImGui::Dummy({0, gap});
    drawTurntable(ui);
}

void SheetDialog::drawPreview(Ui& ui, ImVec2 size) {
    const Theme& theme = ui.theme;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 max(corner.x + size.x, corner.y + size.y);
    draw.AddRectFilled(corner, max, theme.panel, theme.px(6));
    ImGui::InvisibleButton("preview", size);
    ui.probe.markItem("sheet.preview");
    const auto& made = maker_.made();
    draw.PushClipRect(corner, max, true);
    if (made && made->sheet && !textures_.empty()) {
        const auto shown = static_cast<std::size_t>(picture_);
        if (ImGui::IsItemHovered()) {
            const ImGuiIO& io = ImGui::GetIO();
            zoom_ = std::clamp(zoom_ * std::exp2(io.MouseWheel * 0.25f), 1.0f, 64.0f);
        }
        if (ImGui::IsItemActive()) {
            pan_.x += ImGui::GetIO().MouseDelta.x;
            pan_.y += ImGui::GetIO().MouseDelta.y;
        }
        drawSheetPicture(ui,
                         {*made->sheet, textures_[shown], corner, size, zoom_,
                          ImGui::IsItemHovered() && !ImGui::IsItemActive()},
                         pan_);
    }
    const bool working = maker_.working() && wrong_.empty();
    const std::string text = problem();
    if (!text.empty()) {
        // What was made before is no longer what is asked for.
        draw.AddRectFilled(corner, max, withAlpha(theme.panel, 0.85f), theme.px(6));
        const float wrap = size.x - theme.px(64);
        const ImVec2 extent = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
        draw.AddText(theme.fonts.text, theme.fonts.text->FontSize,
                     {std::round(corner.x + (size.x - extent.x) * 0.5f),
                      std::round(corner.y + (size.y - extent.y) * 0.5f)},
                     theme.danger, text.c_str(), nullptr, wrap);
    }
    if (working) {
        const float bar = theme.px(4);
        draw.AddRectFilled(
            {corner.x, max.y - bar},
            {corner.x + size.x * static_cast<float>(std::max(maker_.share(), 0.02)), max.y},
            theme.accent);
    }
    draw.PopClipRect();
}

std::string SheetDialog::problem() const {
    if (!wrong_.empty()) return wrong_;
    const auto& made = maker_.made();
    return !maker_.working() && made && !made->sheet ? made->problem : std::string();
}

std::string SheetDialog::said() const {
    if (std::string text = problem(); !text.empty()) return text;
    if (maker_.working()) {
        return maker_.stage().empty() ? "Casting…" : "Casting: " + maker_.stage();
    }
    if (!maker_.made()) return {};
    const Sheet& sheet = *maker_.made()->sheet;
    const Image& image = sheet.pictures.front().image;
    return grouped(sheet.sprites.size()) + (sheet.sprites.size() == 1 ? " sprite" : " sprites") +
           kBetweenFacts + std::to_string(image.width) + " × " + std::to_string(image.height) +
           " pixels" + kBetweenFacts + "cell " + std::to_string(sheet.cellPx.x) + " × " +
           std::to_string(sheet.cellPx.y) + kBetweenFacts + "anchor " +
           std::to_string(sheet.anchorPixel.x) + ", " + std::to_string(sheet.anchorPixel.y);
}

void SheetDialog::drawFacts(Ui& ui) {
    const auto& made = maker_.made();
    const bool several = made && made->sheet && made->sheet->pictures.size() > 1;
    const float width = several ? ui.theme.px(176) : 0.0f;
    const std::string all = problem().empty() ? said() : "There is no sheet";
    // Whole facts, as many as there is room for.
    const float room = ImGui::GetContentRegionAvail().x - width;
    std::string text = all;
    while (ImGui::CalcTextSize(text.c_str()).x > room) {
        const std::size_t last = text.rfind(kBetweenFacts);
        if (last == std::string::npos) break;
        text.resize(last);
    }
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.textDim);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
    ui.probe.markItem("sheet.facts");
    if (text != all) tooltip(ui, all.c_str());
    if (!several) return;
    // Which of the pictures is shown.
    const auto& pictures = made->sheet->pictures;
    ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
    ImGui::SetNextItemWidth(width);
    const auto nameOf = [&](int k) {
        const std::string& name = pictures[static_cast<std::size_t>(k)].name;
        return name.empty() ? "Sprites" : name.c_str();
    };
    const int count = static_cast<int>(pictures.size());
    if (ImGui::BeginCombo("##picture", nameOf(std::min(picture_, count - 1)))) {
        for (int k = 0; k < count; ++k) {
            if (ImGui::Selectable(nameOf(k), k == picture_)) picture_ = k;
        }
        ImGui::EndCombo();
    }
    ui.probe.markItem("sheet.picture");
}

void SheetDialog::browse(Ui& ui) {
    const std::filesystem::path now(file_);
    FileBrowser::Request request{.title = "Export sprite sheet",
                                 .button = "Choose",
                                 .saving = true,
                                 .extensions = {".png"},
                                 .folder = now.parent_path(),
                                 .name = now.filename().string(),
                                 .replaced = [](const auto&) {
                                     // Asked about when all that goes is known.
                                     return std::vector<std::filesystem::path>{};
                                 }};
    ui.context.files.browse(std::move(request),
                            [this](CommandContext&, const std::filesystem::path& chosen) {
                                file_ = chosen.string();
                                problem_.clear();
                            });
}

bool SheetDialog::drawFooter(Ui& ui, bool listens) {
    const Theme& theme = ui.theme;
    const ImVec2 button = theme.px(108, 30);
    const float gap = theme.px(8);
    ImGui::PushStyleColor(ImGuiCol_Text, theme.danger);
    ImGui::TextUnformatted(problem_.c_str());
    ImGui::PopStyleColor();
    ui.probe.markItem("sheet.problem");
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, theme.px(10, 7));
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 2 * (button.x + gap) - button.y -
                            gap);
    if (ImGui::InputTextWithHint("##file", "File", &file_)) problem_.clear();
    typesFile_ = ImGui::IsItemActive();
    ui.probe.markItem("sheet.file");
    ImGui::PopStyleVar();
    ImGui::SameLine(0.0f, gap);
    if (iconButton(ui, "sheet.browse", icon::kFolder, Lit::off, button.y, "Choose the file…")) {
        browse(ui);
    }
    ImGui::SameLine(0.0f, gap);
    if (ImGui::Button("Cancel", button) || pressedKey(ImGuiKey_Escape)) close();
    ui.probe.markItem("sheet.cancel");
    ImGui::SameLine(0.0f, gap);
    ImGui::BeginDisabled(!wrong_.empty());
    const bool pressed = primaryButton(ui, "Export", button);
    ImGui::EndDisabled();
    ui.probe.markItem("sheet.export");
    return pressed || (listens && pressedEnter() && wrong_.empty());
}

std::optional<SheetExport> SheetDialog::accept(Ui& ui) {
    std::filesystem::path path(file_);
    if (file_.empty() || path.filename().empty()) {
        problem_ = "The file needs a name";
        return std::nullopt;
    }
    if (path.extension() != ".png") {
        path += ".png";
        file_ = path.string();
    }
    const SheetSettings& settings = ui.settings.sheet;
    const Result<SheetOptions> options = sheetOptions(settings);
    if (!options) return std::nullopt;
    const std::optional<Turntable> turntable = turntableBeside(path, settings);
    const std::vector<std::filesystem::path> replaced =
        replacedBySheet(ui.session.document().palette, *options, path, turntable);
    const bool agreed = std::ranges::all_of(replaced, [&](const std::filesystem::path& file) {
        return std::ranges::find(replace_, file) != replace_.end();
    });
    if (!agreed) {
        replace_ = replaced;
        problem_ = questionAbout(replaced);
        return std::nullopt;
    }
    SheetExport asked{
        {ui.session.snapshot(), sheetProfile(settings, ui.session.profile()), *options},
        nullptr,
        path,
        turntable};
    // What is seen is what was asked for, unless it is still on its way.
    if (!maker_.working() && maker_.made()) asked.sheet = maker_.made()->sheet;
    return asked;
}

std::optional<SheetExport> SheetDialog::draw(Ui& ui) {
    if (!open_) return std::nullopt;
    if (!beginDialog(ui, "##sheet", "Export sprite sheet", kSheetDialogWidth, kSheetDialogHeight))
        return std::nullopt;
    // Enter ends the typing of a number, but in the name of the file it is meant for the dialog.
    const bool listens = !ImGui::IsAnyItemActive() || typesFile_;
    follow(ui);
    const Theme& theme = ui.theme;
    const float below = theme.px(30 + 8 + 24 + 8 + 12);
    const float height = ImGui::GetContentRegionAvail().y - below;
    ImGui::Dummy(theme.px(0, 4));
    ImGui::BeginChild("settings", {theme.px(kSettingsWidth), height});
    drawSettings(ui);
    ImGui::EndChild();
    ImGui::SameLine(0.0f, theme.px(20));
    ImGui::BeginGroup();
    const float facts = theme.px(24 + 8);
    drawPreview(ui, {ImGui::GetContentRegionAvail().x, height - facts});
    drawFacts(ui);
    ImGui::EndGroup();
    std::optional<SheetExport> asked;
    if (drawFooter(ui, listens)) asked = accept(ui);
    if (asked) close();
    endDialog();
    return asked;
}

}  // namespace voxprite::editor
