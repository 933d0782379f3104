// The colours that a grid of vectors gives to voxels. Private to core/io.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/base/box.h"
#include "core/base/image.h"
#include "core/base/result.h"
#include "core/io/vdb_file.h"
#include "core/model/voxel_grid.h"

namespace voxprite::vdb {

class Colours {
  public:
    // Of a grid of kind vector; kept only where there is a voxel near. `grid` may be any within the
    // range of voxels.
    [[nodiscard]] static Result<Colours> of(const Grid& grid, const VoxelGrid& voxels);
    // Alpha 255; black where the grid has nothing.
    [[nodiscard]] Rgba8 at(glm::ivec3 v) const;
    // The one colour of a cube, where a tile of the grid covers it or the grid has nothing at all.
    // Its edge is a power of two, and it is aligned to that.
    [[nodiscard]] std::optional<Rgba8> over(const IBox& cube) const;

  private:
    // Cubes of one edge, by place: one colour, or one for each of their cells.
    struct Level {
        int edge = 1;
        std::unordered_map<std::uint64_t, std::vector<Rgba8>> cubes;
    };
    [[nodiscard]] static std::uint64_t keyOf(glm::ivec3 cube);
    Level& level(int edge);

    std::vector<Level> levels_;
};

}  // namespace voxprite::vdb
