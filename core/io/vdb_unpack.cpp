#include "core/io/vdb_file.h"
#include "core/volume/volume_library.h"

namespace voxprite::vdb {

Status unpackBlosc(ByteView packed, std::span<std::uint8_t> bytes) {
    // The header of a Blosc chunk: bytes 4 ... 7 are the unpacked length, 12 ... 15 the packed one.
    constexpr std::size_t kHeader = 16;
    const auto damaged = [] { return fail("a node's packed values are damaged"); };
    if (packed.size() < kHeader) return damaged();
    ByteReader header(packed.subspan(4));
    const std::uint32_t unpacked = header.u32("").value_or(0);
    static_cast<void>(header.u32(""));
    if (unpacked != bytes.size() || header.u32("").value_or(0) != packed.size()) return damaged();
    const Result<const VolumeLibrary*> library = volumeLibrary();
    if (!library) return Failure(library.error());
    try {
        (*library)->unpackBlosc(packed, bytes);
    } catch (const std::exception&) {
        return damaged();
    }
    return {};
}

}  // namespace voxprite::vdb
