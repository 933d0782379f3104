#include "app/editor/commands/command_context.h"

#include "app/editor/panels/toasts.h"
#include "app/editor/session/file_flow.h"
#include "app/editor/session/selection_edits.h"
#include "app/editor/views/voxel_viewport.h"

namespace voxprite::editor {

void CommandContext::report(const Status& status) const {
    if (!status) toasts.error(status.error().describe());
}

void CommandContext::perform(Action action, const std::function<void()>& afterwards) {
    if (!session.isLong(action)) {
        const Status performed = session.perform(std::move(action));
        if (!performed) return report(performed);
        if (afterwards) afterwards();
        return;
    }
    // The steps of a drag follow each other from frame to frame.
    if (action.mergeKey != 0) return files.drag(std::move(action));
    std::string title = action.label;
    const auto shared = std::make_shared<Action>(std::move(action));
    files.step(
        std::move(title),
        [shared](const Session& s, const Progress& progress) {
            return s.prepare(std::move(*shared), progress);
        },
        afterwards);
}

bool CommandContext::settle() {
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
