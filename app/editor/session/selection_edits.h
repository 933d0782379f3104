// What can be done with the selection, or with the whole of the active object while nothing is
// selected. Everything fails when that object is hidden, locked or empty.
#pragma once

#include "app/editor/session/session.h"
#include "app/editor/settings/settings.h"

namespace voxprite::editor {

// The voxels that commands are about.
struct Chosen {
    int node = -1;
    int model = 0;
    Placement entityFromModel;
    VoxelSet voxels;        // model space
    bool selected = false;  // by the artist; else they are the whole object
};
[[nodiscard]] Result<Chosen> chosenVoxels(const Session& session);
// Is something selected, and does it lie in what is shown? In another frame it may not.
[[nodiscard]] bool selectionShows(const Session& session);

// --- selecting; all within the active object
[[nodiscard]] Status selectEverything(Session& session);
[[nodiscard]] Status invertSelection(Session& session);
[[nodiscard]] Status selectColour(Session& session, std::uint8_t colour);

// --- clipboard
[[nodiscard]] Status copySelection(Session& session);

// --- into the air; the Move tool puts down what floats
[[nodiscard]] Status lift(Session& session, const ToolSettings& settings, Floating::Kind kind);
// Do its colours lie where the document has them, whatever document it was copied from?
[[nodiscard]] bool clipFits(const Session& session);
// Makes them: finds each colour's place, and adds those that the document lacks while there is
// room; `said` tells the artist, if there is anything to tell.
[[nodiscard]] Status fitClip(Session& session, std::string& said);
// To where it was copied from, into the active object.
[[nodiscard]] Status pasteClip(Session& session);
// A copy of it, beside it.
[[nodiscard]] Status duplicateSelection(Session& session);
// Puts down what floats. Nothing when that changes nothing.
[[nodiscard]] Result<std::optional<Action>> putDown(Session& session);

// --- at once
[[nodiscard]] Result<Action> deleteSelection(const Session& session, const char* verb);
[[nodiscard]] Result<Action> recolourSelection(const Session& session, std::uint8_t colour);
// All else of the object goes away.
[[nodiscard]] Result<Action> cropToSelection(const Session& session);
[[nodiscard]] Result<Action> trimToBox(const Session& session, const IBox& entityBox);
// What is selected leaves its object and becomes one of its own, the last node.
[[nodiscard]] Result<Action> selectionToObject(const Session& session);

}  // namespace voxprite::editor
