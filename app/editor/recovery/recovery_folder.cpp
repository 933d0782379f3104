#include "app/editor/recovery/recovery_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/editor/views/small_sprite.h"
#include "core/base/file.h"
#include "core/io/formats.h"
#include "core/io/json_text.h"
#include "core/io/png.h"
#include "core/io/profile_json.h"
#include "core/model/entity_voxels.h"
#include "core/svo/bake.h"

namespace voxprite::editor {
namespace {

namespace fs = std::filesystem;

std::int64_t unixSecondsNow() {
    using namespace std::chrono;
    return duration_cast<seconds>(system_clock::now().time_since_epoch()).count();
}

// The lock of a folder, or -1 when an editor holds it (or there is none to take).
int takeLock(const fs::path& folder, int flags) {
    const int lock = ::open((folder / "lock").c_str(), flags | O_RDWR | O_CLOEXEC, 0600);
    if (lock >= 0 && ::flock(lock, LOCK_EX | LOCK_NB) == 0) return lock;
    if (lock >= 0) ::close(lock);
    return -1;
}

struct CopyFiles {
    fs::path document, profile, picture;
};

CopyFiles filesOf(const fs::path& folder, std::uint64_t number) {
    const std::string n = std::to_string(number);
    return {folder / (n + ".voxprite"), folder / (n + ".profile.json"), folder / (n + ".png")};
}

void removeCopy(const CopyFiles& files) {
    std::error_code ignored;
    for (const fs::path& old : {files.document, files.profile, files.picture}) {
        fs::remove(old, ignored);
    }
}

Status writePicture(const fs::path& path, const WorkCopy& copy) {
    const VoxelGrid voxels = flatten(copy.document, 0);
    const Result<Octree> octree = bake(voxels);
    if (!octree) return Failure(octree.error());
    const IBox bounds = voxels.bounds();
    const auto sprite = smallSprite(
        {octree->view(), bounds, copy.document.entity, copy.profile, copy.document.palette},
        kRecoveryPictureEdgePx);
    return sprite ? writePngFile(path, sprite->image()) : Status{};
}

// A file stands in the note as its path, under `key`, and its stamp beside that.
void noteFile(nlohmann::json& note, const std::string& key, const std::optional<KnownFile>& file) {
    if (!file) return;
    note[key] = jsonTextFromBytes(file->path.string());
    if (const auto& stamp = file->stamp) {
        note[key + "_stamp"] = nlohmann::json::array(
            {stamp->device, stamp->inode, stamp->bytes, stamp->changedNanoseconds});
    }
}

std::optional<KnownFile> notedFile(const nlohmann::json& note, const std::string& key) {
    if (!note.contains(key)) return std::nullopt;
    KnownFile file{bytesFromJsonText(note.at(key).get<std::string>())};
    if (note.contains(key + "_stamp")) {
        const nlohmann::json& stamp = note.at(key + "_stamp");
        file.stamp = FileStamp{stamp.at(0).get<std::uint64_t>(), stamp.at(1).get<std::uint64_t>(),
                               stamp.at(2).get<std::uint64_t>(), stamp.at(3).get<std::int64_t>()};
    }
    return file;
}

std::optional<LostWork> readNote(const fs::path& folder) {
    const Result<std::string> text = readTextFile(folder / "note.json");
    if (!text) return std::nullopt;
    const nlohmann::json note = nlohmann::json::parse(*text, nullptr, false);
    if (!note.is_object()) return std::nullopt;
    try {
        const CopyFiles files = filesOf(folder, note.at("number").get<std::uint64_t>());
        LostWork work{folder, files.document, files.profile, files.picture, {}, {}, 0, 0};
        work.file = notedFile(note, "file");
        work.profileFile = notedFile(note, "profile_file");
        work.title = bytesFromJsonText(note.at("title").get<std::string>());
        work.edits = note.at("edits").get<std::uint64_t>();
        work.unixSeconds = note.at("unix_seconds").get<std::int64_t>();
        return work;
    } catch (const nlohmann::json::exception&) {
        return std::nullopt;
    }
}

}  // namespace

fs::path recoveryPath() {
    const char* state = std::getenv("XDG_STATE_HOME");
    const char* home = std::getenv("HOME");
    const fs::path base = state != nullptr && *state != '\0'
                              ? fs::path(state)
                              : fs::path(home != nullptr ? home : "/") / ".local" / "state";
    return base / "voxprite" / "recovery";
}

Result<RecoveryFolder> RecoveryFolder::create(const fs::path& recovery) {
    std::error_code error;
    fs::create_directories(recovery, error);
    if (error) return failInFile(recovery.string(), error.message());
    std::string name = (recovery / "work-").string() + std::string(6, 'X');  // for mkdtemp to fill
    if (::mkdtemp(name.data()) == nullptr) {
        return failInFile(recovery.string(), "no folder can be made in it");
    }
    const int lock = takeLock(name, O_CREAT);
    if (lock < 0) return failInFile(name, "cannot be locked");
    return RecoveryFolder(name, lock);
}

RecoveryFolder::~RecoveryFolder() {
    if (lock_ >= 0) ::close(lock_);
}

RecoveryFolder::RecoveryFolder(RecoveryFolder&& other) noexcept
    : folder_(std::move(other.folder_)),
      lock_(std::exchange(other.lock_, -1)),
      number_(other.number_) {}

RecoveryFolder& RecoveryFolder::operator=(RecoveryFolder&& other) noexcept {
    std::swap(folder_, other.folder_);
    std::swap(lock_, other.lock_);
    std::swap(number_, other.number_);
    return *this;
}

Status RecoveryFolder::write(const WorkCopy& copy) {
    const Status written = writeAs(number_ + 1, copy);
    // What stays behind goes with the folder.
    removeCopy(filesOf(folder_, written ? number_ : number_ + 1));
    if (written) ++number_;
    return written;
}

Status RecoveryFolder::writeAs(std::uint64_t number, const WorkCopy& copy) const {
    const CopyFiles files = filesOf(folder_, number);
    if (Status done = saveDocument(files.document, copy.document, copy.profile); !done) return done;
    if (Status done = writeProfileFile(files.profile, copy.profile); !done) return done;
    if (Status done = writePicture(files.picture, copy); !done) return done;
    nlohmann::json note{{"number", number},
                        {"title", jsonTextFromBytes(copy.title)},
                        {"edits", copy.edits},
                        {"unix_seconds", unixSecondsNow()}};
    noteFile(note, "file", copy.file);
    noteFile(note, "profile_file", copy.profileFile);
    return writeFileAtomically(folder_ / "note.json", note.dump(2) + "\n");
}

Status RecoveryFolder::clear() {
    std::error_code error;
    fs::remove(folder_ / "note.json", error);  // first: without it there is no copy
    if (error) return failInFile(folder_.string(), error.message());
    removeCopy(filesOf(folder_, number_));
    return {};
}

void RecoveryFolder::remove() {
    std::error_code ignored;  // at worst an empty folder stays, which the next start clears away
    fs::remove_all(folder_, ignored);
}

std::vector<LostWork> findLostWork(const fs::path& recovery) {
    std::vector<LostWork> found;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(recovery, error)) {
        const int lock = takeLock(entry.path(), 0);
        if (lock < 0) continue;
        std::error_code ignored;
        std::optional<LostWork> work = readNote(entry.path());
        if (work && fs::exists(work->document, ignored)) {
            found.push_back(std::move(*work));
        } else {
            fs::remove_all(entry.path(), ignored);
        }
        ::close(lock);
    }
    std::ranges::sort(found, [](const LostWork& a, const LostWork& b) {
        return std::pair(b.unixSeconds, b.folder) < std::pair(a.unixSeconds, a.folder);
    });
    return found;
}

void discard(const LostWork& work) {
    std::error_code ignored;
    std::filesystem::remove_all(work.folder, ignored);
}

}  // namespace voxprite::editor
