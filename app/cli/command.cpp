#include "app/cli/command.h"

#include "core/io/json_text.h"

namespace voxprite::cli {

void addJsonFlag(CLI::App& app, Command& command) {
    app.add_flag("--json", command.json, "Print one JSON object and nothing else");
}

Json textJson(const std::string& bytes) {
    return jsonTextFromBytes(bytes);
}
Json textJson(const std::filesystem::path& path) {
    return textJson(path.string());
}

std::string warningLines(const Json& warnings) {
    std::string text;
    for (const Json& warning : warnings) {
        text += "  warning: " + onOneLine(warning.get<std::string>()) + '\n';
    }
    return text;
}

}  // namespace voxprite::cli
