// Puts .vox files together chunk by chunk, right or wrong, without any code of the reader or
// writer.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/base/bytes.h"
#include "core/model/palette.h"

namespace voxprite::test {

// Little-endian 32 bits, a string, a dictionary: appended to `bytes`.
void put32(Bytes& bytes, std::int64_t value);
void putText(Bytes& bytes, const std::string& text);
void putProperties(Bytes& bytes, const Properties& properties);

class VoxBuilder {
  public:
    using Voxel = std::array<std::uint8_t, 4>;  // x, y, z, colour

    VoxBuilder& chunk(const std::string& id, const Bytes& content, const Bytes& children = {});
    // SIZE and XYZI.
    VoxBuilder& model(glm::ivec3 size, const std::vector<Voxel>& voxels);
    // Nodes of the scene graph. Frames and models come with their attributes.
    VoxBuilder& transform(int id, int child, const Properties& attributes = {},
                          const std::vector<Properties>& frames = {{}}, int layer = -1);
    VoxBuilder& group(int id, const std::vector<int>& children, const Properties& attributes = {});
    VoxBuilder& shape(int id, const std::vector<std::pair<int, Properties>>& models,
                      const Properties& attributes = {});
    VoxBuilder& layer(int id, const Properties& attributes);

    [[nodiscard]] Bytes bytes(int version = 200) const;
    // Where the content of the next chunk will stand in the file.
    [[nodiscard]] std::uint64_t nextContent() const { return 20 + chunks_.size() + 12; }

  private:
    Bytes chunks_;
};

// One solid voxel in the middle of a model of this size, placed by a scene graph of one object.
[[nodiscard]] VoxBuilder oneObject(glm::ivec3 size, const Properties& frame);

}  // namespace voxprite::test
