// Range checks of numbers from outside, with messages that name the field, its value and the range.
#pragma once

#include <charconv>
#include <cmath>
#include <string>

#include "core/base/result.h"

namespace voxprite {

// The shortest text that reads back as `value`: "0.1", "1e-06", "nan".
[[nodiscard]] inline std::string textFromNumber(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof(text), value).ptr;
    return {text, end};
}

// `range` is how a person would write lowest ... highest: "1/64 and 64".
[[nodiscard]] inline Status checkRange(const std::string& field, double value, double lowest,
                                       double highest, const std::string& range) {
    // Written so that NaN fails too.
    if (value >= lowest && value <= highest) return {};
    return fail(field + " is " + textFromNumber(value) + "; it must be between " + range);
}

[[nodiscard]] inline Status checkRange(const std::string& field, double value, double lowest,
                                       double highest) {
    return checkRange(field, value, lowest, highest,
                      textFromNumber(lowest) + " and " + textFromNumber(highest));
}

}  // namespace voxprite
