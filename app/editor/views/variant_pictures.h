// Small sprites of the model in the palette's own colours and in those of each variant, cast as
// the game's are. They follow the document; what the mouse only hovers over is not in them.
#pragma once

#include <optional>
#include <vector>

#include "app/editor/session/session.h"
#include "core/sprite/sprite_buffer.h"
#include "render/picture_texture.h"

namespace voxprite::editor {

// The small sprite (small_sprite.h) of the document in these colours.
[[nodiscard]] std::optional<SpriteBuffer> smallSprite(const Session& session,
                                                      const Palette& palette, int edgePx);

class VariantPictures {
  public:
    static constexpr int kEdgePx = 48;

    // Brings them up to date. Needs the window's GL context.
    void update(const Session& session);
    // 0: the palette's own colours; k: variant k - 1.
    [[nodiscard]] const PictureTexture& picture(std::size_t k) const { return pictures_[k]; }
    [[nodiscard]] std::size_t count() const { return pictures_.size(); }

  private:
    std::vector<PictureTexture> pictures_;
    std::uint64_t modelRevision_ = 0;
    GameProfile profile_;
    Entity entity_;
};

}  // namespace voxprite::editor
