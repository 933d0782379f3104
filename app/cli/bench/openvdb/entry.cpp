#include "app/cli/bench/openvdb/parts.h"

namespace {

class Rivals : public voxprite::bench::OpenVdbRivals {
  public:
    std::unique_ptr<voxprite::bench::OpenVdbVolume> volume(glm::ivec3 size) const override {
        return voxprite::bench::makeVolume(size);
    }
    std::unique_ptr<voxprite::bench::OpenVdbGrid> grid() const override {
        return voxprite::bench::makeGrid();
    }
};

}  // namespace

// Where the library is entered.
extern "C" __attribute__((visibility("default"))) const voxprite::bench::OpenVdbRivals*
voxpriteOpenVdbRivals() {
    static const Rivals rivals;
    return &rivals;
}
