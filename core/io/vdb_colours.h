// The colours that a grid of vectors gives to voxels. Private to core/io.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <unordered_map>
#include <unordered_set>
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
    // The one colour of a cube that is aligned to its edge, a power of eight: where a tile of the
    // grid covers it, or (of 8, 64 or 512 an edge) nothing is in it.
    [[nodiscard]] std::optional<Rgba8> over(const IBox& cube) const;

  private:
    // Cubes of one edge, by place: one colour, or one for each of their cells.
    struct Level {
        int edge = 1;
        std::unordered_map<std::uint64_t, std::vector<Rgba8>> cubes;
    };
    [[nodiscard]] static std::uint64_t keyOf(glm::ivec3 cube);
    void add(glm::ivec3 origin, int edge, std::vector<Rgba8> colours);

    std::vector<Level> levels_;
    // Of those edges, the cubes with smaller ones in them.
    static constexpr std::array<int, 3> kEdges{8, 64, 512};
    std::array<std::unordered_set<std::uint64_t>, 3> parents_;
};

}  // namespace voxprite::vdb
