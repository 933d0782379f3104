// The sockets over the two views: a mark where each lies, with its name.
#pragma once

#include <optional>

#include "app/editor/panels/ui.h"
#include "app/editor/session/session.h"
#include "app/editor/views/view_drawing.h"

namespace voxprite::editor {

// Over the edit view. The chosen one stands out.
void drawSocketsOverVoxels(Ui& ui, const ViewDrawing& drawing);
// Over the sprite: where the sprite's parallel rays see them, not where the eye would. What the
// voxels hide is faint.
void drawSocketsOverSprite(Ui& ui, const ViewDrawing& drawing, const Camera& camera,
                           ViewHistory history);

// The socket whose mark lies under a position of the edit view, if any.
[[nodiscard]] std::optional<int> socketAt(const Session& session, const Camera& camera,
                                          glm::dvec2 viewPx, double reachPx);

}  // namespace voxprite::editor
