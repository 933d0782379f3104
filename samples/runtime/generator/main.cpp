// Makes the conformance set of .svo: `make_conformance FOLDER`. The same bytes on every run.
//
// index.json lists the files in their order; SVO.md tells what its fields mean.
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/file.h"
#include "core/svo/bake.h"
#include "samples/runtime/generator/cases.h"

using namespace voxprite;
using namespace voxprite::samples;
using Json = nlohmann::ordered_json;

namespace {

Json vectorJson(const glm::ivec3& v) {
    return {v.x, v.y, v.z};
}

// The voxels in ascending order of z, y, x: from core's own reading, which verifyExport() and the
// tests hold against the documents.
Json voxelsJson(const Octree& octree) {
    std::vector<std::pair<glm::ivec3, int>> voxels;
    toVoxels(octree).forEachSolid([&](glm::ivec3 at, std::uint8_t material) {
        voxels.emplace_back(at - octree.origin, material);
    });
    std::sort(voxels.begin(), voxels.end(), [](const auto& a, const auto& b) {
        return std::array{a.first.z, a.first.y, a.first.x} <
               std::array{b.first.z, b.first.y, b.first.x};
    });
    Json json = Json::array();
    for (const auto& [at, material] : voxels) json.push_back({at.x, at.y, at.z, material});
    return json;
}

Json modelJson(const SvoModel& model) {
    const Octree& octree = model.octree;
    return {{"name", model.name},
            {"size", vectorJson(octree.size)},
            {"origin", vectorJson(octree.origin)},
            {"max_depth", octree.maxDepth},
            {"nodes", octree.nodes.size()},
            {"payloads", octree.payloads.size()},
            {"voxels", voxelsJson(octree)}};
}

// Models count from the file's first.
Json clipJson(const SvoClip& clip, std::size_t firstModel) {
    Json frames = Json::array();
    for (std::size_t i = 0; i < clip.models.size(); ++i) {
        frames.push_back({firstModel + clip.models[i], clip.durationsMilliseconds[i]});
    }
    return {{"name", clip.name}, {"loops", clip.loop}, {"frames", std::move(frames)}};
}

Json socketJson(const SvoSocket& socket) {
    Json positions = Json::array();
    for (const glm::dvec3& p : socket.positions) positions.push_back({p.x, p.y, p.z});
    return {{"name", socket.name}, {"positions", std::move(positions)}};
}

Json entityJson(const SvoFile& file) {
    Json colours = Json::array();
    for (std::size_t i = 0; i < file.palette.size(); ++i) {
        const Rgba8 c = file.palette[i];
        if (c != Rgba8(0)) colours.push_back({i, c.x, c.y, c.z, c.w});
    }
    return {{"name", file.name},
            {"anchor", {file.anchor.x, file.anchor.y, file.anchor.z}},
            {"models", file.models.size()},
            {"clips", file.clips.size()},
            {"sockets", file.sockets.size()},
            {"colours", std::move(colours)}};
}

Json caseJson(const Case& one) {
    Json json{{"file", one.name + ".svo"}, {"valid", one.valid}, {"shows", one.shows}};
    if (!one.valid) return json;
    const std::vector<SvoFile> set = readSvoSet(one.bytes).value();
    for (const char* list : {"models", "clips", "sockets"}) json[list] = Json::array();
    for (const SvoFile& file : set) {
        const std::size_t firstModel = json["models"].size();
        for (const SvoModel& model : file.models) json["models"].push_back(modelJson(model));
        for (const SvoClip& clip : file.clips) json["clips"].push_back(clipJson(clip, firstModel));
        for (const SvoSocket& socket : file.sockets) json["sockets"].push_back(socketJson(socket));
        if (set.size() > 1) json["entities"].push_back(entityJson(file));
    }
    return json;
}

Status write(const std::filesystem::path& folder) {
    std::vector<Case> cases = validCases();
    for (Case& broken : brokenCases()) cases.push_back(std::move(broken));
    std::string index = "[\n";
    for (const Case& one : cases) {
        if (Status s = writeFileAtomically(folder / (one.name + ".svo"), one.bytes); !s) return s;
        index += caseJson(one).dump() + (&one == &cases.back() ? "\n]\n" : ",\n");
    }
    return writeFileAtomically(folder / "index.json", index);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: make_conformance FOLDER\n");
        return 2;
    }
    if (Status s = write(argv[1]); !s) {
        std::fprintf(stderr, "%s\n", s.error().describe().c_str());
        return 1;
    }
    return 0;
}
