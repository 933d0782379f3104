// The copies around the edited model.
#include <array>

#include "app/editor/panels/panels.h"
#include "app/editor/widgets.h"

namespace voxprite::editor {
namespace {

constexpr std::array kPatterns{Choice{"None", "Only the edited model"},
                               Choice{"Grid", "Copies in rows and columns around it"},
                               Choice{"Crowd", "Copies at random places around it"},
                               Choice{"March", "Ranks of copies that walk past it"}};

}  // namespace

void drawScene(Ui& ui) {
    CopySettings& copies = ui.settings.scene.copies;
    static_cast<void>(enumRow(ui, "scene.pattern", "Copies", copies.pattern, kPatterns));
}

}  // namespace voxprite::editor
