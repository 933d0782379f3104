// What comes up over the window on a command and goes again, all in one place.
#pragma once

#include "app/editor/panels/command_palette.h"
#include "app/editor/panels/preferences.h"
#include "app/editor/panels/saved_cameras.h"
#include "app/editor/panels/sheet_dialog.h"
#include "app/editor/panels/tour.h"

namespace voxprite::editor {

struct Overlays {
    CommandPalette palette;
    Preferences preferences;
    SavedCameras cameras;
    Tour tour;
    SheetDialog sheet;

    // "palette", "preferences", "cameras", "sheet", "tour" or nothing.
    [[nodiscard]] const char* openName() const {
        if (palette.isOpen()) return "palette";
        if (preferences.isOpen()) return "preferences";
        if (cameras.isOpen()) return "cameras";
        if (sheet.isOpen()) return "sheet";
        return tour.isOpen() ? "tour" : "";
    }
};

}  // namespace voxprite::editor
