// What the chunks of a .vox file say, before it is put together as a document.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/model/document.h"

namespace voxprite {

inline constexpr std::size_t kMaxVoxLayers = 1024;
// Levels of the file's scene graph, in which transforms count like groups and shapes.
inline constexpr int kMaxVoxDepth = 2048;

class VoxFields;

// A node chunk. Its fields stand where the merged SceneNode will have them: a transform fills name,
// hidden, locked, layer and placements; a shape fills models; both fill attributes.
struct VoxNode {
    enum class Kind : std::uint8_t { transform, group, shape };

    Kind kind = Kind::transform;
    int id = 0;
    std::uint64_t offset = 0;  // of the chunk's content, for errors
    SceneNode part;            // layer is still the id of the file
    std::vector<int> links;    // ids: the child of a transform, the children of a group

    [[nodiscard]] std::string name() const { return "node " + std::to_string(id); }
};

// Colours as the chunks give them; what is not there is not set.
struct VoxPaletteChunks {
    std::vector<Rgba8> colours;  // entry i is colour i + 1, at most 255
    std::optional<std::array<std::uint8_t, 256>> displayMap;
    std::vector<std::string> rowNames;  // at most 32, the last row of the palette first
    std::optional<std::array<std::string, 256>> colourNames;
    std::array<Properties, 256> materials;
};

// Warnings in the order of the file; too many are cut off with a sentence that says so.
class VoxWarnings {
  public:
    void add(std::string sentence);
    [[nodiscard]] std::vector<std::string> release() { return std::move(sentences_); }

  private:
    std::vector<std::string> sentences_;
};

struct VoxFile {
    std::vector<Model> models;
    std::vector<VoxNode> nodes;                       // in the order of the file
    std::unordered_map<int, std::size_t> nodeFromId;  // index into nodes
    std::vector<Layer> layers;                        // by id; ids that are missing are blank
    VoxPaletteChunks palette;
    std::vector<KeptRecord> cameras;
    std::vector<KeptRecord> renderSettings;
    VoxWarnings warnings;
};

// The chunks of a whole file (vox_chunks.cpp).
[[nodiscard]] Result<VoxFile> parseVox(ByteView bytes);

// The node chunks (vox_node.cpp). `fields` holds the content of one chunk.
[[nodiscard]] VoxNode parseVoxNode(VoxNode::Kind kind, VoxFields& fields, VoxWarnings& warnings);

// The scene graph as a tree of document nodes, root first (vox_graph.cpp). Nodes that are used more
// than once are copied for each use, within limits. `fileBytes` is the file's length.
[[nodiscard]] Result<std::vector<SceneNode>> sceneFromVox(VoxFile& file, std::uint64_t fileBytes);

// Colours, display order, names and materials (vox_palette.cpp).
void parseVoxColours(VoxFields& fields, VoxPaletteChunks& palette, VoxWarnings& warnings);
void parseVoxDisplayMap(VoxFields& fields, VoxPaletteChunks& palette);
void parseVoxRowNames(VoxFields& fields, VoxPaletteChunks& palette, VoxWarnings& warnings);
void parseVoxColourNames(VoxFields& fields, VoxPaletteChunks& palette);
void parseVoxMaterial(VoxFields& fields, VoxPaletteChunks& palette, VoxWarnings& warnings);
void parseVoxOldMaterial(VoxFields& fields, VoxPaletteChunks& palette, VoxWarnings& warnings);
[[nodiscard]] Palette paletteFromVox(VoxPaletteChunks chunks, VoxWarnings& warnings);
void writeVoxPalette(ByteWriter& out, const Palette& palette);
void writeVoxNames(ByteWriter& out, const Palette& palette);

}  // namespace voxprite
