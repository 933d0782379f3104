// Parts of the panel of objects. Private to the panels.
#pragma once

#include <string>
#include <vector>

#include "app/editor/panels/ui.h"

namespace voxprite::editor {

// Both draw rows without space between them, into a child of their own.
void drawObjectTree(Ui& ui);
void drawSocketList(Ui& ui);

// How many objects show each model: more than one share it.
[[nodiscard]] std::vector<int> usersOfModels(const Document& document);

// A row of a list: what is drawn behind it, where its parts go.
struct ListRow {
    ImVec2 corner;
    float width = 0.0f;
    float height = 0.0f;
    bool hovered = false;
    bool clicked = false;
    bool doubleClicked = false;
    bool menu = false;  // the right button
    [[nodiscard]] float middle(float of) const {
        return corner.y + std::floor((height - of) * 0.5f);
    }
};
// Takes the row's place; the buttons at its end may lie over it. `endRow` ends it.
[[nodiscard]] ListRow beginRow(Ui& ui, const std::string& probe, bool chosen);
void endRow(const ListRow& row);

// The name of a row while it is typed; true while it goes on. What was typed is in `name`.
[[nodiscard]] bool typeName(Ui& ui, const ListRow& row, float indent, float end, std::string& name);

}  // namespace voxprite::editor
