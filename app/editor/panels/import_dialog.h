// Before a mesh becomes voxels: how many, and what of its inside. What the command line takes as
// options (core/io/mesh_options.h).
#pragma once

#include <filesystem>
#include <optional>

#include "app/editor/panels/ui.h"
#include "core/io/formats.h"

namespace voxprite::editor {

class ImportDialog {
  public:
    void open(std::filesystem::path file);
    [[nodiscard]] bool isOpen() const { return !file_.empty(); }
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }

    enum class Answer : std::uint8_t { none, import, cancel };
    // Draws it while it is open; it is closed by an answer other than none.
    [[nodiscard]] Answer draw(Ui& ui);
    // What was chosen last; until then what the command line would do.
    [[nodiscard]] const ReadOptions& chosen() const { return options_; }

  private:
    void drawSize(Ui& ui);
    void drawFilling(Ui& ui);

    std::filesystem::path file_;
    ReadOptions options_;
    bool byUnit_ = false;
    double voxelsPerUnit_ = 16.0;
};

}  // namespace voxprite::editor
