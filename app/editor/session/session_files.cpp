// The session's files: what opening and saving do to it.
#include <algorithm>

#include "app/editor/session/background_job.h"
#include "app/editor/session/session.h"
#include "core/edit/make_action.h"
#include "core/edit/unused_models.h"
#include "core/io/formats.h"
#include "core/io/profile_json.h"
#include "core/io/svo_set.h"

namespace voxprite::editor {
namespace {

constexpr std::size_t kLongestTitle = 80;  // bytes

// What a file can be called, too.
std::string titleOfEntity(const std::string& name, const std::string& otherwise) {
    std::string title = name.substr(0, kLongestTitle);
    // No half of a character at the end.
    if (title.size() < name.size()) {
        while (!title.empty() && (static_cast<unsigned char>(name[title.size()]) & 0xC0) == 0x80) {
            title.pop_back();
        }
    }
    for (char& c : title) {
        const bool apart = c == '/' || c == '\\' || c == ':';
        if (apart || static_cast<unsigned char>(c) < 0x20) c = '_';
    }
    if (title.starts_with('.')) title[0] = '_';
    return title.empty() ? otherwise : title;
}

// What files of documents keep of the game's profile.
AuthoredValues authoredWith(const GameProfile& profile) {
    return {profile.voxelSizeMetres, profile.sigma};
}

}  // namespace

void Session::adopt(Document document, Derived derived) {
    workspace_.document = std::move(document);
    frame_ = 0;
    activeNode_ = -1;
    voxelRevisions_.clear();
    selection_.forget();
    install(std::move(derived));
    chooseActiveNode();
    ++contentsRevision_;
    showVariant(std::nullopt);
    history_.clear();
    history_.markSaved();
    warnings_.clear();
}

Status Session::startNew() {
    Document empty = Document::withEmptyModel();
    Result<Derived> derived = derive(empty, 0);
    if (!derived) return Failure(derived.error());
    adopt(std::move(empty), std::move(*derived));
    file_.reset();
    entityTitle_.clear();
    return {};
}

Result<Session::Opened> Session::read(const std::filesystem::path& path, JobProgress* progress,
                                      const ReadOptions& options) {
    // Reading takes about as long as building does, whatever the format.
    if (progress != nullptr) progress->enter("Reading the file", 0.05);
    const std::optional<FileStamp> stamp = stampOf(path);
    Result<LoadedDocument> loaded = loadDocument(path, options);
    if (!loaded) return Failure(loaded.error());
    if (progress != nullptr) progress->enter("Building the octree", 0.5);
    Result<Derived> derived = derive(loaded->document, 0);
    if (!derived) return inFile(Result<Opened>(Failure(derived.error())), path.string());
    std::string title;
    if (options.entity && loaded->format == Format::svo && entitiesAt(path) > 1) {
        title = titleOfEntity(loaded->document.entity.name,
                              path.stem().string() + " " + std::to_string(*options.entity));
    }
    return Opened{{path, stamp}, std::move(*loaded), std::move(*derived), std::move(title)};
}

void Session::adopt(Opened opened) {
    const AuthoredValues authored = opened.loaded.document.authored;
    adopt(std::move(opened.loaded.document), std::move(opened.derived));
    file_ = std::move(opened.file);
    entityTitle_ = std::move(opened.entityTitle);
    warnings_ = std::move(opened.loaded.warnings);
    // A game's profile wins over what the file was made with; the built-in one stands for no game.
    const Format format = opened.loaded.format;
    if (!profileFile_ && (format == Format::voxprite || format == Format::svo)) {
        workspace_.profile.voxelSizeMetres = authored.voxelSizeMetres;
        workspace_.profile.sigma = authored.sigma;
        markSavedWithDocument(authored.voxelSizeMetres, authored.sigma);
    }
}

void Session::markSavedWithDocument(double voxelSizeMetres, double sigma) {
    savedProfile_.voxelSizeMetres = voxelSizeMetres;
    savedProfile_.sigma = sigma;
}

bool Session::profileHasUnsavedOfItsOwn() const {
    if (profileFile_) return profileUnsaved();
    GameProfile kept = savedProfile_;
    kept.voxelSizeMetres = profile().voxelSizeMetres;
    kept.sigma = profile().sigma;
    return kept != profile();
}

Status Session::open(const std::filesystem::path& path, const ReadOptions& options) {
    Result<Opened> opened = read(path, nullptr, options);
    if (!opened) return Failure(opened.error());
    adopt(std::move(*opened));
    return {};
}

Status Session::recover(const std::filesystem::path& document, const GameProfile& profile,
                        const std::optional<KnownFile>& file,
                        const std::optional<KnownFile>& profileFile) {
    Result<Opened> opened = read(document);
    if (!opened) return Failure(opened.error());
    adopt(std::move(*opened));
    workspace_.profile = profile;
    profileFile_ = profileFile;
    if (profileFile) {
        if (Result<GameProfile> saved = readProfileFile(profileFile->path)) savedProfile_ = *saved;
    }
    file_ = file;
    if (file && entitiesAt(file->path) > 1) {
        entityTitle_ = titleOfEntity(workspace_.document.entity.name, file->path.stem().string());
    }
    history_.markUnsaved();
    return {};
}

Result<Session::Saving> Session::beginSaving(const std::filesystem::path& path) {
    const Result<Format> format = formatOf(path);
    if (!format) return Failure(format.error());
    // A record of the game's values at this time; no edit of the document.
    workspace_.document.authored = authoredWith(profile());
    const bool wasSaved = !unsaved();
    if (*format == Format::voxprite) history_.markSaved();
    return Saving{path,      *format,  withoutUnusedModels(document()),
                  profile(), wasSaved, unusedModels(document())};
}

Session::Written Session::write(const Saving& saving, std::stop_token stop) {
    // Whatever is replaced has been agreed to.
    Status saved = saveDocument(saving.path, saving.document, saving.profile, std::move(stop),
                                {.mesh = {}, .replaceNeighbours = true});
    if (!saved) return Failure(saved.error());
    // At once: what another program writes before the window comes to know that this is saved must
    // not be taken for what was written here.
    return stampOf(saving.path);
}

void Session::endSaving(const Saving& saving, const Written& written) {
    if (saving.format != Format::voxprite) return;
    if (!written) {
        if (!saving.wasSaved) history_.markUnsaved();
        return;
    }
    file_ = KnownFile{saving.path, *written};
    entityTitle_.clear();
    if (!profileFile_) markSavedWithDocument(saving.profile.voxelSizeMetres, saving.profile.sigma);
}

Status Session::saveAs(const std::filesystem::path& path) {
    const Result<Saving> saving = beginSaving(path);
    if (!saving) return Failure(saving.error());
    const Written written = write(*saving);
    endSaving(*saving, written);
    return written ? Status() : Failure(written.error());
}

Status Session::openProfile(const std::filesystem::path& path) {
    const std::optional<FileStamp> stamp = stampOf(path);
    Result<GameProfile> profile = readProfileFile(path);
    if (!profile) return Failure(profile.error());
    Status performed =
        perform(makeAction("Open game profile", ProfileEdit{workspace_.profile, *profile}));
    if (!performed) return performed;
    profileFile_ = KnownFile{path, stamp};
    savedProfile_ = workspace_.profile;
    return {};
}

Status Session::saveProfile(const std::filesystem::path& path) {
    if (Status saved = writeProfileFile(path, profile()); !saved) return saved;
    profileFile_ = KnownFile{path, stampOf(path)};
    savedProfile_ = workspace_.profile;
    return {};
}

bool Session::hasNativePath() const {
    if (!file_) return false;
    const Result<Format> format = formatOf(file_->path);
    return format && *format == Format::voxprite;
}

bool Session::unsaved() const {
    return history_.differsFromSaved([&](const ActionPart& part) {
        const auto* edit = std::get_if<ProfileEdit>(&part);
        if (edit == nullptr) return true;
        return !profileFile_ && authoredWith(edit->before) != authoredWith(edit->after);
    });
}

std::optional<std::filesystem::path> Session::path() const {
    if (!file_) return std::nullopt;
    return file_->path;
}

std::string Session::title() const {
    if (!entityTitle_.empty()) return entityTitle_;
    return file_ ? file_->path.stem().string() : "Untitled";
}

}  // namespace voxprite::editor
