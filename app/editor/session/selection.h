// What the artist has selected, and the voxels that are in the air: lifted out of an object or
// pasted, and no part of the document until they are put down. No part of the document itself;
// plain values, kept right by the session whenever the document changes.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "core/edit/clip.h"
#include "core/edit/history.h"
#include "core/edit/selection.h"

namespace voxprite::editor {

// A step of more voxels is worked out behind the window. (A box of 64 cubed is not one: it is shown
// and made within a frame's time.)
inline constexpr std::uint64_t kLongStepVoxels = 300'000;

// Voxels in the air and where they come from. Putting them down takes `from` away and lays over it
// what made() gives: one patch, so that nothing is lost before.
struct Floating {
    enum class Kind : std::uint8_t { move, hollow, dilate, erode, smooth };

    Kind kind = Kind::move;
    std::string label;  // of the step that it becomes
    int node = -1;
    int model = 0;
    Placement entityFromModel;
    VoxelSet from;               // model space; empty for what was pasted
    VoxelClip clip;              // entity space, so that it lies as it looks on screen
    std::optional<IBox> limits;  // entity space: nothing outside it changes
    bool selects = true;         // what was put down is selected
    glm::ivec3 home{0};          // the minimum corner of bounds() when it was lifted
    // What the number in the options stands for: the scale, or layers, or passes.
    int amount = 1;

    [[nodiscard]] static int greatestAmount(Kind kind);
    [[nodiscard]] IBox bounds() const;  // entity space, scaled
    void moveTo(glm::ivec3 min);
    void moveBy(glm::ivec3 byVoxels) { clip.modelFromClip.translation += byVoxels; }
    // About the middle of what is seen; `axis` of entity space.
    void turn(int axis, int turns);
    void flip(int axis);
    // Scaled, or hollowed and so on; entity space.
    [[nodiscard]] Result<VoxelClip> made() const;
    [[nodiscard]] Result<VoxelPatch> patch(const Document& document) const;
    // What will be selected once it is put down; model space.
    [[nodiscard]] Result<VoxelSet> footprint() const;
    // So many voxels that to put them down, or to show where they would lie, takes long.
    [[nodiscard]] bool isLarge() const;

  private:
    void place(const SignedPermutation& rotation);
};

class VoxelSelection {
  public:
    // Solid voxels of one model, model space.
    [[nodiscard]] const VoxelSet& voxels() const { return *now_.voxels; }
    // They never change, whatever is selected later.
    [[nodiscard]] const std::shared_ptr<const VoxelSet>& sharedVoxels() const {
        return now_.voxels;
    }
    [[nodiscard]] bool empty() const { return voxels().empty(); }
    // The object it was made in; means nothing while it is empty.
    [[nodiscard]] int node() const { return now_.node; }
    [[nodiscard]] int model() const { return now_.model; }
    // Rises with every change of the selection and of what floats, and when nodes get other
    // indices.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }

    // Within another object than before there is nothing to add to or take from.
    void select(int node, int model, VoxelSet with, SelectMode mode = SelectMode::replace);
    void clear() { select(-1, 0, {}); }

    [[nodiscard]] const std::optional<Floating>& floating() const { return floating_; }
    void setFloating(std::optional<Floating> floating);
    // change(Floating&), while something floats.
    template <class Change>
    void changeFloating(const Change& change) {
        if (!floating_) return;
        change(*floating_);
        ++revision_;
    }

    // --- for the session
    // Becomes the selection with the next step.
    void selectWithNextStep(int node, int model, VoxelSet voxels);
    // What floats comes down with the next step, and is in the air until then.
    void landWithNextStep() { lands_ = floating_.has_value(); }
    // What will then be selected; nothing when the selection stays as it is.
    [[nodiscard]] Result<std::optional<VoxelSet>> landed() const;
    // That step is made now, with what landed() found; or it is not made after all.
    void land(std::optional<VoxelSet> landed);
    void stayInTheAir() { lands_ = false; }
    // A step of the history was made at `position`; before the document is followed.
    void stepMade(std::size_t position, bool asANewStep, const Changed& changed);
    // The history went from one position to another.
    void wentTo(std::size_t from, std::size_t to, const Changed& changed);
    // Drops what is no longer there: no longer solid, or of a model that its object shows in no
    // frame.
    void follow(const Document& document, const Changed& changed);
    // Another document: nothing is selected.
    void forget();

  private:
    struct State {
        int node = -1;
        int model = 0;
        std::shared_ptr<const VoxelSet> voxels = std::make_shared<VoxelSet>();
    };

    void followNodes(const Changed& changed);

    State now_;
    std::optional<State> next_;
    // What was selected when the history left a position: it is selected again on the way back.
    std::map<std::size_t, State> before_;
    std::optional<Floating> floating_;
    bool lands_ = false;
    std::uint64_t revision_ = 1;
};

}  // namespace voxprite::editor
