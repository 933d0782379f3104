#include "app/cli/bench/openvdb_rivals.h"

#include "core/base/late_library.h"

namespace voxprite::bench {

Result<const OpenVdbRivals*> openVdbRivals() {
    using Entry = const OpenVdbRivals*();
    static const Result<void*> entry = entryOf("libvoxprite_rivals.so", "voxpriteOpenVdbRivals");
    if (!entry) return Failure(entry.error());
    return reinterpret_cast<Entry*>(*entry)();
}

}  // namespace voxprite::bench
