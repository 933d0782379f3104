#include <openvdb/io/Compression.h>

#include <cstring>
#include <sstream>

#include "core/io/vdb_file.h"

namespace voxprite::vdb {

bool unpackBlosc(ByteView packed, std::span<std::uint8_t> bytes) {
    // The header of a Blosc chunk: bytes 4 ... 7 are the unpacked length, 12 ... 15 the packed one.
    constexpr std::size_t kHeader = 16;
    if (packed.size() < kHeader) return false;
    ByteReader header(packed.subspan(4));
    const std::uint32_t unpacked = header.u32("").value_or(0);
    static_cast<void>(header.u32(""));
    if (unpacked != bytes.size() || header.u32("").value_or(0) != packed.size()) return false;
    const auto length = static_cast<std::int64_t>(packed.size());
    std::string text(sizeof length + packed.size(), '\0');
    std::memcpy(text.data(), &length, sizeof length);
    std::memcpy(text.data() + sizeof length, packed.data(), packed.size());
    std::istringstream stream(text);
    try {
        openvdb::io::bloscFromStream(stream, reinterpret_cast<char*>(bytes.data()), bytes.size());
    } catch (const std::exception&) {
        return false;
    }
    return true;
}

}  // namespace voxprite::vdb
