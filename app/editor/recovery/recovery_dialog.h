// What editors left behind that crashed, with a picture of each: the artist takes it or leaves it.
#pragma once

#include <optional>
#include <vector>

#include "app/editor/panels/ui.h"
#include "app/editor/recovery/recovery_folder.h"
#include "render/picture_texture.h"

namespace voxprite::editor {

class RecoveryDialog {
  public:
    // Needs the window's GL context.
    void offer(std::vector<LostWork> works);
    [[nodiscard]] bool isOpen() const { return !offered_.empty(); }
    // The work to recover, in the frame in which it was chosen; what stays unchosen is offered
    // again at the next start, unless it was discarded.
    [[nodiscard]] std::optional<LostWork> draw(Ui& ui);

  private:
    struct Offered {
        LostWork work;
        PictureTexture picture;
    };
    enum class Answer : std::uint8_t { none, recover, discard };
    [[nodiscard]] Answer drawOne(Ui& ui, const Offered& offered);

    std::vector<Offered> offered_;
};

}  // namespace voxprite::editor
