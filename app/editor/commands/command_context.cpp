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
        const auto waits = [&] { return files.blocks() || files.comesAfterDrag(edit.mergeKey); };
        if (!waits() && edit.settles) static_cast<void>(settle());
        if (waits()) {
            edits.push(std::move(edit));
        } else {
            perform(edit.make(session.document()));
        }
    }
}

bool CommandContext::settle() {
    // A step of a drag may be put in force at any time: no other one is made beside it.
    const auto waits = [this] { return files.blocks() || files.drags(); };
    if (waits()) return false;
    if (auto made = editView.tools().confirm(session)) perform(std::move(*made));
    if (waits()) return false;
    Result<std::optional<Action>> action = putDown(session);
    if (!action) {
        report(Failure(action.error()));
    } else if (*action) {
        perform(std::move(**action));
    }
    return !waits();
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
