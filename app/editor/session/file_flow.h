// Opening, saving and exporting: from the question about unsaved changes over the choice of a file
// to the news that it is done. What takes long goes on behind the window; while a file is being
// opened nothing else can be done, while one is being saved all can. Long steps of the document go
// the same way.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "app/editor/commands/command_context.h"
#include "app/editor/panels/dialogs.h"
#include "app/editor/panels/entity_dialog.h"
#include "app/editor/panels/file_browser.h"
#include "app/editor/panels/import_dialog.h"
#include "app/editor/session/background_job.h"
#include "app/editor/session/sheet_maker.h"

namespace voxprite::editor {

class FileFlow {
  public:
    // `context` outlives this.
    explicit FileFlow(CommandContext& context) : context_(context) {}

    void startNew() { unlessUnsaved(Waiting::startNew); }
    void open() { unlessUnsaved(Waiting::openDialog); }
    // Of a file with several entities that one, if it is given; else it asks.
    void open(const std::filesystem::path& file, std::optional<std::size_t> entity = {});
    // A model of another file into the scene around the edited one; of a file with several entities
    // it asks for some.
    void addToScene(const std::filesystem::path& file);
    void save();
    void saveAs();
    // As one sprite, or each model as one, all in one file.
    void exportOctree();
    // Behind the window.
    void exportSheet(SheetExport asked);
    void openProfile();
    void saveProfile();
    void saveProfileAs();
    void quit() { unlessUnsaved(Waiting::quit); }

    // For any other file: asks for one, starting where the last one was, and hands it on.
    using Chosen = std::function<void(CommandContext&, const std::filesystem::path&)>;
    void browse(FileBrowser::Request request, Chosen chosen);

    // For any other long work: one thing at a time, so it fails while another goes on.
    [[nodiscard]] Status work(std::string title, BackgroundJob::Work work);
    // Gives up what is being read or written, and what waits for it. What is read is forgotten at
    // once; what is written goes on until it has stopped, and says whether it was written even so.
    void cancelWork();

    // A step of the document that takes long: nothing else can be done until it is in force, and
    // `afterwards` done, or was stopped.
    using Prepare =
        std::function<Result<std::shared_ptr<Session::Prepared>>(const Session&, const Progress&)>;
    void step(std::string title, const Prepare& prepare,
              const std::function<void()>& afterwards = {});

    // A step of a drag that takes long: of those that follow each other only the newest is made, as
    // soon as the one before it is in force. The hand goes on meanwhile.
    void drag(Action action);
    // The scene as that drag leaves it; null while there is none.
    [[nodiscard]] const SceneState* draggedScene() const;

    // The dialogs, while there are any; and the end of what went on behind the window.
    void draw(Ui& ui);
    [[nodiscard]] bool isWorking() const { return job_.running() || step_.running() || drags(); }
    // Other edits, and commands, come after it.
    [[nodiscard]] bool drags() const { return dragged_.has_value(); }
    // Does an edit of this key? Those of the same drag do not.
    [[nodiscard]] bool comesAfterDrag(std::uint64_t mergeKey) const {
        return drags() && dragged_->mergeKey != mergeKey;
    }
    // Nothing else can be done: the document must stay as it is.
    [[nodiscard]] bool blocks() const { return (job_.running() && blocks_) || step_.running(); }
    // Scripts do one thing after another: waits until nothing goes on.
    void finishWork();
    // A question, or an error to be read, lies over all else.
    [[nodiscard]] bool asks() const {
        return !context_.dialogs.openName().empty() || isBrowsing() || isImporting() ||
               entities_.isOpen();
    }
    [[nodiscard]] bool isBrowsing() const { return browser_.isOpen(); }
    // What the browser says of the name; empty while it has nothing against it.
    [[nodiscard]] const std::string& browserSays() const { return browser_.says(); }
    // Asks what voxels a mesh shall become.
    [[nodiscard]] bool isImporting() const { return import_.isOpen(); }
    // Asks which of a file's entities are meant.
    [[nodiscard]] const EntityDialog& entities() const { return entities_; }

    [[nodiscard]] bool quits() const { return quits_; }
    // Is another document open than at the last call?
    [[nodiscard]] bool takeReplaced() { return std::exchange(replaced_, false); }

  private:
    // What waits for the answer about unsaved changes.
    enum class Waiting : std::uint8_t { none, startNew, openDialog, openFile, quit };
    // Asks about the document; then, where the game profile would be lost, about that.
    void unlessUnsaved(Waiting what);
    void unlessProfileUnsaved();
    void afterUnsavedQuestion(UnsavedAnswer answer);
    void afterChangedQuestion(ChangedAnswer answer);
    void goOn();
    // Of a mesh it asks first what voxels it shall become, of several entities which one is meant.
    void openNow(const std::filesystem::path& path, std::optional<std::size_t> entity);
    void readNow(const std::filesystem::path& path, const ReadOptions& options);
    // On the job's thread: what follows if the file has several entities, or is a damaged one of
    // these; else nothing.
    [[nodiscard]] std::optional<BackgroundJob::Done> askedFirst(const std::filesystem::path& path,
                                                                EntityDialog::Asks asks);
    void afterEntities(const EntityDialog::Answer& answer);
    void saveTo(const std::filesystem::path& path);
    void saveProfileTo(const std::filesystem::path& path);
    void exportTo(const std::filesystem::path& path);
    void exportModelsTo(const std::filesystem::path& path);
    void write(std::string title, const std::filesystem::path& path,
               const std::function<void()>& afterwards);
    void followDrag();
    void askForFile(Ui& ui);
    void showProgress(Ui& ui);
    // What the format of a file of this name cannot hold.
    [[nodiscard]] std::vector<std::string> lossesAt(const std::filesystem::path& path) const;
    void tellLosses(const std::filesystem::path& path);
    // A failure to be read; success to be seen in passing.
    bool tell(const Status& done, const std::string& news);
    // Of a file that was to be written behind the window: cancelled is no failure.
    bool tellWritten(const Status& done, const std::stop_token& stop);

    CommandContext& context_;
    FileBrowser browser_;
    ImportDialog import_;
    EntityDialog entities_;
    Chosen chosen_;
    BackgroundJob step_;
    BackgroundJob job_;
    bool blocks_ = false;  // it reads a file: nothing else may be done meanwhile
    Waiting waiting_ = Waiting::none;
    bool asksForProfile_ = false;       // the question about unsaved changes
    bool replacesProfile_ = false;      // the one about what another program changed
    Waiting afterJob_ = Waiting::none;  // until the job has ended
    bool settled_ = false;              // before that, as far as could be
    std::filesystem::path waitingFile_;
    std::optional<std::size_t> waitingEntity_;
    bool quits_ = false;
    bool replaced_ = false;
    BackgroundJob drag_;
    std::optional<Action> dragged_;  // what is asked for or made
    bool dragIsNew_ = false;         // nobody makes it yet
};

}  // namespace voxprite::editor
