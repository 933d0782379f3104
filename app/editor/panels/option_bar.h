// How the options of the tool in hand share the bar above the views. Private to the panels.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "app/editor/panels/ui.h"
#include "app/editor/tools/tool_options.h"

namespace voxprite::editor {

constexpr float kOptionHeight = 24.0f;

// What stands in the bar or, where there is no room for it, in the popup at the bar's end.
struct OptionPart {
    int worth = 0;        // what is worth less gives way first
    float width = 0.0f;   // pixels
    float behind = 0.0f;  // the gap before the next one
    std::function<void()> draw;
    bool atRight = false;
    bool on = false;  // changes what edits do: out of sight it must not be forgotten
};

[[nodiscard]] float widthOf(std::span<const OptionPart> parts);
// The worthiest, as many as there is room for.
[[nodiscard]] std::vector<bool> partsThatFit(std::span<const OptionPart> parts, float room);
// Into the current window, in the order given.
void drawOptionBar(Ui& ui, std::span<const OptionPart> parts);

void optionLabel(Ui& ui, const char* text, const char* hint = nullptr);
[[nodiscard]] float optionLabelWidth(const Ui& ui, const char* text);

// The guides of every tool: mirrors, the selection and the limits. `ui` and `options` outlive them.
[[nodiscard]] std::vector<OptionPart> guideParts(Ui& ui, ToolOptions& options);

}  // namespace voxprite::editor
