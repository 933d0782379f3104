#include "core/model/store_version.h"

#include <openvdb/version.h>

namespace voxprite {

std::string storeVersion() {
    return "OpenVDB " OPENVDB_LIBRARY_VERSION_STRING;
}

}  // namespace voxprite
