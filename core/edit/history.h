// Every change to a document or profile is an Action that the history executes; nothing else
// changes them. Each action holds its before and after, so undo and redo are exact.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/boxed.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/model/document.h"
#include "core/model/game_profile.h"

namespace voxprite {

struct VoxelChange {
    glm::ivec3 position{0};  // model space
    std::uint8_t before = 0;
    std::uint8_t after = 0;
    bool operator==(const VoxelChange&) const = default;
};

// Every part says what shall be; what was there before is recorded by History::execute itself, so
// that undo is exact even when the caller's `before` is stale.

// Sparse before/after of one model. In a recorded step: ascending positions (x, then y, then z),
// none twice, no change with before == after.
struct VoxelPatch {
    int model = 0;
    std::vector<VoxelChange> changes;
};

// A whole value replaced by another of its kind.
struct PaletteEdit {
    Boxed<Palette> before, after;  // boxed: 22 KB each, and most steps hold none
};
struct EntityEdit {
    Entity before, after;
};
struct ProfileEdit {
    GameProfile before, after;
};
struct SocketsEdit {
    std::vector<Socket> before, after;
};
// The scene graph with its layers and clips; models themselves are only ever appended or, on undo,
// removed again. `addedModels` stand behind the first modelsBefore of the document; while the step
// is in force the document holds them and the list is empty.
struct SceneState {
    std::vector<SceneNode> nodes;
    std::vector<Layer> layers;
    std::vector<Clip> clips;
    bool operator==(const SceneState&) const = default;
};
[[nodiscard]] SceneState sceneOf(const Document& document);
// Do both look the same in every frame, whatever their objects and layers are called?
[[nodiscard]] bool showsTheSame(const SceneState& a, const SceneState& b);
struct SceneEdit {
    SceneState before, after;
    std::size_t modelsBefore = 0;
    std::vector<Model> addedModels;
    // The index that each node of `before` has in `after`, -1: it is gone. Empty: the one it had.
    std::vector<int> nodesAfter{};
};

using ActionPart =
    std::variant<VoxelPatch, PaletteEdit, EntityEdit, ProfileEdit, SocketsEdit, SceneEdit>;

// Finds the patches of an edit in a document; on any thread, and any number of times.
using MakePatches = std::function<Result<std::vector<VoxelPatch>>(const Document&)>;
// Of one patch, or why there is none.
[[nodiscard]] Result<std::vector<VoxelPatch>> onePatch(Result<VoxelPatch> patch);

struct Action {
    std::string label;  // "Attach 12 voxels"; shown in the history panel
    std::vector<ActionPart> parts;
    // Actions with the same non-zero key that follow each other become one step (a slider drag, a
    // stroke of the brush), with the later label. A new stroke takes a new key.
    std::uint64_t mergeKey = 0;
    // For an edit of very many voxels, whose patches take long to find: they are found when it is
    // carried out, which may be on another thread, and stand behind `parts`. Empty after
    // makeParts().
    MakePatches makePatches;

    [[nodiscard]] std::size_t bytes() const;  // memory held, about
};
// Has `action` say all that it does. Fails as its makePatches does.
[[nodiscard]] Status makeParts(Action& action, const Document& document);

// What the artist edits.
struct Workspace {
    Document document = Document::withEmptyModel();
    GameProfile profile;
};

// What a step changed, for those who keep something derived from the workspace.
struct Changed {
    struct Voxels {
        int model = 0;
        std::vector<glm::ivec3> positions;  // model space; of a prepared step: none, it may be all
    };
    std::vector<Voxels> voxels;
    bool palette = false;
    bool entity = false;
    bool profile = false;
    bool sockets = false;
    bool scene = false;  // placements, visibility, models: rebuild what depends on them
    bool notes = false;  // of the scene, what no picture shows: names, locks, clips
    // As SceneEdit::nodesAfter.
    std::vector<int> nodesAfter;

    // The index that a node (-1: none) has now; -1 when it is gone.
    [[nodiscard]] int nodeNow(int before) const;
    [[nodiscard]] bool any() const {
        return !voxels.empty() || palette || entity || profile || sockets || scene || notes;
    }
};

// A step carried out on a copy of the workspace: see History::prepare().
struct PreparedStep {
    enum class Way : std::uint8_t { execute, undo, redo };
    Way way = Way::execute;
    Workspace workspace{};  // as the step leaves it
    Action action{};        // of Way::execute
    // Of the others, what undoing and redoing changes in the step itself, by the number of the
    // part.
    std::vector<std::pair<std::size_t, ActionPart>> parts{};
    Changed changed{};
};

class History {
  public:
    // Whoever keeps something derived from the workspace goes along with what a step changes, or
    // says why it cannot. Then the step is taken back, and it is told of that too.
    using Follow = std::function<Status(const Changed&)>;

    // Applies `action` and records it; an action that changes nothing is not recorded. Drops the
    // redoable steps, and the oldest ones while more than memoryLimitBytes() are held; the newest
    // always stays. A step that merging has brought back to its start goes away. Nothing merges
    // into a step at which the workspace was saved, so that undo leads back to what was saved. What
    // `follow` refuses returns nothing changed, and no step is recorded, merged or dropped.
    Changed execute(Workspace& workspace, Action action, const Follow& follow = {});
    // Nothing to undo or redo, or `follow` refuses: returns nothing changed.
    Changed undo(Workspace& workspace, const Follow& follow = {});
    Changed redo(Workspace& workspace, const Follow& follow = {});

    // The same in two halves, for steps of very many voxels. What takes long changes nothing here,
    // so that it can go on on another thread while nobody else changes history or workspace; then
    // commit() puts the step in force at once. They fail when they are stopped, execution also as
    // makeParts() does; undo and redo need a step to go to.
    [[nodiscard]] static Result<PreparedStep> prepare(const Workspace& workspace, Action action,
                                                      const Progress& progress = {});
    [[nodiscard]] Result<PreparedStep> prepareUndo(const Workspace& workspace,
                                                   const Progress& progress = {}) const;
    [[nodiscard]] Result<PreparedStep> prepareRedo(const Workspace& workspace,
                                                   const Progress& progress = {}) const;
    Changed commit(Workspace& workspace, PreparedStep step);

    [[nodiscard]] bool canUndo() const { return position_ > 0; }
    [[nodiscard]] bool canRedo() const { return position_ < steps_.size(); }
    [[nodiscard]] const std::vector<Action>& steps() const { return steps_; }
    [[nodiscard]] std::size_t position() const { return position_; }  // steps in force
    [[nodiscard]] std::size_t bytes() const { return bytes_; }
    [[nodiscard]] std::size_t memoryLimitBytes() const { return memoryLimitBytes_; }
    void setMemoryLimitBytes(std::size_t limit) { memoryLimitBytes_ = limit; }
    // Forgets all steps; the workspace stays as it is.
    void clear();

    // Is the workspace as it was at the last markSaved()?
    [[nodiscard]] bool isSaved() const {
        return savedPosition_ == static_cast<long long>(position_);
    }
    // Does it differ from that in a part that counts? Also true where no undo or redo leads back.
    [[nodiscard]] bool differsFromSaved(const std::function<bool(const ActionPart&)>& counts) const;
    void markSaved() { savedPosition_ = static_cast<long long>(position_); }
    // What was marked has not been saved after all.
    void markUnsaved() { savedPosition_ = -1; }

  private:
    void dropRedoable();
    void record(const Workspace& workspace, Action action);
    void dropOldest();

    std::vector<Action> steps_;
    std::size_t position_ = 0;
    std::size_t bytes_ = 0;
    std::size_t memoryLimitBytes_ = std::size_t{2} << 30;
    long long savedPosition_ = 0;  // -1: no longer reachable
};

}  // namespace voxprite
