#include "render/gl/shader_library.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace voxprite::gl {

namespace {

Status append(const std::string& name, ShaderSource& out) {
    if (std::ranges::find(out.files, name) != out.files.end()) return {};
    const auto& sources = embeddedShaders();
    const auto found = sources.find(name);
    if (found == sources.end()) return fail("no shader of the name " + name);
    const std::string number = std::to_string(out.files.size());
    out.files.push_back(name);
    out.text += "#line 1 " + number + "\n";
    std::istringstream lines{std::string(found->second)};
    int lineNumber = 0;
    for (std::string line; std::getline(lines, line);) {
        ++lineNumber;
        constexpr std::string_view kInclude = "#include \"";
        if (!line.starts_with(kInclude)) {
            out.text += line + "\n";
            continue;
        }
        const std::size_t end = line.find('"', kInclude.size());
        const std::string path = line.substr(kInclude.size(), end - kInclude.size());
        if (const Status included = append(path, out); !included) {
            return failAtLine(lineNumber, 1, included.error().message + " (in " + name + ")");
        }
        out.text += "#line " + std::to_string(lineNumber + 1) + " " + number + "\n";
    }
    return {};
}

// Reads digits from `at`; false when there are none.
bool readNumber(std::string_view text, std::size_t& at, std::size_t& value) {
    const std::size_t start = at;
    value = 0;
    while (at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0 &&
           at - start < 6) {
        value = value * 10 + static_cast<std::size_t>(text[at++] - '0');
    }
    return at > start;
}

}  // namespace

Result<ShaderSource> assembleShader(const std::string& name,
                                    const std::vector<std::string>& defines) {
    ShaderSource out;
    out.text = "#version 450 core\n";
    for (const std::string& define : defines) out.text += "#define " + define + "\n";
    if (const Status appended = append(name, out); !appended) {
        return tl::unexpected(appended.error());
    }
    return out;
}

// Mesa writes "0:12(3): error", NVIDIA "0(12) : error", others "ERROR: 0:12:".
std::string namedLog(std::string_view log, const std::vector<std::string>& files) {
    std::string out;
    std::istringstream lines{std::string(log)};
    for (std::string line; std::getline(lines, line);) {
        std::size_t at = line.starts_with("ERROR: ") ? 7 : 0;
        std::size_t file = 0;
        std::size_t number = 0;
        if (readNumber(line, at, file) && at < line.size() &&
            (line[at] == ':' || line[at] == '(') && readNumber(line, ++at, number) &&
            file < files.size()) {
            if (at < line.size() && line[at] == ')') ++at;
            line = files[file] + ":" + std::to_string(number) + line.substr(at);
        }
        out += (out.empty() ? "" : "\n") + line;
    }
    return out;
}

}  // namespace voxprite::gl
