// Choosing a file to open or a name to save under, inside the window.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/panels/ui.h"

namespace voxprite::editor {

// What has to be agreed to before these files are replaced, of which the last is the one that was
// asked for: few by name, many by that one. Of a .svo also how much it holds.
[[nodiscard]] std::string questionAbout(const std::vector<std::filesystem::path>& replaced);

class FileBrowser {
  public:
    struct Request {
        std::string title{};                    // "Open a model"
        std::string button{};                   // "Open"
        bool saving = false;                    // else the file must exist
        std::vector<std::string> extensions{};  // ".vox", ...; the first is added when saving
        std::filesystem::path folder{};         // where to start
        std::string name{};                     // suggested
        // What people call the format of this ending: where there is more than one, it can be
        // chosen by that when saving.
        std::function<std::string(const std::string& ending)> formatName{};
        // Ways to write the file, one of which is chosen beside its name.
        std::vector<std::string> ways{};
        // What a file of this name would leave out, a sentence each; said before it is written.
        std::function<std::vector<std::string>(const std::filesystem::path&)> losses{};
        // The files that saving under this name would replace; without it that file alone.
        std::function<std::vector<std::filesystem::path>(const std::filesystem::path&)> replaced{};
    };
    void open(Request request);
    [[nodiscard]] bool isOpen() const { return open_; }
    // Which of the request's ways was chosen.
    [[nodiscard]] std::size_t way() const { return way_; }
    // Why the name cannot be used, or what has to be agreed to first.
    [[nodiscard]] const std::string& says() const { return problem_; }
    // Draws it while open; returns the path when one was chosen. Overwriting has been confirmed.
    [[nodiscard]] std::optional<std::filesystem::path> draw(Ui& ui);

  private:
    struct Entry {
        std::string name;
        bool folder = false;
        std::uintmax_t bytes = 0;
    };
    void enter(const std::filesystem::path& folder);
    void drawPath(Ui& ui);
    void drawList(Ui& ui, float height, bool& accepted);
    // The ending that a file of this name is saved with.
    [[nodiscard]] std::string endingFor(const std::filesystem::path& path) const;
    [[nodiscard]] std::optional<std::filesystem::path> accept();
    [[nodiscard]] std::vector<std::filesystem::path> replacedBy(
        const std::filesystem::path& path) const;
    [[nodiscard]] bool choosesFormat() const {
        return request_.saving && request_.formatName && request_.extensions.size() > 1;
    }
    void drawFormats(Ui& ui, float width);
    void drawWays(Ui& ui, float width);
    void findLosses();
    // Why the name cannot be used, else what its format leaves out; so many lines.
    [[nodiscard]] int noteLines() const;
    void drawNote(Ui& ui);
    void drawFooter(Ui& ui, bool& accepted);

    Request request_;
    bool open_ = false;
    std::filesystem::path folder_;
    std::vector<Entry> entries_;
    std::string name_;
    std::string problem_;                   // why the name cannot be used
    std::optional<std::string> lossesFor_;  // the ending that losses_ are of
    std::vector<std::string> losses_;
    std::size_t way_ = 0;
    std::string overwrite_;  // the name whose overwriting is asked about
};

}  // namespace voxprite::editor
