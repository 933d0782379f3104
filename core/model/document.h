// A document is what a file holds: models, the scene graph that places them, the palette, and the
// entity that the scene makes. Plain values: copying a document copies it whole.
//
// Model space    integer voxels of one model; placements turn it about its origin.
// Entity space   integer voxels; where the root of the scene graph places everything. Z up.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/box.h"
#include "core/base/check.h"
#include "core/base/result.h"
#include "core/model/palette.h"
#include "core/model/placement.h"
#include "core/model/voxel_grid.h"

namespace voxprite {

// Voxels that objects show; several objects (and frames) may share one model.
struct Model {
    VoxelGrid voxels;
    // The canvas its file declared, kept so that writing gives the file back; empty when none was.
    // Voxels may lie outside (the canvas binds nothing).
    IBox canvas;
    bool operator==(const Model&) const = default;
};

// Frames run from 0 to at most kMaxFrames - 1.
inline constexpr int kMaxFrames = 1 << 16;
inline constexpr int kMaxFrameMilliseconds = 1'000'000;

struct PlacementKey {
    int frame = 0;  // from here on, until the next key
    Placement placement;
    bool operator==(const PlacementKey&) const = default;
};

struct ModelKey {
    int frame = 0;
    int model = 0;  // index into Document::models
    bool operator==(const ModelKey&) const = default;
};

// A node of the scene graph: an object (it has model keys) or a group (it has none).
struct SceneNode {
    std::string name;
    bool hidden = false;
    bool locked = false;
    int layer = -1;             // index into Document::layers; -1 is none
    int parent = -1;            // -1 only for the root, node 0
    std::vector<int> children;  // indices into Document::nodes, in drawing order: later wins
    std::vector<PlacementKey> placements =
        std::vector<PlacementKey>(1);  // ascending frames, at least one
    std::vector<ModelKey> models;      // ascending frames; empty for a group
    // From one key to the next the translation runs evenly, rounded down; turns and mirrors still
    // hold until the next key. This is how objects of .vox files move.
    bool glides = false;
    // The frames from the first key to the last go on for ever, before as after.
    bool loopPlacements = false;
    bool loopModels = false;
    Properties attributes;  // what the file said beyond this, kept for writing

    bool operator==(const SceneNode&) const = default;
    [[nodiscard]] bool isGroup() const { return models.empty(); }
};

struct Layer {
    std::string name;
    bool hidden = false;
    Properties attributes;
    bool operator==(const Layer&) const = default;
};

// A camera or render setting of the file, kept as it was read.
struct KeptRecord {
    int id = 0;
    Properties attributes;
    bool operator==(const KeptRecord&) const = default;
};

// A named run of frames [first, last], played at framesPerSecond.
struct Clip {
    std::string name;
    int first = 0;
    int last = 0;
    double framesPerSecond = 8.0;
    bool loop = true;
    // One for each frame, 1 ... 1,000,000, in place of framesPerSecond; or none.
    std::vector<int> durationsMilliseconds{};
    bool operator==(const Clip&) const = default;
};

// A named point of the entity (hand, muzzle, seat) where the game fastens things.
struct SocketKey {
    int frame = 0;                   // from here on, until the next key
    glm::dvec3 positionVoxels{0.0};  // entity space, continuous
    bool operator==(const SocketKey&) const = default;
};
struct Socket {
    std::string name;
    std::vector<SocketKey> positions = std::vector<SocketKey>(1);  // ascending frames, at least one
    bool operator==(const Socket&) const = default;
};

// The thing that stands in the game. All of a document's visible objects make one entity.
struct Entity {
    std::string name;
    // Which point of entity space (in voxels, continuous) stands at the world position. Not set:
    // the bottom centre of the bounds, which it follows. Any point is allowed, outside too.
    std::optional<glm::dvec3> anchorVoxels;
    // Applied in the order roll, pitch, yaw: about +Y, then +X, then +Z of voxel space, each
    // counter-clockwise seen from the positive end of its axis.
    double yawDegrees = 0.0;
    double pitchDegrees = 0.0;
    double rollDegrees = 0.0;
    double scale = 1.0;              // uniform, 1e-3 ... 1e3
    glm::dvec3 positionMetres{0.0};  // of the anchor, in the Y-up world
    bool operator==(const Entity&) const = default;
};

// The game's values at the time of saving: a record. The game profile in use wins.
struct AuthoredValues {
    double voxelSizeMetres = 0.1;
    double sigma = 4.0;
    bool operator==(const AuthoredValues&) const = default;
};

struct Document {
    Palette palette = Palette::standard();
    std::vector<Model> models;
    std::vector<SceneNode> nodes{SceneNode{}};  // node 0 is the root, a group
    std::vector<Layer> layers;
    std::vector<KeptRecord> cameras;
    std::vector<KeptRecord> renderSettings;
    std::vector<Clip> clips;
    std::vector<Socket> sockets;
    Entity entity;
    AuthoredValues authored;

    bool operator==(const Document&) const = default;

    // Of a model that there is.
    [[nodiscard]] const VoxelGrid& voxelsOf(int model) const {
        VOXPRITE_CHECK(model >= 0 && static_cast<std::size_t>(model) < models.size());
        return models[static_cast<std::size_t>(model)].voxels;
    }

    // One empty model shown by one object.
    [[nodiscard]] static Document withEmptyModel();
};

// Every index in range, the nodes one tree, keys ascending, numbers finite and in range. A document
// from outside (a file) is checked by this before anyone else sees it.
[[nodiscard]] Status validate(const Document& document);
[[nodiscard]] Status validate(const Entity& entity);

}  // namespace voxprite
