#include "app/cli/arguments.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <system_error>

namespace voxprite::cli {
namespace {

// Options that may stand alone: what they take then, and what they take else.
struct OptionalValue {
    std::string_view option;
    const char* alone;
    bool (*isValue)(std::string_view text);
};
constexpr std::array kOptionalValues{
    OptionalValue{"--ground", "auto", [](std::string_view t) { return numberFrom(t).has_value(); }},
    OptionalValue{"--ortho", "auto", [](std::string_view t) { return numberFrom(t).has_value(); }},
    OptionalValue{"--minification", "on",
                  [](std::string_view t) { return switchFrom(t).has_value(); }},
    OptionalValue{"--snapshot-blend", "on",
                  [](std::string_view t) { return switchFrom(t).has_value(); }},
};

bool isFileName(const std::string& argument) {
    std::error_code tooLong;
    return argument.find_first_of("./") != std::string::npos ||
           std::filesystem::exists(argument, tooLong);
}

}  // namespace

std::vector<std::string> normalisedArguments(const CLI::App& app,
                                             std::vector<std::string> arguments) {
    const auto isCommand = [&](const CLI::App* sub) {
        return !arguments.empty() && sub->get_name() == arguments[0];
    };
    const bool aboutTheProgram =
        !arguments.empty() &&
        (arguments[0] == "--help" || arguments[0] == "-h" || arguments[0] == "--version");
    if (!aboutTheProgram && app.get_subcommands(isCommand).empty()) {
        if (!arguments.empty() && !arguments[0].starts_with('-') && !isFileName(arguments[0])) {
            throw CLI::ValidationError("'" + arguments[0] + "' is neither a command nor a file");
        }
        arguments.insert(arguments.begin(), "edit");
    }
    std::vector<std::string> normalised;
    for (std::size_t k = 0; k < arguments.size(); ++k) {
        const auto option =
            std::find_if(kOptionalValues.begin(), kOptionalValues.end(),
                         [&](const OptionalValue& o) { return o.option == arguments[k]; });
        if (option == kOptionalValues.end()) {
            normalised.push_back(arguments[k]);
        } else if (k + 1 < arguments.size() && option->isValue(arguments[k + 1])) {
            normalised.push_back(arguments[k] + "=" + arguments[k + 1]);
            ++k;
        } else {
            normalised.push_back(arguments[k] + "=" + option->alone);
        }
    }
    return normalised;
}

std::optional<double> numberFrom(std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
        return std::nullopt;
    }
    return value;
}

std::optional<int> indexFrom(std::string_view text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::optional<glm::dvec3> vectorFrom(std::string_view text) {
    glm::dvec3 vector{0.0};
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t comma = axis < 2 ? text.find(',') : text.size();
        if (comma == std::string_view::npos) return std::nullopt;
        const std::optional<double> value = numberFrom(text.substr(0, comma));
        if (!value) return std::nullopt;
        vector[axis] = *value;
        text.remove_prefix(std::min(comma + 1, text.size()));
    }
    return vector;
}

std::optional<glm::ivec2> sizeFrom(std::string_view text) {
    glm::ivec2 size{0};
    const std::size_t cross = text.find('x');
    if (cross == std::string_view::npos) return std::nullopt;
    const auto parse = [](std::string_view digits, int& value) {
        const auto [end, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), value);
        return error == std::errc{} && end == digits.data() + digits.size() && value > 0;
    };
    if (!parse(text.substr(0, cross), size.x) || !parse(text.substr(cross + 1), size.y)) {
        return std::nullopt;
    }
    return size;
}

std::optional<bool> switchFrom(std::string_view text) {
    if (text == "on" || text == "true" || text == "1") return true;
    if (text == "off" || text == "false" || text == "0") return false;
    return std::nullopt;
}

}  // namespace voxprite::cli
