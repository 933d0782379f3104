#include "core/io/vox_fields.h"

#include <bit>
#include <charconv>

namespace voxprite {

std::uint8_t VoxFields::u8(std::string_view what) {
    return ok() ? kept(reader_.u8(what), what) : std::uint8_t{0};
}

std::int32_t VoxFields::i32(std::string_view what) {
    return ok() ? kept(reader_.i32(what), what) : 0;
}

float VoxFields::f32(std::string_view what) {
    return ok() ? std::bit_cast<float>(kept(reader_.u32(what), what)) : 0.0F;
}

std::uint32_t VoxFields::count(std::size_t bytesEach, std::string_view what) {
    const std::uint64_t at = offset();
    const std::int32_t value = i32(what);
    if (value < 0 || static_cast<std::uint64_t>(value) > remaining() / bytesEach) {
        refuse(at, std::string(what) + " claims " + std::to_string(value) + " entries, but only " +
                       std::to_string(remaining()) + " bytes follow");
        return 0;
    }
    return static_cast<std::uint32_t>(value);
}

std::string VoxFields::text(std::string_view what) {
    return ok() ? utf8FromBytes(kept(reader_.string32(what), what)) : std::string();
}

Properties VoxFields::properties(std::string_view what) {
    Properties result;
    const std::uint32_t pairs = count(8, what);
    for (std::uint32_t i = 0; i < pairs && ok(); ++i) {
        std::string key = text(what);
        std::string value = text(what);
        if (ok()) result.insert_or_assign(std::move(key), std::move(value));
    }
    return result;
}

ByteView VoxFields::take(std::uint64_t bytes, std::string_view what) {
    return ok() ? kept(reader_.take(bytes, what), what) : ByteView();
}

void VoxFields::refuse(std::uint64_t at, std::string message) {
    if (ok()) error_ = failAtByte(at, std::move(message)).value();
}

Status VoxFields::status() const {
    if (error_) return tl::unexpected(*error_);
    return {};
}

namespace {

// Bytes of the UTF-8 character that starts at `at`, 0 where none does. Shortest forms only, no
// surrogates, nothing above U+10FFFF (RFC 3629).
std::size_t utf8Length(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
    };
    const auto continues = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
    const unsigned lead = byte(at);
    if (lead < 0x80) return 1;
    if (lead < 0xC2 || lead > 0xF4 || !continues(at + 1)) return 0;
    if (lead < 0xE0) return 2;
    if (!continues(at + 2)) return 0;
    if (lead < 0xF0) {
        const bool overlong = lead == 0xE0 && byte(at + 1) < 0xA0;
        const bool surrogate = lead == 0xED && byte(at + 1) >= 0xA0;
        return overlong || surrogate ? 0 : 3;
    }
    if (!continues(at + 3)) return 0;
    const bool overlong = lead == 0xF0 && byte(at + 1) < 0x90;
    const bool tooLarge = lead == 0xF4 && byte(at + 1) >= 0x90;
    return overlong || tooLarge ? 0 : 4;
}

}  // namespace

std::string utf8FromBytes(std::string_view bytes) {
    std::size_t at = 0;
    while (at < bytes.size()) {
        const std::size_t length = utf8Length(bytes, at);
        if (length == 0) break;
        at += length;
    }
    if (at == bytes.size()) return std::string(bytes);
    std::string result;
    result.reserve(bytes.size() * 2);
    for (const char c : bytes) {
        const auto code = static_cast<unsigned char>(c);
        if (code < 0x80) {
            result += c;
        } else {
            result += static_cast<char>(0xC0U | (code >> 6U));
            result += static_cast<char>(0x80U | (code & 0x3FU));
        }
    }
    return result;
}

std::optional<int> wholeNumber(std::string_view text) {
    int value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end) return std::nullopt;
    return value;
}

void writeProperties(ByteWriter& out, const Properties& properties) {
    out.u32(static_cast<std::uint32_t>(properties.size()));
    for (const auto& [key, value] : properties) {
        out.string32(key);
        out.string32(value);
    }
}

std::optional<std::string> takeProperty(Properties& properties, const std::string& key) {
    auto node = properties.extract(key);
    if (node.empty()) return std::nullopt;
    return std::move(node.mapped());
}

bool takeSwitch(Properties& properties, const std::string& key) {
    return takeProperty(properties, key) == "1";
}

}  // namespace voxprite
