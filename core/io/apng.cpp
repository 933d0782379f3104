#include "core/io/apng.h"

#include <zlib.h>

#include <cstring>
#include <string>
#include <string_view>

#include "core/io/png.h"

namespace voxprite {
namespace {

constexpr std::size_t kSignatureBytes = 8;
constexpr std::size_t kHeaderBytes = 25;  // of the IHDR chunk, which follows

// Everything in a PNG is big-endian.
void bigEndian(Bytes& bytes, std::uint32_t value, int count) {
    for (int shift = 8 * (count - 1); shift >= 0; shift -= 8) {
        bytes.push_back(static_cast<std::uint8_t>(value >> shift));
    }
}

std::uint32_t u32At(const Bytes& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < 4; ++k) value = value << 8 | bytes[at + k];
    return value;
}

void append(Bytes& bytes, ByteView more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
}

void appendChunk(Bytes& file, std::string_view type, const Bytes& content) {
    bigEndian(file, static_cast<std::uint32_t>(content.size()), 4);
    const std::size_t from = file.size();
    file.insert(file.end(), type.begin(), type.end());
    append(file, content);
    const auto length = static_cast<uInt>(file.size() - from);
    bigEndian(file, static_cast<std::uint32_t>(crc32(0, file.data() + from, length)), 4);
}

// The packed pixels of a PNG that writePng made: the contents of its IDAT chunks.
Bytes packedPixels(const Bytes& png) {
    Bytes packed;
    std::size_t at = kSignatureBytes;
    while (at + 12 <= png.size()) {
        const std::size_t length = u32At(png, at);
        if (std::memcmp(png.data() + at + 4, "IDAT", 4) == 0) {
            append(packed, ByteView(png).subspan(at + 8, length));
        }
        at += length + 12;
    }
    return packed;
}

Bytes frameControl(std::uint32_t number, const ApngFrame& frame) {
    Bytes control;
    bigEndian(control, number, 4);
    bigEndian(control, static_cast<std::uint32_t>(frame.image.width), 4);
    bigEndian(control, static_cast<std::uint32_t>(frame.image.height), 4);
    bigEndian(control, 0, 4);  // left and top
    bigEndian(control, 0, 4);
    bigEndian(control, static_cast<std::uint32_t>(frame.milliseconds), 2);
    bigEndian(control, 1000, 2);  // the unit of the line above: parts of a second
    bigEndian(control, 0, 1);     // afterwards the picture stays
    bigEndian(control, 0, 1);     // until it is replaced, alpha and all
    return control;
}

}  // namespace

Result<Bytes> writeApng(std::span<const ApngFrame> frames) {
    if (frames.empty()) return fail("an animation needs a frame");
    const Image& first = frames.front().image;
    Bytes file;
    std::uint32_t number = 0;
    for (std::size_t k = 0; k < frames.size(); ++k) {
        const ApngFrame& frame = frames[k];
        if (frame.image.width != first.width || frame.image.height != first.height) {
            return fail("frame " + std::to_string(k) + " has another size than the first");
        }
        if (frame.milliseconds < 1 || frame.milliseconds > 65'535) {
            return fail("frame " + std::to_string(k) + " must last 1 to 65535 milliseconds");
        }
        const Result<Bytes> png = writePng(frame.image);
        if (!png) return png;
        if (k == 0) {
            append(file, ByteView(*png).first(kSignatureBytes + kHeaderBytes));
            Bytes animation;
            bigEndian(animation, static_cast<std::uint32_t>(frames.size()), 4);
            bigEndian(animation, 0, 4);  // for ever
            appendChunk(file, "acTL", animation);
        }
        appendChunk(file, "fcTL", frameControl(number++, frame));
        Bytes pixels;
        if (k > 0) bigEndian(pixels, number++, 4);
        append(pixels, packedPixels(*png));
        appendChunk(file, k == 0 ? "IDAT" : "fdAT", pixels);
    }
    appendChunk(file, "IEND", {});
    return file;
}

}  // namespace voxprite
