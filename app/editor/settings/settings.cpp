#include "app/editor/settings/settings.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "app/editor/settings/settings_json.h"
#include "core/base/file.h"

namespace voxprite::editor {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMaxRecent = 12;

std::filesystem::path fromEnvironment(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr ? std::filesystem::path(value) : std::filesystem::path();
}

}  // namespace

void ToolSettings::choose(ToolKind chosen) {
    if (!isForOneClick()) before = tool;
    tool = chosen;
}

void ToolSettings::chooseMode(EditMode chosen) {
    mode = chosen;
    if (isForOneClick()) tool = before;
}

void WindowSettings::show(DockTab list) {
    dockTab = list;
    showsDock = showsSide = true;
}

void EditorSettings::remember(const std::filesystem::path& file) {
    std::error_code ignored;
    const std::filesystem::path full = std::filesystem::absolute(file, ignored).lexically_normal();
    std::erase(window.recent, full);
    window.recent.insert(window.recent.begin(), full);
    if (window.recent.size() > kMaxRecent) window.recent.resize(kMaxRecent);
    window.folder = full.parent_path();
}

std::filesystem::path settingsPath() {
    std::filesystem::path base = fromEnvironment("XDG_CONFIG_HOME");
    if (base.empty()) base = fromEnvironment("HOME") / ".config";
    return base / "voxprite" / "editor.json";
}

EditorSettings loadSettings(const std::filesystem::path& path) {
    const Result<std::string> text = readTextFile(path);
    if (!text) return {};
    try {
        return settingsFrom(Json::parse(*text));
    } catch (const Json::exception&) {
        return {};
    }
}

Status saveSettings(const std::filesystem::path& path, const EditorSettings& settings,
                    const EditorSettings& before) {
    std::error_code failed;
    std::filesystem::create_directories(path.parent_path(), failed);
    if (failed) return failInFile(path.string(), failed.message());
    const Result<std::string> text = readTextFile(path);
    Json json = text ? Json::parse(*text, nullptr, false) : Json();
    if (!json.is_object()) json = Json::object();
    const Json now = jsonOf(settings), then = jsonOf(before);
    for (const auto& [name, part] : now.items()) {
        if (!json.contains(name) || part != then.at(name)) json[name] = part;
    }
    // Paths need not be UTF-8.
    return writeFileAtomically(path,
                               json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace voxprite::editor
