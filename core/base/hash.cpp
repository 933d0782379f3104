#include "core/base/hash.h"

#include <openssl/evp.h>
#include <zlib.h>

#include <array>

#include "core/base/check.h"

namespace voxprite {

std::string sha256Hex(ByteView bytes) {
    std::array<unsigned char, 32> digest{};
    unsigned int length = 0;
    const int ok =
        EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr);
    VOXPRITE_CHECK(ok == 1 && length == digest.size());
    static_cast<void>(ok);

    constexpr const char* kDigits = "0123456789abcdef";
    std::string hex;
    hex.reserve(2 * digest.size());
    for (const unsigned char byte : digest) {
        hex += kDigits[byte >> 4];
        hex += kDigits[byte & 15];
    }
    return hex;
}

std::uint32_t crc32(ByteView bytes) {
    if (bytes.empty()) return 0;  // for zlib a null pointer asks for the start value
    return static_cast<std::uint32_t>(::crc32_z(0, bytes.data(), bytes.size()));
}

}  // namespace voxprite
