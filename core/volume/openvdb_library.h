// The parts of the VolumeLibrary that OpenVDB does. Private to core/volume.
#pragma once

#include "core/volume/volume_library.h"

namespace voxprite {

[[nodiscard]] std::unique_ptr<SolidVoxels> openVdbSolidVoxels();
[[nodiscard]] std::unique_ptr<NearestTriangles> openVdbNearestTriangles(
    const TriangleCorners& corners);
void openVdbFloodedInside(const TriangleCorners& corners, glm::ivec3 size,
                          const std::function<void(glm::ivec3 cell)>& visit);
[[nodiscard]] std::unique_ptr<VdbWriter> openVdbWriter();
void openVdbUnpackBlosc(std::span<const std::uint8_t> packed, std::span<std::uint8_t> bytes);

[[nodiscard]] const VolumeLibrary& openVdbLibrary();

}  // namespace voxprite
