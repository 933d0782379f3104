#include "core/io/json_value.h"
#include "core/io/project_json.h"

namespace voxprite {
namespace {

using Json = nlohmann::ordered_json;

Json vectorJson(glm::ivec3 v) {
    return {v.x, v.y, v.z};
}
Json vectorJson(glm::dvec3 v) {
    return {v.x, v.y, v.z};
}
Json textJson(const std::string& text) {
    return jsonTextFromBytes(text);
}

Json propertiesJson(const Properties& properties) {
    Json json = Json::object();
    for (const auto& [key, value] : properties) json[jsonTextFromBytes(key)] = textJson(value);
    return json;
}

// A list of what `write` makes of each element.
template <class T, class Write>
Json listJson(const std::vector<T>& values, Write write) {
    Json json = Json::array();
    for (const T& value : values) json.push_back(write(value));
    return json;
}

// Row r of the matrix as +-(column + 1): the identity is [1, 2, 3].
Json placementJson(const Placement& placement) {
    Json rotation = Json::array();
    for (std::size_t row = 0; row < 3; ++row) {
        rotation.push_back(placement.rotation.sign[row] * (placement.rotation.axis[row] + 1));
    }
    return {{"rotation", std::move(rotation)}, {"translation", vectorJson(placement.translation)}};
}

Json rampJson(const PaletteRamp& ramp) {
    return {{"name", textJson(ramp.name)}, {"indices", ramp.indices}};
}

Json variantJson(const PaletteVariant& variant) {
    Json overrides = Json::object();
    for (const auto& [index, colour] : variant.overrides) {
        overrides[std::to_string(index)] = colourText(colour);
    }
    return {{"name", textJson(variant.name)}, {"overrides", std::move(overrides)}};
}

Json paletteJson(const Palette& palette) {
    Json colours = Json::array();
    for (const Rgba8 colour : palette.colours) colours.push_back(colourText(colour));
    Json names = Json::object();
    Json materials = Json::object();
    for (std::size_t k = 0; k < 256; ++k) {
        if (!palette.names[k].empty()) names[std::to_string(k)] = textJson(palette.names[k]);
        if (!palette.materials[k].empty()) {
            materials[std::to_string(k)] = propertiesJson(palette.materials[k]);
        }
    }
    Json json{{"colours", std::move(colours)},
              {"names", std::move(names)},
              {"materials", std::move(materials)},
              {"displayOrder", palette.displayOrder}};
    if (!palette.ramps.empty()) json["ramps"] = listJson(palette.ramps, rampJson);
    if (!palette.variants.empty()) json["variants"] = listJson(palette.variants, variantJson);
    return json;
}

Json entityJson(const Entity& entity) {
    Json json{{"name", textJson(entity.name)},
              {"yawDegrees", entity.yawDegrees},
              {"pitchDegrees", entity.pitchDegrees},
              {"rollDegrees", entity.rollDegrees},
              {"scale", entity.scale},
              {"positionMetres", vectorJson(entity.positionMetres)}};
    if (entity.anchorVoxels) json["anchorVoxels"] = vectorJson(*entity.anchorVoxels);
    return json;
}

Json modelJson(const Model& model, const VoxelEntry& entry) {
    Json json{{"file", entry.file}, {"crc32", entry.crc32}, {"solidVoxels", entry.solidVoxels}};
    if (model.canvas != IBox{}) {
        json["canvas"] = {{"min", vectorJson(model.canvas.min)},
                          {"max", vectorJson(model.canvas.max)}};
    }
    return json;
}

Json nodeJson(const SceneNode& node) {
    Json written{{"name", textJson(node.name)},
                 {"hidden", node.hidden},
                 {"locked", node.locked},
                 {"layer", node.layer},
                 {"parent", node.parent},
                 {"children", node.children},
                 {"placements", listJson(node.placements,
                                         [](const PlacementKey& key) {
                                             Json json = placementJson(key.placement);
                                             json["frame"] = key.frame;
                                             return json;
                                         })},
                 {"models", listJson(node.models,
                                     [](const ModelKey& key) -> Json {
                                         return {{"frame", key.frame}, {"model", key.model}};
                                     })},
                 {"loopPlacements", node.loopPlacements},
                 {"loopModels", node.loopModels},
                 {"attributes", propertiesJson(node.attributes)}};
    if (node.glides) written["glides"] = true;
    return written;
}

Json layerJson(const Layer& layer) {
    return {{"name", textJson(layer.name)},
            {"hidden", layer.hidden},
            {"attributes", propertiesJson(layer.attributes)}};
}

Json recordJson(const KeptRecord& record) {
    return {{"id", record.id}, {"attributes", propertiesJson(record.attributes)}};
}

Json clipJson(const Clip& clip) {
    Json json{{"name", textJson(clip.name)},
              {"first", clip.first},
              {"last", clip.last},
              {"framesPerSecond", clip.framesPerSecond},
              {"loop", clip.loop}};
    if (!clip.durationsMilliseconds.empty()) {
        json["durationsMilliseconds"] = clip.durationsMilliseconds;
    }
    return json;
}

Json socketJson(const Socket& socket) {
    return {{"name", textJson(socket.name)},
            {"positions", listJson(socket.positions, [](const SocketKey& key) -> Json {
                 return {{"frame", key.frame}, {"voxels", vectorJson(key.positionVoxels)}};
             })}};
}

}  // namespace

std::string writeProjectJson(const Document& document, const AuthoredValues& authored,
                             const std::vector<VoxelEntry>& entries) {
    Json models = Json::array();
    for (std::size_t k = 0; k < document.models.size(); ++k) {
        models.push_back(modelJson(document.models[k], entries[k]));
    }
    Json json{
        {"voxprite_project", kProjectVersion},
        {"authored", {{"voxelSizeMetres", authored.voxelSizeMetres}, {"sigma", authored.sigma}}},
        {"entity", entityJson(document.entity)},
        {"models", std::move(models)},
        {"nodes", listJson(document.nodes, nodeJson)},
        {"layers", listJson(document.layers, layerJson)},
        {"clips", listJson(document.clips, clipJson)},
        {"cameras", listJson(document.cameras, recordJson)},
        {"renderSettings", listJson(document.renderSettings, recordJson)},
        {"palette", paletteJson(document.palette)}};
    if (!document.sockets.empty()) json["sockets"] = listJson(document.sockets, socketJson);
    return json.dump(1) + "\n";
}

}  // namespace voxprite
