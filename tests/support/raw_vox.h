// A second opinion on .vox files: walks the bare chunks and places the models of frame 0 by
// following the nodes, sharing no code with the reader. For good files only.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/base/bytes.h"

namespace voxprite::test {

struct RawModel {
    std::array<int, 3> size{};
    std::vector<std::uint8_t> cells;  // the colour of each, x fastest; 0 where there is no voxel

    [[nodiscard]] std::uint8_t& at(int x, int y, int z) {
        return cells.at(static_cast<std::size_t>((z * size[1] + y) * size[0] + x));
    }
};

// Positions within +-2^20, packed so that they can be looked up fast.
[[nodiscard]] std::uint64_t packed(int x, int y, int z);

struct RawVox {
    std::vector<RawModel> models;
    std::vector<std::array<std::uint8_t, 4>> colours;  // of RGBA, none without one
    bool hasSceneGraph = false;
    // Visible voxels of frame 0 where the scene graph puts them; in drawing order, so that a later
    // one with the same position wins.
    std::unordered_map<std::uint64_t, std::uint8_t> placed;  // by packed position
};

// Nothing where the file is none of MagicaVoxel's or has no plain voxels.
[[nodiscard]] std::optional<RawVox> readRawVox(const Bytes& file);

}  // namespace voxprite::test
