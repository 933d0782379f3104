// Sprite sheets made behind the window: for the dialog's preview, and to be written.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/session/background_job.h"
#include "core/model/document.h"
#include "core/model/game_profile.h"
#include "core/sheet/sheet_files.h"

namespace voxprite::editor {

// All that a sheet is made of.
struct SheetRequest {
    std::shared_ptr<const Document> document;
    GameProfile profile;
    SheetOptions options;
};

class SheetMaker {
  public:
    struct Made {
        SheetRequest request;
        std::shared_ptr<const Sheet> sheet;  // null: it failed
        std::string problem;                 // why
        std::vector<Image> shown;            // its pictures, none wider or higher than kShownEdge
    };
    static constexpr int kShownEdge = 2048;

    // Instead of what was asked for before. Begins when nothing else is asked for in a moment.
    void ask(SheetRequest request);
    // Nothing is wanted any more, and nothing is made.
    void drop();
    // Once a frame. True when made() is another one.
    bool update();
    [[nodiscard]] bool working() const { return wanted_ || job_.running(); }
    // "12 of 64 sprites"; empty before the first.
    [[nodiscard]] std::string stage() const { return job_.stage(); }
    [[nodiscard]] double share() const { return job_.share(); }
    // The newest that is ready; while another is on its way, the one before it. Null: none yet.
    [[nodiscard]] const std::shared_ptr<const Made>& made() const { return made_; }
    // For scripts, which do one thing after another.
    void finish();

  private:
    void begin();

    std::optional<SheetRequest> wanted_;
    std::chrono::steady_clock::time_point asked_;
    BackgroundJob job_;
    std::shared_ptr<const Made> made_;
};

// What shall be written, and where.
struct SheetExport {
    SheetRequest request;
    std::shared_ptr<const Sheet> sheet;  // of the request, if it has been made already
    std::filesystem::path output;
    std::optional<Turntable> turntable;
};

// Makes what is not made yet and writes it; how many files. Fails as makeSheet() and
// writeSheetFiles() do; stopped before the first file is written, it has written nothing.
[[nodiscard]] Result<std::size_t> writeSheet(const SheetExport& asked, JobProgress& progress);

}  // namespace voxprite::editor
