// Trees of .vdb files, node by node.
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <tuple>

#include "core/io/vdb_file.h"

namespace voxprite::vdb {
namespace {

constexpr std::uint32_t kZip = 1;
constexpr std::uint32_t kActiveOnly = 2;
constexpr std::uint32_t kBlosc = 4;

// How the inactive values of a node are told.
constexpr std::uint8_t kOneValue = 2;
constexpr std::uint8_t kMaskNoValues = 3;
constexpr std::uint8_t kMaskOneValue = 4;
constexpr std::uint8_t kMaskTwoValues = 5;
constexpr std::uint8_t kAllValues = 6;

double halfFrom(std::uint16_t bits) {
    const int exponent = bits >> 10 & 0x1F;
    const int fraction = bits & 0x3FF;
    const double sign = (bits & 0x8000) != 0 ? -1.0 : 1.0;
    if (exponent == 0x1F) return fraction != 0 ? 0.0 : sign * 65504.0;
    if (exponent == 0) return sign * std::ldexp(fraction, -24);
    return sign * std::ldexp(fraction + 1024, exponent - 25);
}

double numberAt(const std::uint8_t* bytes, const GridType& type, bool half) {
    std::uint64_t bits = 0;
    const std::size_t count = half ? 2 : type.component;
    for (std::size_t k = 0; k < count; ++k) bits |= std::uint64_t{bytes[k]} << 8 * k;
    if (half) return halfFrom(static_cast<std::uint16_t>(bits));
    double number = 0.0;
    if (type.kind == Kind::real || type.kind == Kind::vector) {
        number = count == 4
                     ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)))
                     : std::bit_cast<double>(bits);
    } else if (type.isSigned) {
        const auto shift = static_cast<int>(64 - 8 * count);
        number = static_cast<double>(static_cast<std::int64_t>(bits << shift) >> shift);
    } else {
        number = static_cast<double>(bits);
    }
    return std::isfinite(number) ? number : 0.0;
}

std::vector<bool> bitsOf(ByteView bytes) {
    std::vector<bool> bits(bytes.size() * 8);
    for (std::size_t k = 0; k < bits.size(); ++k) bits[k] = (bytes[k / 8] >> k % 8 & 1) != 0;
    return bits;
}

class Walk {
  public:
    Walk(const Grid& grid, ByteReader& reader, const Visit& visit)
        : type_(*grid.type), packing_(grid.packing), reader_(reader), visit_(visit) {}

    Status run() {
        const std::uint64_t offset = reader_.offset();
        const Result<std::uint32_t> one = reader_.u32("a tree");
        if (!one) return Failure(one.error());
        if (*one != 1) return failAtByte(offset, "a tree of several buffers cannot be read");
        const Result<Value> background = storedValue("a tree's background");
        if (!background) return Failure(background.error());
        background_ = *background;
        const Result<std::uint32_t> tiles = reader_.u32("the number of tiles");
        if (!tiles) return Failure(tiles.error());
        const Result<std::uint32_t> children = reader_.u32("the number of nodes");
        if (!children) return Failure(children.error());
        if (*tiles == 0 && *children == 0) return {};
        const int edge = 1 << (type_.bits[0] + type_.bits[1] + type_.bits[2]);
        if (Status s = rootTiles(*tiles, edge); !s) return s;
        if (Status s = rootChildren(*children, edge); !s) return s;
        for (const glm::ivec3& leaf : leaves_) {
            if (Status s = leafValues(leaf); !s) return s;
        }
        return {};
    }

  private:
    [[nodiscard]] bool half() const {
        return type_.half && (type_.kind == Kind::real || type_.kind == Kind::vector);
    }
    [[nodiscard]] std::size_t packedValueBytes() const {
        return half() ? type_.valueBytes / type_.component * 2 : type_.valueBytes;
    }

    Value valueAt(const std::uint8_t* bytes, bool isHalf) const {
        Value value{};
        const std::size_t step = isHalf ? 2 : type_.component;
        const std::size_t numbers = type_.valueBytes / type_.component;
        for (std::size_t k = 0; k < numbers; ++k) {
            value[k] = numberAt(bytes + k * step, type_, isHalf);
        }
        return value;
    }

    // One value by itself has all its bits.
    Result<Value> storedValue(const char* what) {
        const Result<ByteView> bytes = reader_.take(type_.valueBytes, what);
        if (!bytes) return Failure(bytes.error());
        return valueAt(bytes->data(), false);
    }

    Result<glm::ivec3> origin(int edge, std::optional<glm::ivec3>& before) {
        const std::uint64_t offset = reader_.offset();
        glm::ivec3 at{0};
        for (int axis = 0; axis < 3; ++axis) {
            const Result<std::int32_t> coordinate = reader_.i32("the place of a node");
            if (!coordinate) return Failure(coordinate.error());
            at[axis] = *coordinate;
        }
        const auto order = [](glm::ivec3 v) { return std::tuple(v.x, v.y, v.z); };
        if ((at.x | at.y | at.z) % edge != 0 || (before && order(at) <= order(*before))) {
            return failAtByte(offset, "a node lies at an odd place");
        }
        before = at;
        return at;
    }

    Status rootTiles(std::uint32_t count, int edge) {
        std::optional<glm::ivec3> before;
        for (std::uint32_t k = 0; k < count; ++k) {
            const Result<glm::ivec3> at = origin(edge, before);
            if (!at) return Failure(at.error());
            const Result<Value> value = storedValue("a tile");
            if (!value) return Failure(value.error());
            const Result<std::uint8_t> active = reader_.u8("a tile");
            if (!active) return Failure(active.error());
            if (!visit_.tile) continue;
            if (Status s = visit_.tile(*at, edge, *value, *active != 0); !s) return s;
        }
        return {};
    }

    Status rootChildren(std::uint32_t count, int edge) {
        std::optional<glm::ivec3> before;
        for (std::uint32_t k = 0; k < count; ++k) {
            const Result<glm::ivec3> at = origin(edge, before);
            if (!at) return Failure(at.error());
            if (Status s = node(0, *at); !s) return s;
        }
        return {};
    }

    [[nodiscard]] std::size_t entries(std::size_t level) const {
        return std::size_t{1} << 3 * type_.bits[level];
    }
    [[nodiscard]] int edgeBelow(std::size_t level) const {
        int bits = 0;
        for (std::size_t k = level + 1; k < type_.bits.size(); ++k) bits += type_.bits[k];
        return 1 << bits;
    }
    [[nodiscard]] glm::ivec3 place(std::size_t level, std::size_t entry) const {
        const int bits = type_.bits[level];
        const int mask = (1 << bits) - 1;
        const auto n = static_cast<int>(entry);
        return glm::ivec3(n >> 2 * bits, n >> bits & mask, n & mask) * edgeBelow(level);
    }

    Status node(std::size_t level, glm::ivec3 at) {
        const std::size_t count = entries(level);
        if (level == 2) {
            const Result<ByteView> mask = reader_.take(count / 8, "a leaf");
            if (!mask) return Failure(mask.error());
            leaves_.push_back(at);
            return {};
        }
        const Result<ByteView> childBytes = reader_.take(count / 8, "a node");
        if (!childBytes) return Failure(childBytes.error());
        const Result<ByteView> activeBytes = reader_.take(count / 8, "a node");
        if (!activeBytes) return Failure(activeBytes.error());
        const std::vector<bool> children = bitsOf(*childBytes);
        const std::vector<bool> active = bitsOf(*activeBytes);
        if (Status s = values(active); !s) return s;
        if (visit_.tile) {
            for (std::size_t k = 0; k < count; ++k) {
                if (children[k]) continue;
                const Status s =
                    visit_.tile(at + place(level, k), edgeBelow(level), values_[k], active[k]);
                if (!s) return s;
            }
        }
        for (std::size_t k = 0; k < count; ++k) {
            if (!children[k]) continue;
            if (Status s = node(level + 1, at + place(level, k)); !s) return s;
        }
        return {};
    }

    Status leafValues(glm::ivec3 at) {
        const std::size_t count = entries(2);
        const Result<ByteView> mask = reader_.take(count / 8, "a leaf's values");
        if (!mask) return Failure(mask.error());
        const std::vector<bool> active = bitsOf(*mask);
        if (type_.kind == Kind::boolean || type_.kind == Kind::mask) {
            // The place once more, then (of bool) a bit a value.
            if (const auto again = reader_.take(12, "a leaf's place"); !again) {
                return Failure(again.error());
            }
            std::vector<bool> truths = active;
            if (type_.kind == Kind::boolean) {
                const Result<ByteView> bits = reader_.take(count / 8, "a leaf's values");
                if (!bits) return Failure(bits.error());
                truths = bitsOf(*bits);
            }
            values_.assign(count, {});
            for (std::size_t k = 0; k < count; ++k) values_[k][0] = truths[k] ? 1.0 : 0.0;
        } else if (Status s = values(active); !s) {
            return s;
        }
        if (!visit_.leaf) return {};
        return visit_.leaf(at, 1 << type_.bits[2], values_, active);
    }

    [[nodiscard]] Value negated(Value value) const {
        if (type_.kind == Kind::boolean || type_.kind == Kind::mask) {
            return {value[0] == 0.0 ? 1.0 : 0.0};
        }
        return {-value[0], -value[1], -value[2]};
    }

    // Reads the values of a node with these active ones into values_ (only where they are wanted).
    Status values(const std::vector<bool>& active) {
        const std::uint64_t offset = reader_.offset();
        const Result<std::uint8_t> told = reader_.u8("a node's values");
        if (!told) return Failure(told.error());
        if (*told > kAllValues) return failAtByte(offset, "the values are told in an unknown way");
        Value inactive = *told == 0 ? background_ : negated(background_);
        Value selected = background_;
        const auto readInto = [&](Value& value) -> Status {
            const Result<Value> stored = storedValue("a node's inactive value");
            if (!stored) return Failure(stored.error());
            value = *stored;
            return {};
        };
        if (*told == kOneValue || *told == kMaskOneValue || *told == kMaskTwoValues) {
            if (Status s = readInto(inactive); !s) return s;
        }
        if (*told == kMaskTwoValues) {
            if (Status s = readInto(selected); !s) return s;
        }
        std::vector<bool> selection;
        if (*told >= kMaskNoValues && *told <= kMaskTwoValues) {
            const Result<ByteView> mask = reader_.take(active.size() / 8, "a node's values");
            if (!mask) return Failure(mask.error());
            selection = bitsOf(*mask);
        }
        const bool activeOnly = (packing_ & kActiveOnly) != 0 && *told != kAllValues;
        const auto stored =
            activeOnly ? static_cast<std::size_t>(std::count(active.begin(), active.end(), true))
                       : active.size();
        if (Status s = unpack(stored * packedValueBytes()); !s) return s;
        if (!visit_.tile && !visit_.leaf) return {};
        values_.assign(active.size(), {});
        std::size_t next = 0;
        for (std::size_t k = 0; k < active.size(); ++k) {
            if (!activeOnly || active[k]) {
                values_[k] = valueAt(unpacked_.data() + next++ * packedValueBytes(), half());
            } else {
                values_[k] = !selection.empty() && selection[k] ? selected : inactive;
            }
        }
        return {};
    }

    // The next `bytes` bytes, unpacked into unpacked_.
    Status unpack(std::size_t bytes) {
        if (half() && bytes == 0) return {};
        const std::uint64_t offset = reader_.offset();
        const bool wanted = visit_.tile || visit_.leaf;
        std::uint64_t length = bytes;
        bool packed = false;
        if ((packing_ & (kZip | kBlosc)) != 0) {
            const Result<std::uint64_t> told = reader_.u64("a node's values");
            if (!told) return Failure(told.error());
            const auto number = static_cast<std::int64_t>(*told);
            packed = number > 0;
            length = packed ? *told : ~*told + 1;
            if (!packed && length != bytes) {
                return failAtByte(offset, "a node's values have the wrong length");
            }
        }
        const Result<ByteView> data = reader_.take(length, "a node's values");
        if (!data) return Failure(data.error());
        if (!wanted) return {};
        if (!packed) {
            unpacked_.assign(data->begin(), data->end());
            return {};
        }
        unpacked_.assign(bytes, 0);
        if ((packing_ & kBlosc) != 0) {
            const Status whole = unpackBlosc(*data, unpacked_);
            return whole ? whole : failAtByte(offset, whole.error().message);
        }
        auto size = static_cast<uLongf>(bytes);
        const bool whole = uncompress(unpacked_.data(), &size, data->data(),
                                      static_cast<uLong>(data->size())) == Z_OK &&
                           size == bytes;
        if (!whole) return failAtByte(offset, "a node's packed values are damaged");
        return {};
    }

    const GridType& type_;
    std::uint32_t packing_;
    ByteReader& reader_;
    const Visit& visit_;
    Value background_{};
    std::vector<glm::ivec3> leaves_;
    std::vector<Value> values_;
    Bytes unpacked_;
};

}  // namespace

Status walk(const Grid& grid, ByteReader& reader, const Visit& visit) {
    return Walk(grid, reader, visit).run();
}

}  // namespace voxprite::vdb
