#include "app/cli/trade/camera_way.h"

#include <cmath>

#include "app/trade/meter.h"
#include "core/base/file.h"
#include "core/io/json_value.h"

namespace voxprite::trade {
namespace {

OrbitAngles anglesFrom(const JsonValue& value) {
    JsonObject object(value);
    OrbitAngles angles;
    angles.yawDegrees = object.need("yaw").number();
    angles.pitchDegrees = object.need("pitch").number();
    object.read("roll", angles.rollDegrees);
    object.refuseUnknown();
    if (!(std::abs(angles.pitchDegrees) <= 90.0)) value.fail("pitch must be -90 ... 90 degrees");
    return angles;
}

std::vector<OrbitAngles> wayFrom(const nlohmann::ordered_json& json) {
    JsonObject object(JsonValue(json, ""));
    const JsonValue version = object.need("voxprite_way");
    if (version.integer(1) > 1) version.fail("written by a newer version of voxprite");
    const JsonValue frames = object.need("frames");
    object.refuseUnknown();
    std::vector<OrbitAngles> way;
    for (const JsonValue& frame : frames.list()) way.push_back(anglesFrom(frame));
    if (way.size() < 2 || way.size() > kMostWayFrames) frames.fail("must be 2 ... 10000");
    return way;
}

Result<std::vector<OrbitAngles>> read(const std::string& path) {
    const Result<std::string> text = readTextFile(path);
    if (!text) return Failure(text.error());
    const Result<nlohmann::ordered_json> json = parseJson(*text);
    if (!json) return Failure(json.error());
    return readFields([&] { return wayFrom(*json); });
}

}  // namespace

Result<std::vector<OrbitAngles>> readCameraWay(const std::string& path) {
    return inFile(read(path), path);
}

}  // namespace voxprite::trade
