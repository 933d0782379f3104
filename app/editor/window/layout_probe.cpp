#include "app/editor/window/layout_probe.h"

#include <nlohmann/json.hpp>

#include "core/base/file.h"

namespace voxprite::editor {

void LayoutProbe::mark(std::string_view name, ImVec2 min, ImVec2 max) {
    if (wanted()) items_.insert_or_assign(std::string(name), ImVec4(min.x, min.y, max.x, max.y));
}

void LayoutProbe::markItem(std::string_view name) {
    mark(name, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
}

Status LayoutProbe::endFrame(const nlohmann::json& state) {
    if (!wanted()) return {};
    nlohmann::json json{{"items", nlohmann::json::object()}, {"state", state}};
    for (const auto& [name, rect] : items_) json["items"][name] = {rect.x, rect.y, rect.z, rect.w};
    items_.clear();
    // Names of files may hold any bytes.
    std::string text = json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace);
    if (text == written_) return {};
    written_ = std::move(text);
    return writeFileAtomically(*path_, written_);
}

}  // namespace voxprite::editor
