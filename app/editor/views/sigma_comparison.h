// Two or four values of sigma side by side. One of them is the one in force, that of the game's
// profile; the others are there to be looked at.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

namespace voxprite::editor {

struct SigmaComparison {
    int cells = 0;  // 0 (off), 2 or 4
    std::array<double, 4> sigmas{1.0, 2.0, 3.0, 4.0};
    int inForce = 0;  // the cell of the profile's sigma

    bool operator==(const SigmaComparison&) const = default;
    [[nodiscard]] bool on() const { return cells > 0; }
    // The cell in force among so many pictures: a view that has just been split anew still shows
    // those it had.
    [[nodiscard]] std::size_t inForceAmong(std::size_t pictures) const;
    // Shows `count` cells (0, 2 or 4) with values around that of the profile.
    void open(int count, double profileSigma);
    // The profile has this sigma now: a cell that shows it already becomes the one in force, else
    // the one in force follows. So undoing "use this" goes back to the cell before.
    void follow(double profileSigma);
};

// Where the cells of a view lie, in reading order; `gapPx` between them. Two stand side by side in
// a wide view, one above the other in a high one.
struct CellArea {
    glm::ivec2 min{0};
    glm::ivec2 size{1};
};
[[nodiscard]] std::vector<CellArea> cellAreas(glm::ivec2 viewPx, int cells, int gapPx);

}  // namespace voxprite::editor
