// All that a command may reach: what it changes and who carries it out. One place instead of a
// global; App owns it for as long as it lives.
#pragma once

#include <functional>
#include <string>

#include "app/editor/session/session.h"
#include "app/editor/settings/settings.h"

namespace voxprite::editor {

class VoxelViewport;
class SpriteViewport;
class FileFlow;
class Dialogs;
class EditQueue;
class ObjectSelection;
class Playback;
class Toasts;
struct Overlays;
class PaletteEditor;
class TradeStudy;

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
    TradeStudy& study;

    // At once, or behind the window when the step is long (FileFlow::step). `afterwards` once it is
    // in force; never, when it fails or is stopped.
    void perform(Action action, const std::function<void()>& afterwards = {});
    // What must wait stays in the queue.
    void perform(EditQueue& edits);
    void undo();
    void redo();
    // What is in the air, or being made, comes down, as before every other edit. False while that
    // goes on behind the window, or must wait for what does.
    [[nodiscard]] bool settle();
    // A failure becomes a message on screen.
    void report(const Status& status) const;
};

}  // namespace voxprite::editor
