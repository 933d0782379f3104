#include "app/editor/commands/command_context.h"

#include "app/editor/panels/toasts.h"
#include "app/editor/panels/ui.h"
#include "app/editor/session/file_flow.h"
#include "app/editor/session/selection_edits.h"
#include "app/editor/views/voxel_viewport.h"

namespace voxprite::editor {

void CommandContext::report(const Status& status) const {
    if (!status) toasts.error(status.error().describe());
}

void CommandContext::perform(Action action, const std::function<void()>& afterwards) {
    const bool isLong = session.isLong(action);
    // The steps of a drag follow each other from frame to frame; the one back to where it began is
    // short, and takes the place of the last all the same.
    if (action.mergeKey != 0 && (isLong || files.drags())) return files.drag(std::move(action));
    if (!isLong) {
        const Status performed = session.perform(std::move(action));
        if (!performed) return report(performed);
        if (afterwards) afterwards();
        return;
    }
    std::string title = action.label;
    const auto shared = std::make_shared<Action>(std::move(action));
    files.step(
        std::move(title),
        [shared](const Session& s, const Progress& progress) {
            return s.prepare(std::move(*shared), progress);
        },
        afterwards);
}

void CommandContext::perform(EditQueue& edits) {
    for (EditQueue::Edit& edit : edits.take()) {
        // One long step at a time: the others come after it, but for those of the same drag.
        const bool waits = files.blocks() || files.comesAfterDrag(edit.mergeKey);
        // What is in the air belongs to where its object lies now.
        if (!waits && edit.ofScene) static_cast<void>(settle());
        if (waits || files.blocks()) {
            edits.push(std::move(edit));
        } else {
            perform(edit.make(session.document()));
        }
    }
}

bool CommandContext::settle() {
    if (files.blocks()) return false;
    if (auto made = editView.tools().confirm(session)) perform(std::move(*made));
    if (files.blocks()) return false;
    Result<std::optional<Action>> action = putDown(session);
    if (!action) {
        report(Failure(action.error()));
    } else if (*action) {
        perform(std::move(**action));
    }
    return !files.blocks();
}

void CommandContext::undo() {
    if (!session.undoIsLong()) return report(session.undo());
    files.step("Undo: " + session.history().steps()[session.history().position() - 1].label,
               [](const Session& s, const Progress& progress) { return s.prepareUndo(progress); });
}

void CommandContext::redo() {
    if (!session.redoIsLong()) return report(session.redo());
    files.step("Redo: " + session.history().steps()[session.history().position()].label,
               [](const Session& s, const Progress& progress) { return s.prepareRedo(progress); });
}

}  // namespace voxprite::editor
