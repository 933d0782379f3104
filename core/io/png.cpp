#include "core/io/png.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <memory>

#include <zlib.h>

#include <cstdlib>

#include "core/base/file.h"
#include "core/io/png_check.h"

namespace voxprite {
namespace {

// For stb, whose own compressor is several times slower and packs worse; it frees what it is given.
unsigned char* deflated(unsigned char* data, int size, int* packedSize, int level) {
    uLongf packed = compressBound(static_cast<uLong>(size));
    auto* bytes = static_cast<unsigned char*>(std::malloc(packed));
    if (bytes != nullptr &&
        compress2(bytes, &packed, data, static_cast<uLong>(size), std::min(level, 6)) == Z_OK) {
        *packedSize = static_cast<int>(packed);
        return bytes;
    }
    std::free(bytes);
    return nullptr;
}

}  // namespace
}  // namespace voxprite

#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>
#define STBI_WRITE_NO_STDIO
#define STBIW_ZLIB_COMPRESS voxprite::deflated
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

namespace voxprite {
namespace {

// Without empty chunks IDAT, which are allowed: when the first is one, stb copies its no bytes to
// nowhere, which C does not allow. `bytes` have passed checkPng().
Bytes withoutEmptyPixelChunks(ByteView bytes) {
    constexpr std::size_t kSignature = 8, kAround = 12;  // length, name and checksum of a chunk
    Bytes kept(bytes.begin(), bytes.begin() + kSignature);
    for (std::size_t at = kSignature; at + kAround <= bytes.size();) {
        const std::size_t length = std::size_t{bytes[at]} << 24 | std::size_t{bytes[at + 1]} << 16 |
                                   std::size_t{bytes[at + 2]} << 8 | bytes[at + 3];
        const ByteView chunk = bytes.subspan(at, std::min(length + kAround, bytes.size() - at));
        const bool pixels = std::memcmp(chunk.data() + 4, "IDAT", 4) == 0;
        if (!(pixels && length == 0)) kept.insert(kept.end(), chunk.begin(), chunk.end());
        at += chunk.size();
    }
    return kept;
}

}  // namespace

Result<Image> readPng(ByteView file) {
    if (file.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
        return fail("the PNG file is larger than 2 GiB");
    }
    if (Status s = checkPng(file, kMaxPngEdge); !s) return tl::unexpected(s.error());
    const Bytes bytes = withoutEmptyPixelChunks(file);
    int width = 0;
    int height = 0;
    int channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(bytes.data(), static_cast<int>(bytes.size()), &width, &height,
                              &channels, STBI_rgb_alpha),
        stbi_image_free);
    if (!pixels) return fail(std::string("the PNG cannot be read: ") + stbi_failure_reason());
    Image image(width, height);
    std::memcpy(image.pixels.data(), pixels.get(), image.pixels.size() * sizeof(Rgba8));
    return image;
}

Result<Bytes> writePng(const Image& image) {
    if (image.width < 1 || image.height < 1 || image.width > kMaxPngEdge ||
        image.height > kMaxPngEdge) {
        return fail("a picture of " + std::to_string(image.width) + " x " +
                    std::to_string(image.height) + " pixels cannot be written; 1 to " +
                    std::to_string(kMaxPngEdge) + " an edge can");
    }
    Bytes bytes;
    const auto append = [](void* context, void* data, int size) {
        const auto* first = static_cast<const std::uint8_t*>(data);
        auto& target = *static_cast<Bytes*>(context);
        target.insert(target.end(), first, first + size);
    };
    const int written = stbi_write_png_to_func(append, &bytes, image.width, image.height, 4,
                                               image.pixels.data(), image.width * 4);
    if (written == 0) return fail("there is not enough memory to write the picture");
    return bytes;
}

Result<Image> readPngFile(const std::filesystem::path& path) {
    return inFile(readFile(path).and_then([](const Bytes& bytes) { return readPng(bytes); }),
                  path.string());
}

Status writePngFile(const std::filesystem::path& path, const Image& image) {
    return inFile(writePng(image).and_then([&](const Bytes& bytes) {
        return writeFileAtomically(path, ByteView(bytes));
    }),
                  path.string());
}

}  // namespace voxprite
