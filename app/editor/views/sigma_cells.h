// The sprite view split into cells, each with a sigma of its own.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/editor/views/scene_figures.h"
#include "app/editor/views/view_canvas.h"
#include "core/sprite/sprite_view.h"
#include "render/scene_renderer.h"

namespace voxprite::editor {

// One picture of the sprite view; without a comparison there is one alone.
struct SpriteCell {
    std::unique_ptr<Frame> frame;        // null: the picture is that of the canvas
    std::vector<ViewHistory> histories;  // one an entity
    std::vector<std::optional<RepresentationChoice>> chosen;  // likewise
    RepresentationShares shares{};
    SceneStats stats;
    std::string problem;            // why there is no picture
    std::uint64_t arrangement = 0;  // SpriteScene::arrangement() that the entities are of

    // What its views remember.
    void forget() {
        histories.clear();
        chosen.clear();
    }
};

// Pictures, values and what can be done with them; between the canvas' begin() and end().
void showSigmaCells(Ui& ui, const ViewCanvas& canvas, std::span<const CellArea> areas,
                    std::span<const SpriteCell> cells);

}  // namespace voxprite::editor
