#include "core/io/project_json.h"

#include <algorithm>

#include "core/io/json_value.h"

namespace voxprite {
namespace {

using Json = nlohmann::ordered_json;

Properties propertiesFrom(const JsonValue& value) {
    Properties properties;
    for (const auto& [key, text] : value.members()) properties[key] = text.text();
    return properties;
}

template <class T>
std::vector<T> listFrom(const JsonValue& value, T (*read)(const JsonValue&)) {
    std::vector<T> result;
    for (const JsonValue& element : value.list()) result.push_back(read(element));
    return result;
}

Placement placementFrom(JsonObject& object) {
    Placement placement;
    const JsonValue rotation = object.need("rotation");
    const std::vector<JsonValue> rows = rotation.list(3);
    unsigned columns = 0;
    for (std::size_t row = 0; row < 3; ++row) {
        const int entry = rows[row].integer(-3, 3);
        if (entry == 0) rows[row].fail("must not be 0");
        placement.rotation.axis[row] = static_cast<std::uint8_t>(std::abs(entry) - 1);
        placement.rotation.sign[row] = entry < 0 ? std::int8_t{-1} : std::int8_t{1};
        columns |= 1u << placement.rotation.axis[row];
    }
    if (columns != 7) rotation.fail("must name each of 1, 2 and 3 once");
    placement.translation = object.need("translation").integers3();
    return placement;
}

PlacementKey placementKeyFrom(const JsonValue& value) {
    JsonObject object(value);
    PlacementKey key;
    key.placement = placementFrom(object);
    object.read("frame", key.frame);
    object.refuseUnknown();
    return key;
}

ModelKey modelKeyFrom(const JsonValue& value) {
    JsonObject object(value);
    ModelKey key;
    object.read("frame", key.frame);
    key.model = object.need("model").integer();
    object.refuseUnknown();
    return key;
}

int indexFrom(const JsonValue& value) {
    return value.integer(0);
}

std::size_t paletteIndexFrom(const std::string& key, const JsonValue& value) {
    const bool digits =
        !key.empty() && key.size() <= 3 &&
        std::all_of(key.begin(), key.end(), [](char c) { return c >= '0' && c <= '9'; });
    const int index = digits ? std::stoi(key) : 256;
    if (index > 255) value.fail("is not an index of the palette (0 ... 255)");
    return static_cast<std::size_t>(index);
}

PaletteRamp rampFrom(const JsonValue& value) {
    JsonObject object(value);
    PaletteRamp ramp;
    object.read("name", ramp.name);
    for (const JsonValue& index : object.need("indices").list()) {
        ramp.indices.push_back(static_cast<std::uint8_t>(index.integer(1, 255)));
    }
    object.refuseUnknown();
    return ramp;
}

PaletteVariant variantFrom(const JsonValue& value) {
    JsonObject object(value);
    PaletteVariant variant;
    variant.name = object.need("name").text();
    for (const auto& [key, colour] : object.need("overrides").members()) {
        variant.overrides[static_cast<std::uint8_t>(paletteIndexFrom(key, colour))] =
            colour.colour();
    }
    object.refuseUnknown();
    return variant;
}

Palette paletteFrom(const JsonValue& value) {
    JsonObject object(value);
    Palette palette;
    const std::vector<JsonValue> colours = object.need("colours").list(256);
    for (std::size_t k = 0; k < 256; ++k) palette.colours[k] = colours[k].colour();
    for (const auto& [key, name] : object.need("names").members()) {
        palette.names[paletteIndexFrom(key, name)] = name.text();
    }
    for (const auto& [key, material] : object.need("materials").members()) {
        palette.materials[paletteIndexFrom(key, material)] = propertiesFrom(material);
    }
    const std::vector<JsonValue> order = object.need("displayOrder").list(256);
    for (std::size_t k = 0; k < 256; ++k) {
        palette.displayOrder[k] = static_cast<std::uint8_t>(order[k].integer(0, 255));
    }
    if (const auto ramps = object.find("ramps")) palette.ramps = listFrom(*ramps, rampFrom);
    if (const auto variants = object.find("variants")) {
        palette.variants = listFrom(*variants, variantFrom);
    }
    object.refuseUnknown();
    return palette;
}

Entity entityFrom(const JsonValue& value) {
    JsonObject object(value);
    Entity entity;
    object.read("name", entity.name);
    object.read("yawDegrees", entity.yawDegrees);
    object.read("pitchDegrees", entity.pitchDegrees);
    object.read("rollDegrees", entity.rollDegrees);
    object.read("scale", entity.scale);
    object.read("positionMetres", entity.positionMetres);
    if (const auto anchor = object.find("anchorVoxels")) entity.anchorVoxels = anchor->numbers3();
    object.refuseUnknown();
    return entity;
}

Model modelFrom(const JsonValue& value, VoxelEntry& entry) {
    JsonObject object(value);
    Model model;
    entry.file = object.need("file").text();
    const JsonValue crc = object.need("crc32");
    if (crc.unsigned64() > UINT32_MAX) crc.fail("must fit 32 bits");
    entry.crc32 = static_cast<std::uint32_t>(crc.unsigned64());
    entry.solidVoxels = object.need("solidVoxels").unsigned64();
    if (const auto field = object.find("canvas")) {
        JsonObject canvas(*field);
        model.canvas = {canvas.need("min").integers3(), canvas.need("max").integers3()};
        canvas.refuseUnknown();
    }
    object.refuseUnknown();
    return model;
}

SceneNode nodeFrom(const JsonValue& value) {
    JsonObject object(value);
    SceneNode node;
    object.read("name", node.name);
    object.read("hidden", node.hidden);
    object.read("locked", node.locked);
    object.read("layer", node.layer);
    node.parent = object.need("parent").integer();
    node.children = listFrom(object.need("children"), indexFrom);
    node.placements = listFrom(object.need("placements"), placementKeyFrom);
    node.models = listFrom(object.need("models"), modelKeyFrom);
    object.read("glides", node.glides);
    object.read("loopPlacements", node.loopPlacements);
    object.read("loopModels", node.loopModels);
    if (const auto field = object.find("attributes")) node.attributes = propertiesFrom(*field);
    object.refuseUnknown();
    return node;
}

Layer layerFrom(const JsonValue& value) {
    JsonObject object(value);
    Layer layer;
    object.read("name", layer.name);
    object.read("hidden", layer.hidden);
    if (const auto field = object.find("attributes")) layer.attributes = propertiesFrom(*field);
    object.refuseUnknown();
    return layer;
}

KeptRecord recordFrom(const JsonValue& value) {
    JsonObject object(value);
    KeptRecord record;
    record.id = object.need("id").integer();
    if (const auto field = object.find("attributes")) record.attributes = propertiesFrom(*field);
    object.refuseUnknown();
    return record;
}

Clip clipFrom(const JsonValue& value) {
    JsonObject object(value);
    Clip clip;
    object.read("name", clip.name);
    clip.first = object.need("first").integer(0);
    clip.last = object.need("last").integer(0);
    object.read("framesPerSecond", clip.framesPerSecond);
    object.read("loop", clip.loop);
    if (const auto durations = object.find("durationsMilliseconds")) {
        clip.durationsMilliseconds = listFrom(*durations, indexFrom);
    }
    object.refuseUnknown();
    return clip;
}

SocketKey socketKeyFrom(const JsonValue& value) {
    JsonObject object(value);
    SocketKey key;
    object.read("frame", key.frame);
    key.positionVoxels = object.need("voxels").numbers3();
    object.refuseUnknown();
    return key;
}

Socket socketFrom(const JsonValue& value) {
    JsonObject object(value);
    Socket socket;
    object.read("name", socket.name);
    socket.positions = listFrom(object.need("positions"), socketKeyFrom);
    object.refuseUnknown();
    return socket;
}

ProjectJson projectFrom(const Json& json) {
    JsonObject object{JsonValue(json, "")};
    const JsonValue version = object.need("voxprite_project");
    if (version.integer(1) > kProjectVersion)
        version.fail("written by a newer version of voxprite");

    ProjectJson project;
    Document& document = project.document;
    JsonObject authored(object.need("authored"));
    authored.read("voxelSizeMetres", document.authored.voxelSizeMetres);
    authored.read("sigma", document.authored.sigma);
    authored.refuseUnknown();
    document.entity = entityFrom(object.need("entity"));
    for (const JsonValue& model : object.need("models").list()) {
        document.models.push_back(modelFrom(model, project.entries.emplace_back()));
    }
    document.nodes = listFrom(object.need("nodes"), nodeFrom);
    document.layers = listFrom(object.need("layers"), layerFrom);
    document.clips = listFrom(object.need("clips"), clipFrom);
    if (const auto sockets = object.find("sockets")) {
        document.sockets = listFrom(*sockets, socketFrom);
    }
    document.cameras = listFrom(object.need("cameras"), recordFrom);
    document.renderSettings = listFrom(object.need("renderSettings"), recordFrom);
    document.palette = paletteFrom(object.need("palette"));
    object.refuseUnknown();
    return project;
}

}  // namespace

Result<ProjectJson> readProjectJson(std::string_view text) {
    const Result<Json> json = parseJson(text);
    if (!json) return Failure(json.error());
    return readFields([&] { return projectFrom(*json); });
}

}  // namespace voxprite
