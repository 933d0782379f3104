#include "core/model/document.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "tests/support/voxels.h"

namespace voxprite {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::string messageFor(const std::function<void(Document&)>& change) {
    Document document = test::busyDocument();
    change(document);
    const Status status = validate(document);
    return status ? "valid" : status.error().describe();
}

std::string messageForEntity(const std::function<void(Entity&)>& change) {
    return messageFor([&](Document& d) { change(d.entity); });
}

TEST(Document, FixturesAreValid) {
    EXPECT_EQ(messageFor([](Document&) {}), "valid");
    EXPECT_TRUE(validate(Document{}));
    EXPECT_TRUE(validate(Document::withEmptyModel()));
    EXPECT_TRUE(validate(test::documentOf(test::figure())));
    EXPECT_TRUE(validate(test::animationOf({test::figure(), test::asymmetric()})));
}

TEST(Document, IsAValue) {
    const Document a = test::busyDocument();
    Document b = a;
    EXPECT_EQ(a, b);
    b.models[0].voxels.set({0, 0, 0}, 99);
    EXPECT_FALSE(a == b);
    EXPECT_EQ(a, test::busyDocument());
}

TEST(Document, IndicesMustBeInRange) {
    EXPECT_EQ(messageFor([](Document& d) { d.nodes[3].models[0].model = 5; }),
              "node 3 (\"letter\"): model 5 does not exist; there are 5");
    EXPECT_EQ(messageFor([](Document& d) { d.nodes[3].models[0].model = -1; }),
              "node 3 (\"letter\"): model -1 does not exist; there are 5");
    EXPECT_EQ(messageFor([](Document& d) { d.nodes[3].layer = 2; }),
              "node 3 (\"letter\"): layer 2 does not exist; there are 2");
    EXPECT_EQ(messageFor([](Document& d) { d.nodes[1].children.push_back(77); }),
              "node 1 (\"left\"): child 77 does not exist; there are 13");
}

TEST(Document, TheNodesMustBeOneTree) {
    EXPECT_EQ(messageFor([](Document& d) { d.nodes.clear(); }),
              "there is no node; node 0 must be the root");
    EXPECT_EQ(messageFor([](Document& d) { d.nodes[0].parent = 1; }),
              "node 0 is the root; its parent must be -1");
    EXPECT_EQ(messageFor([](Document& d) { d.nodes[0].models = {ModelKey{}}; }),
              "node 0 (\"root\"): it is an object and has children; only groups have");
    EXPECT_EQ(messageFor([](Document& d) { d.nodes[2].parent = 0; }),
              "node 2 (\"inner\"): its parent is 0, but it is a child of node 1");
    EXPECT_EQ(messageFor([](Document& d) { d.nodes[0].children.push_back(3); }),
              "node 3 (\"letter\"): it is a child twice");
    EXPECT_EQ(messageFor([](Document& d) { d.nodes[0].children.pop_back(); }),
              "node 12 (\"empty group\"): it does not hang on the root");
    EXPECT_EQ(messageFor([](Document& d) {
                  // A ring beside the tree: each is the other's child.
                  SceneNode node = d.nodes.back();
                  node.name = "a";
                  node.parent = 14;
                  node.children = {14};
                  d.nodes.push_back(node);
                  node.parent = 13;
                  node.children = {13};
                  d.nodes.push_back(node);
              }),
              "node 13 (\"a\"): it does not hang on the root");
    EXPECT_EQ(messageFor([](Document& d) {
                  d.nodes[0].children.clear();
                  d.nodes.resize(1);
                  d.nodes[0].models = {ModelKey{}};
              }),
              "node 0 is the root and must be a group");
    EXPECT_EQ(messageFor([](Document& d) { d.nodes[2].children.push_back(0); }),
              "node 2 (\"inner\"): child 0 does not exist; there are 13");
}

TEST(Document, AVeryDeepTreeIsNoProblem) {
    Document document = Document::withEmptyModel();
    document.nodes.resize(1);
    document.nodes[0].children.clear();
    constexpr int kDepth = 100'000;
    for (int i = 1; i <= kDepth; ++i) {
        document.nodes.back().children = {i};
        SceneNode node;
        node.parent = i - 1;
        document.nodes.push_back(std::move(node));
    }
    EXPECT_TRUE(validate(document));
}

TEST(Document, KeysMustAscend) {
    EXPECT_EQ(messageFor([](Document& d) { d.nodes[7].models[1].frame = 0; }),
              "node 7 (\"walker\"): models: frame 0 follows frame 0; frames must ascend");
    EXPECT_EQ(messageFor([](Document& d) { d.nodes[7].placements[0].frame = -1; }),
              "node 7 (\"walker\"): placements: frame -1 is outside 0 ... 65535");
    EXPECT_EQ(messageFor([](Document& d) { d.nodes[7].placements[1].frame = kMaxFrames; }),
              "node 7 (\"walker\"): placements: frame 65536 is outside 0 ... 65535");
    EXPECT_EQ(messageFor([](Document& d) { d.nodes[7].placements.clear(); }),
              "node 7 (\"walker\"): it has no placement");
}

TEST(Document, PlacementsMustBeSignedPermutations) {
    const std::string message =
        "node 3 (\"letter\"): the rotation at frame 0 is none of the 48 signed permutations";
    EXPECT_EQ(messageFor([](Document& d) {
                  d.nodes[3].placements[0].placement.rotation.axis = {0, 0, 2};
              }),
              message);
    EXPECT_EQ(messageFor([](Document& d) {
                  d.nodes[3].placements[0].placement.rotation.axis = {0, 1, 3};
              }),
              message);
    EXPECT_EQ(messageFor([](Document& d) {
                  d.nodes[3].placements[0].placement.rotation.sign = {0, 1, 1};
              }),
              message);
}

TEST(Document, NothingMayReachBeyondTheCoordinates) {
    const auto move = [](Document& d, std::size_t node, int x) {
        d.nodes[node].placements[0].placement.translation.x = x;
    };
    EXPECT_EQ(messageFor([&](Document& d) { move(d, 3, kMaxCoordinate + 1); }),
              "node 3 (\"letter\"): the translation at frame 0 is beyond +-16777216 voxels");
    EXPECT_EQ(messageFor([&](Document& d) { move(d, 3, kMaxCoordinate - 5); }),
              "node 3 (\"letter\"): its placements reach beyond +-16777216 voxels");
    EXPECT_EQ(messageFor([&](Document& d) { move(d, 3, kMaxCoordinate - 50); }), "valid");
    // Half by the group, half by the object in it.
    EXPECT_EQ(messageFor([&](Document& d) {
                  move(d, 1, kMaxCoordinate / 2);
                  move(d, 4, -kMaxCoordinate / 2);
              }),
              "node 4 (\"mirrored letter\"): its placements reach beyond +-16777216 voxels");
    EXPECT_EQ(messageFor([](Document& d) { d.models[2].canvas.max.y = kMaxCoordinate + 2; }),
              "valid");
    EXPECT_EQ(messageFor([](Document& d) {
                  d.models[2].canvas = {{0, 0, 0}, {1, kMaxCoordinate + 2, 1}};
              }),
              "model 2: its canvas reaches beyond +-16777216 voxels");
}

TEST(Document, PaletteRules) {
    EXPECT_EQ(messageFor([](Document& d) { d.palette.colours[0] = Rgba8(1, 0, 0, 0); }),
              "palette.colours[0] must be transparent black: index 0 is empty");
    EXPECT_EQ(messageFor([](Document& d) { d.palette.displayOrder[5] = 6; }),
              "palette.displayOrder is not a permutation of 0..255");
    EXPECT_EQ(messageFor([](Document& d) {
                  std::swap(d.palette.displayOrder[0], d.palette.displayOrder[1]);
              }),
              "palette.displayOrder[0] must be 0");
}

TEST(Document, ClipsMustLieWithinTheFrames) {
    EXPECT_EQ(messageFor([](Document& d) { d.clips[1].last = 5; }),
              "clip 1 (\"stop\"): frames 4 ... 5 are not within 0 ... 4");
    EXPECT_EQ(messageFor([](Document& d) { d.clips[0].first = 4; }),
              "clip 0 (\"walk\"): frames 4 ... 3 are not within 0 ... 4");
    EXPECT_EQ(messageFor([](Document& d) { d.clips[0].framesPerSecond = 0; }),
              "clip 0 (\"walk\"): framesPerSecond is 0; it must be between 0.001 and 1000");
    EXPECT_NE(messageFor([](Document& d) { d.clips[0].framesPerSecond = kNan; }), "valid");
}

TEST(Document, AClipHasOneDurationAFrame) {
    const auto withDurations = [](std::vector<int> durations) {
        return messageFor([&](Document& d) { d.clips[0].durationsMilliseconds = durations; });
    };
    EXPECT_EQ(withDurations({1, 2, 3, 1'000'000}), "valid");
    EXPECT_EQ(withDurations({1, 2, 3}), "clip 0 (\"walk\"): it has not one duration a frame");
    EXPECT_EQ(withDurations({1, 2, 3, 0}),
              "clip 0 (\"walk\"): a frame of 0 ms; it must be 1 ... 1000000");
    EXPECT_NE(withDurations({1, 2, 3, 1'000'001}), "valid");
}

TEST(Document, SocketsHaveAPositionInEveryFrame) {
    EXPECT_EQ(messageFor([](Document& d) { d.sockets[0].positions.clear(); }),
              "socket 0 (\"hand\"): it has no position");
    EXPECT_EQ(messageFor([](Document& d) { d.sockets[1].positions[0].frame = 2; }),
              "socket 1 (\"muzzle\"): positions: frame 2 follows frame 2; frames must ascend");
    EXPECT_EQ(messageFor([](Document& d) { d.sockets[0].positions[0].positionVoxels.z = 2e7; }),
              "socket 0 (\"hand\"): position.z is 2e+07; it must be between -1e+07 and 1e+07");
    EXPECT_NE(messageFor([](Document& d) { d.sockets[0].positions[0].positionVoxels.x = kNan; }),
              "valid");
}

TEST(Document, EntityAndAuthoredValuesHaveRanges) {
    EXPECT_EQ(messageForEntity([](Entity& e) { e.scale = 0; }),
              "entity.scale is 0; it must be between 0.001 and 1000");
    EXPECT_NE(messageForEntity([](Entity& e) { e.scale = kNan; }), "valid");
    EXPECT_EQ(messageForEntity([](Entity& e) { e.scale = 1e3; }), "valid");
    EXPECT_EQ(messageForEntity([](Entity& e) { e.scale = 1e-3; }), "valid");
    EXPECT_EQ(messageForEntity([](Entity& e) { e.anchorVoxels = glm::dvec3(0.0, 1e8, 0.0); }),
              "entity.anchorVoxels.y is 1e+08; it must be between -1e+07 and 1e+07");
    EXPECT_EQ(messageForEntity([](Entity& e) { e.positionMetres.z = -2e12; }),
              "entity.positionMetres.z is -2e+12; it must be between -1e+12 and 1e+12");
    EXPECT_NE(messageForEntity([](Entity& e) { e.yawDegrees = kNan; }), "valid");
    EXPECT_NE(messageForEntity([](Entity& e) { e.pitchDegrees = 1e300; }), "valid");
    EXPECT_NE(messageForEntity([](Entity& e) { e.rollDegrees = -HUGE_VAL; }), "valid");
    EXPECT_EQ(messageFor([](Document& d) { d.authored.sigma = 65; }),
              "authored.sigma is 65; it must be between 1/64 and 64");
    EXPECT_EQ(messageFor([](Document& d) { d.authored.voxelSizeMetres = 0; }),
              "authored.voxelSizeMetres is 0; it must be between 1e-6 and 1e6 metres");
}

}  // namespace
}  // namespace voxprite
