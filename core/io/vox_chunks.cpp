// The chunks of a .vox file, one after the other.

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/io/vox_fields.h"
#include "core/io/vox_file.h"

namespace voxprite {

namespace {

constexpr int kOfficialSize = 256;
constexpr int kMaxSize = 2048;
constexpr std::size_t kMaxWarnings = 64;

// What the grid of a model takes, roughly: a block of 8 x 8 x 8 voxels, and inner nodes in each of
// the eight octants around the pivot.
constexpr std::uint64_t kBytesPerBlock = 640;
constexpr std::uint64_t kBytesPerModel = 8 * 9000;
constexpr std::uint64_t kBlockAllowance = std::uint64_t{1} << 30;

struct ChunkHeader {
    std::string id;
    std::uint64_t offset = 0;  // of the id
    std::uint32_t contentBytes = 0;
    std::uint32_t childBytes = 0;
};

std::string printable(ByteView id) {
    const bool plain =
        std::all_of(id.begin(), id.end(), [](std::uint8_t c) { return c >= 0x20 && c < 0x7F; });
    if (plain) return {id.begin(), id.end()};
    std::string hex;
    for (const std::uint8_t c : id) {
        char digits[4];
        std::snprintf(digits, sizeof(digits), "%02x", c);
        hex += (hex.empty() ? "" : " ") + std::string(digits);
    }
    return hex;
}

Failure notVox(ByteView bytes) {
    if (bytes.empty()) return failAtByte(0, "the file is empty");
    // Slab6: three sizes, a byte a voxel, 256 colours of three bytes.
    ByteReader reader(bytes);
    std::uint64_t slab6Bytes = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const std::uint32_t size = reader.u32("").value_or(0);
        slab6Bytes = size > 0 && size <= 4096 ? slab6Bytes * size : 0;
    }
    if (slab6Bytes > 0 && slab6Bytes + 12 + 768 == bytes.size()) {
        return failAtByte(0,
                          "this is a .vox of Slab6, another format of the same name; only those of "
                          "MagicaVoxel can be read");
    }
    return failAtByte(0, "not a MagicaVoxel file: it does not begin with \"VOX \"");
}

Result<ChunkHeader> readHeader(ByteReader& reader) {
    ChunkHeader header;
    header.offset = reader.offset();
    const Result<ByteView> fields = reader.take(12, "a chunk's header");
    if (!fields) return tl::unexpected(fields.error());
    header.id = printable(fields->first(4));
    ByteReader lengths(fields->subspan(4));
    header.contentBytes = lengths.u32("").value_or(0);
    header.childBytes = lengths.u32("").value_or(0);
    const std::uint64_t claimed = std::uint64_t{header.contentBytes} + header.childBytes;
    if (claimed > reader.remaining()) {
        return failAtByte(header.offset, "chunk " + header.id + " claims " +
                                             std::to_string(claimed) + " bytes, but only " +
                                             std::to_string(reader.remaining()) + " follow");
    }
    return header;
}

// Counts the blocks that the voxels of one model fall into. Positions are bytes.
class BlockCount {
  public:
    explicit BlockCount(glm::ivec3 pivot) : shift_(7 - (pivot + 7) % 8) {}

    void add(glm::ivec3 position) {
        const glm::ivec3 block = (position + shift_) / 8;
        const auto index = static_cast<std::size_t>((block.x * kEdge + block.y) * kEdge + block.z);
        if (seen_[index]) return;
        seen_[index] = true;
        ++count_;
    }
    [[nodiscard]] std::uint64_t count() const { return count_; }

  private:
    static constexpr int kEdge = 33;  // (255 + 7) / 8 + 1
    glm::ivec3 shift_;                // so that blocks begin where those of the grid do
    std::vector<bool> seen_ = std::vector<bool>(kEdge * kEdge * kEdge);
    std::uint64_t count_ = 0;
};

class ChunkParser {
  public:
    explicit ChunkParser(std::uint64_t fileBytes)
        : maxBlockBytes_(kBlockAllowance + 32 * fileBytes) {}

    Status chunk(const std::string& id, VoxFields& fields) {
        if (id == "SIZE") {
            parseSize(fields);
        } else if (id == "XYZI") {
            parseVoxels(fields);
        } else if (id == "PACK") {
            packedModels_ = fields.i32("the number of models");
        } else if (id == "nTRN") {
            parseNode(VoxNode::Kind::transform, fields);
        } else if (id == "nGRP") {
            parseNode(VoxNode::Kind::group, fields);
        } else if (id == "nSHP") {
            parseNode(VoxNode::Kind::shape, fields);
        } else if (id == "LAYR") {
            parseLayer(fields);
        } else if (id == "RGBA") {
            parseVoxColours(fields, file_.palette, file_.warnings);
        } else if (id == "IMAP") {
            parseVoxDisplayMap(fields, file_.palette);
        } else if (id == "NOTE") {
            parseVoxRowNames(fields, file_.palette, file_.warnings);
        } else if (id == "vpCN") {
            parseVoxColourNames(fields, file_.palette);
        } else if (id == "MATL") {
            parseVoxMaterial(fields, file_.palette, file_.warnings);
        } else if (id == "MATT") {
            parseVoxOldMaterial(fields, file_.palette, file_.warnings);
        } else if (id == "rCAM") {
            const int camera = fields.i32("a camera's id");
            file_.cameras.push_back({camera, fields.properties("a camera's attributes")});
        } else if (id == "rOBJ") {
            file_.renderSettings.push_back({0, fields.properties("a render setting")});
        } else if (id == "TDCZ") {
            fields.refuse(fields.offset() - 12,
                          "chunk TDCZ: the voxels are compressed in the way of the game Teardown, "
                          "which cannot be read; save the model with MagicaVoxel");
        } else {
            skip(id);
        }
        return fields.status();
    }

    Result<VoxFile> finish() {
        if (sizeOffset_) return failAtByte(*sizeOffset_, "a SIZE chunk has no XYZI chunk after it");
        if (packedModels_ && *packedModels_ != static_cast<std::int64_t>(file_.models.size())) {
            file_.warnings.add("PACK announces " + std::to_string(*packedModels_) +
                               " models, but there are " + std::to_string(file_.models.size()));
        }
        if (file_.models.empty()) file_.warnings.add("the file holds no model");
        return std::move(file_);
    }

  private:
    void parseSize(VoxFields& fields) {
        const std::uint64_t at = fields.offset();
        if (sizeOffset_) fields.refuse(*sizeOffset_, "a SIZE chunk has no XYZI chunk after it");
        for (int axis = 0; axis < 3; ++axis) size_[axis] = fields.i32("a model's size");
        sizeOffset_ = at;
        const int largest = std::max({size_.x, size_.y, size_.z});
        if (std::min({size_.x, size_.y, size_.z}) < 0 || largest > kMaxSize) {
            fields.refuse(at, "a model's size is " + std::to_string(size_.x) + " x " +
                                  std::to_string(size_.y) + " x " + std::to_string(size_.z) +
                                  "; an edge has at most " + std::to_string(kMaxSize) + " voxels");
        }
        if (largest > kOfficialSize) {
            file_.warnings.add("model " + std::to_string(file_.models.size()) +
                               " is larger than MagicaVoxel's 256 voxels");
        }
    }

    void parseVoxels(VoxFields& fields) {
        const std::uint64_t at = fields.offset();
        if (!sizeOffset_) {
            fields.refuse(at, "an XYZI chunk has no SIZE chunk before it");
            return;
        }
        sizeOffset_.reset();
        const std::uint32_t count = fields.count(4, "XYZI");
        const ByteView voxels = fields.take(std::uint64_t{count} * 4, "the voxels");
        if (!fields.ok()) return;

        Model model;
        const glm::ivec3 canvas = glm::max(size_, glm::ivec3(1));
        const glm::ivec3 pivot = canvas / 2;
        model.canvas = {-pivot, canvas - pivot};
        std::size_t colourless = 0, outside = 0;
        BlockCount blocks(pivot);
        for (std::size_t i = 0; i < voxels.size(); i += 4) {
            const glm::ivec3 v(voxels[i], voxels[i + 1], voxels[i + 2]);
            if (voxels[i + 3] == 0) {
                ++colourless;
            } else if (!IBox{glm::ivec3(0), canvas}.contains(v)) {
                ++outside;
            } else {
                model.voxels.set(v - pivot, voxels[i + 3]);
                blocks.add(v);
            }
        }
        if (blocks.count() > 0) blockBytes_ += kBytesPerModel + blocks.count() * kBytesPerBlock;
        if (blockBytes_ > maxBlockBytes_) {
            fields.refuse(at, "the voxels are so scattered that they would take more than " +
                                  std::to_string(maxBlockBytes_ >> 20) + " MiB");
        }
        const auto tellLeftOut = [&](std::size_t number, const char* why) {
            if (number == 0) return;
            file_.warnings.add("model " + std::to_string(file_.models.size()) + ": " +
                               std::to_string(number) + " voxels " + why + "; they are left out");
        };
        tellLeftOut(colourless, "have colour 0, which is empty");
        tellLeftOut(outside, "lie outside its size");
        file_.models.push_back(std::move(model));
    }

    void parseNode(VoxNode::Kind kind, VoxFields& fields) {
        VoxNode node = parseVoxNode(kind, fields, file_.warnings);
        if (!fields.ok()) return;
        if (!file_.nodeFromId.emplace(node.id, file_.nodes.size()).second) {
            fields.refuse(node.offset, "there are two nodes " + std::to_string(node.id));
            return;
        }
        file_.nodes.push_back(std::move(node));
    }

    void parseLayer(VoxFields& fields) {
        const std::uint64_t at = fields.offset();
        const int id = fields.i32("a layer's id");
        Layer layer;
        layer.attributes = fields.properties("a layer's attributes");
        layer.name = takeProperty(layer.attributes, "_name").value_or("");
        layer.hidden = takeSwitch(layer.attributes, "_hidden");
        if (id < 0 || static_cast<std::size_t>(id) >= kMaxVoxLayers) {
            fields.refuse(at, "layer " + std::to_string(id) + " is none of 0 ... " +
                                  std::to_string(kMaxVoxLayers - 1));
        }
        if (!fields.ok()) return;
        const auto index = static_cast<std::size_t>(id);
        if (file_.layers.size() <= index) file_.layers.resize(index + 1);
        file_.layers[index] = std::move(layer);
    }

    void skip(const std::string& id) {
        if (std::find(skipped_.begin(), skipped_.end(), id) != skipped_.end()) return;
        if (skipped_.size() < kMaxWarnings) skipped_.push_back(id);
        file_.warnings.add("chunk " + id + " is not understood; it is left out");
    }

    VoxFile file_;
    std::uint64_t maxBlockBytes_;
    std::uint64_t blockBytes_ = 0;
    glm::ivec3 size_{0};
    std::optional<std::uint64_t> sizeOffset_;  // set between a SIZE and its XYZI
    std::optional<std::int64_t> packedModels_;
    std::vector<std::string> skipped_;
};

// Some writers leave MAIN's length at 0 or forget to bring it up to date: do chunks of the format
// follow where it says that they end?
bool goesOn(ByteReader reader, std::uint64_t childBytes) {
    constexpr std::array kFirst{"PACK", "SIZE", "XYZI", "RGBA", "nTRN", "nGRP", "nSHP",
                                "LAYR", "MATL", "IMAP", "NOTE", "rCAM", "rOBJ", "MATT"};
    if (!reader.take(childBytes, "")) return false;
    const Result<ChunkHeader> header = readHeader(reader);
    return header && std::ranges::find(kFirst, header->id) != kFirst.end();
}

}  // namespace

void VoxWarnings::add(std::string sentence) {
    if (sentences_.size() < kMaxWarnings) {
        sentences_.push_back(std::move(sentence));
    } else if (sentences_.size() == kMaxWarnings) {
        sentences_.emplace_back("there is more of this kind");
    }
}

Result<VoxFile> parseVox(ByteView bytes) {
    ByteReader reader(bytes);
    const Result<ByteView> magic = reader.take(4, "the first four bytes");
    if (!magic || std::string(magic->begin(), magic->end()) != "VOX ") return notVox(bytes);
    const Result<std::int32_t> version = reader.i32("the version");
    if (!version) return tl::unexpected(version.error());
    if (*version < 150 || *version > 200) {
        return failAtByte(4, "version " + std::to_string(*version) +
                                 " of the format is not known; 150 to 200 are");
    }
    const Result<ChunkHeader> main = readHeader(reader);
    if (!main) return tl::unexpected(main.error());
    if (main->id != "MAIN") {
        return failAtByte(main->offset, "the first chunk is " + main->id + " instead of MAIN");
    }
    (void)reader.take(main->contentBytes, "chunk MAIN");
    const bool endsTooSoon = goesOn(reader, main->childBytes);
    Result<ByteReader> chunks =
        reader.sub(endsTooSoon ? reader.remaining() : main->childBytes, "chunk MAIN");
    if (!chunks) return tl::unexpected(chunks.error());

    ChunkParser parser(bytes.size());
    while (!chunks->atEnd()) {
        const Result<ChunkHeader> header = readHeader(*chunks);
        if (!header) return tl::unexpected(header.error());
        const Result<ByteReader> content = chunks->sub(header->contentBytes, "chunk " + header->id);
        if (!content) return tl::unexpected(content.error());
        VoxFields fields(*content);
        if (Status s = parser.chunk(header->id, fields); !s) return tl::unexpected(s.error());
        if (auto skipped = chunks->take(header->childBytes, "chunk " + header->id); !skipped) {
            return tl::unexpected(skipped.error());
        }
    }
    Result<VoxFile> file = parser.finish();
    if (file && endsTooSoon) {
        file->warnings.add("chunk MAIN claims " + std::to_string(main->childBytes) +
                           " bytes, but chunks go on after them; all are read");
    }
    if (file && !reader.atEnd()) {
        file->warnings.add(std::to_string(reader.remaining()) +
                           " bytes follow after the last chunk");
    }
    return file;
}

}  // namespace voxprite
