// Copies of unsaved work on the disk, kept against crashes and power cuts: one folder a running
// editor, inside the recovery folder.
//
//   <recovery>/<id>/lock               held (flock) for as long as the editor runs
//   <recovery>/<id>/note.json          what the copy is of, and its number n; replaced last
//   <recovery>/<id>/<n>.voxprite       the document
//   <recovery>/<id>/<n>.profile.json   the game profile
//   <recovery>/<id>/<n>.png            its sprite, small; none for an empty model
//
// A copy counts once the note names it, and only then does the one before it go: a kill at any
// moment leaves a whole copy. Whose lock is free has crashed: the system lets go of it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/session/known_file.h"
#include "core/base/result.h"
#include "core/model/document.h"
#include "core/model/game_profile.h"

namespace voxprite::editor {

inline constexpr int kRecoveryPictureEdgePx = 104;

// $XDG_STATE_HOME/voxprite/recovery, or under ~/.local/state.
[[nodiscard]] std::filesystem::path recoveryPath();

struct WorkCopy {
    Document document;
    GameProfile profile;
    std::optional<KnownFile> file;  // of the document, if it has one
    std::string title;
    std::uint64_t edits = 0;                    // since it was saved or opened, about
    std::optional<KnownFile> profileFile = {};  // of the game profile, if it has one
};

// The folder of one running editor. Its lock goes with the object, its files stay.
class RecoveryFolder {
  public:
    [[nodiscard]] static Result<RecoveryFolder> create(const std::filesystem::path& recovery);
    ~RecoveryFolder();
    RecoveryFolder(RecoveryFolder&& other) noexcept;
    RecoveryFolder& operator=(RecoveryFolder&& other) noexcept;

    // In place of the copy before it, which stays when this fails. One thread at a time.
    [[nodiscard]] Status write(const WorkCopy& copy);
    // All is saved: nothing is left to recover.
    [[nodiscard]] Status clear();
    // Goes away, copy and all: the end of an orderly run.
    void remove();

  private:
    [[nodiscard]] Status writeAs(std::uint64_t number, const WorkCopy& copy) const;

    RecoveryFolder(std::filesystem::path folder, int lock)
        : folder_(std::move(folder)), lock_(lock) {}

    std::filesystem::path folder_;
    int lock_ = -1;
    std::uint64_t number_ = 0;  // of the copy that the note names
};

// A copy that an editor left behind which no longer runs.
struct LostWork {
    std::filesystem::path folder;
    std::filesystem::path document, profile, picture;  // of the copy
    std::optional<KnownFile> file;
    std::string title;
    std::uint64_t edits = 0;
    std::int64_t unixSeconds = 0;  // when the copy was made
    std::optional<KnownFile> profileFile = {};
};

// Newest first. Folders without a whole copy are no work; their remains are removed.
[[nodiscard]] std::vector<LostWork> findLostWork(const std::filesystem::path& recovery);
void discard(const LostWork& work);

}  // namespace voxprite::editor
