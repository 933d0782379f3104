// What libvoxprite_openvdb.so is entered by.
#include "core/volume/openvdb_library.h"

extern "C" __attribute__((visibility("default"))) const voxprite::VolumeLibrary*
voxpriteVolumeLibrary() {
    return &voxprite::openVdbLibrary();
}
