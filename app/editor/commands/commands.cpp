#include "app/editor/commands/commands.h"

#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "app/editor/commands/command_context.h"
#include "app/editor/commands/tables.h"

namespace voxprite::editor {
namespace {

std::vector<Command> allCommands() {
    std::vector<Command> all;
    for (const auto table :
         {fileCommands(), editCommands(), clipboardCommands(), selectionCommands(),
          objectCommands(), animationCommands(), toolCommands(), toolOptionCommands(),
          paletteCommands(), viewCommands(), sceneCommands(), representationCommands(),
          tradeCommands(), helpCommands()}) {
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

const char* titleOf(MenuId menu) {
    switch (menu) {
        case MenuId::none:
            break;
        case MenuId::file:
            return "File";
        case MenuId::edit:
            return "Edit";
        case MenuId::select:
            return "Select";
        case MenuId::object:
            return "Object";
        case MenuId::animation:
            return "Animation";
        case MenuId::tool:
            return "Tools";
        case MenuId::palette:
            return "Palette";
        case MenuId::view:
            return "View";
        case MenuId::help:
            return "Help";
    }
    return "";
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

void bindKeys(Keymap& keymap, const Command& command, const std::array<Chord, 2>& chords) {
    if (chords == command.chords) {
        keymap.erase(command.tag);
    } else {
        keymap[command.tag] = chords;
    }
}

std::vector<const Command*> conflictsOf(const Command& command, const Chord& chord,
                                        const Keymap& keymap) {
    std::vector<const Command*> others;
    if (chord.key == 0) return others;
    for (const Command& other : commands()) {
        const auto& chords = chordsOf(other, keymap);
        const bool same = std::ranges::find(chords, chord) != chords.end();
        if (other.id != command.id && same) others.push_back(&other);
    }
    return others;
}

std::string conflictText(const Command& command, const Keymap& keymap) {
    std::string text;
    for (const Chord& chord : chordsOf(command, keymap)) {
        for (const Command* other : conflictsOf(command, chord, keymap)) {
            text += (text.empty() ? "Also means: " : ", ") + std::string(other->name);
        }
    }
    return text;
}

std::vector<const Command*> commandsWithKey(std::string_view query, const Keymap& keymap) {
    const auto lowered = [](std::string text) {
        for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        return text;
    };
    std::vector<std::string> words;
    std::istringstream stream(lowered(std::string(query)));
    for (std::string word; stream >> word;) words.push_back(word);
    std::vector<const Command*> found;
    for (const Command& command : commands()) {
        const auto& chords = chordsOf(command, keymap);
        const std::string text = lowered(std::string(titleOf(command.menu)) + " " + command.name +
                                         " " + chordText(chords[0]) + " " + chordText(chords[1]));
        const auto isIn = [&](const std::string& word) {
            return text.find(word) != std::string::npos;
        };
        if (std::ranges::all_of(words, isIn)) found.push_back(&command);
    }
    return found;
}

std::string nameWithKey(CommandId id, const Keymap& keymap) {
    const Command& command = commandOf(id);
    const std::string key = chordText(chordsOf(command, keymap)[0]);
    return key.empty() ? command.name : std::string(command.name) + "  (" + key + ")";
}

void CommandQueue::askByKeys(const Keymap& keymap) {
    const ImGuiIO& io = ImGui::GetIO();
    // A dialog in front takes all keys, and so does a field. Dear ImGui wants text for a frame more
    // than there is a field, in which what follows Esc at once would be lost.
    const bool dialog = ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup);
    const bool typing = io.WantTextInput && ImGui::IsAnyItemActive();
    if (typing || dialog) return;
    for (const Command& command : commands()) {
        for (const Chord& chord : chordsOf(command, keymap)) {
            if (isPressed(chord, command.repeats, io)) ask(command.id);
        }
    }
}

}  // namespace voxprite::editor
