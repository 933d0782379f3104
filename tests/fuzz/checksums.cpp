// In place of core/base/checksums.cpp, which the linker then leaves out.
#include "core/base/hash.h"

namespace voxprite {

const bool kChecksumsCount = false;

}  // namespace voxprite
