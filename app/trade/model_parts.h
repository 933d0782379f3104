// A model with everything that it can be drawn by, made when it is first asked for.
#pragma once

#include <map>
#include <memory>

#include "app/trade/meter.h"
#include "core/lod/cluster_mesh.h"
#include "core/sprite/placed_entity.h"

namespace voxprite::trade {

class ModelParts {
  public:
    // Its centre stands at the world's origin.
    ModelParts(std::shared_ptr<const Model> model, const GameProfile& profile);

    [[nodiscard]] const Model& model() const { return *model_; }
    [[nodiscard]] const PlacedEntity& placed() const { return placed_; }
    [[nodiscard]] int mostLevels() const { return mostLevels_; }

    struct Coarse {
        Octree octree;
        PlacedEntity placed;
        double milliseconds = 0.0;  // that making it took
    };
    // levels: 1 ... mostLevels().
    [[nodiscard]] Result<const Coarse*> coarse(int levels);
    struct Clusters {
        ClusterMesh mesh;
        double milliseconds = 0.0;
    };
    [[nodiscard]] Result<const Clusters*> clusters();

  private:
    std::shared_ptr<const Model> model_;
    PlacedEntity placed_;
    int mostLevels_ = 0;
    std::map<int, Coarse> coarse_;
    std::unique_ptr<Clusters> clusters_;
};

[[nodiscard]] std::uint64_t bytesOf(const OctreeView& octree);

}  // namespace voxprite::trade
