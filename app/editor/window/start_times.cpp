#include "app/editor/window/start_times.h"

#include <chrono>
#include <ctime>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/file.h"

namespace voxprite::editor {

void StartTimes::mark(std::string part) {
    const std::chrono::duration<double, std::milli> now =
        std::chrono::steady_clock::now().time_since_epoch();
    const double cpuMs = 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    marks_.push_back({std::move(part), now.count(), cpuMs});
}

Status StartTimes::write(const std::filesystem::path& path) const {
    nlohmann::json rows = nlohmann::json::array();
    for (const Mark& mark : marks_) {
        rows.push_back({{"part", mark.part}, {"at_ms", mark.atMs}, {"cpu_ms", mark.cpuMs}});
    }
    const std::string text = rows.dump(1) + "\n";
    return writeFileAtomically(path, Bytes(text.begin(), text.end()));
}

}  // namespace voxprite::editor
