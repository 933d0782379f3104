// The panels around the views. Each draws into the current ImGui window.
#pragma once

#include "app/editor/panels/ui.h"

namespace voxprite::editor {

void drawToolColumn(Ui& ui);
void drawInspector(Ui& ui);
void drawObjects(Ui& ui);
void drawHistory(Ui& ui);
// From the step `position` of the history to another, in place of where it was on the way to. What
// is only being made is dropped.
void askForStep(CommandQueue& commands, std::size_t position, std::size_t wanted);
void drawScene(Ui& ui);
void drawTrade(Ui& ui);
void drawRepresentations(Ui& ui);  // a part of it
// Of the lists below the inspector; are they unfolded?
[[nodiscard]] bool drawDockTabs(Ui& ui);
void drawStatusBar(Ui& ui);
// The bar at the top; returns a recent file that was chosen.
[[nodiscard]] std::optional<std::filesystem::path> drawMenuBar(Ui& ui);

}  // namespace voxprite::editor
