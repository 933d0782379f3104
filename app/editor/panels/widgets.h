// The few controls that the panels are built from. A row is a label on the left and a control that
// fills the rest; each returns true when it changed its value.
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "app/editor/panels/ui.h"
#include "core/model/game_profile.h"

namespace voxprite::editor {

struct Range {
    double min = 0.0;
    double max = 1.0;
    double speed = 0.1;  // change a pixel dragged
    const char* format = "%.2f";
};

// A heading that folds what is under it. Returns whether it is open.
[[nodiscard]] bool section(Ui& ui, const char* title, bool openAtFirst = true);
// The label of a row; the next widget is the row's control. `hint` explains it on hovering.
void rowLabel(Ui& ui, const char* label, const char* hint = nullptr);

[[nodiscard]] bool numberRow(Ui& ui, const char* name, const char* label, double& value,
                             const Range& range, const char* hint = nullptr);
[[nodiscard]] bool vectorRow(Ui& ui, const char* name, const char* label, glm::dvec3& value,
                             const Range& range, const char* hint = nullptr,
                             bool axisColours = true);
// Of a sigma on a slider: whole and quarter values above 1, where the grid falls evenly; halvings
// below.
[[nodiscard]] double snapSigma(double sigma);
// A slider over powers of two, with a number to type beside it.
[[nodiscard]] bool logSliderRow(Ui& ui, const char* name, const char* label, double& value,
                                double min, double max, double (*snap)(double),
                                const char* hint = nullptr,
                                const Range& typed = {kLeastSigma, kMostSigma, 0.02, "%.4g"});
[[nodiscard]] bool switchRow(Ui& ui, const char* name, const char* label, bool& value,
                             const char* hint = nullptr);
// One of a few, side by side. Without a label they take the whole width.
struct Choice {
    const char* label;
    const char* hint;
};
[[nodiscard]] bool choiceRow(Ui& ui, const char* name, const char* label, int& value,
                             std::span<const Choice> choices);
template <class Enum>
[[nodiscard]] bool enumRow(Ui& ui, const char* name, const char* label, Enum& value,
                           std::span<const Choice> choices) {
    int index = static_cast<int>(value);
    if (!choiceRow(ui, name, label, index, choices)) return false;
    value = static_cast<Enum>(index);
    return true;
}
void readoutRow(Ui& ui, const char* label, const std::string& text, const char* hint = nullptr);

enum class Lit : std::uint8_t {
    off,
    icon,   // something that is switched on
    filled  // the one of a group that is in use
};
// A square button with an icon.
[[nodiscard]] bool iconButton(Ui& ui, const char* name, const char* icon, Lit lit, float sizePx,
                              const char* tooltip, ImFont* font = nullptr);
// The button of a command: its icon, its name and key in the tooltip.
void commandButton(Ui& ui, CommandId id, Lit lit, float sizePx, ImFont* font = nullptr);
void tooltip(Ui& ui, const char* text);
// A text button in the accent colour, for what a dialog is for.
[[nodiscard]] bool primaryButton(Ui& ui, const char* label, ImVec2 size);
// As ImGui's own, but for names that people give: there "##" does not end what is shown. Each under
// an identity of its own (PushID).
[[nodiscard]] bool textSelectable(const std::string& text, bool on, ImVec2 size = {0.0f, 0.0f},
                                  ImGuiSelectableFlags flags = 0);
[[nodiscard]] bool textButton(const std::string& text);
[[nodiscard]] bool beginTextCombo(const char* id, const std::string& shown);
// In place of the rows of a list that a search left empty.
void nothingFoundText(const Theme& theme);

}  // namespace voxprite::editor
