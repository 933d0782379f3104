// The node chunks of the scene graph: nTRN, nGRP, nSHP.

#include <algorithm>
#include <sstream>

#include "core/io/vox_fields.h"
#include "core/io/vox_file.h"
#include "core/model/entity_voxels.h"

namespace voxprite {

namespace {

template <class Key>
struct TrackEntry {
    Key key;
    Properties rest;  // attributes that are not understood
};

// Without _f an entry holds from the frame of its own position, as in files before animation.
int takeFrame(Properties& attributes, std::size_t position, const VoxNode& node, std::uint64_t at,
              VoxFields& fields) {
    const std::optional<std::string> text = takeProperty(attributes, "_f");
    const std::optional<int> frame =
        text ? wholeNumber(*text) : static_cast<int>(std::min<std::size_t>(position, kMaxFrames));
    if (frame && *frame >= 0 && *frame < kMaxFrames) return *frame;
    fields.refuse(at, node.name() + ": the frame \"" + text.value_or(std::to_string(position)) +
                          "\" is no number of 0 ... " + std::to_string(kMaxFrames - 1));
    return 0;
}

std::optional<glm::ivec3> translationFromText(const std::string& text) {
    std::istringstream words(text);
    glm::ivec3 result{0};
    for (int axis = 0; axis < 3; ++axis) {
        std::string word;
        if (!(words >> word)) return std::nullopt;
        const std::optional<int> value = wholeNumber(word);
        if (!value || *value < -kMaxCoordinate || *value > kMaxCoordinate) return std::nullopt;
        result[axis] = *value;
    }
    std::string more;
    if (words >> more) return std::nullopt;
    return result;
}

Placement takePlacement(Properties& attributes, const VoxNode& node, std::uint64_t at,
                        VoxFields& fields) {
    Placement placement;
    if (const std::optional<std::string> text = takeProperty(attributes, "_r")) {
        const std::optional<int> byte = wholeNumber(*text);
        const Result<SignedPermutation> rotation =
            byte ? SignedPermutation::fromVoxByte(*byte) : fail("not a number");
        if (rotation) {
            placement.rotation = *rotation;
        } else {
            fields.refuse(at, node.name() + ": the rotation \"" + *text + "\" is none");
        }
    }
    if (const std::optional<std::string> text = takeProperty(attributes, "_t")) {
        if (const std::optional<glm::ivec3> translation = translationFromText(*text)) {
            placement.translation = *translation;
        } else {
            fields.refuse(at, node.name() + ": the translation \"" + *text +
                                  "\" is not three whole numbers within +-" +
                                  std::to_string(kMaxCoordinate));
        }
    }
    return placement;
}

// The keys in ascending order, one a frame; what their attributes say beyond them goes to the node.
template <class Key>
std::vector<Key> keysFromTrack(std::vector<TrackEntry<Key>> track, const char* prefix,
                               VoxNode& node, VoxWarnings& warnings) {
    std::stable_sort(track.begin(), track.end(),
                     [](const auto& a, const auto& b) { return a.key.frame < b.key.frame; });
    std::vector<Key> keys;
    for (std::size_t i = 0; i < track.size(); ++i) {
        if (i + 1 < track.size() && track[i + 1].key.frame == track[i].key.frame) {
            warnings.add(node.name() + " has several keys for frame " +
                         std::to_string(track[i].key.frame) + "; the last one counts");
            continue;
        }
        for (auto& [key, value] : track[i].rest) {
            node.part.attributes[prefix + std::to_string(keys.size()) + "/" + key] =
                std::move(value);
        }
        keys.push_back(track[i].key);
    }
    return keys;
}

void parseTransform(VoxNode& node, VoxFields& fields, VoxWarnings& warnings) {
    SceneNode& part = node.part;
    part.attributes = fields.properties("a transform's attributes");
    part.name = takeProperty(part.attributes, "_name").value_or("");
    part.hidden = takeSwitch(part.attributes, "_hidden");
    part.locked = takeSwitch(part.attributes, "_locked");
    part.loopPlacements = takeSwitch(part.attributes, "_loop");
    node.links = {fields.i32("a transform's child")};
    (void)fields.i32("a transform's reserved id");
    part.layer = fields.i32("a transform's layer");

    std::vector<TrackEntry<PlacementKey>> track;
    const std::uint32_t frames = fields.count(4, "a transform's frames");
    for (std::size_t i = 0; i < frames && fields.ok(); ++i) {
        const std::uint64_t at = fields.offset();
        TrackEntry<PlacementKey> entry;
        entry.rest = fields.properties("a transform's frame");
        entry.key.frame = takeFrame(entry.rest, i, node, at, fields);
        entry.key.placement = takePlacement(entry.rest, node, at, fields);
        track.push_back(std::move(entry));
    }
    if (!fields.ok()) return;
    if (track.empty()) {
        warnings.add(node.name() + " has no frame; it stays where it is");
        track.emplace_back();
    }
    part.placements = keysFromTrack(std::move(track), "frame/", node, warnings);
    part.glides = true;
    part.glides = movesBetweenKeys(part);  // said of those alone that do
}

void parseGroup(VoxNode& node, VoxFields& fields) {
    for (auto& [key, value] : fields.properties("a group's attributes")) {
        node.part.attributes["group/" + key] = value;
    }
    const std::uint32_t children = fields.count(4, "a group's children");
    for (std::uint32_t i = 0; i < children && fields.ok(); ++i) {
        node.links.push_back(fields.i32("a group's children"));
    }
}

void parseShape(VoxNode& node, VoxFields& fields, VoxWarnings& warnings) {
    Properties attributes = fields.properties("a shape's attributes");
    node.part.loopModels = takeSwitch(attributes, "_loop");
    for (auto& [key, value] : attributes) node.part.attributes["shape/" + key] = value;

    std::vector<TrackEntry<ModelKey>> track;
    const std::uint32_t models = fields.count(8, "a shape's models");
    for (std::size_t i = 0; i < models && fields.ok(); ++i) {
        const std::uint64_t at = fields.offset();
        TrackEntry<ModelKey> entry;
        entry.key.model = fields.i32("a shape's model");
        entry.rest = fields.properties("a shape's model attributes");
        entry.key.frame = takeFrame(entry.rest, i, node, at, fields);
        track.push_back(std::move(entry));
    }
    if (track.empty()) warnings.add(node.name() + " is a shape without a model");
    node.part.models = keysFromTrack(std::move(track), "model/", node, warnings);
}

}  // namespace

VoxNode parseVoxNode(VoxNode::Kind kind, VoxFields& fields, VoxWarnings& warnings) {
    VoxNode node;
    node.kind = kind;
    node.offset = fields.offset();
    node.id = fields.i32("a node's id");
    switch (kind) {
        case VoxNode::Kind::transform:
            parseTransform(node, fields, warnings);
            break;
        case VoxNode::Kind::group:
            parseGroup(node, fields);
            break;
        case VoxNode::Kind::shape:
            parseShape(node, fields, warnings);
            break;
    }
    return node;
}

}  // namespace voxprite
