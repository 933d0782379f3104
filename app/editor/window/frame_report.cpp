#include "app/editor/window/frame_report.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/file.h"

namespace voxprite::editor {

void FrameReport::begin(std::string name, FrameClock& clock) {
    if (!name_.empty()) stretches_.push_back({name_, clock});
    name_ = std::move(name);
    clock.forget();
}

Status FrameReport::write(const std::filesystem::path& path, FrameClock& clock) {
    begin({}, clock);
    nlohmann::json rows = nlohmann::json::array();
    const auto tenths = [](double milliseconds) { return std::round(milliseconds * 10.0) / 10.0; };
    for (const Stretch& stretch : stretches_) {
        const auto part = [&](FramePart which) { return tenths(stretch.clock.longest(which)); };
        rows.push_back({{"mark", stretch.name},
                        {"own_ms", tenths(stretch.clock.longestOwn())},
                        {"work_ms", part(FramePart::work)},
                        {"upload_ms", part(FramePart::upload)},
                        {"draw_ms", part(FramePart::draw)},
                        {"present_ms", part(FramePart::present)}});
    }
    const std::string text = rows.dump(1) + "\n";
    return writeFileAtomically(path, Bytes(text.begin(), text.end()));
}

}  // namespace voxprite::editor
