#include <openvdb/io/Compression.h>
#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>

#include <cstring>
#include <optional>
#include <sstream>

#include "core/volume/openvdb_library.h"

namespace voxprite {
namespace {

openvdb::Coord coord(glm::ivec3 v) {
    return {v.x, v.y, v.z};
}

class OpenVdbWriter : public VdbWriter {
  public:
    OpenVdbWriter() { openvdb::initialize(); }

    void beginGrid(const std::string& name, double voxelSizeMetres) override {
        grid_ = openvdb::Int32Grid::create(0);
        grid_->setName(name);
        grid_->setTransform(openvdb::math::Transform::createLinearTransform(voxelSizeMetres));
        grid_->setSaveFloatAsHalf(false);
        grids_.push_back(grid_);
        accessor_.emplace(grid_->tree());
    }
    void fill(const IBox& box, std::uint8_t value) override {
        accessor_->clear();
        grid_->sparseFill({coord(box.min), coord(box.max - 1)}, value, true);
    }
    void set(glm::ivec3 voxel, std::uint8_t value) override {
        accessor_->setValueOn(coord(voxel), value);
    }
    std::string file(const std::string& textName, const std::string& text) const override {
        openvdb::MetaMap metadata;
        metadata.insertMeta(textName, openvdb::StringMetadata(text));
        std::ostringstream stream(std::ios::binary);
        openvdb::io::Stream(stream).write(grids_, metadata);
        return std::move(stream).str();
    }

  private:
    openvdb::GridCPtrVec grids_;
    openvdb::Int32Grid::Ptr grid_;
    std::optional<openvdb::Int32Grid::Accessor> accessor_;
};

}  // namespace

std::unique_ptr<VdbWriter> openVdbWriter() {
    return std::make_unique<OpenVdbWriter>();
}

void openVdbUnpackBlosc(std::span<const std::uint8_t> packed, std::span<std::uint8_t> bytes) {
    const auto length = static_cast<std::int64_t>(packed.size());
    std::string text(sizeof length + packed.size(), '\0');
    std::memcpy(text.data(), &length, sizeof length);
    std::memcpy(text.data() + sizeof length, packed.data(), packed.size());
    std::istringstream stream(text);
    openvdb::io::bloscFromStream(stream, reinterpret_cast<char*>(bytes.data()), bytes.size());
}

}  // namespace voxprite
