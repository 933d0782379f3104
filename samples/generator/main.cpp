// Makes the files of samples/: `make_samples FOLDER`. The same bytes on every run.
#include <array>
#include <cstdio>
#include <filesystem>
#include <string>

#include "core/io/formats.h"
#include "core/io/profile_json.h"
#include "samples/generator/brush.h"

using namespace voxprite;
using namespace voxprite::samples;

namespace {

// A scene of several objects: the cottage and what stands around it, sharing one oak and one fence.
Document village() {
    Document document;
    document.palette = samplePalette();
    document.entity.name = "village";
    const auto addModel = [&](VoxelGrid grid) {
        document.models.emplace_back();
        document.models.back().voxels = std::move(grid);
        return static_cast<int>(document.models.size()) - 1;
    };
    const auto addObject = [&](const char* name, int model, glm::ivec3 at,
                               SignedPermutation turn = {}) {
        SceneNode node;
        node.name = name;
        node.parent = 0;
        node.models = {ModelKey{0, model}};
        node.placements = {PlacementKey{0, Placement{turn, at}}};
        document.nodes[0].children.push_back(static_cast<int>(document.nodes.size()));
        document.nodes.push_back(std::move(node));
    };
    const SignedPermutation quarterTurn{{1, 0, 2}, {-1, 1, 1}};
    const SignedPermutation mirrorX{{0, 1, 2}, {-1, 1, 1}};
    const int ground = addModel(meadow());
    const int house = addModel(cottage());
    const int tree = addModel(oak());
    const int rail = addModel(fence());
    const int hero = addModel(knight());
    addObject("meadow", ground, {0, 0, 0});
    addObject("cottage", house, {6, 14, 1});
    addObject("oak", tree, {-36, 10, 0});
    addObject("young oak", tree, {44, 24, -12}, quarterTurn);
    addObject("fence left", rail, {-32, -26, 0});
    addObject("fence right", rail, {34, -28, 0}, mirrorX);
    addObject("knight", hero, {-4, -34, 1});
    return document;
}

// Four steps of a walk, one model a frame.
Document walkingKnight() {
    Document document = documentOf("knight", knight(0));
    for (int step = 1; step < 4; ++step) {
        document.models.emplace_back();
        document.models.back().voxels = knight(step);
        document.nodes[1].models.push_back(ModelKey{step, step});
    }
    document.nodes[1].loopModels = true;
    document.clips = {Clip{"walk", 0, 3, 6.0, true}};
    // The arms swing, one voxel up and one down.
    const auto swinging = [](glm::dvec3 place, double up) {
        return std::vector{SocketKey{0, place}, SocketKey{1, place + glm::dvec3(0, 0, up)},
                           SocketKey{2, place}, SocketKey{3, place - glm::dvec3(0, 0, up)}};
    };
    document.sockets = {Socket{"sword hand", swinging({-9.5, -5.0, 10.5}, 1.0)},
                        Socket{"shield", swinging({9.0, -5.0, 11.0}, -1.0)},
                        Socket{"head", {SocketKey{0, {0.5, 0.5, 38.0}}}}};
    return document;
}

bool report(const std::filesystem::path& path, const Status& status) {
    if (status) {
        std::printf("%s\n", path.c_str());
        return true;
    }
    std::fprintf(stderr, "%s\n", status.error().describe().c_str());
    return false;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: make_samples FOLDER\n");
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    const GameProfile profile;
    bool good = true;
    const auto save = [&](const char* name, const Document& document) {
        good = report(folder / name, saveDocument(folder / name, document, profile)) && good;
    };
    save("knight.vox", documentOf("knight", knight()));
    save("oak.vox", documentOf("oak", oak()));
    save("cottage.vox", documentOf("cottage", cottage()));
    save("truck.vox", documentOf("truck", truck()));
    save("letters.vox", documentOf("letters", letterCube()));
    save("walk.voxprite", walkingKnight());
    save("village.voxprite", village());
    GameProfile villageProfile;
    villageProfile.sigma = 2.0;
    good = report(folder / "village.profile.json",
                  writeProfileFile(folder / "village.profile.json", villageProfile)) &&
           good;
    return good ? 0 : 1;
}
