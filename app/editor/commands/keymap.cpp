#include "app/editor/commands/keymap.h"

#include <cctype>

#include "app/editor/window/input.h"

namespace voxprite::editor {
namespace {

std::string lowered(std::string_view text) {
    std::string low(text);
    for (char& c : low) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return low;
}

bool takePrefix(std::string& text, std::string_view prefix) {
    if (!text.starts_with(prefix)) return false;
    text.erase(0, prefix.size());
    return true;
}

}  // namespace

std::string chordText(const Chord& chord) {
    if (chord.key == 0) return {};
    std::string text;
    if (chord.control) text += "Ctrl+";
    if (chord.shift) text += "Shift+";
    if (chord.alt) text += "Alt+";
    return text + keyLabel(chord.key);
}

std::optional<Chord> chordNamed(std::string_view text) {
    Chord chord;
    if (text.empty()) return chord;
    std::string rest = lowered(text);
    chord.control = takePrefix(rest, "ctrl+");
    chord.shift = takePrefix(rest, "shift+");
    chord.alt = takePrefix(rest, "alt+");
    for (int key = 1; key <= kLastKey; ++key) {
        if (keyName(key) && lowered(keyLabel(key)) == rest) {
            chord.key = key;
            return chord;
        }
    }
    return std::nullopt;
}

}  // namespace voxprite::editor
