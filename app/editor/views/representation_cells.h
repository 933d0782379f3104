// The current model by everything that it can be drawn by, side by side: what each looks like from
// a chosen distance, pixel for pixel and magnified, how far it is off the exact sprite, and what it
// costs. The distance changes by itself while it flies.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "app/editor/settings/representation_settings.h"
#include "app/editor/views/level_library.h"
#include "app/editor/views/sigma_comparison.h"
#include "app/editor/views/view_canvas.h"

namespace voxprite::editor {

class RepresentationCells {
  public:
    static constexpr std::size_t kCells = kRepresentations;

    // Flies from near to far and back.
    void advance(RepresentationSettings& settings, double seconds);

    // What the pictures show.
    struct Subject {
        const GpuOctree* octree = nullptr;
        const Palette* palette = nullptr;
        PlacedEntity placed;
        GameProfile profile;
        OrbitAngles angles;
        std::uint64_t revision = 0;  // of octree, palette and profile
    };
    // Draws what is not drawn yet; true when something was. What a hand that moves has no time for,
    // the errors, is worked out once nothing has changed for a moment.
    [[nodiscard]] Result<bool> render(SceneRenderer& renderer, const Subject& subject,
                                      const LevelLibrary& library,
                                      const RepresentationSettings& settings, glm::ivec2 viewPx,
                                      int gapPx);
    // Shows nothing until it is drawn again.
    void clear();
    // Some error is still to be worked out.
    [[nodiscard]] bool pending() const;

    // Pictures, figures, and the row with the distance; between the canvas' begin() and end().
    void show(Ui& ui, const ViewCanvas& canvas, const LevelLibrary& library);

    // Height of that row.
    [[nodiscard]] static int barPx(const Theme& theme) { return static_cast<int>(theme.px(44)); }
    // The cell that is outlined: what would be chosen from here.
    [[nodiscard]] std::size_t chosen() const { return chosen_; }
    [[nodiscard]] std::optional<double> errorOf(std::size_t cell) const {
        return cells_[cell].error;
    }

  private:
    struct Cell {
        RepresentationChoice choice;
        std::unique_ptr<Frame> frame;
        bool offered = false;
        std::optional<double> error;  // of this very picture
        std::optional<double> microseconds;
        SceneStats stats;
    };
    struct Shown {
        std::uint64_t subject = 0, library = 0;
        double yaw = 0.0, pitch = 0.0;
        RepresentationSettings settings;
        glm::ivec2 viewPx{0};
        bool operator==(const Shown&) const = default;
    };
    [[nodiscard]] Status draw(SceneRenderer& renderer, const Subject& subject,
                              const LevelLibrary& library, const RepresentationSettings& settings);
    [[nodiscard]] Status measureNext();
    void caption(Ui& ui, const Cell& cell, ImVec2 min, ImVec2 max, bool chosen);
    void drawBar(Ui& ui, ImVec2 min, ImVec2 max);

    std::array<Cell, kCells> cells_;
    std::vector<CellArea> areas_;
    int zoom_ = 1;
    int edgePx_ = 1;  // of the middle of the pictures, where the model is
    std::size_t chosen_ = 0;
    double distanceMetres_ = 0.0;
    double flightSeconds_ = 0.0;
    int still_ = 0;  // pictures in a row that were the same
    std::optional<Shown> shown_;
    // Of another size than what is drawn now: the user interface may have been told to show them.
    std::vector<std::unique_ptr<Frame>> leaving_;
};

}  // namespace voxprite::editor
