#include "core/io/apng.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>

#include "core/io/png.h"
#include "core/io/png_text.h"

namespace voxprite {
namespace {

std::uint32_t bigEndianAt(const Bytes& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < 4; ++k) value = value << 8 | bytes[at + k];
    return value;
}

void append(Bytes& bytes, ByteView more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
}

// The packed pixels of a PNG that writePng made: the contents of its IDAT chunks.
Bytes packedPixels(const Bytes& png) {
    Bytes packed;
    std::size_t at = kPngSignatureBytes;
    while (at + 12 <= png.size()) {
        const std::size_t length = bigEndianAt(png, at);
        if (std::memcmp(png.data() + at + 4, "IDAT", 4) == 0) {
            append(packed, ByteView(png).subspan(at + 8, length));
        }
        at += length + 12;
    }
    return packed;
}

Bytes frameControl(std::uint32_t number, const AnimationFrame& frame) {
    Bytes control;
    putBigEndian(control, number, 4);
    putBigEndian(control, static_cast<std::uint32_t>(frame.image.width), 4);
    putBigEndian(control, static_cast<std::uint32_t>(frame.image.height), 4);
    putBigEndian(control, 0, 4);  // left and top
    putBigEndian(control, 0, 4);
    // A count of parts of a second, and how many of them a second has.
    std::uint32_t parts = 1000;
    const auto count = [&] {
        return static_cast<std::uint64_t>(frame.milliseconds) * parts / 1000;
    };
    while (parts > 1 && count() > 65'535) parts /= 10;
    putBigEndian(control, static_cast<std::uint32_t>(std::min<std::uint64_t>(count(), 65'535)), 2);
    putBigEndian(control, parts, 2);
    putBigEndian(control, 0, 1);  // afterwards the picture stays
    putBigEndian(control, 0, 1);  // until it is replaced, alpha and all
    return control;
}

}  // namespace

Result<Bytes> writeApng(std::span<const AnimationFrame> frames) {
    if (frames.empty()) return fail("an animation needs a frame");
    const Image& first = frames.front().image;
    Bytes file;
    std::uint32_t number = 0;
    for (std::size_t k = 0; k < frames.size(); ++k) {
        const AnimationFrame& frame = frames[k];
        if (frame.image.width != first.width || frame.image.height != first.height) {
            return fail("frame " + std::to_string(k) + " has another size than the first");
        }
        if (frame.milliseconds < 1) {
            return fail("frame " + std::to_string(k) + " must last a millisecond at least");
        }
        const Result<Bytes> png = writePng(frame.image);
        if (!png) return png;
        if (k == 0) {
            append(file, ByteView(*png).first(kPngSignatureBytes + kPngHeaderBytes));
            Bytes animation;
            putBigEndian(animation, static_cast<std::uint32_t>(frames.size()), 4);
            putBigEndian(animation, 0, 4);  // for ever
            appendPngChunk(file, "acTL", animation);
        }
        appendPngChunk(file, "fcTL", frameControl(number++, frame));
        Bytes pixels;
        if (k > 0) putBigEndian(pixels, number++, 4);
        append(pixels, packedPixels(*png));
        appendPngChunk(file, k == 0 ? "IDAT" : "fdAT", pixels);
    }
    appendPngChunk(file, "IEND", {});
    return file;
}

}  // namespace voxprite
