#include "core/io/vdb_colours.h"

#include <algorithm>
#include <cmath>

namespace voxprite::vdb {
namespace {

Rgba8 colourFrom(const Value& value) {
    const auto byte = [](double part) {
        return static_cast<std::uint8_t>(std::lround(std::clamp(part, 0.0, 1.0) * 255.0));
    };
    return {byte(value[0]), byte(value[1]), byte(value[2]), 255};
}

int floorDivided(int x, int edge) {
    return x >= 0 ? x / edge : -((-x + edge - 1) / edge);
}

glm::ivec3 cubeOf(glm::ivec3 v, int edge) {
    return {floorDivided(v.x, edge), floorDivided(v.y, edge), floorDivided(v.z, edge)};
}

}  // namespace

std::uint64_t Colours::keyOf(glm::ivec3 cube) {
    const auto bits = [](int x) { return static_cast<std::uint64_t>(x) & 0x1F'FFFF; };
    return bits(cube.x) << 42 | bits(cube.y) << 21 | bits(cube.z);
}

void Colours::add(glm::ivec3 origin, int edge, std::vector<Rgba8> colours) {
    auto level = std::ranges::find(levels_, edge, &Level::edge);
    if (level == levels_.end()) level = levels_.insert(levels_.end(), {edge, {}});
    level->cubes[keyOf(cubeOf(origin, edge))] = std::move(colours);
    for (std::size_t k = 0; k < kEdges.size(); ++k) {
        if (edge < kEdges[k]) parents_[k].insert(keyOf(cubeOf(origin, kEdges[k])));
    }
}

Result<Colours> Colours::of(const Grid& grid, const VoxelGrid& voxels) {
    // Only cubes in the voxels' bounds are kept, and those are as few as the file is long.
    const IBox bounds = voxels.bounds();
    Colours colours;
    const auto matters = [&](glm::ivec3 origin, int edge) {
        if (!isInVoxelRange(origin) || !isInVoxelRange(origin + (edge - 1))) return false;
        return !IBox{origin, origin + edge}.intersected(bounds).empty();
    };
    Visit visit;
    visit.tile = [&](glm::ivec3 origin, int edge, const Value& value, bool active) -> Status {
        if (!active || !matters(origin, edge)) return {};
        colours.add(origin, edge, {colourFrom(value)});
        return {};
    };
    visit.leaf = [&](glm::ivec3 origin, int edge, std::span<const Value> values,
                     const std::vector<bool>&) -> Status {
        if (!matters(origin, edge)) return {};
        std::vector<Rgba8> cells;
        cells.reserve(values.size());
        for (const Value& value : values) cells.push_back(colourFrom(value));
        colours.add(origin, edge, std::move(cells));
        return {};
    };
    ByteReader reader = grid.tree;
    if (Status s = walk(grid, reader, visit); !s) return Failure(s.error());
    std::ranges::sort(colours.levels_, {}, &Level::edge);
    return colours;
}

Rgba8 Colours::at(glm::ivec3 v) const {
    for (const Level& level : levels_) {
        const glm::ivec3 cube = cubeOf(v, level.edge);
        const auto found = level.cubes.find(keyOf(cube));
        if (found == level.cubes.end()) continue;
        if (found->second.size() == 1) return found->second[0];
        const glm::ivec3 cell = v - cube * level.edge;
        const auto n =
            static_cast<std::size_t>((cell.x * level.edge + cell.y) * level.edge + cell.z);
        return found->second[n];
    }
    return {0, 0, 0, 255};
}

std::optional<Rgba8> Colours::over(const IBox& cube) const {
    const int edge = cube.size().x;
    for (const Level& level : levels_) {
        if (level.edge < edge) continue;
        const auto found = level.cubes.find(keyOf(cubeOf(cube.min, level.edge)));
        if (found == level.cubes.end()) continue;
        if (found->second.size() == 1) return found->second[0];
        return std::nullopt;
    }
    for (std::size_t k = 0; k < kEdges.size(); ++k) {
        const bool isEmpty =
            kEdges[k] == edge && !parents_[k].contains(keyOf(cubeOf(cube.min, edge)));
        if (isEmpty) return at(cube.min);
    }
    return std::nullopt;
}

}  // namespace voxprite::vdb
