// Alone in its file, so that a program that defines it does not get this one from the library.
#include "core/base/hash.h"

namespace voxprite {

const bool kChecksumsCount = true;

}  // namespace voxprite
