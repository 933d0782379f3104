// A file of several entities (core/io/svo_set.h): which of them are meant, by name, size and
// sprite.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/panels/ui.h"
#include "core/io/svo_file.h"
#include "render/picture_texture.h"

namespace voxprite::editor {

class EntityDialog {
  public:
    enum class Asks : std::uint8_t {
        one,  // to be opened
        some  // to be added; all are ticked at first
    };
    // At least one entity. In place of what was asked before.
    void open(std::filesystem::path file, std::vector<SvoFile> set, Asks asks);
    [[nodiscard]] bool isOpen() const { return !rows_.empty(); }
    // The name of the entity that the keys are at, and how many are ticked: "oak, 3 ticked".
    [[nodiscard]] std::string said() const;

    struct Answer {
        std::filesystem::path file;
        Asks asks = Asks::one;
        struct Entity {
            std::size_t index = 0;  // in the file
            std::string name;
        };
        std::vector<Entity> entities;  // at least one, in the file's order
    };
    // Draws it while it is open; what was chosen, in the frame in which it was. Closed by that, and
    // by being left. Needs the window's GL context.
    [[nodiscard]] std::optional<Answer> draw(Ui& ui);

  private:
    struct Row {
        std::size_t index = 0;
        std::string name;
        bool ticked = true;
        // Made when the row is first seen.
        std::string figures;
        PictureTexture picture;
    };
    void see(const Ui& ui, Row& row);
    void drawSearch(Ui& ui);
    void moveByKeys();
    [[nodiscard]] bool drawList(Ui& ui);  // true: it was chosen twice
    void drawRow(Ui& ui, Row& row, ImVec2 corner, ImVec2 size);
    [[nodiscard]] bool drawFooter(Ui& ui, bool listens);
    void drawTicking(Ui& ui, ImVec2 button);
    [[nodiscard]] std::size_t ticked() const;
    [[nodiscard]] Answer answer();
    void close();

    std::filesystem::path file_;
    Asks asks_ = Asks::one;
    std::vector<SvoFile> set_;
    std::vector<Row> rows_;
    std::string search_;
    std::vector<std::size_t> found_;  // the rows that the search leaves
    std::size_t chosen_ = 0;          // of them
    bool moved_ = false;              // by no click: it must be brought into sight
};

}  // namespace voxprite::editor
