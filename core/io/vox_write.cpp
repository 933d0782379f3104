// The writer: version 200, chunks in the order in which MagicaVoxel writes them.

#include <algorithm>
#include <glm/common.hpp>
#include <limits>
#include <optional>
#include <set>

#include "core/io/vox.h"
#include "core/io/vox_fields.h"
#include "core/io/vox_file.h"
#include "core/io/vox_pieces.h"

namespace voxprite {

namespace {

// Attributes of a node, sorted back into the chunks and entries that they were read from.
struct AttributesByPlace {
    Properties transform;
    Properties child;  // of the group or the shape
    std::vector<Properties> frames;
    std::vector<Properties> models;
};

// The entry of a track and the key in "3/_key", where there is such an entry.
Properties* entryOf(std::vector<Properties>& entries, std::string_view& key) {
    const std::size_t slash = key.find('/');
    if (slash == std::string_view::npos) return nullptr;
    const std::optional<int> index = wholeNumber(key.substr(0, slash));
    if (!index || *index < 0 || static_cast<std::size_t>(*index) >= entries.size()) return nullptr;
    key.remove_prefix(slash + 1);
    return &entries[static_cast<std::size_t>(*index)];
}

// A key that has a field of its own at its place stays among those of the transform.
AttributesByPlace attributesByPlace(const SceneNode& node) {
    using Keys = std::set<std::string_view>;
    AttributesByPlace result;
    result.frames.resize(node.placements.size());
    result.models.resize(node.models.size());
    const std::string_view childPrefix = node.isGroup() ? "group/" : "shape/";
    for (const auto& [name, value] : node.attributes) {
        std::string_view key = name;
        const auto takePrefix = [&](std::string_view prefix) {
            if (!key.starts_with(prefix)) return false;
            key.remove_prefix(prefix.size());
            return true;
        };
        Properties* place = nullptr;
        Keys taken;
        if (takePrefix(childPrefix)) {
            place = &result.child;
            if (!node.isGroup()) taken = {"_loop"};
        } else if (takePrefix("frame/")) {
            place = entryOf(result.frames, key);
            taken = {"_f", "_r", "_t"};
        } else if (takePrefix("model/")) {
            place = entryOf(result.models, key);
            taken = {"_f"};
        }
        if (place && !taken.contains(key)) {
            place->emplace(key, value);
        } else {
            result.transform.emplace(name, value);
        }
    }
    return result;
}

// Attributes may not say again what a field says.
Status checkAttributes(const Document& document) {
    const auto check = [](const Properties& properties, const std::string& owner,
                          std::initializer_list<const char*> taken) -> Status {
        for (const char* key : taken) {
            if (properties.contains(key)) {
                return fail(owner + ": the attribute " + key + " has a field of its own");
            }
        }
        return {};
    };
    for (std::size_t i = 0; i < document.nodes.size(); ++i) {
        if (Status s = check(document.nodes[i].attributes, "node " + std::to_string(i),
                             {"_name", "_hidden", "_locked", "_loop"});
            !s) {
            return s;
        }
    }
    for (std::size_t i = 0; i < document.layers.size(); ++i) {
        if (Status s = check(document.layers[i].attributes, "layer " + std::to_string(i),
                             {"_name", "_hidden"});
            !s) {
            return s;
        }
    }
    return {};
}

Status checkLimits(const Document& document) {
    if (document.layers.size() > kMaxVoxLayers) {
        return fail("a .vox file cannot hold more than " + std::to_string(kMaxVoxLayers) +
                    " layers");
    }
    // A level of the document is two of the file, and a split model adds two.
    std::vector<std::pair<int, int>> open{{0, 1}};  // node, level
    while (!open.empty()) {
        const auto [node, level] = open.back();
        open.pop_back();
        if (2 * level + 2 > kMaxVoxDepth) {
            return fail("a .vox file cannot hold nodes nested deeper than " +
                        std::to_string(kMaxVoxDepth / 2 - 1) + " levels");
        }
        for (const int child : document.nodes[static_cast<std::size_t>(node)].children) {
            open.emplace_back(child, level + 1);
        }
    }
    return {};
}

class SceneWriter {
  public:
    SceneWriter(ByteWriter& out, const Document& document, VoxPieces& pieces)
        : out_(out),
          document_(document),
          pieces_(pieces),
          nextId_(static_cast<int>(2 * document.nodes.size())) {}

    // An empty model is needed where a split model is not shown in every frame.
    void addEmptyPieceIfNeeded() {
        for (const SceneNode& node : document_.nodes) {
            if (node.models.size() > 1 && !pivotOf(node)) {
                emptyPiece_ = static_cast<int>(pieces_.pieces.size());
                pieces_.pieces.emplace_back();
                return;
            }
        }
    }

    // Node i of the document is the transform 2 i and the group or shape 2 i + 1; the chunks come
    // in the order of the document, which is how the reader finds that order again.
    void write() {
        for (std::size_t i = 0; i < document_.nodes.size(); ++i) {
            const SceneNode& node = document_.nodes[i];
            const AttributesByPlace attributes = attributesByPlace(node);
            const auto id = static_cast<int>(2 * i);
            writeTransform(node, attributes, id);
            if (!node.isGroup()) {
                writeModels(node, attributes, id + 1);
                continue;
            }
            std::vector<int> childIds = node.children;
            for (int& child : childIds) child *= 2;
            writeGroup(attributes.child, id + 1, childIds);
        }
    }

  private:
    const std::vector<PlacedPiece>& piecesOfModel(int model) const {
        return pieces_.ofModel[static_cast<std::size_t>(model)];
    }

    // Where the one piece of each of the node's models lies, if it is the same place for all and
    // the node's transform can say it: then the node needs no objects below it.
    std::optional<glm::ivec3> pivotOf(const SceneNode& node) const {
        if (node.isGroup()) return glm::ivec3(0);
        std::optional<glm::ivec3> pivot;
        for (const ModelKey& key : node.models) {
            const std::vector<PlacedPiece>& placed = piecesOfModel(key.model);
            if (placed.size() != 1 || placed[0].pivot != pivot.value_or(placed[0].pivot)) {
                return std::nullopt;
            }
            pivot = placed[0].pivot;
        }
        if (*pivot == glm::ivec3(0)) return pivot;
        const SignedPermutation& first = node.placements[0].placement.rotation;
        for (const PlacementKey& key : node.placements) {
            // A turn about another pivot would glide along another way.
            if (node.glides && key.placement.rotation != first) return std::nullopt;
            const glm::ivec3 t = movedTo(*pivot, key.placement).translation;
            if (t != glm::clamp(t, -kMaxCoordinate, kMaxCoordinate)) return std::nullopt;
        }
        return pivot;
    }

    // Other programs look up the layer of an object without asking whether it has one, and
    // MagicaVoxel leaves none without.
    int layerOf(const SceneNode& node) const {
        if (node.isGroup() || node.layer >= 0) return node.layer;
        const auto seen = std::ranges::find(document_.layers, false, &Layer::hidden);
        if (seen == document_.layers.end()) return node.layer;
        return static_cast<int>(seen - document_.layers.begin());
    }

    static Placement movedTo(glm::ivec3 pivot, const Placement& placement) {
        return placement * Placement{{}, pivot};
    }

    void writeTransform(const SceneNode& node, const AttributesByPlace& attributes, int id) {
        Properties own = attributes.transform;
        if (!node.name.empty()) own["_name"] = node.name;
        if (node.hidden) own["_hidden"] = "1";
        if (node.locked) own["_locked"] = "1";
        if (node.loopPlacements) own["_loop"] = "1";
        const bool animated = node.placements.size() > 1 || node.placements[0].frame != 0;
        const glm::ivec3 pivot = pivotOf(node).value_or(glm::ivec3(0));
        std::vector<Properties> frames;
        const auto addKey = [&](int frame, const Placement& placement, Properties properties) {
            if (animated) properties["_f"] = std::to_string(frame);
            if (placement.rotation != SignedPermutation{}) {
                properties["_r"] = std::to_string(placement.rotation.toVoxByte());
            }
            const glm::ivec3 t = movedTo(pivot, placement).translation;
            if (t != glm::ivec3(0)) properties["_t"] = textFromVector(t);
            frames.push_back(std::move(properties));
        };
        for (std::size_t i = 0; i < node.placements.size(); ++i) {
            const auto& [frame, placement] = node.placements[i];
            addKey(frame, placement, attributes.frames[i]);
            if (i + 1 == node.placements.size()) break;
            // What stands still until it jumps must be told to.
            const PlacementKey& next = node.placements[i + 1];
            if (!node.glides && next.frame > frame + 1 &&
                movedTo(pivot, next.placement).translation !=
                    movedTo(pivot, placement).translation) {
                addKey(next.frame - 1, placement, {});
            }
        }
        writeTransformChunk(id, own, layerOf(node), frames);
    }

    void writeTransformChunk(int id, const Properties& attributes, int layer,
                             const std::vector<Properties>& frames) {
        writeChunk(out_, "nTRN", [&] {
            out_.i32(id);
            writeProperties(out_, attributes);
            out_.i32(id + 1);
            out_.i32(-1);
            out_.i32(layer);
            out_.u32(static_cast<std::uint32_t>(frames.size()));
            for (const Properties& frame : frames) writeProperties(out_, frame);
        });
    }

    void writeGroup(const Properties& attributes, int id, const std::vector<int>& childIds) {
        writeChunk(out_, "nGRP", [&] {
            out_.i32(id);
            writeProperties(out_, attributes);
            out_.u32(static_cast<std::uint32_t>(childIds.size()));
            for (const int child : childIds) out_.i32(child);
        });
    }

    void writeShape(int id, Properties attributes, bool loop, const std::vector<ModelKey>& keys,
                    const std::vector<Properties>& ofKeys) {
        if (loop) attributes["_loop"] = "1";
        const bool animated = keys.size() > 1 || keys[0].frame != 0;
        writeChunk(out_, "nSHP", [&] {
            out_.i32(id);
            writeProperties(out_, attributes);
            out_.u32(static_cast<std::uint32_t>(keys.size()));
            for (std::size_t i = 0; i < keys.size(); ++i) {
                out_.i32(keys[i].model);
                Properties own = ofKeys[i];
                if (animated) own["_f"] = std::to_string(keys[i].frame);
                writeProperties(out_, own);
            }
        });
    }

    void writeModels(const SceneNode& node, const AttributesByPlace& attributes, int id) {
        if (!pivotOf(node)) {
            writeSplitModels(node, attributes, id);
            return;
        }
        std::vector<ModelKey> keys = node.models;
        for (ModelKey& key : keys) key.model = piecesOfModel(key.model)[0].piece;
        writeShape(id, attributes.child, node.loopModels, keys, attributes.models);
    }

    // A group with one object for each place where any of the models has a piece. Each object has
    // all the keys of the node, and shows nothing where its place belongs to no piece.
    void writeSplitModels(const SceneNode& node, const AttributesByPlace& attributes, int id) {
        std::set<std::array<int, 3>> pivots;
        for (const ModelKey& key : node.models) {
            for (const PlacedPiece& placed : piecesOfModel(key.model)) {
                pivots.insert({placed.pivot.x, placed.pivot.y, placed.pivot.z});
            }
        }
        std::vector<int> ids;
        for (std::size_t i = 0; i < pivots.size(); ++i) {
            ids.push_back(nextId_);
            nextId_ += 2;
        }
        writeGroup({}, id, ids);
        auto next = ids.begin();
        for (const auto& [x, y, z] : pivots) {
            const glm::ivec3 pivot(x, y, z);
            std::vector<ModelKey> keys = node.models;
            for (ModelKey& key : keys) key.model = pieceAt(key.model, pivot);
            Properties frame;
            if (pivot != glm::ivec3(0)) frame["_t"] = textFromVector(pivot);
            writeTransformChunk(*next, {}, layerOf(node), {frame});
            writeShape(*next + 1, attributes.child, node.loopModels, keys, attributes.models);
            ++next;
        }
    }

    int pieceAt(int model, glm::ivec3 pivot) const {
        const std::vector<PlacedPiece>& placed = piecesOfModel(model);
        const auto found =
            std::find_if(placed.begin(), placed.end(),
                         [&](const PlacedPiece& piece) { return piece.pivot == pivot; });
        return found == placed.end() ? emptyPiece_ : found->piece;
    }

    static std::string textFromVector(glm::ivec3 v) {
        return std::to_string(v.x) + " " + std::to_string(v.y) + " " + std::to_string(v.z);
    }

    ByteWriter& out_;
    const Document& document_;
    VoxPieces& pieces_;
    int nextId_;
    int emptyPiece_ = -1;
};

void writePiece(ByteWriter& out, const VoxPiece& piece) {
    writeChunk(out, "SIZE", [&] {
        for (int axis = 0; axis < 3; ++axis) out.i32(piece.size[axis]);
    });
    writeChunk(out, "XYZI", [&] {
        out.u32(static_cast<std::uint32_t>(piece.voxels.size() / 4));
        out.raw(ByteView(piece.voxels));
    });
}

void writeLayer(ByteWriter& out, const Layer& layer, std::size_t id) {
    Properties attributes = layer.attributes;
    if (!layer.name.empty()) attributes["_name"] = layer.name;
    if (layer.hidden) attributes["_hidden"] = "1";
    writeChunk(out, "LAYR", [&] {
        out.u32(static_cast<std::uint32_t>(id));
        writeProperties(out, attributes);
        out.i32(-1);
    });
}

}  // namespace

std::vector<std::string> voxLosses(const Document& document) {
    const auto cut = std::ranges::count_if(document.models, [](const Model& model) {
        const glm::ivec3 size = model.voxels.bounds().size();
        return std::max({size.x, size.y, size.z}) > kMaxVoxEdge;
    });
    if (cut == 0) return {};
    const std::string edge = std::to_string(kMaxVoxEdge);
    return {".vox has models of at most " + edge + " voxels an edge: " + std::to_string(cut) +
            (cut == 1 ? " model is" : " models are") +
            " written in pieces, each an object of its own"};
}

Result<Bytes> writeVox(const Document& document) {
    if (Status s = validate(document); !s) return tl::unexpected(s.error());
    if (Status s = checkAttributes(document); !s) return tl::unexpected(s.error());
    if (Status s = checkLimits(document); !s) return tl::unexpected(s.error());
    Result<VoxPieces> pieces = piecesOf(document);
    if (!pieces) return tl::unexpected(pieces.error());

    ByteWriter out;
    SceneWriter scene(out, document, *pieces);
    scene.addEmptyPieceIfNeeded();
    out.raw("VOX ");
    out.u32(200);
    out.raw("MAIN");
    out.u32(0);
    const std::size_t childBytes = out.size();
    out.u32(0);
    const std::size_t children = out.size();
    for (const VoxPiece& piece : pieces->pieces) writePiece(out, piece);
    scene.write();
    for (std::size_t i = 0; i < document.layers.size(); ++i) {
        writeLayer(out, document.layers[i], i);
    }
    writeVoxPalette(out, document.palette);
    for (const KeptRecord& setting : document.renderSettings) {
        writeChunk(out, "rOBJ", [&] { writeProperties(out, setting.attributes); });
    }
    for (const KeptRecord& camera : document.cameras) {
        writeChunk(out, "rCAM", [&] {
            out.i32(camera.id);
            writeProperties(out, camera.attributes);
        });
    }
    writeVoxNames(out, document.palette);
    if (out.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
        return fail("the .vox file would be larger than 2 GiB");
    }
    out.patchU32(childBytes, static_cast<std::uint32_t>(out.size() - children));
    return out.release();
}

}  // namespace voxprite
