// For the program: OpenVDB's library is loaded when something first asks for it.
#include "core/base/late_library.h"
#include "core/volume/volume_library.h"

namespace voxprite {

Result<const VolumeLibrary*> volumeLibrary() {
    using Entry = const VolumeLibrary*();
    static const Result<void*> entry = entryOf("libvoxprite_openvdb.so", "voxpriteVolumeLibrary");
    if (!entry) return Failure(entry.error());
    return reinterpret_cast<Entry*>(*entry)();
}

}  // namespace voxprite
