#include "core/io/mesh_texture.h"

#include <cstring>
#include <limits>
#include <memory>
#include <string>

#include "core/io/png.h"

#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>

namespace voxprite {
namespace {

bool startsWith(ByteView bytes, std::string_view signature) {
    return bytes.size() >= signature.size() &&
           std::memcmp(bytes.data(), signature.data(), signature.size()) == 0;
}

Status checkPixels(std::uint64_t width, std::uint64_t height, std::uint64_t most) {
    if (width * height <= most) return {};
    return fail("the picture has " + std::to_string(width) + " x " + std::to_string(height) +
                " pixels, more than textures may have together");
}

Result<Image> readJpeg(ByteView bytes, std::uint64_t mostPixels) {
    if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
        return fail("the JPEG file is larger than 2 GiB");
    }
    const auto count = static_cast<int>(bytes.size());
    int width = 0, height = 0, channels = 0;
    if (stbi_info_from_memory(bytes.data(), count, &width, &height, &channels) == 0) {
        return fail(std::string("the JPEG cannot be read: ") + stbi_failure_reason());
    }
    const auto w = static_cast<std::uint64_t>(width), h = static_cast<std::uint64_t>(height);
    if (Status s = checkPixels(w, h, mostPixels); !s) return Failure(s.error());
    // Every 8 x 8 pixels take a bit at the least.
    if (w * h > 512 * std::uint64_t{bytes.size()}) return fail("the JPEG is cut short");
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(bytes.data(), count, &width, &height, &channels, STBI_rgb_alpha),
        stbi_image_free);
    if (!pixels) return fail(std::string("the JPEG cannot be read: ") + stbi_failure_reason());
    Image image(width, height);
    std::memcpy(image.pixels.data(), pixels.get(), image.pixels.size() * sizeof(Rgba8));
    return image;
}

}  // namespace

Result<Image> readTexture(ByteView bytes, std::uint64_t mostPixels) {
    if (startsWith(bytes, "\xFF\xD8\xFF")) return readJpeg(bytes, mostPixels);
    if (!startsWith(bytes, "\x89PNG")) return fail("the picture is neither PNG nor JPEG");
    // Width and height stand at bytes 16 and 20, the high byte first.
    if (bytes.size() < 24) return fail("the PNG is cut short");
    const auto number = [&](std::size_t at) {
        return std::uint64_t{bytes[at]} << 24 | std::uint64_t{bytes[at + 1]} << 16 |
               std::uint64_t{bytes[at + 2]} << 8 | std::uint64_t{bytes[at + 3]};
    };
    if (Status s = checkPixels(number(16), number(20), mostPixels); !s) return Failure(s.error());
    return readPng(bytes);
}

}  // namespace voxprite
