#include "core/io/png_check.h"

#include <zlib.h>

#include <algorithm>
#include <array>

#include "core/base/hash.h"

namespace voxprite {

namespace {

std::uint32_t bigEndian32(ByteView bytes) {
    return (std::uint32_t{bytes[0]} << 24U) | (std::uint32_t{bytes[1]} << 16U) |
           (std::uint32_t{bytes[2]} << 8U) | std::uint32_t{bytes[3]};
}

struct Header {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    int bitsPerPixel = 0;
    bool interlaced = false;
};

// Bits a sample times samples a pixel; 0 for a combination that PNG does not have.
int bitsPerPixel(int depth, int colourType) {
    const bool small = depth == 1 || depth == 2 || depth == 4;
    const bool large = depth == 8 || depth == 16;
    switch (colourType) {
        case 0:
            return small || large ? depth : 0;
        case 2:
            return large ? 3 * depth : 0;
        case 3:
            return small || depth == 8 ? depth : 0;
        case 4:
            return large ? 2 * depth : 0;
        case 6:
            return large ? 4 * depth : 0;
        default:
            return 0;
    }
}

Result<Header> headerFrom(ByteView content, std::uint64_t offset, int maxEdge) {
    if (content.size() != 13) return failAtByte(offset, "the chunk IHDR has the wrong length");
    Header header;
    header.width = bigEndian32(content);
    header.height = bigEndian32(content.subspan(4));
    header.bitsPerPixel = bitsPerPixel(content[8], content[9]);
    header.interlaced = content[12] == 1;
    const auto limit = static_cast<std::uint32_t>(maxEdge);
    if (header.width == 0 || header.height == 0 || header.width > limit || header.height > limit) {
        return failAtByte(offset, "the picture is " + std::to_string(header.width) + " x " +
                                      std::to_string(header.height) + " pixels; 1 to " +
                                      std::to_string(maxEdge) + " an edge can be read");
    }
    if (header.bitsPerPixel == 0 || content[10] != 0 || content[11] != 0 || content[12] > 1) {
        return failAtByte(offset, "the chunk IHDR names an unknown pixel format");
    }
    return header;
}

// Bytes of the filtered rows: one for the filter and the row's pixels; seven passes if interlaced.
std::uint64_t unpackedBytes(const Header& header) {
    struct Pass {
        std::uint32_t x, y, stepX, stepY;
    };
    constexpr std::array<Pass, 7> kAdam7{Pass{0, 0, 8, 8}, Pass{4, 0, 8, 8}, Pass{0, 4, 4, 8},
                                         Pass{2, 0, 4, 4}, Pass{0, 2, 2, 4}, Pass{1, 0, 2, 2},
                                         Pass{0, 1, 1, 2}};
    const auto passBytes = [&](const Pass& pass) -> std::uint64_t {
        if (pass.x >= header.width || pass.y >= header.height) return 0;
        const std::uint64_t width = (header.width - pass.x + pass.stepX - 1) / pass.stepX;
        const std::uint64_t height = (header.height - pass.y + pass.stepY - 1) / pass.stepY;
        return height * (1 + (width * static_cast<std::uint64_t>(header.bitsPerPixel) + 7) / 8);
    };
    if (!header.interlaced) return passBytes({0, 0, 1, 1});
    std::uint64_t bytes = 0;
    for (const Pass& pass : kAdam7) bytes += passBytes(pass);
    return bytes;
}

// Unfolds packed data without keeping it, to count it.
class Unpacked {
  public:
    Unpacked() : ready_(inflateInit(&stream_) == Z_OK) {}
    ~Unpacked() {
        if (ready_) inflateEnd(&stream_);
    }
    Unpacked(const Unpacked&) = delete;
    Unpacked& operator=(const Unpacked&) = delete;

    // False when the data is damaged or gives more than `most` bytes in all.
    bool add(ByteView packed, std::uint64_t most) {
        std::array<Bytef, 16384> scratch;
        stream_.next_in = const_cast<Bytef*>(packed.data());
        stream_.avail_in = static_cast<uInt>(packed.size());
        while (ready_ && !ended_ && stream_.avail_in > 0) {
            stream_.next_out = scratch.data();
            stream_.avail_out = static_cast<uInt>(scratch.size());
            const int result = inflate(&stream_, Z_NO_FLUSH);
            bytes_ += scratch.size() - stream_.avail_out;
            ended_ = result == Z_STREAM_END;
            if ((result != Z_OK && !ended_) || bytes_ > most) return false;
        }
        return ready_;
    }
    [[nodiscard]] bool ended() const { return ended_; }
    [[nodiscard]] std::uint64_t bytes() const { return bytes_; }

  private:
    z_stream stream_{};
    bool ready_;
    bool ended_ = false;
    std::uint64_t bytes_ = 0;
};

}  // namespace

Status checkPng(ByteView bytes, int maxEdge) {
    constexpr std::array<std::uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    if (bytes.size() < kSignature.size() ||
        !std::equal(kSignature.begin(), kSignature.end(), bytes.begin())) {
        return failAtByte(0, "not a PNG file");
    }
    ByteReader reader(bytes.subspan(kSignature.size()), kSignature.size());
    std::optional<Header> header;
    Unpacked pixels;
    while (true) {
        const std::uint64_t offset = reader.offset();
        const Result<ByteView> start = reader.take(8, "a chunk's header");
        if (!start) return tl::unexpected(start.error());
        const std::string id(start->begin() + 4, start->end());
        const Result<ByteView> content = reader.take(bigEndian32(*start), "a chunk");
        if (!content) return tl::unexpected(content.error());
        const Result<ByteView> sum = reader.take(4, "a chunk's checksum");
        if (!sum) return tl::unexpected(sum.error());
        const ByteView summed =
            bytes.subspan(static_cast<std::size_t>(offset) + 4, content->size() + 4);
        if (kChecksumsCount && crc32(summed) != bigEndian32(*sum)) {
            return failAtByte(offset, "the checksum of a chunk is wrong");
        }
        if (!header) {
            if (id != "IHDR") return failAtByte(offset, "the first chunk is not IHDR");
            Result<Header> read = headerFrom(*content, offset, maxEdge);
            if (!read) return tl::unexpected(read.error());
            header = *read;
        } else if (id == "IHDR") {
            return failAtByte(offset, "there is a second chunk IHDR");
        } else if (id == "IDAT" && !pixels.add(*content, unpackedBytes(*header))) {
            return failAtByte(offset, "the packed pixels are damaged");
        } else if (id == "IEND") {
            break;
        }
    }
    if (!pixels.ended() || pixels.bytes() != unpackedBytes(*header)) {
        return failAtByte(reader.offset(), "the packed pixels end too early");
    }
    return {};
}

}  // namespace voxprite
