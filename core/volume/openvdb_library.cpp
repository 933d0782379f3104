#include "core/volume/openvdb_library.h"

namespace voxprite {
namespace {

class OpenVdbLibrary : public VolumeLibrary {
  public:
    std::unique_ptr<SolidVoxels> solidVoxels() const override { return openVdbSolidVoxels(); }
    std::unique_ptr<NearestTriangles> nearestTriangles(
        const TriangleCorners& corners) const override {
        return openVdbNearestTriangles(corners);
    }
    void forEachFloodedInside(const TriangleCorners& corners, glm::ivec3 size,
                              const std::function<void(glm::ivec3 cell)>& visit) const override {
        openVdbFloodedInside(corners, size, visit);
    }
    std::unique_ptr<VdbWriter> vdbWriter() const override { return openVdbWriter(); }
    void unpackBlosc(std::span<const std::uint8_t> packed,
                     std::span<std::uint8_t> bytes) const override {
        openVdbUnpackBlosc(packed, bytes);
    }
};

}  // namespace

const VolumeLibrary& openVdbLibrary() {
    static const OpenVdbLibrary library;
    return library;
}

}  // namespace voxprite
