#include "core/base/bytes.h"

#include <bit>
#include <concepts>

#include "core/base/check.h"

namespace voxprite {

namespace {

template <std::unsigned_integral T>
T valueFromLittleEndian(ByteView bytes) {
    T value = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) {
        value = static_cast<T>(value | static_cast<T>(static_cast<T>(bytes[i]) << (8 * i)));
    }
    return value;
}

template <std::unsigned_integral T>
void appendLittleEndian(Bytes& bytes, T value) {
    for (std::size_t i = 0; i < sizeof(T); ++i) {
        bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    }
}

template <std::unsigned_integral T>
Result<T> readValue(ByteReader& reader, std::string_view what) {
    return reader.take(sizeof(T), what).map(valueFromLittleEndian<T>);
}

}  // namespace

Result<std::uint8_t> ByteReader::u8(std::string_view what) {
    return readValue<std::uint8_t>(*this, what);
}

Result<std::uint16_t> ByteReader::u16(std::string_view what) {
    return readValue<std::uint16_t>(*this, what);
}

Result<std::uint32_t> ByteReader::u32(std::string_view what) {
    return readValue<std::uint32_t>(*this, what);
}

Result<std::uint64_t> ByteReader::u64(std::string_view what) {
    return readValue<std::uint64_t>(*this, what);
}

Result<std::int32_t> ByteReader::i32(std::string_view what) {
    return u32(what).map([](std::uint32_t bits) { return std::bit_cast<std::int32_t>(bits); });
}

Result<double> ByteReader::f64(std::string_view what) {
    return u64(what).map([](std::uint64_t bits) { return std::bit_cast<double>(bits); });
}

Result<ByteView> ByteReader::take(std::uint64_t count, std::string_view what) {
    if (count > remaining()) {
        return failAtByte(offset(), "the file ends inside " + std::string(what));
    }
    const ByteView taken = bytes_.subspan(position_, static_cast<std::size_t>(count));
    position_ += taken.size();
    return taken;
}

Result<ByteReader> ByteReader::sub(std::uint64_t count, std::string_view what) {
    const std::uint64_t start = offset();
    return take(count, what).map([start](ByteView taken) { return ByteReader(taken, start); });
}

Result<std::string> ByteReader::string32(std::string_view what) {
    const std::size_t start = position_;
    const auto text = u32(what).and_then([&](std::uint32_t length) { return take(length, what); });
    if (!text) {
        position_ = start;
        return Failure(text.error());
    }
    return std::string(text->begin(), text->end());
}

void ByteWriter::u8(std::uint8_t value) {
    bytes_.push_back(value);
}

void ByteWriter::u16(std::uint16_t value) {
    appendLittleEndian(bytes_, value);
}

void ByteWriter::u32(std::uint32_t value) {
    appendLittleEndian(bytes_, value);
}

void ByteWriter::u64(std::uint64_t value) {
    appendLittleEndian(bytes_, value);
}

void ByteWriter::i32(std::int32_t value) {
    u32(std::bit_cast<std::uint32_t>(value));
}

void ByteWriter::f64(double value) {
    u64(std::bit_cast<std::uint64_t>(value));
}

void ByteWriter::raw(ByteView bytes) {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
}

void ByteWriter::raw(std::string_view text) {
    bytes_.insert(bytes_.end(), text.begin(), text.end());
}

void ByteWriter::string32(std::string_view text) {
    VOXPRITE_CHECK(text.size() <= 0xFFFF'FFFFu);
    u32(static_cast<std::uint32_t>(text.size()));
    raw(text);
}

void ByteWriter::alignTo(std::size_t alignment) {
    VOXPRITE_CHECK(alignment > 0);
    bytes_.resize((bytes_.size() + alignment - 1) / alignment * alignment, 0);
}

void ByteWriter::patchU32(std::size_t at, std::uint32_t value) {
    VOXPRITE_CHECK(at + 4 <= bytes_.size());
    for (std::size_t i = 0; i < 4; ++i) {
        bytes_[at + i] = static_cast<std::uint8_t>(value >> (8 * i));
    }
}

}  // namespace voxprite
