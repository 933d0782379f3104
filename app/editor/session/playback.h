// Plays the animation in both views: which clip, and where its head is.
#pragma once

#include <optional>

#include "app/editor/session/session.h"
#include "app/editor/settings/settings.h"
#include "core/model/playback.h"

namespace voxprite::editor {

class Playback {
  public:
    // While the view plays: shows the frame that is due. A clip that does not loop ends the
    // playing.
    [[nodiscard]] Status advance(Session& session, ViewSettings& view, double seconds);

    // An index into Document::clips; nothing plays all frames at the view's own rate.
    [[nodiscard]] std::optional<int> clip(const Document& document) const;
    void chooseClip(std::optional<int> clip) { clip_ = clip; }
    [[nodiscard]] Clip played(const Session& session, const ViewSettings& view) const;

  private:
    std::optional<int> clip_;
    PlayHead head_;
    bool plays_ = false;
};

}  // namespace voxprite::editor
