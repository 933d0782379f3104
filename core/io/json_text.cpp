#include "core/io/json_text.h"

#include <algorithm>

namespace voxprite {
namespace {

struct TooDeep {
    int depth = 0;
};

// "line 3, column 7" of the byte at `position`.
Failure failAtPosition(std::string_view text, std::size_t position, std::string message) {
    const std::string_view before = text.substr(0, std::min(position, text.size()));
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::size_t lineStart = before.rfind('\n');
    const std::size_t column =
        before.size() - (lineStart == std::string_view::npos ? 0 : lineStart + 1) + 1;
    return failAtLine(static_cast<int>(line), static_cast<int>(column), std::move(message));
}

// nlohmann's text is "[json.exception.parse_error.101] parse error at line 1, column 2: syntax
// error while parsing value - invalid literal; last read: 'x'". The place is ours to say.
std::string reasonOf(std::string_view what) {
    const auto dropThrough = [&](std::string_view mark, std::size_t from) {
        const std::size_t found = what.find(mark, from);
        if (found != std::string_view::npos) what.remove_prefix(found + mark.size());
    };
    dropThrough("] ", 0);
    const std::size_t place = what.find("column ");
    if (what.starts_with("parse error at ") && place != std::string_view::npos) {
        dropThrough(": ", place);
    }
    return std::string(what);
}

// The length of the valid UTF-8 sequence at the start of `bytes`, or 0 (RFC 3629: shortest form,
// no surrogates, at most U+10FFFF).
std::size_t sequenceLength(std::string_view bytes) {
    const auto byteAt = [&](std::size_t k) { return static_cast<unsigned char>(bytes[k]); };
    const unsigned lead = byteAt(0);
    if (lead < 0x80) return 1;
    const std::size_t length = lead >= 0xC2 && lead <= 0xDF   ? 2
                               : lead >= 0xE0 && lead <= 0xEF ? 3
                               : lead >= 0xF0 && lead <= 0xF4 ? 4
                                                              : 0;
    if (length == 0 || length > bytes.size()) return 0;
    for (std::size_t k = 1; k < length; ++k) {
        if ((byteAt(k) & 0xC0) != 0x80) return 0;
    }
    const unsigned second = byteAt(1);
    if (lead == 0xE0 && second < 0xA0) return 0;
    if (lead == 0xED && second > 0x9F) return 0;
    if (lead == 0xF0 && second < 0x90) return 0;
    if (lead == 0xF4 && second > 0x8F) return 0;
    return length;
}

// U+10FF00 + b is F4 8F (BC | b >> 6) (80 | b & 3F).
bool isEscape(std::string_view bytes) {
    return bytes.size() >= 4 && bytes[0] == '\xF4' && bytes[1] == '\x8F' &&
           static_cast<unsigned char>(bytes[2]) >= 0xBC &&
           static_cast<unsigned char>(bytes[2]) <= 0xBF &&
           (static_cast<unsigned char>(bytes[3]) & 0xC0) == 0x80;
}

}  // namespace

Result<nlohmann::ordered_json> parseJson(std::string_view text) {
    try {
        return nlohmann::ordered_json::parse(
            text.begin(), text.end(),
            [](int depth, nlohmann::ordered_json::parse_event_t, nlohmann::ordered_json&) {
                if (depth > kMaxJsonDepth) throw TooDeep{depth};
                return true;
            });
    } catch (const nlohmann::json::parse_error& error) {
        const std::size_t position = error.byte > 0 ? error.byte - 1 : 0;
        return failAtPosition(text, position, "not valid JSON: " + reasonOf(error.what()));
    } catch (const TooDeep&) {
        return fail("JSON nested deeper than " + std::to_string(kMaxJsonDepth) + " levels");
    } catch (const std::exception& error) {
        return fail("not valid JSON: " + reasonOf(error.what()));
    }
}

std::string jsonTextFromBytes(std::string_view bytes) {
    std::string text;
    text.reserve(bytes.size());
    while (!bytes.empty()) {
        const std::size_t length = isEscape(bytes) ? 0 : sequenceLength(bytes);
        if (length > 0) {
            text += bytes.substr(0, length);
            bytes.remove_prefix(length);
        } else {
            const auto byte = static_cast<unsigned char>(bytes.front());
            text += {'\xF4', '\x8F', static_cast<char>(0xBC | byte >> 6),
                     static_cast<char>(0x80 | (byte & 0x3F))};
            bytes.remove_prefix(1);
        }
    }
    return text;
}

std::string bytesFromJsonText(std::string_view text) {
    std::string bytes;
    bytes.reserve(text.size());
    while (!text.empty()) {
        if (isEscape(text)) {
            bytes += static_cast<char>((text[2] & 3) << 6 | (text[3] & 0x3F));
            text.remove_prefix(4);
        } else {
            bytes += text.front();
            text.remove_prefix(1);
        }
    }
    return bytes;
}

}  // namespace voxprite
