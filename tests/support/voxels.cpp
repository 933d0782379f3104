#include "tests/support/voxels.h"

#include <array>
#include <string_view>

#include "tests/support/random.h"

namespace voxprite::test {

namespace {

// Visits every position of [0, size).
template <class Visit>
void forEachPosition(glm::ivec3 size, const Visit& visit) {
    for (int x = 0; x < size.x; ++x) {
        for (int y = 0; y < size.y; ++y) {
            for (int z = 0; z < size.z; ++z) visit(glm::ivec3(x, y, z));
        }
    }
}

SignedPermutation rotation(std::array<std::uint8_t, 3> axis, std::array<std::int8_t, 3> sign) {
    return {axis, sign};
}

SceneNode nodeUnder(Document& document, int parent, const char* name) {
    SceneNode node;
    node.name = name;
    node.parent = parent;
    document.nodes[static_cast<std::size_t>(parent)].children.push_back(
        static_cast<int>(document.nodes.size()));
    return node;
}

void addGroup(Document& document, int parent, const char* name, std::vector<PlacementKey> keys) {
    SceneNode node = nodeUnder(document, parent, name);
    node.placements = std::move(keys);
    document.nodes.push_back(std::move(node));
}

SceneNode& addObject(Document& document, int parent, const char* name, Placement placement,
                     std::vector<ModelKey> models) {
    SceneNode node = nodeUnder(document, parent, name);
    node.placements = {PlacementKey{0, placement}};
    node.models = std::move(models);
    document.nodes.push_back(std::move(node));
    return document.nodes.back();
}

}  // namespace

VoxelGrid randomVoxels(std::uint64_t seed, glm::ivec3 size, double fillRate, int colours) {
    Random random(seed);
    VoxelGrid voxels;
    forEachPosition(size, [&](glm::ivec3 v) {
        if (random.chance(fillRate)) {
            voxels.set(v, static_cast<std::uint8_t>(random.between(1, colours)));
        }
    });
    return voxels;
}

VoxelGrid shellSphere(int n) {
    // In half voxels from the centre, so that all of it is integers.
    const auto isInside = [n](glm::ivec3 v) {
        const glm::ivec3 d = 2 * v + 1 - n;
        return d.x * d.x + d.y * d.y + d.z * d.z <= n * n;
    };
    VoxelGrid voxels;
    forEachPosition(glm::ivec3(n), [&](glm::ivec3 v) {
        if (!isInside(v)) return;
        bool surface = false;
        for (int axis = 0; axis < 3; ++axis) {
            glm::ivec3 step(0);
            step[axis] = 1;
            surface = surface || !isInside(v + step) || !isInside(v - step);
        }
        if (!surface) return;
        const glm::ivec3 half(2 * v.x >= n, 2 * v.y >= n, 2 * v.z >= n);
        voxels.set(v, static_cast<std::uint8_t>(1 + half.x + 2 * half.y + 4 * half.z));
    });
    return voxels;
}

VoxelGrid solidBox(glm::ivec3 size, std::uint8_t value) {
    VoxelGrid voxels;
    voxels.fill({glm::ivec3(0), size}, value);
    return voxels;
}

VoxelGrid figure() {
    constexpr std::uint8_t kSkin = 10;
    constexpr std::uint8_t kShirt = 30;
    constexpr std::uint8_t kTrousers = 80;
    constexpr std::uint8_t kHair = 120;
    constexpr std::uint8_t kEye = 255;
    constexpr std::uint8_t kShield = 216;
    const auto box = [](int x0, int y0, int z0, int x1, int y1, int z1) {
        return IBox{{x0, y0, z0}, {x1, y1, z1}};
    };
    VoxelGrid voxels;
    voxels.fill(box(4, 2, 0, 7, 6, 12), kTrousers);
    voxels.fill(box(8, 2, 0, 11, 6, 12), kTrousers);
    voxels.fill(box(4, 1, 12, 11, 7, 23), kShirt);
    voxels.fill(box(0, 2, 12, 3, 6, 22), kShirt);
    voxels.fill(box(3, 2, 19, 4, 6, 22), kShirt);
    voxels.fill(box(11, 2, 15, 14, 6, 22), kShirt);
    voxels.fill(box(14, 0, 11, 16, 8, 22), kShield);
    voxels.fill(box(6, 3, 23, 9, 6, 24), kSkin);
    voxels.fill(box(4, 1, 24, 11, 7, 31), kSkin);
    voxels.fill(box(4, 1, 30, 11, 8, 32), kHair);
    voxels.set({5, 1, 27}, kEye);
    voxels.set({9, 1, 27}, kEye);
    return voxels;
}

VoxelGrid asymmetric() {
    VoxelGrid voxels;
    voxels.fill({{0, 0, 0}, {13, 2, 2}}, 1);
    voxels.fill({{0, 0, 0}, {2, 9, 2}}, 2);
    voxels.fill({{0, 0, 0}, {2, 2, 17}}, 3);
    // As one reads it from the front: x to the right, z upward.
    constexpr std::array<std::string_view, 7> kLetter{"#####", "#", "#", "####", "#", "#", "#"};
    for (std::size_t row = 0; row < kLetter.size(); ++row) {
        for (std::size_t column = 0; column < kLetter[row].size(); ++column) {
            if (kLetter[row][column] != '#') continue;
            voxels.set({4 + static_cast<int>(column), 0, 12 - static_cast<int>(row)}, 4);
        }
    }
    return voxels;
}

Document documentOf(VoxelGrid voxels) {
    Document document = Document::withEmptyModel();
    document.models[0].voxels = std::move(voxels);
    return document;
}

Document animationOf(std::vector<VoxelGrid> frames) {
    Document document = Document::withEmptyModel();
    document.models.clear();
    document.nodes[1].models.clear();
    for (VoxelGrid& voxels : frames) {
        const int frame = static_cast<int>(document.models.size());
        document.nodes[1].models.push_back({frame, frame});
        document.models.push_back(Model{std::move(voxels), {}});
    }
    return document;
}

Document busyDocument() {
    Document document;
    document.palette.colours[1] = Rgba8(12, 34, 56, 255);
    document.palette.colours[7] = Rgba8(200, 100, 50, 128);
    document.palette.names[7] = "amber glass";
    document.palette.materials[7] = {{"_type", "_glass"}, {"_alpha", "0.5"}};
    std::swap(document.palette.displayOrder[3], document.palette.displayOrder[200]);
    document.layers = {Layer{"front", false, {}}, Layer{"construction", true, {}}};

    const auto addModel = [&](VoxelGrid voxels, IBox canvas = {}) {
        document.models.push_back(Model{std::move(voxels), canvas});
        return static_cast<int>(document.models.size()) - 1;
    };
    const int letter = addModel(asymmetric(), {{0, 0, 0}, {13, 9, 17}});
    const int person = addModel(figure(), {{0, 0, 0}, {16, 8, 32}});
    const int noise = addModel(randomVoxels(7, {9, 10, 11}, 0.4, 255));
    const int ball = addModel(shellSphere(12));
    const int nothing = addModel(VoxelGrid{});

    const SignedPermutation turned = rotation({1, 0, 2}, {-1, 1, 1});
    const SignedPermutation mirrored = rotation({0, 1, 2}, {-1, 1, 1});
    const SignedPermutation tumbled = rotation({2, 0, 1}, {1, -1, -1});
    document.nodes[0].name = "root";
    addGroup(document, 0, "left", {{0, {turned, {-20, 5, 0}}}, {4, {turned, {-21, 5, 1}}}});
    addGroup(document, 1, "inner", {{0, {tumbled, {3, -40, 7}}}});
    addObject(document, 0, "letter", {}, {{0, letter}});
    addObject(document, 1, "mirrored letter", {mirrored, {30, 0, 0}}, {{0, letter}});
    addObject(document, 2, "tumbled letter", {tumbled, {0, 0, 0}}, {{0, letter}});
    addObject(document, 2, "noise", {mirrored * tumbled, {-3, 2, 1}}, {{0, noise}});
    SceneNode& walker = addObject(document, 0, "walker", {{}, {8, 4, 2}}, {{0, person}, {2, ball}});
    walker.loopModels = true;
    walker.placements.push_back({3, {turned, {9, 4, 2}}});
    walker.loopPlacements = true;
    walker.layer = 0;
    addObject(document, 0, "overlap", {{}, {2, 0, 3}}, {{0, noise}}).locked = true;
    addObject(document, 0, "hidden", {{}, {100, 0, 0}}, {{0, ball}}).hidden = true;
    addObject(document, 0, "in a hidden layer", {{}, {0, 100, 0}}, {{0, ball}}).layer = 1;
    addObject(document, 0, "nothing", {{}, {0, 0, 500}}, {{0, nothing}});
    addGroup(document, 0, "empty group", {{0, {}}});

    document.clips = {Clip{"walk", 0, 3, 12.5, true}, Clip{"stop", 4, 4, 1.0, false}};
    document.sockets = {Socket{"hand", {{0, {1.5, -20.25, 7.0}}}},
                        Socket{"muzzle", {{0, {3.0, 4.0, 5.5}}, {2, {4.0, 4.0, 5.5}}}}};
    document.entity.name = "busy";
    document.entity.anchorVoxels = glm::dvec3(1.5, -2.25, 0.0);
    document.entity.yawDegrees = 30.0;
    document.entity.scale = 1.5;
    document.authored = {0.25, 7.5};
    return document;
}

VoxelMap mapOf(const VoxelGrid& voxels) {
    VoxelMap map;
    voxels.forEachSolid([&](glm::ivec3 v, std::uint8_t value) { map[{v.x, v.y, v.z}] = value; });
    return map;
}

}  // namespace voxprite::test
