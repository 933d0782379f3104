// The soft shade between voxels in the voxel view.
#pragma once

#include <cstdint>

namespace voxprite {

enum class VoxelOcclusion : std::uint8_t {
    off,
    corners,  // where voxels stand up beside a face
    rays      // by the short rays of core/sprite/face_shade.h, which see farther; smooth
};

}  // namespace voxprite
