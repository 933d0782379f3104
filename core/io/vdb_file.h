// The structure of a .vdb file: what grids it has and what their trees hold. Private to core/io.
//
//   header      i64 magic, u32 file version, u32 library major, minor, u8 has offsets, 36 bytes of
//               identity
//   metadata    u32 count, then name, type name, u32 length and value each
//   grids       u32 count, then each: name, type name, name of the grid whose tree it shares, i64
//               places of grid, buffers and end; u32 packing, metadata, transform, tree
//   tree        u32 1, background, u32 tiles, u32 children; tiles: i32[3] origin, value, u8 active;
//               children: i32[3] origin and the node: mask of children, mask of active values,
//               values, then the children; leaves have a mask alone. Then for all leaves in the
//               same order: mask and values
//
// Texts are a u32 length and bytes. Nodes have 2^(3 n) entries in the order x, y, z (z fastest).
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace voxprite::vdb {

enum class Kind : std::uint8_t { boolean, mask, whole, real, vector };

// What the values of a grid are and how large their nodes.
struct GridType {
    Kind kind = Kind::real;
    std::size_t valueBytes = 4;
    std::size_t component = 4;  // bytes of a number of it
    bool isSigned = true;       // of whole numbers
    bool half = false;          // stored with half the bits
    std::array<int, 3> bits{5, 4,
                            3};  // 2^bits entries an edge: the root's children, theirs, leaves
};

using Value = std::array<double, 3>;  // scalars are the first

struct Grid {
    std::string name;
    std::string typeName;
    std::optional<GridType> type;  // none: of a kind that is no voxels
    std::string gridClass;         // "level set", "fog volume", ...
    bool isInstance = false;       // has no tree of its own
    std::uint32_t packing = 0;
    ByteReader tree{ByteView()};
};

struct File {
    std::map<std::string, std::string> texts;  // metadata of the file
    std::vector<Grid> grids;
};
// Goes through all trees once, so that what is wrong is found before anything is made of it.
[[nodiscard]] Result<File> parse(ByteView bytes);

// What a tree holds, from the root down. Either may be empty: then values are not unpacked.
struct Visit {
    // A cube of one value.
    std::function<Status(glm::ivec3 origin, int edge, const Value& value, bool active)> tile{};
    // edge^3 values in the order of nodes; active[i] belongs to values[i].
    std::function<Status(glm::ivec3 origin, int edge, std::span<const Value> values,
                         const std::vector<bool>& active)>
        leaf{};
};
// Moves `reader`, which stands at the tree, behind it.
[[nodiscard]] Status walk(const Grid& grid, ByteReader& reader, const Visit& visit);

// Blosc data that stands for exactly `bytes` bytes.
[[nodiscard]] Status unpackBlosc(ByteView packed, std::span<std::uint8_t> bytes);

}  // namespace voxprite::vdb
