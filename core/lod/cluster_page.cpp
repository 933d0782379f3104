#include "core/lod/cluster_page.h"

namespace voxprite {
namespace {

void writeFloat(float value, ByteWriter& out) {
    out.u32(std::bit_cast<std::uint32_t>(value));
}

void writeVector(glm::vec3 value, ByteWriter& out) {
    writeFloat(value.x, out);
    writeFloat(value.y, out);
    writeFloat(value.z, out);
}

}  // namespace

void writeClusterPage(const ClusterPage& page, ByteWriter& out) {
    writeVector(page.centre, out);
    writeFloat(page.radius, out);
    writeVector(page.lodBoundsCentre, out);
    writeFloat(page.lodBoundsRadius, out);
    writeVector(page.parentBoundsCentre, out);
    writeFloat(page.parentBoundsRadius, out);
    writeFloat(page.lodError, out);
    writeFloat(page.parentError, out);
    out.u32(page.firstIndex);
    out.u32(page.indexCount);
}

void writeClusterCutParams(const ClusterCutParams& params, ByteWriter& out) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) writeFloat(params.worldFromTree[column][row], out);
    }
    writeVector(params.cameraPosition, out);
    writeFloat(params.tanHalfFovY, out);
    writeFloat(params.viewportHeight, out);
    writeFloat(params.pixelBudget, out);
    writeFloat(params.worldScale, out);
    out.u32(params.clusterCount);
}

}  // namespace voxprite
