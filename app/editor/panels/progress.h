// What goes on behind the window, and a way to stop it.
#pragma once

#include "app/editor/panels/ui.h"
#include "app/editor/session/background_job.h"

namespace voxprite::editor {

// In front of everything when it `blocks`, else a card in the corner. Takes the mouse and keys even
// before it `shows`, if it blocks. True when it shall be cancelled.
[[nodiscard]] bool drawProgress(Ui& ui, const BackgroundJob& job, bool blocks, bool shows);

}  // namespace voxprite::editor
