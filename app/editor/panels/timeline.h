// The animation, below both views: its frames, its clips, and what plays.
#pragma once

#include "app/editor/panels/ui.h"

namespace voxprite::editor {

// In device pixels; 0 while there is nothing to animate, or the artist folded it away.
[[nodiscard]] float timelineHeight(const Theme& theme, const Session& session,
                                   const EditorSettings& settings);
void drawTimeline(Ui& ui);

// The settings of a clip in a popup, opened under this name.
inline constexpr const char* kClipPopup = "clip";
void drawClipPopup(Ui& ui, int clip);
// The clip becomes `edited`, by the drag that is going on.
void editClip(Ui& ui, int clip, Clip edited);

}  // namespace voxprite::editor
