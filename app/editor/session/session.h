// One open document and everything that follows from it: history, live octree of the frame shown,
// bounds, the file it came from. Knows neither window nor GPU.
//
// All changes go one way: perform(action) -> history -> document -> live octree, of which only the
// voxels that changed are touched.
//
// There are two octrees. octree() is the document's: tools aim at it, so that an edit that is only
// coming never moves what they aim at. shownOctree() has the coming edit in it; views draw it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/editor/session/known_file.h"
#include "app/editor/session/selection.h"
#include "app/editor/session/shown_octree.h"
#include "core/base/file.h"
#include "core/edit/clip.h"
#include "core/edit/history.h"
#include "core/io/formats.h"
#include "core/model/entity_voxels.h"
#include "core/sprite/sprite_view.h"
#include "core/svo/live_octree.h"

namespace voxprite::editor {

class JobProgress;

class Session {
  public:
    Session();  // a new document, one empty model
    // Derived data points into the workspace.
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    [[nodiscard]] const Document& document() const { return workspace_.document; }
    [[nodiscard]] const GameProfile& profile() const { return workspace_.profile; }
    [[nodiscard]] const Workspace& workspace() const { return workspace_; }
    [[nodiscard]] const History& history() const { return history_; }
    [[nodiscard]] const LiveOctree& octree() const { return octree_; }
    // Of the entity, all frames together; empty when there is no voxel.
    [[nodiscard]] const IBox& bounds() const { return bounds_; }

    // Shows what `patches` would make of the document, in place of the last preview. The preview
    // ends with clearPreview() and with every change of the document or of the frame. Patches as
    // patchVoxels() gives them: ascending positions, none twice. Costs the voxels that differ.
    // Fails, showing no preview, when the model would outgrow what an octree can hold.
    [[nodiscard]] Status preview(const std::vector<VoxelPatch>& patches);
    void clearPreview();
    [[nodiscard]] bool previews() const { return shown_.previews(); }
    [[nodiscard]] const LiveOctree& shownOctree() const { return shown_.octree(); }
    // bounds(), and what the preview fills.
    [[nodiscard]] IBox shownBounds() const { return bounds_.united(shown_.filled()); }
    // Of the shown octree since the last call; the caller uploads them.
    [[nodiscard]] OctreeChanges takeOctreeChanges();
    // Rises with every change that a view could show; modelRevision only with those of voxels,
    // palette and scene.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }
    [[nodiscard]] std::uint64_t modelRevision() const { return modelRevision_; }
    // The same, but for which frame and which variant of the palette are shown.
    [[nodiscard]] std::uint64_t contentsRevision() const { return contentsRevision_; }
    // Changes with every change of one model's voxels, and is never the same for two models.
    [[nodiscard]] std::uint64_t voxelRevision(int model) const {
        return voxelRevisions_[static_cast<std::size_t>(model)];
    }

    // The palette variant that is shown and whose colours are edited; nothing: the palette's own.
    // Another document starts with its own.
    [[nodiscard]] std::optional<std::size_t> variant() const { return variant_; }
    void showVariant(std::optional<std::size_t> variant);
    // The document's palette in the colours of that variant.
    [[nodiscard]] const Palette& shownPalette() const { return shownPalette_; }

    // Fails, with nothing changed, when the model would outgrow what an octree can hold.
    [[nodiscard]] Status perform(Action action);
    [[nodiscard]] Status undo();
    [[nodiscard]] Status redo();
    // Is this so large a step that the window must not wait for it?
    [[nodiscard]] bool isLong(const Action& action) const;
    [[nodiscard]] bool undoIsLong() const;
    [[nodiscard]] bool redoIsLong() const;
    // Such steps in two halves. What takes long reads the session alone, on any thread, while
    // nobody changes the session; commit() is quick. A step that was prepared is committed before
    // anything else is done, or dropped. Fail as perform() does, and when they are stopped.
    struct Prepared;
    [[nodiscard]] Result<std::shared_ptr<Prepared>> prepare(Action action,
                                                            const Progress& progress) const;
    // The same of a copy of the session's workspace, for a step that may be put in force while the
    // session's revision() is what it was then: whatever is done meanwhile is safe.
    [[nodiscard]] static Result<std::shared_ptr<Prepared>> prepare(const Workspace& workspace,
                                                                   int frame, Action action,
                                                                   const Progress& progress);
    [[nodiscard]] Result<std::shared_ptr<Prepared>> prepareUndo(const Progress& progress) const;
    [[nodiscard]] Result<std::shared_ptr<Prepared>> prepareRedo(const Progress& progress) const;
    void commit(Prepared prepared);
    void dropPrepared() { selection_.stayInTheAir(); }
    // The document as it is now, for whoever works with it while it changes. Costs a copy once
    // after each change, as long as somebody has it.
    [[nodiscard]] std::shared_ptr<const Document> snapshot();
    // Shows what was made of a snapshot, if nothing has changed since, in place of the last preview
    // (shown_octree.h).
    void showInstead(LiveOctree octree, const IBox& filled);

    // What the artist has selected, and what is in the air; it follows the document.
    [[nodiscard]] const VoxelSelection& selection() const { return selection_; }
    [[nodiscard]] VoxelSelection& selection() { return selection_; }
    // What was last copied or cut; the clipboard of the voxel tools, placed in entity space: as it
    // looked on screen. No part of the document: it outlives it.
    struct Clipboard {
        std::shared_ptr<const VoxelClip> clip;   // null while there is none
        std::shared_ptr<const Palette> palette;  // what its indices mean
    };
    [[nodiscard]] const Clipboard& copied() const { return copied_; }
    // The same in the colours that a document had for it, at last: what is pasted and stamped.
    [[nodiscard]] const Clipboard& fitted() const { return fitted_; }
    [[nodiscard]] const std::shared_ptr<const VoxelClip>& clip() const { return fitted_.clip; }
    // Their indices mean the colours that the document has now. A fitted clip may have lost colours
    // that this document has no room for: another one gets them from what was copied.
    void setClip(VoxelClip clip);
    void setFittedClip(VoxelClip clip);
    // Most that undo may hold.
    void limitHistory(std::size_t bytes) { history_.setMemoryLimitBytes(bytes); }
    // A key of its own for the actions of one stroke or drag, which become one step.
    [[nodiscard]] std::uint64_t newMergeKey() { return ++lastMergeKey_; }

    [[nodiscard]] int frame() const { return frame_; }
    [[nodiscard]] int frames() const { return frames_; }
    [[nodiscard]] Status setFrame(int frame);

    // The object that tools edit: an index into Document::nodes, or -1 when there is none.
    [[nodiscard]] int activeNode() const { return activeNode_; }
    void setActiveNode(int node);
    // Where it lies in this frame; nothing while it is hidden.
    [[nodiscard]] std::optional<Instance> activeInstance() const;
    // The object whose voxel shows at an entity voxel; -1 where it is empty.
    [[nodiscard]] int nodeAt(glm::ivec3 entityVoxel) const;
    [[nodiscard]] const std::vector<Instance>& instances() const { return sampler_->instances(); }

    // The shown entity as it stands in the game (on the anchor that the document gives it, so that
    // a preview never makes it jump); and as it is edited: entity space itself, one unit a voxel,
    // its origin at the world's, so that nothing moves while voxels are added.
    [[nodiscard]] PlacedEntity placedInGame() const;
    // The entity of the document itself as it stands in the game: what shows no preview, and must
    // not move while the pointer does.
    [[nodiscard]] PlacedEntity madeInGame() const;
    [[nodiscard]] PlacedEntity placedForEditing() const { return placedForEditing(shownBounds()); }
    // Voxels of a box of entity space, where they lie in that view.
    [[nodiscard]] static PlacedEntity placedForEditing(const IBox& box);

    [[nodiscard]] Status startNew();
    [[nodiscard]] Status open(const std::filesystem::path& path, const ReadOptions& options = {});
    // In any format, by the ending. Only the native format makes the document saved under
    // that name; the others are exports.
    [[nodiscard]] Status saveAs(const std::filesystem::path& path);

    // The same in two halves, for long files. read() and write() do what takes time, on any
    // thread; what goes before or after them is quick.
    struct Derived {
        LiveOctree octree;
        ShownOctree shown;
        IBox bounds;
        int frames = 1;
        // Where each model lies in any frame, each place once: what bounds grow by.
        std::vector<std::vector<Placement>> placesOfModel;
    };
    struct Opened {
        KnownFile file;
        LoadedDocument loaded;
        Derived derived;
        std::string entityTitle{};  // of one of several entities in the file; else empty
    };
    [[nodiscard]] static Result<Opened> read(const std::filesystem::path& path,
                                             JobProgress* progress = nullptr,
                                             const ReadOptions& options = {});
    void adopt(Opened opened);
    // The copy of unsaved work that a crash left (recovery/recovery_folder.h): it is `file`, if
    // any, with changes that are in no file yet. The files are known as they were before the crash.
    [[nodiscard]] Status recover(const std::filesystem::path& document, const GameProfile& profile,
                                 const std::optional<KnownFile>& file,
                                 const std::optional<KnownFile>& profileFile = {});
    struct Saving {
        std::filesystem::path path;
        Format format = Format::voxprite;
        Document document;
        GameProfile profile;
        bool wasSaved = false;  // there was nothing to save
        int modelsLeftOut = 0;  // that no object shows
    };
    // What came of it: the file as it was written, by which it is known again. (None where another
    // name than the one that was asked for was written to, or another program was as quick.)
    using Written = Result<std::optional<FileStamp>>;
    // The document as it is now. It counts as saved from here on; endSaving() says whether it was.
    [[nodiscard]] Result<Saving> beginSaving(const std::filesystem::path& path);
    [[nodiscard]] static Written write(const Saving& saving, std::stop_token stop = {});
    void endSaving(const Saving& saving, const Written& written);

    [[nodiscard]] Status openProfile(const std::filesystem::path& path);
    [[nodiscard]] Status saveProfile(const std::filesystem::path& path);

    // Of the document and of the game's profile, if they have one.
    [[nodiscard]] const std::optional<KnownFile>& file() const { return file_; }
    [[nodiscard]] const std::optional<KnownFile>& profileFile() const { return profileFile_; }
    // Of file().
    [[nodiscard]] std::optional<std::filesystem::path> path() const;
    // Can be saved under its own name without asking for another.
    [[nodiscard]] bool hasNativePath() const;
    // "hut", or "Untitled"; of one of several entities in a file that one's name.
    [[nodiscard]] std::string title() const;
    // What files that are made of the document are called at first: title(), or "untitled".
    [[nodiscard]] std::string stem() const { return file_ ? title() : "untitled"; }
    // In what the document's file keeps: VoxelSize and sigma among it while the profile has no file
    // of its own.
    [[nodiscard]] bool unsaved() const;
    [[nodiscard]] bool profileUnsaved() const { return savedProfile_ != workspace_.profile; }
    // Other than in the values that files of documents keep, while the profile has no file?
    [[nodiscard]] bool profileHasUnsavedOfItsOwn() const;
    // What was odd about the file last opened.
    [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

  private:
    // Brings derived data up to date with what `changed` says; fails where an octree cannot go.
    [[nodiscard]] Status follow(const Changed& changed);
    // The same for the history; `first` becomes what the first call says.
    [[nodiscard]] History::Follow following(Status& first);
    // The step is made: what the artist has in hand and has selected goes along.
    void arrive(const Changed& changed);
    void reviseVoxels(int model);
    [[nodiscard]] Status followVoxels(const Changed::Voxels& changed);
    void growOrShrinkBounds(const Changed::Voxels& changed);
    // What the entity shows at a voxel once `patches` are in force.
    [[nodiscard]] std::uint8_t valueWith(const std::vector<VoxelPatch>& patches,
                                         glm::ivec3 entityVoxel) const;
    // All that follows from one frame of a document.
    [[nodiscard]] static Result<Derived> derive(const Document& document, int frame);
    void install(Derived derived);
    [[nodiscard]] Status rebuild();
    // `floating`: what comes down with the step, if anything.
    [[nodiscard]] static Result<std::shared_ptr<Prepared>> derived(Result<PreparedStep> step,
                                                                   int frame,
                                                                   const VoxelSelection* floating,
                                                                   const Progress& progress);
    void adopt(Document document, Derived derived);
    // A document's file holds no more of the game's profile than this.
    void markSavedWithDocument(double voxelSizeMetres, double sigma);
    void chooseActiveNode();
    void followPalette();

    Workspace workspace_;
    History history_;
    LiveOctree octree_;
    ShownOctree shown_;
    IBox bounds_;
    std::optional<std::size_t> variant_;
    Palette shownPalette_;
    std::uint64_t revision_ = 1;
    std::uint64_t modelRevision_ = 1;
    std::uint64_t contentsRevision_ = 1;
    std::vector<std::uint64_t> voxelRevisions_;
    std::uint64_t lastVoxelRevision_ = 0;
    std::uint64_t lastMergeKey_ = 0;

    int frame_ = 0;
    int frames_ = 1;
    int activeNode_ = -1;
    std::optional<EntitySampler> sampler_;
    std::vector<std::vector<Placement>> placesOfModel_;

    std::optional<KnownFile> file_;
    std::string entityTitle_;  // of one of several entities in the file there; else empty
    std::optional<KnownFile> profileFile_;
    GameProfile savedProfile_;
    std::vector<std::string> warnings_;
    VoxelSelection selection_;
    Clipboard copied_, fitted_;
    std::weak_ptr<const Document> snapshot_;
    std::uint64_t snapshotRevision_ = 0;
};

struct Session::Prepared {
    PreparedStep step;
    Derived derived;
    // What will be selected, of what is put down.
    std::optional<VoxelSet> landed;
};

}  // namespace voxprite::editor
