// For whoever links OpenVDB: the work itself. The program has late/loaded.cpp in place of this.
#include "core/volume/openvdb_library.h"

namespace voxprite {

Result<const VolumeLibrary*> volumeLibrary() {
    return &openVdbLibrary();
}

}  // namespace voxprite
