// File > Export sprite sheet: what `voxprite sheet` does, with a picture of what will come of it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/panels/ui.h"
#include "app/editor/session/sheet_maker.h"
#include "render/picture_texture.h"

namespace voxprite::editor {

class SheetDialog {
  public:
    // The file is proposed beside that of the document.
    void open(const Session& session, const std::filesystem::path& folder);
    [[nodiscard]] bool isOpen() const { return open_; }
    // The preview is on its way.
    [[nodiscard]] bool working() const { return open_ && maker_.working(); }
    void finishWork() { maker_.finish(); }
    // What it says of the sheet: how many sprites it has, or why there is none.
    [[nodiscard]] std::string said() const;
    // What it says of the file: why the name cannot be used, or what has to be agreed to first.
    [[nodiscard]] const std::string& saysOfFile() const { return problem_; }
    // Draws it while it is open; what shall be written, in the frame in which that was asked for.
    [[nodiscard]] std::optional<SheetExport> draw(Ui& ui);

  private:
    // What the preview was asked for.
    struct Asked {
        SheetSettings settings;
        GameProfile profile;
        std::uint64_t contents = 0;  // revision of the session's
        bool operator==(const Asked&) const = default;
    };
    void close();
    void follow(Ui& ui);
    void drawSettings(Ui& ui);
    void drawViews(Ui& ui);
    void drawLook(Ui& ui);
    void drawPicture(Ui& ui);
    void drawTurntable(Ui& ui);
    void drawPreview(Ui& ui, ImVec2 size);
    [[nodiscard]] std::string problem() const;  // with what is set
    void drawFacts(Ui& ui);
    [[nodiscard]] bool drawFooter(Ui& ui, bool listens);
    void browse(Ui& ui);
    [[nodiscard]] std::optional<SheetExport> accept(Ui& ui);

    bool open_ = false;
    std::string file_;                            // as typed
    bool typesFile_ = false;                      // the field had the keys in the frame before
    std::vector<std::filesystem::path> replace_;  // may be, the artist said
    std::string problem_;                         // of the file's name
    std::optional<Asked> asked_;
    std::string wrong_;  // with the settings
    SheetMaker maker_;
    std::vector<PictureTexture> textures_;  // of the maker's pictures
    int picture_ = 0;                       // that is shown
    float zoom_ = 1.0f;                     // on top of what fits
    ImVec2 pan_{0.0f, 0.0f};
};

}  // namespace voxprite::editor
