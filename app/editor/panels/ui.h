// What a panel is given: the document to show, settings to edit, and where to put what it wants
// done. A panel changes nothing but settings; edits of the document leave it as actions.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/editor/commands/command_context.h"
#include "app/editor/commands/commands.h"
#include "app/editor/session/session.h"
#include "app/editor/settings/settings.h"
#include "app/editor/views/scene_figures.h"
#include "app/editor/window/layout_probe.h"
#include "app/editor/window/theme.h"
#include "core/edit/make_action.h"

namespace voxprite::editor {

// Edits on their way to the session. All that come from one drag of a widget carry one key.
class EditQueue {
  public:
    // What an edit does to the document as it is when its turn comes; asked once.
    using Make = std::function<Action(const Document&)>;
    struct Edit {
        Make make;
        std::uint64_t mergeKey = 0;
        bool settles = false;  // what is in the air, or being made, is put down first
    };

    // Call after every widget that can be dragged: a new drag starts a new step.
    void watchItem(Session& session) {
        if (ImGui::IsItemActivated() || key_ == 0) key_ = session.newMergeKey();
    }
    template <class Part>
    void push(std::string label, Part part, bool merge = true) {
        push(makeAction(std::move(label), std::move(part), merge ? key_ : 0));
    }
    void push(Action action) {
        const std::uint64_t mergeKey = action.mergeKey;
        push(Edit{
            [action = std::move(action)](const Document&) mutable { return std::move(action); },
            mergeKey});
    }
    // An edit of the scene replaces all of it: made before its turn, it would take back what it
    // waits for. And what is in the air belongs to where its object lies now. `mergeKey` is its
    // action's.
    void pushScene(Make make, std::uint64_t mergeKey = 0) {
        push(Edit{std::move(make), mergeKey, true});
    }
    void push(Edit edit) { edits_.push_back(std::move(edit)); }
    // Of the drag that is going on.
    [[nodiscard]] std::uint64_t key() const { return key_; }
    [[nodiscard]] std::vector<Edit> take() { return std::exchange(edits_, {}); }

  private:
    std::vector<Edit> edits_;
    std::uint64_t key_ = 0;
};

// What only the views know, for the status bar.
struct ViewFigures {
    double sigmaInForce = 0.0;  // 0: no sprite is drawn
    double screenPxPerPx = 0.0;
    std::optional<glm::ivec3> hovered;  // voxel, entity space
    std::optional<double> editMilliseconds;
    SceneFigures scene;
    std::string strokeSize;  // "12 × 5 × 1" while a box is drawn
};

struct Ui {
    const Theme& theme;
    Session& session;
    EditorSettings& settings;
    EditQueue& edits;
    CommandQueue& commands;
    const CommandContext& context;  // for what state a command is in
    LayoutProbe& probe;
    ViewFigures& figures;
    // Where the pointer went since the last frame, from where it was then; window pixels.
    std::span<const glm::dvec2> pointerPath;
};

}  // namespace voxprite::editor
