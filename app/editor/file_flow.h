// Opening, saving and exporting: from the question about unsaved changes over the choice of a file
// to the news that it is done.
#pragma once

#include <filesystem>
#include <functional>

#include "app/editor/command_context.h"
#include "app/editor/panels/dialogs.h"
#include "app/editor/panels/file_browser.h"

namespace voxprite::editor {

class FileFlow {
  public:
    // `context` outlives this.
    explicit FileFlow(CommandContext& context) : context_(context) {}

    void startNew() { unlessUnsaved(Waiting::startNew); }
    void open() { unlessUnsaved(Waiting::openDialog); }
    void open(const std::filesystem::path& file);
    void save();
    void saveAs();
    void exportOctree();
    void openProfile();
    void saveProfile();
    void saveProfileAs();
    void quit() { unlessUnsaved(Waiting::quit); }

    // For any other file: asks for one, starting where the last one was, and hands it on.
    using Chosen = std::function<void(CommandContext&, const std::filesystem::path&)>;
    void browse(FileBrowser::Request request, Chosen chosen);

    // The dialogs, while there are any.
    void draw(Ui& ui);
    [[nodiscard]] bool isBrowsing() const { return browser_.isOpen(); }

    [[nodiscard]] bool quits() const { return quits_; }
    // Is another document open than at the last call?
    [[nodiscard]] bool takeReplaced() { return std::exchange(replaced_, false); }

  private:
    // What waits for the answer about unsaved changes.
    enum class Waiting : std::uint8_t { none, startNew, openDialog, openFile, quit };
    void unlessUnsaved(Waiting what);
    void afterUnsavedQuestion(UnsavedAnswer answer);
    void goOn();
    void openNow(const std::filesystem::path& path);
    void saveTo(const std::filesystem::path& path);
    // A failure to be read; success to be seen in passing.
    bool tell(const Status& done, const std::string& news);

    CommandContext& context_;
    FileBrowser browser_;
    Chosen chosen_;
    Waiting waiting_ = Waiting::none;
    std::filesystem::path waitingFile_;
    bool quits_ = false;
    bool replaced_ = false;
};

}  // namespace voxprite::editor
