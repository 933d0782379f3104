// voxprite inspect FILE: what is in a file.
#include <algorithm>
#include <array>
#include <sstream>

#include "app/cli/command.h"
#include "app/cli/source.h"
#include "core/io/svo_set.h"
#include "core/model/entity_voxels.h"
#include "core/model/playback.h"
#include "core/svo/bake.h"

namespace voxprite::cli {
namespace {

struct InspectOptions {
    std::string file;
    ReadOptions reading;
};

// Model is shown by this node, if by any: the first one in the scene.
const SceneNode* nodeShowing(const Document& document, int model) {
    for (const SceneNode& node : document.nodes) {
        for (const ModelKey& key : node.models) {
            if (key.model == model) return &node;
        }
    }
    return nullptr;
}

std::uint64_t coloursIn(const VoxelGrid& voxels) {
    std::array<bool, 256> used{};
    voxels.forEachBlock([&](const VoxelBlock& block) {
        if (block.voxels == nullptr) {
            used[block.uniformValue] = true;
        } else {
            for (int k = 0; k < 512; ++k) used[block.voxels[k]] = true;
        }
    });
    used[0] = false;
    return static_cast<std::uint64_t>(std::count(used.begin(), used.end(), true));
}

Json sizeJson(glm::ivec3 size) {
    return {size.x, size.y, size.z};
}

Json octreeJson(const Octree& octree) {
    return {{"max_depth", octree.maxDepth},
            {"nodes", octree.nodes.size()},
            {"payloads", octree.payloads.size()},
            {"bytes", octree.nodes.size() * 4 + octree.payloads.size() * 8}};
}

// A model that no octree can hold is said so in `warnings`; it is still a model.
Json modelJson(const Document& document, int index, Json& warnings) {
    const VoxelGrid& voxels = document.models[static_cast<std::size_t>(index)].voxels;
    const SceneNode* const node = nodeShowing(document, index);
    const Result<Octree> octree = bake(voxels);
    if (!octree) warnings.push_back("there is no octree of a model: " + octree.error().describe());
    return {{"name", textJson(node != nullptr ? node->name : std::string())},
            {"size", sizeJson(voxels.bounds().size())},
            {"voxels", voxels.solidCount()},
            {"colours", coloursIn(voxels)},
            {"frames", node != nullptr ? node->models.size() : 1},
            {"svo", octree ? octreeJson(*octree) : Json(nullptr)}};
}

bool isSeen(const std::vector<Instance>& visible, int node) {
    return std::any_of(visible.begin(), visible.end(),
                       [node](const Instance& instance) { return instance.node == node; });
}

Json instancesJson(const Document& document, const std::vector<int>& models) {
    const std::vector<Instance> visible = instancesOf(document, 0);
    Json instances = Json::array();
    for (const Instance& instance : instancesOf(document, 0, true)) {
        const auto listed = std::find(models.begin(), models.end(), instance.model);
        const SceneNode& node = document.nodes[static_cast<std::size_t>(instance.node)];
        instances.push_back(
            {{"model", listed != models.end() ? Json(listed - models.begin()) : Json(nullptr)},
             {"name", textJson(node.name)},
             {"hidden", !isSeen(visible, instance.node)}});
    }
    return instances;
}

Json paletteJson(const Palette& palette) {
    Json variants = Json::array();
    for (const PaletteVariant& variant : palette.variants) {
        variants.push_back(
            {{"name", textJson(variant.name)}, {"colours", variant.overrides.size()}});
    }
    return {{"variants", std::move(variants)}, {"ramps", palette.ramps.size()}};
}

Json clipsJson(const Document& document) {
    Json clips = Json::array();
    for (const Clip& clip : document.clips) {
        double seconds = 0.0;
        for (int frame = clip.first; frame <= clip.last; ++frame) {
            seconds += frameSeconds(clip, frame);
        }
        clips.push_back({{"name", textJson(clip.name)},
                         {"first", clip.first},
                         {"last", clip.last},
                         {"seconds", seconds},
                         {"loop", clip.loop}});
    }
    return clips;
}

Json socketsJson(const Document& document) {
    Json sockets = Json::array();
    for (const Socket& socket : document.sockets) {
        sockets.push_back(
            {{"name", textJson(socket.name)}, {"positions", socket.positions.size()}});
    }
    return sockets;
}

// "  sockets:  "hand"  "muzzle"", or nothing.
std::string namesLine(const char* what, const Json& list) {
    if (list.empty()) return {};
    std::string line = std::string("  ") + what + ":";
    for (const Json& item : list) line += "  \"" + onOneLine(item["name"].get<std::string>()) + '"';
    return line + '\n';
}

std::string describe(const Json& json, const std::string& file) {
    std::ostringstream text;
    text << onOneLine(file) << ": " << json["format"].get<std::string>() << ", "
         << json["models"].size() << " model(s), " << json["instances"].size() << " object(s), "
         << json["frames"] << " frame(s)\n";
    int index = 0;
    for (const Json& model : json["models"]) {
        const Json& size = model["size"];
        const Json& svo = model["svo"];
        text << "  " << index++ << "  " << size[0] << " x " << size[1] << " x " << size[2] << "  "
             << model["voxels"] << " voxels, " << model["colours"] << " colours";
        if (!svo.is_null()) {
            text << "; octree: depth " << svo["max_depth"] << ", " << svo["nodes"] << " nodes, "
                 << svo["payloads"] << " payloads, " << svo["bytes"] << " bytes";
        }
        const std::string name = onOneLine(model["name"].get<std::string>());
        if (!name.empty()) text << "  \"" << name << '"';
        if (model["frames"] > 1) text << "  (one of " << model["frames"] << " frames)";
        text << '\n';
    }
    if (const Json& variants = json["palette"]["variants"]; !variants.empty()) {
        text << "  palette variants:";
        for (const Json& variant : variants) {
            text << "  \"" << onOneLine(variant["name"].get<std::string>()) << "\" ("
                 << variant["colours"] << " colours)";
        }
        text << '\n';
    }
    text << namesLine("clips", json["clips"]) << namesLine("sockets", json["sockets"]);
    text << warningLines(json["warnings"]);
    return text.str();
}

Json documentJson(const LoadedDocument& loaded) {
    const Document& document = loaded.document;
    const std::vector<int> sources = sourceModels(document);
    Json warnings = warningsJson(loaded);
    Json models = Json::array();
    for (const int index : sources) models.push_back(modelJson(document, index, warnings));

    const IBox bounds = entityBounds(document);
    return {{"format", nameOf(loaded.format)},
            {"models", std::move(models)},
            {"instances", instancesJson(document, sources)},
            {"palette", paletteJson(document.palette)},
            {"clips", clipsJson(document)},
            {"sockets", socketsJson(document)},
            {"warnings", std::move(warnings)},
            {"frames", frameCount(document)},
            {"entity_size", sizeJson(bounds.empty() ? glm::ivec3(0) : bounds.size())}};
}

// Models in the order of the file, whose they are beside them.
Report reportOfSet(const std::vector<SvoFile>& set, const std::string& file) {
    Report report;
    Json models = Json::array(), entities = Json::array(), warnings = Json::array();
    report.text = file + ": svo, " + std::to_string(set.size()) + " entities\n";
    for (std::size_t i = 0; i < set.size(); ++i) {
        Json one = documentJson({.document = documentFromSvo(set[i]), .format = Format::svo});
        const std::string name = set[i].name;
        report.text += describe(one, std::to_string(i) + "  \"" + name + "\"");
        for (Json& model : one["models"]) {
            model["entity"] = i;
            models.push_back(std::move(model));
        }
        for (Json& warning : one["warnings"]) warnings.push_back(std::move(warning));
        entities.push_back({{"name", textJson(name)},
                            {"models", one["models"].size()},
                            {"size", one["entity_size"]},
                            {"frames", one["frames"]},
                            {"clips", one["clips"]},
                            {"sockets", one["sockets"]}});
    }
    report.json = {{"format", nameOf(Format::svo)},
                   {"entities", std::move(entities)},
                   {"models", std::move(models)},
                   {"instances", Json::array()},
                   {"warnings", std::move(warnings)}};
    return report;
}

Result<Report> inspect(const InspectOptions& options) {
    const Result<std::vector<SvoFile>> set =
        options.reading.entity ? std::vector<SvoFile>{} : severalEntities(options.file);
    if (!set) return Failure(set.error());
    if (!set->empty()) return reportOfSet(*set, options.file);
    const Result<LoadedDocument> loaded = loadDocument(options.file, options.reading);
    if (!loaded) return Failure(loaded.error());
    Report report;
    report.json = documentJson(*loaded);
    report.text = describe(report.json, options.file);
    return report;
}

}  // namespace

void addInspect(CLI::App& app, Command& command) {
    CLI::App& sub = *app.add_subcommand("inspect", "Say what is in a file");
    auto options = std::make_shared<InspectOptions>();
    sub.add_option("FILE", options->file, "A model: " + listed(modelEndings()))->required();
    addEntityOption(sub, options->reading);
    addJsonFlag(sub, command);
    runs(sub, command, options, inspect);
}

}  // namespace voxprite::cli
