#include "app/editor/window/play_script.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/io/json_text.h"

namespace voxprite::editor {
namespace {

using Json = nlohmann::json;

constexpr std::array<std::string_view, 3> kButtons{"left", "right", "middle"};

std::optional<glm::dvec2> pairOf(const Json& value) {
    if (!value.is_array() || value.size() != 2 || !value[0].is_number() || !value[1].is_number()) {
        return std::nullopt;
    }
    return glm::dvec2(value[0].get<double>(), value[1].get<double>());
}

// UTF-8 to one event a code point; malformed bytes are left out.
void appendText(const std::string& text, long long frame, std::vector<ScriptLine>& lines) {
    for (std::size_t at = 0; at < text.size();) {
        const auto lead = static_cast<unsigned char>(text[at]);
        const std::size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
        int code = length == 1 ? lead : lead & (0x7F >> length);
        for (std::size_t i = 1; i < length && at + i < text.size(); ++i) {
            code = (code << 6) | (static_cast<unsigned char>(text[at + i]) & 0x3F);
        }
        lines.push_back({frame, InputEvent{.kind = InputKind::text, .code = code}});
        at += length;
    }
}

// Appends what one object says; false when it says nothing that is known.
bool appendLine(const Json& object, long long frame, std::vector<ScriptLine>& lines) {
    const auto down = [&] { return object.value("down", true); };
    if (object.contains("move")) {
        const auto position = pairOf(object["move"]);
        if (!position) return false;
        lines.push_back({frame, InputEvent{.kind = InputKind::move, .position = *position}});
    } else if (object.contains("wheel")) {
        const auto notches = pairOf(object["wheel"]);
        if (!notches) return false;
        lines.push_back({frame, InputEvent{.kind = InputKind::wheel, .position = *notches}});
    } else if (object.contains("button")) {
        const auto found = std::ranges::find(kButtons, object["button"].get<std::string>());
        if (found == kButtons.end()) return false;
        const auto code = static_cast<int>(found - kButtons.begin());
        lines.push_back(
            {frame, InputEvent{.kind = InputKind::button, .code = code, .down = down()}});
    } else if (object.contains("key")) {
        const auto key = keyNamed(object["key"].get<std::string>());
        if (!key) return false;
        lines.push_back({frame, InputEvent{.kind = InputKind::key, .code = *key, .down = down()}});
    } else if (object.contains("text")) {
        appendText(object["text"].get<std::string>(), frame, lines);
    } else if (object.contains("drop")) {
        InputEvent event{.kind = InputKind::drop};
        for (const auto& path : object["drop"]) {
            event.files.emplace_back(bytesFromJsonText(path.get<std::string>()));
        }
        lines.push_back({frame, std::move(event)});
    } else if (object.contains("screenshot")) {
        lines.push_back({frame, ScriptScreenshot{object["screenshot"].get<std::string>()}});
    } else if (object.contains("mark")) {
        lines.push_back({frame, ScriptMark{object["mark"].get<std::string>()}});
    } else if (object.contains("quit")) {
        lines.push_back({frame, ScriptQuit{}});
    } else {
        return false;
    }
    return true;
}

}  // namespace

Result<std::vector<ScriptLine>> readPlayScript(std::string_view text) {
    std::vector<ScriptLine> lines;
    long long frame = 0;
    int number = 0;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        ++number;
        if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
        // The library throws on a wrong type; that is an error of the line like any other.
        try {
            const Json object = Json::parse(line);
            const long long next = object.value("frame", frame);
            if (next < frame) return failAtLine(number, 1, "frames never go back");
            frame = next;
            if (!appendLine(object, frame, lines)) {
                return failAtLine(number, 1, "no input that is known");
            }
        } catch (const Json::exception& error) {
            return failAtLine(number, 1, error.what());
        }
    }
    return lines;
}

long long ScriptFrames::next(double seconds) {
    last_ = std::max(last_ + 1, std::llround(kScriptFramesPerSecond * seconds));
    return last_;
}

std::string writeScriptLine(long long frame, const InputEvent& event) {
    Json object{{"frame", frame}};
    switch (event.kind) {
        case InputKind::move:
            object["move"] = {event.position.x, event.position.y};
            break;
        case InputKind::wheel:
            object["wheel"] = {event.position.x, event.position.y};
            break;
        case InputKind::button:
            if (event.code < 0 || event.code >= static_cast<int>(kButtons.size())) return {};
            object["button"] = kButtons[static_cast<std::size_t>(event.code)];
            object["down"] = event.down;
            break;
        case InputKind::key: {
            const auto name = keyName(event.code);
            if (!name) return {};
            object["key"] = *name;
            object["down"] = event.down;
            break;
        }
        case InputKind::text: {
            const auto code = static_cast<unsigned>(event.code);
            std::string utf8;
            const auto tail = [&](unsigned shift) {
                utf8 += static_cast<char>(0x80u | ((code >> shift) & 0x3Fu));
            };
            if (code < 0x80u) {
                utf8 += static_cast<char>(code);
            } else if (code < 0x800u) {
                utf8 += static_cast<char>(0xC0u | (code >> 6));
                tail(0);
            } else if (code < 0x10000u) {
                utf8 += static_cast<char>(0xE0u | (code >> 12));
                tail(6), tail(0);
            } else {
                utf8 += static_cast<char>(0xF0u | (code >> 18));
                tail(12), tail(6), tail(0);
            }
            object["text"] = utf8;
            break;
        }
        case InputKind::drop:
            object["drop"] = Json::array();
            for (const auto& path : event.files) {
                object["drop"].push_back(jsonTextFromBytes(path.string()));
            }
            break;
        case InputKind::leave:
            return {};
    }
    return object.dump();
}

}  // namespace voxprite::editor
