// Arguments as users write them, and as the parser takes them.
#pragma once

#include <CLI/App.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/image.h"

namespace voxprite::cli {

// Puts in the default command (`voxprite hut.vox` means `voxprite edit hut.vox`), and gives options
// that may stand alone a value (`--ground` becomes `--ground=auto`, `--ground 0.5` becomes
// `--ground=0.5`), which the parser could not tell from a file. Throws CLI::ParseError on an
// unknown command.
[[nodiscard]] std::vector<std::string> normalisedArguments(const CLI::App& app,
                                                           std::vector<std::string> arguments);

// Whole texts only; nothing when the text is something else. Numbers may not be infinite or NaN.
[[nodiscard]] std::optional<double> numberFrom(std::string_view text);
[[nodiscard]] std::optional<int> indexFrom(std::string_view text);
[[nodiscard]] std::optional<glm::dvec3> vectorFrom(std::string_view text);  // "x,y,z"
[[nodiscard]] std::optional<glm::ivec2> sizeFrom(std::string_view text);    // "WxH"
[[nodiscard]] std::optional<bool> switchFrom(std::string_view text);        // "on" or "off"

// An option whose text is read by `parse` and handed to `take`; a text that it refuses is wrong
// usage.
template <class T, class Take>
CLI::Option* addParsed(CLI::App& app, const std::string& name, const std::string& form,
                       const std::string& description, std::optional<T> (*parse)(std::string_view),
                       Take take) {
    return app
        .add_option_function<std::string>(
            name,
            [parse, take, name, form](const std::string& text) {
                const std::optional<T> value = parse(text);
                if (!value) {
                    throw CLI::ValidationError(name, "expected " + form + ", got '" + text + "'");
                }
                take(*value);
            },
            description)
        ->type_name(form);
}

}  // namespace voxprite::cli
