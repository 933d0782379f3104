// OpenGL to measure with: the model's parts on the GPU, and frames drawn as the game's scene draws
// them. Needs a current GL 4.5 context for as long as it lives. Serves one meter at a time.
#pragma once

#include <cstdint>
#include <memory>

#include "app/trade/model_parts.h"
#include "core/sprite/sprite_view.h"

namespace voxprite::trade {

class GlStage {
  public:
    [[nodiscard]] static Result<GlStage> create();
    ~GlStage();
    GlStage(GlStage&&) noexcept;
    GlStage& operator=(GlStage&&) noexcept;

    // What the rest draws. `parts` is used until another is given.
    void setModel(ModelParts& parts);

    // The sprite buffer of the octree that the setting draws.
    [[nodiscard]] Result<SpriteBuffer> castBuffer(const Setting& setting,
                                                  const LatticeView& lattice,
                                                  const LitPalette& lit);
    // The picture read back; of clusters, which have no buffer.
    [[nodiscard]] Result<Shown> show(const Setting& setting, const GameProfile& profile,
                                     const Camera& camera);

    // Sprites and snapshots that were cast are cast anew.
    void forget();
    // One frame, `profile` with the setting in it. The milliseconds until all is drawn.
    [[nodiscard]] Result<double> frame(const Setting& setting, const GameProfile& profile,
                                       const Camera& camera, ViewHistory& history);

  private:
    struct Impl;
    explicit GlStage(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace voxprite::trade
