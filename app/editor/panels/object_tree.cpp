// The scene graph as a list: chosen, named, hidden and locked, and dragged into another order.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "app/editor/commands/command_context.h"
#include "app/editor/panels/objects.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/session/object_selection.h"
#include "app/editor/window/icons.h"
#include "core/edit/scene_edits.h"

namespace voxprite::editor {
namespace {

constexpr const char* kDraggedNodes = "voxprite.nodes";

struct Row {
    int node;
    int depth;
};

const SceneNode& nodeOf(const Document& document, int node) {
    return document.nodes[static_cast<std::size_t>(node)];
}

bool* foldOf(int node) {
    ImGui::PushID(node);
    const ImGuiID id = ImGui::GetID("unfolded");
    ImGui::PopID();
    return ImGui::GetStateStorage()->GetBoolRef(id, true);
}

void unfoldAbove(const Document& document, int node) {
    for (int up = nodeOf(document, node).parent; up > 0; up = nodeOf(document, up).parent) {
        *foldOf(up) = true;
    }
}

// Scrolls no further than needed.
void bringIntoSight(float top, float height) {
    const float least = top + height - ImGui::GetWindowHeight();
    ImGui::SetScrollY(std::clamp(ImGui::GetScrollY(), least, top));
}

// The tree from top to bottom, without the root and what lies in folded groups.
std::vector<Row> rowsOf(const Document& document) {
    std::vector<Row> rows;
    std::vector<Row> open{{0, -1}};
    while (!open.empty()) {
        const Row next = open.back();
        open.pop_back();
        if (next.node != 0) {
            rows.push_back(next);
            if (nodeOf(document, next.node).isGroup() && !*foldOf(next.node)) continue;
        }
        const auto& children = nodeOf(document, next.node).children;
        for (auto child = children.rbegin(); child != children.rend(); ++child) {
            open.push_back({*child, next.depth + 1});
        }
    }
    return rows;
}

std::string displayName(const SceneNode& node, int index) {
    if (!node.name.empty()) return node.name;
    return (node.isGroup() ? "Group " : "Object ") + std::to_string(index);
}

bool isHiddenAbove(const Document& document, int node) {
    for (int up = node; up > 0; up = nodeOf(document, up).parent) {
        if (nodeOf(document, up).hidden) return true;
    }
    return false;
}

// Where what is dragged over a row would go.
struct DropPlace {
    int parent = 0;
    int position = 0;
    bool inside = false;
    bool below = false;
};

DropPlace dropPlace(const Document& document, int node, const ListRow& row) {
    const float share = (ImGui::GetIO().MousePos.y - row.corner.y) / row.height;
    const SceneNode& target = nodeOf(document, node);
    if (target.isGroup() && share > 0.3f && share < 0.75f) {
        return {node, static_cast<int>(target.children.size()), true, false};
    }
    const auto& siblings = nodeOf(document, target.parent).children;
    const auto place = static_cast<int>(std::ranges::find(siblings, node) - siblings.begin());
    const bool below = share >= 0.5f;
    return {target.parent, place + (below ? 1 : 0), false, below};
}

void dragAndDrop(Ui& ui, int node, const ListRow& row, float indent) {
    const Theme& theme = ui.theme;
    const Document& document = ui.session.document();
    ObjectSelection& objects = ui.context.objects;
    if (ImGui::BeginDragDropSource(ImGuiDragDropFlags_SourceNoHoldToOpenOthers)) {
        if (!objects.isChosen(ui.session, node)) objects.choose(ui.session, node);
        ImGui::SetDragDropPayload(kDraggedNodes, &node, sizeof(node));
        const std::size_t count = objects.nodes(ui.session).size();
        const std::string text = count > 1 ? std::to_string(count) + " objects"
                                           : displayName(nodeOf(document, node), node);
        ImGui::TextUnformatted(text.c_str());
        ImGui::EndDragDropSource();
    }
    if (!ImGui::BeginDragDropTarget()) return;
    const ImGuiPayload* payload =
        ImGui::AcceptDragDropPayload(kDraggedNodes, ImGuiDragDropFlags_AcceptBeforeDelivery |
                                                        ImGuiDragDropFlags_AcceptNoDrawDefaultRect);
    if (payload != nullptr) {
        const DropPlace place = dropPlace(document, node, row);
        const std::vector<int> nodes = objects.nodes(ui.session);
        if (moveNodes(document, nodes, place.parent, place.position)) {
            ImDrawList& draw = *ImGui::GetWindowDrawList();
            const ImVec2 end(row.corner.x + row.width, row.corner.y + row.height);
            const float y = place.below ? end.y : row.corner.y;
            if (place.inside) {
                draw.AddRect(row.corner, end, theme.accent, theme.px(4), 0, theme.px(1.5f));
            } else {
                draw.AddLine({row.corner.x + indent, y}, {end.x, y}, theme.accent, theme.px(2));
            }
            if (payload->IsDelivery()) {
                ui.edits.pushScene([nodes, place](const Document& now) {
                    return moveNodes(now, nodes, place.parent, place.position).value_or(Action{});
                });
            }
        }
    }
    ImGui::EndDragDropTarget();
}

void contextMenu(Ui& ui, const ListRow& row, int node) {
    if (row.menu) {
        if (!ui.context.objects.isChosen(ui.session, node)) {
            ui.context.objects.choose(ui.session, node);
        }
        ImGui::OpenPopup("menu");
    }
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ui.theme.px(8, 8));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ui.theme.px(10, 7));
    if (ImGui::BeginPopup("menu")) {
        for (const Command& command : commands()) {
            if (command.menu != MenuId::object || command.id == CommandId::addObject) continue;
            if (command.separator) ImGui::Separator();
            const std::string keys = chordText(chordsOf(command, ui.settings.input.keys)[0]);
            if (ImGui::MenuItem(command.name, keys.c_str(), isOn(command.id, ui.context),
                                isEnabled(command.id, ui.context))) {
                ui.commands.ask(command.id);
            }
            ui.probe.markItem(std::string("object.menu.") + command.tag);
        }
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar(2);
}

// Lock and eye at the end of the row.
void drawSwitches(Ui& ui, const ListRow& row, int node) {
    const Theme& theme = ui.theme;
    const Document& document = ui.session.document();
    const SceneNode& shown = nodeOf(document, node);
    const float square = row.height;
    if (row.hovered || shown.locked) {
        ImGui::SetCursorScreenPos({row.corner.x + row.width - 2 * square, row.corner.y});
        ImGui::PushStyleColor(ImGuiCol_Text, shown.locked ? theme.accent : theme.textFaint);
        if (iconButton(ui, "lock", shown.locked ? icon::kLocked : icon::kUnlocked, Lit::off, square,
                       shown.locked ? "Unlock" : "Lock: tools leave it alone")) {
            ui.edits.pushScene([node, locked = !shown.locked](const Document& now) {
                return setLocked(now, node, locked);
            });
        }
        ImGui::PopStyleColor();
    }
    ImGui::SetCursorScreenPos({row.corner.x + row.width - square, row.corner.y});
    ImGui::PushStyleColor(ImGuiCol_Text, shown.hidden ? theme.textFaint : theme.textDim);
    if (iconButton(ui, "eye", shown.hidden ? icon::kHidden : icon::kVisible, Lit::off, square,
                   shown.hidden ? "Show" : "Hide")) {
        ui.edits.pushScene([node, hidden = !shown.hidden](const Document& now) {
            return setHidden(now, node, hidden);
        });
    }
    ImGui::PopStyleColor();
}

void drawName(Ui& ui, const ListRow& row, int node, float indent, bool shared) {
    const Theme& theme = ui.theme;
    const Document& document = ui.session.document();
    const SceneNode& shown = nodeOf(document, node);
    ObjectSelection& objects = ui.context.objects;
    const float end = row.width - 2 * row.height - (shared ? theme.px(20) : 0.0f);
    if (objects.renaming() == node) {
        std::string name = shown.name;
        if (!typeName(ui, row, indent, end, name)) objects.rename(std::nullopt);
        if (name != shown.name) {
            const std::uint64_t key = ui.edits.key();
            ui.edits.pushScene(
                [=](const Document& now) {
                    Action action = rename(now, node, name);
                    action.mergeKey = key;
                    return action;
                },
                key);
        }
        return;
    }
    const bool active = node == ui.session.activeNode();
    const ImU32 colour = isHiddenAbove(document, node) ? theme.textFaint
                         : active                      ? theme.accent
                                                       : theme.text;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    ImFont* font = shown.isGroup() ? theme.fonts.bold : theme.fonts.text;
    const ImVec4 clip(row.corner.x, row.corner.y, row.corner.x + end, row.corner.y + row.height);
    draw.AddText(font, font->FontSize, {row.corner.x + indent, row.middle(font->FontSize)}, colour,
                 displayName(shown, node).c_str(), nullptr, 0.0f, &clip);
    if (!shared) return;
    const float x = row.corner.x + row.width - 2 * row.height - theme.px(18);
    draw.AddText({x, row.middle(theme.fonts.text->FontSize)}, theme.textFaint, icon::kLink);
    const float pointer = ImGui::GetIO().MousePos.x;
    if (pointer > x && pointer < x + theme.px(16)) {
        tooltip(ui, "Shares its model with another object");
    }
}

void drawRow(Ui& ui, const Row& place, const std::vector<int>& users) {
    const Theme& theme = ui.theme;
    const int node = place.node;
    const SceneNode& shown = nodeOf(ui.session.document(), node);
    ObjectSelection& objects = ui.context.objects;
    bool* unfolded = shown.isGroup() ? foldOf(node) : nullptr;
    ImGui::PushID(node);
    const bool chosen = !objects.socket() && objects.isChosen(ui.session, node);
    const ListRow row = beginRow(ui, "object." + std::to_string(node), chosen);
    float x = theme.px(4) + theme.px(14) * static_cast<float>(place.depth);
    dragAndDrop(ui, node, row, x);
    contextMenu(ui, row, node);

    const float arrowEnd = row.corner.x + x + theme.px(16);
    if (row.clicked && unfolded != nullptr && ImGui::GetIO().MousePos.x < arrowEnd) {
        *unfolded = !*unfolded;
    } else if (row.doubleClicked) {
        objects.rename(node);
    } else if (row.clicked) {
        const ImGuiIO& io = ImGui::GetIO();
        if (io.KeyCtrl || io.KeyShift) {
            objects.toggle(ui.session, node);
        } else {
            objects.choose(ui.session, node);
        }
    }
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float textY = row.middle(theme.fonts.text->FontSize);
    if (unfolded != nullptr) {
        draw.AddText({row.corner.x + x, textY}, theme.textDim,
                     *unfolded ? icon::kDown : icon::kRight);
    }
    x += theme.px(16);
    const ImU32 iconColour = shown.hidden ? theme.textFaint : chosen ? theme.accent : theme.textDim;
    draw.AddText({row.corner.x + x, textY}, iconColour,
                 shown.isGroup() ? icon::kFolder : icon::kObject);
    const bool shared = std::ranges::any_of(shown.models, [&](const ModelKey& key) {
        return users[static_cast<std::size_t>(key.model)] > 1;
    });
    drawName(ui, row, node, x + theme.px(22), shared);
    drawSwitches(ui, row, node);
    endRow(row);
    ImGui::PopID();
}

}  // namespace

std::vector<int> usersOfModels(const Document& document) {
    std::vector<int> users(document.models.size(), 0);
    std::vector<const SceneNode*> lastUser(document.models.size(), nullptr);
    for (const SceneNode& node : document.nodes) {
        for (const ModelKey& key : node.models) {
            // It may show a model in several of its frames.
            const auto model = static_cast<std::size_t>(key.model);
            if (std::exchange(lastUser[model], &node) != &node) ++users[model];
        }
    }
    return users;
}

ListRow beginRow(Ui& ui, const std::string& probe, bool chosen) {
    const Theme& theme = ui.theme;
    ListRow row;
    row.corner = ImGui::GetCursorScreenPos();
    row.width = ImGui::GetContentRegionAvail().x;
    row.height = theme.px(24);
    row.clicked = ImGui::InvisibleButton("row", {row.width, row.height});
    row.hovered = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    row.doubleClicked = row.hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    row.menu = row.hovered && ImGui::IsMouseReleased(ImGuiMouseButton_Right);
    ui.probe.markItem(probe);
    ImGui::SetItemAllowOverlap();
    if (chosen || row.hovered) {
        ImGui::GetWindowDrawList()->AddRectFilled(
            row.corner, {row.corner.x + row.width, row.corner.y + row.height},
            chosen ? theme.accentSoft : theme.fieldHovered, theme.px(4));
    }
    return row;
}

void endRow(const ListRow& row) {
    ImGui::SetCursorScreenPos({row.corner.x, row.corner.y + row.height});
}

bool typeName(Ui& ui, const ListRow& row, float indent, float end, std::string& name) {
    ImGui::SetCursorScreenPos({row.corner.x + indent - ui.theme.px(4), row.corner.y});
    ImGui::SetNextItemWidth(end - indent + ui.theme.px(4));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ui.theme.px(4, 3));
    // The first frame gives it the keyboard; from then on it has it until it ends.
    const ImGuiID id = ImGui::GetID("typing");
    bool* typing = ImGui::GetStateStorage()->GetBoolRef(id, false);
    if (!*typing) ImGui::SetKeyboardFocusHere();
    ImGui::InputText("##name", &name, ImGuiInputTextFlags_AutoSelectAll);
    ui.edits.watchItem(ui.session);
    ui.probe.markItem("name.typed");
    ImGui::PopStyleVar();
    if (ImGui::IsItemActive()) *typing = true;
    const bool ended = *typing && ImGui::IsItemDeactivated();
    if (ended) *typing = false;
    return !ended;
}

void drawObjectTree(Ui& ui) {
    const Document& document = ui.session.document();
    const float height = ui.theme.px(24);
    const auto renaming = ui.context.objects.renaming();
    if (renaming) unfoldAbove(document, *renaming);
    const std::vector<Row> rows = rowsOf(document);
    const std::vector<int> users = usersOfModels(document);
    if (renaming) {
        // Out of sight there is no field, and what is typed would be shortcuts.
        const auto row = std::ranges::find(rows, *renaming, &Row::node) - rows.begin();
        bringIntoSight(ImGui::GetCursorPosY() + static_cast<float>(row) * height, height);
    }
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows.size()), height);
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            drawRow(ui, rows[static_cast<std::size_t>(i)], users);
        }
    }
}

}  // namespace voxprite::editor
