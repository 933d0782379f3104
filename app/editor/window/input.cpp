#include "app/editor/window/input.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace voxprite::editor {
namespace {

struct NamedKey {
    std::string_view name;
    int key;
};

constexpr std::array kNamedKeys{
    NamedKey{"space", GLFW_KEY_SPACE},
    NamedKey{"apostrophe", GLFW_KEY_APOSTROPHE},
    NamedKey{"comma", GLFW_KEY_COMMA},
    NamedKey{"minus", GLFW_KEY_MINUS},
    NamedKey{"period", GLFW_KEY_PERIOD},
    NamedKey{"slash", GLFW_KEY_SLASH},
    NamedKey{"semicolon", GLFW_KEY_SEMICOLON},
    NamedKey{"equal", GLFW_KEY_EQUAL},
    NamedKey{"left_bracket", GLFW_KEY_LEFT_BRACKET},
    NamedKey{"right_bracket", GLFW_KEY_RIGHT_BRACKET},
    NamedKey{"backslash", GLFW_KEY_BACKSLASH},
    NamedKey{"grave_accent", GLFW_KEY_GRAVE_ACCENT},
    NamedKey{"escape", GLFW_KEY_ESCAPE},
    NamedKey{"enter", GLFW_KEY_ENTER},
    NamedKey{"keypad_enter", GLFW_KEY_KP_ENTER},
    NamedKey{"tab", GLFW_KEY_TAB},
    NamedKey{"backspace", GLFW_KEY_BACKSPACE},
    NamedKey{"insert", GLFW_KEY_INSERT},
    NamedKey{"delete", GLFW_KEY_DELETE},
    NamedKey{"right", GLFW_KEY_RIGHT},
    NamedKey{"left", GLFW_KEY_LEFT},
    NamedKey{"down", GLFW_KEY_DOWN},
    NamedKey{"up", GLFW_KEY_UP},
    NamedKey{"page_up", GLFW_KEY_PAGE_UP},
    NamedKey{"page_down", GLFW_KEY_PAGE_DOWN},
    NamedKey{"home", GLFW_KEY_HOME},
    NamedKey{"end", GLFW_KEY_END},
    NamedKey{"keypad_0", GLFW_KEY_KP_0},
    NamedKey{"keypad_1", GLFW_KEY_KP_1},
    NamedKey{"keypad_2", GLFW_KEY_KP_2},
    NamedKey{"keypad_3", GLFW_KEY_KP_3},
    NamedKey{"keypad_4", GLFW_KEY_KP_4},
    NamedKey{"keypad_5", GLFW_KEY_KP_5},
    NamedKey{"keypad_6", GLFW_KEY_KP_6},
    NamedKey{"keypad_7", GLFW_KEY_KP_7},
    NamedKey{"keypad_8", GLFW_KEY_KP_8},
    NamedKey{"keypad_9", GLFW_KEY_KP_9},
    NamedKey{"keypad_decimal", GLFW_KEY_KP_DECIMAL},
    NamedKey{"keypad_divide", GLFW_KEY_KP_DIVIDE},
    NamedKey{"keypad_multiply", GLFW_KEY_KP_MULTIPLY},
    NamedKey{"keypad_subtract", GLFW_KEY_KP_SUBTRACT},
    NamedKey{"keypad_add", GLFW_KEY_KP_ADD},
    NamedKey{"left_shift", GLFW_KEY_LEFT_SHIFT},
    NamedKey{"left_control", GLFW_KEY_LEFT_CONTROL},
    NamedKey{"left_alt", GLFW_KEY_LEFT_ALT},
    NamedKey{"right_shift", GLFW_KEY_RIGHT_SHIFT},
    NamedKey{"right_control", GLFW_KEY_RIGHT_CONTROL},
    NamedKey{"right_alt", GLFW_KEY_RIGHT_ALT},
};

constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz";
constexpr std::string_view kDigits = "0123456789";
constexpr std::array<std::string_view, 12> kFunctionKeys{"f1", "f2", "f3", "f4",  "f5",  "f6",
                                                         "f7", "f8", "f9", "f10", "f11", "f12"};

static_assert(kLastKey == GLFW_KEY_LAST);

}  // namespace

std::vector<InputEvent> InputQueue::takeFrame() {
    std::vector<InputEvent> frame;
    std::vector<int> changedKeys;
    bool keyWentDown = false, moved = false;
    while (!events_.empty()) {
        const InputEvent& next = events_.front();
        if (next.kind == InputKind::key) {
            if (std::ranges::find(changedKeys, next.code) != changedKeys.end()) break;
            if (keyWentDown && !next.down) break;
            keyWentDown = keyWentDown || next.down;
            changedKeys.push_back(next.code);
        }
        // A drag is seen where it ended before it is let go.
        if (next.kind == InputKind::button && !next.down && moved) break;
        moved = moved || next.kind == InputKind::move;
        const bool ends = next.kind == InputKind::button || next.kind == InputKind::drop;
        frame.push_back(std::move(events_.front()));
        events_.pop_front();
        if (ends) break;
    }
    return frame;
}

std::optional<std::string_view> keyName(int key) {
    if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) {
        return kLetters.substr(static_cast<std::size_t>(key - GLFW_KEY_A), 1);
    }
    if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) {
        return kDigits.substr(static_cast<std::size_t>(key - GLFW_KEY_0), 1);
    }
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) {
        return kFunctionKeys[static_cast<std::size_t>(key - GLFW_KEY_F1)];
    }
    const auto* found = std::ranges::find(kNamedKeys, key, &NamedKey::key);
    if (found == kNamedKeys.end()) return std::nullopt;
    return found->name;
}

std::optional<int> keyNamed(std::string_view name) {
    for (int key = GLFW_KEY_SPACE; key <= kLastKey; ++key) {
        if (keyName(key) == name) return key;
    }
    return std::nullopt;
}

std::string keyLabel(int key) {
    const auto name = keyName(key);
    if (!name) return {};
    // GLFW counts the printable keys as ASCII does.
    if (key > GLFW_KEY_SPACE && key <= GLFW_KEY_GRAVE_ACCENT) return {static_cast<char>(key)};
    std::string label(*name);
    bool atStart = true;
    for (char& c : label) {
        if (c == '_') c = ' ';
        if (atStart) c = static_cast<char>(std::toupper(c));
        atStart = c == ' ';
    }
    return label;
}

}  // namespace voxprite::editor
