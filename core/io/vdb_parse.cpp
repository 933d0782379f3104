// Header, metadata and grids of .vdb files.
#include <algorithm>
#include <charconv>
#include <string_view>

#include "core/io/vdb_file.h"
#include "core/io/vox_fields.h"

namespace voxprite::vdb {
namespace {

constexpr std::uint64_t kMagic = 0x56444220;
constexpr std::uint32_t kOldest = 222;
constexpr std::uint32_t kNewest = 225;
constexpr std::uint32_t kMaxGrids = 4096;

// What maps are stored as, in bytes.
struct MapType {
    std::string_view name;
    std::uint64_t bytes;
};
constexpr std::array kMaps{MapType{"AffineMap", 128},
                           MapType{"UnitaryMap", 128},
                           MapType{"ScaleMap", 120},
                           MapType{"UniformScaleMap", 120},
                           MapType{"TranslationMap", 24},
                           MapType{"ScaleTranslateMap", 144},
                           MapType{"UniformScaleTranslateMap", 144}};

struct ValueType {
    std::string_view name;
    GridType type;
};
const std::array kValues{
    ValueType{"bool", {Kind::boolean, 1, 1, false}}, ValueType{"mask", {Kind::mask, 1, 1, false}},
    ValueType{"float", {Kind::real, 4, 4}},          ValueType{"double", {Kind::real, 8, 8}},
    ValueType{"vec3s", {Kind::vector, 12, 4}},       ValueType{"vec3d", {Kind::vector, 24, 8}},
    ValueType{"uint8", {Kind::whole, 1, 1, false}},  ValueType{"int8", {Kind::whole, 1, 1}},
    ValueType{"uint16", {Kind::whole, 2, 2, false}}, ValueType{"int16", {Kind::whole, 2, 2}},
    ValueType{"uint32", {Kind::whole, 4, 4, false}}, ValueType{"int32", {Kind::whole, 4, 4}},
    ValueType{"int64", {Kind::whole, 8, 8}},
};

// "Tree_float_5_4_3", at the end "_HalfFloat" where values have half the bits.
std::optional<GridType> typeFrom(std::string_view name) {
    constexpr std::string_view kBegin = "Tree_", kHalf = "_HalfFloat";
    if (!name.starts_with(kBegin)) return std::nullopt;
    name.remove_prefix(kBegin.size());
    const bool half = name.ends_with(kHalf);
    if (half) name.remove_suffix(kHalf.size());
    const std::size_t end = name.find('_');
    if (end == std::string_view::npos) return std::nullopt;
    const auto* const value = std::ranges::find(kValues, name.substr(0, end), &ValueType::name);
    if (value == kValues.end()) return std::nullopt;
    GridType type = value->type;
    type.half = half;
    std::string_view rest = name.substr(end);
    for (int& bits : type.bits) {
        // One digit; nodes of more than 2^18 or fewer than 64 entries are nobody's.
        if (rest.size() < 2 || rest[0] != '_' || rest[1] < '2' || rest[1] > '6') {
            return std::nullopt;
        }
        bits = rest[1] - '0';
        rest.remove_prefix(2);
    }
    return rest.empty() ? std::optional(type) : std::nullopt;
}

class Parser {
  public:
    explicit Parser(ByteView bytes) : bytes_(bytes), reader_(bytes) {}

    Result<File> run() {
        if (Status s = header(); !s) return Failure(s.error());
        File file;
        if (Status s = metadata(file.texts); !s) return Failure(s.error());
        const std::uint64_t offset = reader_.offset();
        const Result<std::uint32_t> count = reader_.u32("the number of grids");
        if (!count) return Failure(count.error());
        if (*count > kMaxGrids) {
            return failAtByte(offset, "the file claims " + std::to_string(*count) +
                                          " grids; at most " + std::to_string(kMaxGrids) +
                                          " can be read");
        }
        for (std::uint32_t k = 0; k < *count; ++k) {
            Result<Grid> next = grid();
            if (!next) return Failure(next.error());
            file.grids.push_back(std::move(*next));
        }
        return file;
    }

  private:
    Status header() {
        const Result<std::uint64_t> magic = reader_.u64("the header");
        if (!magic) return Failure(magic.error());
        if (*magic != kMagic) return failAtByte(0, "not an OpenVDB file");
        const Result<std::uint32_t> version = reader_.u32("the header");
        if (!version) return Failure(version.error());
        if (*version < kOldest || *version > kNewest) {
            return failAtByte(8, "an OpenVDB file of version " + std::to_string(*version) + "; " +
                                     std::to_string(kOldest) + " to " + std::to_string(kNewest) +
                                     " can be read");
        }
        if (const auto library = reader_.take(8, "the header"); !library) {
            return Failure(library.error());
        }
        const Result<std::uint8_t> offsets = reader_.u8("the header");
        if (!offsets) return Failure(offsets.error());
        hasOffsets_ = *offsets != 0;
        if (const auto identity = reader_.take(36, "the header"); !identity) {
            return Failure(identity.error());
        }
        return {};
    }

    Status metadata(std::map<std::string, std::string>& texts) {
        const Result<std::uint32_t> count = reader_.u32("metadata");
        if (!count) return Failure(count.error());
        for (std::uint32_t k = 0; k < *count; ++k) {
            const Result<std::string> name = reader_.string32("metadata");
            if (!name) return Failure(name.error());
            const Result<std::string> type = reader_.string32("metadata");
            if (!type) return Failure(type.error());
            const Result<std::string> value = reader_.string32("metadata");
            if (!value) return Failure(value.error());
            if (*type == "string") texts[*name] = *value;
        }
        return {};
    }

    Status transform(const std::string& grid) {
        const std::uint64_t offset = reader_.offset();
        const Result<std::string> name = reader_.string32("a transform");
        if (!name) return Failure(name.error());
        const auto* const map = std::ranges::find(kMaps, std::string_view(*name), &MapType::name);
        if (map == kMaps.end()) {
            return failAtByte(offset, "the grid \"" + grid + "\" has the transform \"" +
                                          utf8FromBytes(*name).substr(0, 40) +
                                          "\"; only linear ones can be read");
        }
        const Result<ByteView> numbers = reader_.take(map->bytes, "a transform");
        if (!numbers) return Failure(numbers.error());
        return {};
    }

    // Behind a grid of a kind that is not looked into.
    Status passOver(const Grid& grid, std::uint64_t end, std::uint64_t offset) {
        if (!hasOffsets_ || end < reader_.offset() || end > bytes_.size()) {
            return failAtByte(offset, "the grid \"" + grid.name + "\" is of the type " +
                                          grid.typeName +
                                          ", which cannot be read, and where it ends is not told");
        }
        return reader_.take(end - reader_.offset(), "a grid").map([](ByteView) {});
    }

    Result<Grid> grid() {
        const std::uint64_t offset = reader_.offset();
        Grid grid;
        const Result<std::string> name = reader_.string32("a grid's name");
        if (!name) return Failure(name.error());
        const Result<std::string> type = reader_.string32("a grid's type");
        if (!type) return Failure(type.error());
        const Result<std::string> parent = reader_.string32("a grid's name");
        if (!parent) return Failure(parent.error());
        // Behind a separator a number tells grids of one name apart.
        grid.name = utf8FromBytes(name->substr(0, name->find('\x1E')));
        grid.typeName = utf8FromBytes(*type).substr(0, 80);
        grid.type = typeFrom(*type);
        grid.isInstance = !parent->empty();
        std::array<std::uint64_t, 3> places{};
        for (std::uint64_t& place : places) {
            const Result<std::uint64_t> value = reader_.u64("a grid's place");
            if (!value) return Failure(value.error());
            place = *value;
        }
        if (!grid.type) {
            if (Status s = passOver(grid, places[2], offset); !s) return Failure(s.error());
            return grid;
        }
        const Result<std::uint32_t> packing = reader_.u32("a grid's packing");
        if (!packing) return Failure(packing.error());
        if (*packing > 7)
            return failAtByte(reader_.offset() - 4, "a grid is packed in an unknown way");
        grid.packing = *packing;
        std::map<std::string, std::string> texts;
        if (Status s = metadata(texts); !s) return Failure(s.error());
        grid.gridClass = texts["class"];
        if (Status s = transform(grid.name); !s) return Failure(s.error());
        if (grid.isInstance) return grid;
        grid.tree = reader_;
        if (Status s = walk(grid, reader_, {}); !s) return Failure(s.error());
        return grid;
    }

    ByteView bytes_;
    ByteReader reader_;
    bool hasOffsets_ = false;
};

}  // namespace

Result<File> parse(ByteView bytes) {
    return Parser(bytes).run();
}

}  // namespace voxprite::vdb
