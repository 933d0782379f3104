// The session's files: what opening and saving do to it.
#include <algorithm>

#include "app/editor/session.h"
#include "core/edit/make_action.h"
#include "core/io/formats.h"
#include "core/io/profile_json.h"

namespace voxprite::editor {

Status Session::adopt(Document document) {
    // All or nothing: the octree is built from the new document before the old one goes.
    Document before = std::exchange(workspace_.document, std::move(document));
    const int frameBefore = std::exchange(frame_, 0);
    const int activeBefore = std::exchange(activeNode_, -1);
    if (Status rebuilt = rebuild(); !rebuilt) {
        workspace_.document = std::move(before);
        frame_ = frameBefore;
        activeNode_ = activeBefore;
        static_cast<void>(rebuild());
        return rebuilt;
    }
    showVariant(std::nullopt);
    history_.clear();
    history_.markSaved();
    warnings_.clear();
    return {};
}

Status Session::startNew() {
    if (Status adopted = adopt(Document::withEmptyModel()); !adopted) return adopted;
    path_.reset();
    return {};
}

Status Session::open(const std::filesystem::path& path) {
    Result<LoadedDocument> loaded = loadDocument(path);
    if (!loaded) return Failure(loaded.error());
    const AuthoredValues authored = loaded->document.authored;
    if (Status adopted = adopt(std::move(loaded->document)); !adopted) {
        return inFile(adopted, path.string());
    }
    path_ = path;
    warnings_ = std::move(loaded->warnings);
    // A game's profile wins over what the file was made with; the built-in one stands for no game.
    if (!profilePath_ && loaded->format != Format::vox) {
        workspace_.profile.voxelSizeMetres = authored.voxelSizeMetres;
        workspace_.profile.sigma = authored.sigma;
        savedProfile_ = workspace_.profile;
    }
    return {};
}

Status Session::saveAs(const std::filesystem::path& path) {
    const Result<Format> format = formatOf(path);
    if (!format) return Failure(format.error());
    // A record of the game's values at this time; no edit of the document.
    workspace_.document.authored = {profile().voxelSizeMetres, profile().sigma};
    if (Status saved = saveDocument(path, document(), profile()); !saved) return saved;
    if (*format == Format::voxprite) {
        path_ = path;
        history_.markSaved();
        if (!profilePath_) savedProfile_ = workspace_.profile;
    }
    return {};
}

Status Session::openProfile(const std::filesystem::path& path) {
    Result<GameProfile> profile = readProfileFile(path);
    if (!profile) return Failure(profile.error());
    const bool wasSaved = history_.isSaved();
    Status performed =
        perform(makeAction("Open game profile", ProfileEdit{workspace_.profile, *profile}));
    if (!performed) return performed;
    // The profile has a file of its own: the document is as saved as it was.
    if (wasSaved) history_.markSaved();
    profilePath_ = path;
    savedProfile_ = workspace_.profile;
    return {};
}

Status Session::saveProfile(const std::filesystem::path& path) {
    if (Status saved = writeProfileFile(path, profile()); !saved) return saved;
    profilePath_ = path;
    savedProfile_ = workspace_.profile;
    return {};
}

bool Session::hasNativePath() const {
    if (!path_) return false;
    const Result<Format> format = formatOf(*path_);
    return format && *format == Format::voxprite;
}

std::string Session::title() const {
    return path_ ? path_->stem().string() : "Untitled";
}

}  // namespace voxprite::editor
