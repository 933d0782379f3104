// Elapsed time, by the name that the commands and the bench have for it.
#pragma once

#include "core/base/stopwatch.h"

namespace voxprite::cli {

using voxprite::Stopwatch;

}  // namespace voxprite::cli
