#include "app/editor/commands.h"

#include <imgui.h>

#include <algorithm>

#include "app/editor/command_context.h"
#include "app/editor/commands/tables.h"
#include "app/editor/toasts.h"

namespace voxprite::editor {
namespace {

std::vector<Command> allCommands() {
    std::vector<Command> all;
    for (const auto table :
         {fileCommands(), editCommands(), objectCommands(), toolCommands(), toolOptionCommands(),
          viewCommands(), sceneCommands(), helpCommands()}) {
        all.insert(all.end(), table.begin(), table.end());
    }
    return all;
}

bool isPressed(const Chord& chord, bool repeats, const ImGuiIO& io) {
    return chord.key != 0 && io.KeyCtrl == chord.control && io.KeyShift == chord.shift &&
           io.KeyAlt == chord.alt && ImGui::IsKeyPressed(chord.key, repeats);
}

}  // namespace

std::span<const Command> commands() {
    static const std::vector<Command> all = allCommands();
    return all;
}

const Command& commandOf(CommandId id) {
    return *std::ranges::find(commands(), id, &Command::id);
}

bool isEnabled(CommandId id, const CommandContext& context) {
    const Command& command = commandOf(id);
    return command.enabled == nullptr || command.enabled(context);
}

bool isOn(CommandId id, const CommandContext& context) {
    const Command& command = commandOf(id);
    return command.on != nullptr && command.on(context);
}

const std::array<Chord, 2>& chordsOf(const Command& command, const Keymap& keymap) {
    const auto bound = keymap.find(std::string_view(command.tag));
    return bound != keymap.end() ? bound->second : command.chords;
}

std::string nameWithKey(CommandId id, const Keymap& keymap) {
    const Command& command = commandOf(id);
    const std::string key = chordText(chordsOf(command, keymap)[0]);
    return key.empty() ? command.name : std::string(command.name) + "  (" + key + ")";
}

void CommandQueue::askByKeys(const Keymap& keymap) {
    const ImGuiIO& io = ImGui::GetIO();
    // A dialog in front takes all keys.
    const bool dialog = ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup);
    if (io.WantTextInput || dialog) return;
    for (const Command& command : commands()) {
        for (const Chord& chord : chordsOf(command, keymap)) {
            if (isPressed(chord, command.repeats, io)) ask(command.id);
        }
    }
}

void CommandContext::report(const Status& status) const {
    if (!status) toasts.error(status.error().describe());
}

}  // namespace voxprite::editor
