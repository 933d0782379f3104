// All that a command may reach: what it changes and who carries it out. One place instead of a
// global; App owns it for as long as it lives.
#pragma once

#include <string>

#include "app/editor/session/session.h"
#include "app/editor/settings/settings.h"

namespace voxprite::editor {

class VoxelViewport;
class SpriteViewport;
class FileFlow;
class Dialogs;
class ObjectSelection;
class Playback;
class Toasts;
struct Overlays;
class PaletteEditor;

struct CommandContext {
    Session& session;
    EditorSettings& settings;
    VoxelViewport& editView;
    SpriteViewport& spriteView;
    FileFlow& files;
    Dialogs& dialogs;
    Toasts& toasts;
    Overlays& overlays;
    ObjectSelection& objects;
    Playback& playback;
    PaletteEditor& palette;

    void perform(Action action) { report(session.perform(std::move(action))); }
    // A failure becomes a message on screen.
    void report(const Status& status) const;
};

}  // namespace voxprite::editor
