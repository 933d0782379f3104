// JSON text in and out, by nlohmann/json. Private to core/io (and the command line's output).
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace voxprite {

// Deeper nesting than this is refused (our own files have less than ten levels).
inline constexpr int kMaxJsonDepth = 64;

// Errors name line and column.
[[nodiscard]] Result<nlohmann::ordered_json> parseJson(std::string_view text);

// Names come from old files and may hold any bytes, JSON only UTF-8. A byte b that is part of no
// valid sequence is written as the code point U+10FF00 + b (which no text uses; if one did, its own
// bytes are written that way), so that every byte string goes through JSON and comes back.
[[nodiscard]] std::string jsonTextFromBytes(std::string_view bytes);
[[nodiscard]] std::string bytesFromJsonText(std::string_view text);

}  // namespace voxprite
