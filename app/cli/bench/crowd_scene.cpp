#include "app/cli/bench/crowd_scene.h"

#include <cmath>
#include <random>

#include "core/svo/bake.h"

namespace voxprite::bench {
namespace {

constexpr double kSpacingMetres = 2.5;

VoxelGrid person(int number) {
    const int width = 8 + number % 4 * 2;
    const int legs = 8 + number / 4 * 3;
    const auto colour = static_cast<std::uint8_t>(1 + 5 * number);
    VoxelGrid grid;
    const auto fill = [&](glm::ivec3 low, glm::ivec3 high, int shade) {
        grid.fill({low, high}, static_cast<std::uint8_t>(colour + shade));
    };
    fill({3, 0, 0}, {6, 5, legs}, 0);
    fill({width, 0, 0}, {width + 3, 5, legs}, 0);
    fill({3, 0, legs}, {width + 3, 6, legs + 12}, 1);
    fill({0, 1, legs + 3}, {3, 4, legs + 11}, 2);
    fill({width + 3, 1, legs + 3}, {width + 6, 4, legs + 11}, 2);
    fill({width / 2, 0, legs + 12}, {width / 2 + 6, 6, legs + 18}, 3);
    return grid;
}

int columnsOf(int entities) {
    return static_cast<int>(std::ceil(std::sqrt(static_cast<double>(entities))));
}

}  // namespace

Result<std::vector<Octree>> crowdModels() {
    std::vector<Octree> models;
    for (int k = 0; k < kCrowdModels; ++k) {
        Result<Octree> octree = bake(person(k));
        if (!octree) return Failure(octree.error());
        models.push_back(std::move(*octree));
    }
    return models;
}

std::vector<CrowdMember> crowd(const std::vector<Octree>& models, int entities,
                               const GameProfile& profile) {
    std::mt19937 random(3);
    std::vector<CrowdMember> members;
    members.reserve(static_cast<std::size_t>(entities));
    const int columns = columnsOf(entities);
    for (int k = 0; k < entities; ++k) {
        const int model = k % static_cast<int>(models.size());
        Entity entity;
        entity.yawDegrees = 45.0 * static_cast<double>(random() % 8);
        const auto jitter = [&] { return 0.01 * static_cast<double>(random() % 60); };
        const int row = k / columns;
        const double x = (k % columns - 0.5 * columns) * kSpacingMetres + jitter();
        const double z = (row - 0.5 * columns) * kSpacingMetres + jitter();
        entity.positionMetres = {x, groundClearanceMetres(profile), z};
        const IBox bounds{glm::ivec3(0), models[static_cast<std::size_t>(model)].size};
        members.push_back({model, placeEntity(entity, bounds, profile)});
    }
    return members;
}

double crowdExtentMetres(int entities) {
    return columnsOf(entities) * kSpacingMetres;
}

}  // namespace voxprite::bench
