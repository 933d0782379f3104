// What libvoxprite_rivals.so is made of.
#pragma once

#include "app/cli/bench/openvdb_rivals.h"

namespace voxprite::bench {

[[nodiscard]] std::unique_ptr<OpenVdbVolume> makeVolume(glm::ivec3 size);
[[nodiscard]] std::unique_ptr<OpenVdbGrid> makeGrid();

}  // namespace voxprite::bench
