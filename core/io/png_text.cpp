#include "core/io/png_text.h"

#include "core/base/hash.h"

namespace voxprite {

void putBigEndian(Bytes& bytes, std::uint32_t value, int count) {
    for (int shift = 8 * (count - 1); shift >= 0; shift -= 8) {
        bytes.push_back(static_cast<std::uint8_t>(value >> shift));
    }
}

void appendPngChunk(Bytes& file, std::string_view type, ByteView content) {
    putBigEndian(file, static_cast<std::uint32_t>(content.size()), 4);
    const std::size_t from = file.size();
    file.insert(file.end(), type.begin(), type.end());
    file.insert(file.end(), content.begin(), content.end());
    putBigEndian(file, crc32(ByteView(file).subspan(from)), 4);
}

Bytes withPngText(ByteView png, std::string_view key, std::string_view text) {
    const std::size_t head = kPngSignatureBytes + kPngHeaderBytes;
    Bytes file(png.begin(), png.begin() + static_cast<std::ptrdiff_t>(head));
    Bytes content(key.begin(), key.end());
    content.push_back(0);
    content.insert(content.end(), text.begin(), text.end());
    appendPngChunk(file, "tEXt", content);
    file.insert(file.end(), png.begin() + static_cast<std::ptrdiff_t>(head), png.end());
    return file;
}

std::optional<std::string> pngText(ByteView png, std::string_view key) {
    std::size_t at = kPngSignatureBytes;
    while (at + 12 <= png.size()) {
        std::size_t length = 0;
        for (std::size_t k = 0; k < 4; ++k) length = length << 8 | png[at + k];
        if (length > png.size() - at - 12) return std::nullopt;
        const auto* characters = reinterpret_cast<const char*>(png.data());
        const std::string_view type(characters + at + 4, 4);
        const std::string_view content(characters + at + 8, length);
        if (type == "IDAT") return std::nullopt;
        if (type == "tEXt" && content.size() > key.size() && content.starts_with(key) &&
            content[key.size()] == '\0') {
            return std::string(content.substr(key.size() + 1));
        }
        at += length + 12;
    }
    return std::nullopt;
}

}  // namespace voxprite
