#include "app/editor/session/file_flow.h"

#include "app/editor/panels/progress.h"
#include "app/editor/panels/toasts.h"
#include "core/base/file.h"
#include "core/edit/unused_models.h"
#include "core/io/formats.h"
#include "core/io/svo_set.h"

namespace voxprite::editor {
namespace {

const std::vector<std::string> kProfileExtensions{".json"};
constexpr double kProgressAfterSeconds = 0.25;

std::string formatName(const std::string& ending) {
    const Result<Format> format = formatOf("model" + ending);
    return format ? infoOf(*format).title : std::string();
}

}  // namespace

void FileFlow::open(const std::filesystem::path& file, std::optional<std::size_t> entity) {
    waitingFile_ = file;
    waitingEntity_ = entity;
    unlessUnsaved(Waiting::openFile);
}

void FileFlow::save() {
    const Session& session = context_.session;
    if (!session.hasNativePath()) return saveAs();
    if (session.file()->changedOutside()) {
        replacesProfile_ = false;
        return context_.dialogs.askChanged(session.path()->filename().string());
    }
    saveTo(*session.path());
}

void FileFlow::saveAs() {
    browse({.title = "Save as",
            .button = "Save",
            .saving = true,
            .extensions = writtenEndings(),
            .name = context_.session.stem() + ".voxprite",
            .formatName = formatName,
            .losses = [this](const std::filesystem::path& path) { return lossesAt(path); },
            .replaced =
                [this](const std::filesystem::path& path) {
                    return replacedBySaving(path, context_.session.document());
                }},
           [this](CommandContext&, const std::filesystem::path& path) { saveTo(path); });
}

void FileFlow::openProfile() {
    browse({.title = "Open a game profile", .button = "Open", .extensions = kProfileExtensions},
           [this](CommandContext& c, const std::filesystem::path& path) {
               tell(c.session.openProfile(path), "Game profile " + path.filename().string());
           });
}

void FileFlow::saveProfile() {
    const auto& file = context_.session.profileFile();
    if (!file) return saveProfileAs();
    if (file->changedOutside()) {
        replacesProfile_ = true;
        return context_.dialogs.askChanged(file->path.filename().string());
    }
    saveProfileTo(file->path);
}

void FileFlow::saveProfileTo(const std::filesystem::path& path) {
    const std::string name = path.filename().string();
    if (tell(context_.session.saveProfile(path), "Saved " + name)) goOn();
}

void FileFlow::saveProfileAs() {
    const auto& file = context_.session.profileFile();
    browse({.title = "Save the game profile",
            .button = "Save",
            .saving = true,
            .extensions = kProfileExtensions,
            .name = file ? file->path.filename().string() : "game-profile.json"},
           [this](CommandContext&, const std::filesystem::path& path) { saveProfileTo(path); });
}

void FileFlow::browse(FileBrowser::Request request, Chosen chosen) {
    if (request.folder.empty()) request.folder = context_.settings.window.folder;
    chosen_ = std::move(chosen);
    browser_.open(std::move(request));
}

void FileFlow::draw(Ui& ui) {
    // One modal window at a time, else each frame each would close the other; and a key answers one
    // of them alone.
    if (!context_.dialogs.openName().empty()) {
        const Answers answers = context_.dialogs.draw(ui);
        if (answers.unsaved != UnsavedAnswer::none) afterUnsavedQuestion(answers.unsaved);
        if (answers.changed != ChangedAnswer::none) afterChangedQuestion(answers.changed);
    } else {
        askForFile(ui);
    }
    static_cast<void>(step_.finish());
    static_cast<void>(job_.finish());
    followDrag();
    showProgress(ui);
    if (!isWorking() && afterJob_ != Waiting::none) {
        const Waiting next = std::exchange(afterJob_, Waiting::none);
        // What had to stay in the air meanwhile comes down. This is tried once: it may fail.
        if (!std::exchange(settled_, true)) static_cast<void>(context_.settle());
        unlessUnsaved(next);
    }
}

void FileFlow::askForFile(Ui& ui) {
    const bool browses = browser_.isOpen();
    if (const auto path = browser_.draw(ui)) {
        context_.settings.window.folder = path->parent_path();
        // What was chosen may ask for another file.
        const Chosen chosen = std::exchange(chosen_, {});
        chosen(context_, *path);
    } else if (browses && !browser_.isOpen()) {
        waiting_ = Waiting::none;  // for that file
    }
    const std::filesystem::path mesh = import_.file();
    if (import_.draw(ui) == ImportDialog::Answer::import) readNow(mesh, import_.chosen());
    if (const auto answer = entities_.draw(ui)) afterEntities(*answer);
}

void FileFlow::showProgress(Ui& ui) {
    // Most work is over before anyone could read what it was.
    const auto shows = [](const BackgroundJob& job) {
        return job.seconds() > kProgressAfterSeconds;
    };
    if (step_.running()) {
        if (drawProgress(ui, step_, true, shows(step_))) step_.stop();
    } else if (job_.running()) {
        if (drawProgress(ui, job_, blocks_, shows(job_))) cancelWork();
    }
}

void FileFlow::finishWork() {
    while (isWorking()) {
        step_.wait();
        static_cast<void>(step_.finish());
        job_.wait();
        static_cast<void>(job_.finish());
        drag_.wait();
        followDrag();
    }
}

void FileFlow::step(std::string title, const Prepare& prepare,
                    const std::function<void()>& afterwards) {
    const Session& session = context_.session;
    const auto working = [this, &session, prepare,
                          afterwards](JobProgress& progress) -> BackgroundJob::Done {
        const std::stop_token stop = progress.stopToken();
        const auto prepared = std::make_shared<Result<std::shared_ptr<Session::Prepared>>>(
            prepare(session, progress.as("The document stays as it is until this is done")));
        return [this, prepared, stop, afterwards] {
            if (*prepared) {
                context_.session.commit(std::move(***prepared));
                if (afterwards) afterwards();
                return;
            }
            context_.session.dropPrepared();
            if (stop.stop_requested()) {
                context_.toasts.info("Cancelled: " + step_.title());
            } else {
                context_.toasts.error(prepared->error().describe());
            }
        };
    };
    step_.start(std::move(title), working);
}

void FileFlow::drag(Action action) {
    dragged_ = std::move(action);
    dragIsNew_ = true;
}

const SceneState* FileFlow::draggedScene() const {
    if (!dragged_ || dragged_->parts.empty()) return nullptr;
    const auto* scene = std::get_if<SceneEdit>(&dragged_->parts.front());
    return scene == nullptr ? nullptr : &scene->after;
}

void FileFlow::followDrag() {
    static_cast<void>(drag_.finish());
    if (!dragIsNew_ || drag_.running() || step_.running()) return;
    dragIsNew_ = false;
    Session& session = context_.session;
    const auto making = [this, &session, action = *dragged_, workspace = session.workspace(),
                         frame = session.frame(),
                         revision = session.revision()](JobProgress&) -> BackgroundJob::Done {
        const auto prepared = std::make_shared<Result<std::shared_ptr<Session::Prepared>>>(
            Session::prepare(workspace, frame, action, {}));
        return [this, &session, prepared, revision] {
            if (*prepared && session.revision() != revision) {
                dragIsNew_ = true;  // of what there is now
                return;
            }
            if (*prepared) {
                session.commit(std::move(***prepared));
            } else {
                context_.toasts.error(prepared->error().describe());
            }
            if (!dragIsNew_) dragged_.reset();
        };
    };
    drag_.start(dragged_->label, making);
}

Status FileFlow::work(std::string title, BackgroundJob::Work work) {
    if (job_.running()) return fail(job_.title() + " is not done yet");
    blocks_ = false;
    job_.start(std::move(title), std::move(work));
    return {};
}

void FileFlow::cancelWork() {
    waiting_ = afterJob_ = Waiting::none;
    if (!blocks_) return job_.stop();
    job_.cancel();
    context_.toasts.info("Cancelled: " + job_.title());
}

void FileFlow::unlessUnsaved(Waiting what) {
    if (isWorking()) {
        // What is being saved is saved to its end first.
        afterJob_ = what;
        const BackgroundJob& first = step_.running() ? step_ : job_.running() ? job_ : drag_;
        return context_.toasts.info(first.title() + " first");
    }
    settled_ = false;
    waiting_ = what;
    if (!context_.session.unsaved()) return unlessProfileUnsaved();
    asksForProfile_ = false;
    context_.dialogs.askUnsaved("Save the changes?", "\"" + context_.session.title() + "\"");
}

void FileFlow::unlessProfileUnsaved() {
    const Session& session = context_.session;
    // It stays the same for the next document.
    if (waiting_ != Waiting::quit || !session.profileHasUnsavedOfItsOwn()) return goOn();
    asksForProfile_ = true;
    const auto& file = session.profileFile();
    context_.dialogs.askUnsaved(
        "Save the game profile?",
        "The game profile " + (file ? "\"" + file->path.filename().string() + "\""
                                    : std::string("(light, outline and the like)")));
}

void FileFlow::afterUnsavedQuestion(UnsavedAnswer answer) {
    switch (answer) {
        case UnsavedAnswer::save:
            // Goes on once it has been saved.
            return asksForProfile_ ? saveProfile() : save();
        case UnsavedAnswer::discard:
            return asksForProfile_ ? goOn() : unlessProfileUnsaved();
        case UnsavedAnswer::cancel:
        case UnsavedAnswer::none:
            waiting_ = Waiting::none;
    }
}

void FileFlow::afterChangedQuestion(ChangedAnswer answer) {
    switch (answer) {
        case ChangedAnswer::replace:
            return replacesProfile_ ? saveProfileTo(context_.session.profileFile()->path)
                                    : saveTo(*context_.session.path());
        case ChangedAnswer::saveAs:
            return replacesProfile_ ? saveProfileAs() : saveAs();
        case ChangedAnswer::cancel:
        case ChangedAnswer::none:
            waiting_ = Waiting::none;
    }
}

void FileFlow::goOn() {
    switch (std::exchange(waiting_, Waiting::none)) {
        case Waiting::none:
            return;
        case Waiting::startNew:
            context_.report(context_.session.startNew());
            replaced_ = true;
            return;
        case Waiting::openDialog:
            return browse(
                {.title = "Open a model", .button = "Open", .extensions = modelEndings()},
                [this](CommandContext&, const std::filesystem::path& path) { openNow(path, {}); });
        case Waiting::openFile:
            return openNow(waitingFile_, waitingEntity_);
        case Waiting::quit:
            quits_ = true;
    }
}

void FileFlow::openNow(const std::filesystem::path& path, std::optional<std::size_t> entity) {
    const Result<Format> format = formatOf(path);
    if (format && !infoOf(*format).keepsVoxels) return import_.open(path);
    ReadOptions options;
    options.entity = entity;
    readNow(path, options);
}

void FileFlow::readNow(const std::filesystem::path& path, const ReadOptions& options) {
    const auto opening = [this, path, options](JobProgress& progress) -> BackgroundJob::Done {
        if (!options.entity) {
            if (auto asks = askedFirst(path, EntityDialog::Asks::one)) return *asks;
        }
        // Shared, as what a job leaves behind can be copied.
        const auto opened =
            std::make_shared<Result<Session::Opened>>(Session::read(path, &progress, options));
        return [this, path, opened] {
            CommandContext& c = context_;
            if (!*opened) return c.dialogs.showError(opened->error().describe());
            c.session.adopt(std::move(**opened));
            c.settings.remember(path);
            replaced_ = true;
            for (const std::string& warning : c.session.warnings()) c.toasts.info(warning);
        };
    };
    if (tell(work("Opening " + path.filename().string(), opening), {})) blocks_ = true;
}

std::optional<BackgroundJob::Done> FileFlow::askedFirst(const std::filesystem::path& path,
                                                        EntityDialog::Asks asks) {
    const auto set = std::make_shared<Result<std::vector<SvoFile>>>(severalEntities(path));
    if (*set && (*set)->empty()) return std::nullopt;
    return [this, path, asks, set] {
        if (!*set) return context_.dialogs.showError(set->error().describe());
        entities_.open(path, std::move(**set), asks);
    };
}

void FileFlow::addToScene(const std::filesystem::path& file) {
    const auto looking = [this, file](JobProgress& progress) -> BackgroundJob::Done {
        progress.enter("Reading the file", 0.0);
        if (auto asks = askedFirst(file, EntityDialog::Asks::some)) return *asks;
        return [this, file] { context_.settings.scene.add({.file = file}); };
    };
    if (tell(work("Reading " + file.filename().string(), looking), {})) blocks_ = true;
}

void FileFlow::afterEntities(const EntityDialog::Answer& answer) {
    for (const auto& [index, name] : answer.entities) {
        if (answer.asks == EntityDialog::Asks::some) {
            context_.settings.scene.add({answer.file, true, index, name});
        } else {
            openNow(answer.file, index);
        }
    }
}

void FileFlow::write(std::string title, const std::filesystem::path& path,
                     const std::function<void()>& afterwards) {
    if (job_.running()) {
        tell(fail(job_.title() + " is not done yet"), {});
        return;
    }
    Result<Session::Saving> begun = context_.session.beginSaving(path);
    if (!begun) {
        tell(Failure(begun.error()), {});
        return;
    }
    const auto saving = std::make_shared<const Session::Saving>(std::move(*begun));
    const auto writing = [this, saving, afterwards](JobProgress& progress) -> BackgroundJob::Done {
        progress.enter("Writing", 0.0);
        const std::stop_token stop = progress.stopToken();
        const Session::Written written = Session::write(*saving, stop);
        return [this, saving, written, stop, afterwards] {
            context_.session.endSaving(*saving, written);
            if (!tellWritten(written ? Status() : Failure(written.error()), stop)) return;
            if (const int count = saving->modelsLeftOut; count > 0) {
                context_.toasts.info(std::to_string(count) +
                                     (count == 1 ? " model that no object shows is"
                                                 : " models that no object shows are") +
                                     " not in the file");
            }
            afterwards();
        };
    };
    static_cast<void>(work(std::move(title), writing));
}

void FileFlow::saveTo(const std::filesystem::path& path) {
    const std::string name = path.filename().string();
    write("Saving " + name, path, [this, path, name] {
        tellLosses(path);
        context_.toasts.info("Saved " + name);
        context_.settings.remember(path);
        // A .vox file is an export: the document is as unsaved as it was.
        if (context_.session.unsaved()) waiting_ = Waiting::none;
        unlessProfileUnsaved();
    });
}

bool FileFlow::tell(const Status& done, const std::string& news) {
    if (!done) {
        waiting_ = Waiting::none;
        context_.dialogs.showError(done.error().describe());
        return false;
    }
    if (!news.empty()) context_.toasts.info(news);
    return true;
}

bool FileFlow::tellWritten(const Status& done, const std::stop_token& stop) {
    if (done || !stop.stop_requested()) return tell(done, {});
    context_.toasts.info("Cancelled: " + job_.title());
    return false;
}

}  // namespace voxprite::editor
