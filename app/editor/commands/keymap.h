// Keys with their modifiers, and which of them the artist has bound anew.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace voxprite::editor {

struct Chord {
    int key = 0;  // GLFW's number; 0 is none
    bool control = false;
    bool shift = false;
    bool alt = false;
    bool operator==(const Chord&) const = default;
};

constexpr Chord key(int code) {
    return {code, false, false, false};
}
constexpr Chord control(int code) {
    return {code, true, false, false};
}
constexpr Chord shift(int code) {
    return {code, false, true, false};
}
constexpr Chord controlShift(int code) {
    return {code, true, true, false};
}

// "Ctrl+Shift+Z", or nothing.
[[nodiscard]] std::string chordText(const Chord& chord);
// Of the text above, in any case; nothing when it names no chord. "" is no key at all.
[[nodiscard]] std::optional<Chord> chordNamed(std::string_view text);

// Commands (by tag) whose keys are not the default ones.
using Keymap = std::map<std::string, std::array<Chord, 2>, std::less<>>;

}  // namespace voxprite::editor
