#include "tests/support/png_builder.h"

#include "core/base/hash.h"

namespace voxprite::test {

void putPngChunk(Bytes& png, const std::string& id, const Bytes& content) {
    const auto put = [&png](std::size_t value) {
        for (int shift = 24; shift >= 0; shift -= 8) {
            png.push_back(static_cast<std::uint8_t>(value >> shift));
        }
    };
    put(content.size());
    Bytes summed(id.begin(), id.end());
    summed.insert(summed.end(), content.begin(), content.end());
    png.insert(png.end(), summed.begin(), summed.end());
    put(crc32(ByteView(summed)));
}

Bytes storedZlib(const Bytes& bytes) {
    const auto length = static_cast<std::uint16_t>(bytes.size());
    Bytes result{0x78,
                 0x01,
                 0x01,
                 static_cast<std::uint8_t>(length),
                 static_cast<std::uint8_t>(length >> 8),
                 static_cast<std::uint8_t>(~length),
                 static_cast<std::uint8_t>(~length >> 8)};
    result.insert(result.end(), bytes.begin(), bytes.end());
    std::uint32_t a = 1;
    std::uint32_t b = 0;
    for (const std::uint8_t byte : bytes) {
        a = (a + byte) % 65521;
        b = (b + a) % 65521;
    }
    for (const std::uint32_t half : {b, a}) {
        result.push_back(static_cast<std::uint8_t>(half >> 8));
        result.push_back(static_cast<std::uint8_t>(half));
    }
    return result;
}

Bytes handmadePng(std::uint8_t width, std::uint8_t height, std::uint8_t depth, std::uint8_t type,
                  const Bytes& rows, const Bytes& palette, const Bytes& transparency) {
    Bytes png{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    putPngChunk(png, "IHDR", {0, 0, 0, width, 0, 0, 0, height, depth, type, 0, 0, 0});
    if (!palette.empty()) putPngChunk(png, "PLTE", palette);
    if (!transparency.empty()) putPngChunk(png, "tRNS", transparency);
    putPngChunk(png, "IDAT", storedZlib(rows));
    putPngChunk(png, "IEND", {});
    return png;
}

}  // namespace voxprite::test
