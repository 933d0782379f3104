// Rectangles on pages of one size, in shelves: rows of rectangles of about the same height. (After
// the shelf algorithms of Jylanki, "A thousand ways to pack the bin", 2010, with room given back.)
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

namespace voxprite {

class ShelfPacker {
  public:
    explicit ShelfPacker(glm::ivec2 pageSize) : pageSize_(pageSize) {}

    void addPage();
    [[nodiscard]] int pages() const { return static_cast<int>(pages_.size()); }
    // The lower left corner and the page of a free rectangle, which is taken from now on.
    [[nodiscard]] std::optional<glm::ivec3> take(glm::ivec2 size);
    // What take gave for this size is free again.
    void giveBack(glm::ivec3 place, glm::ivec2 size);

  private:
    struct Gap {
        int x, width;
    };
    struct Shelf {
        int y, height;
        std::vector<Gap> gaps;  // free, from left to right, never touching
        int widest;             // of the gaps
    };
    using Page =
        std::vector<Shelf>;  // from the bottom, without gaps between; no two empty ones touch

    [[nodiscard]] bool isEmpty(const Shelf& shelf) const { return shelf.widest == pageSize_.x; }
    [[nodiscard]] Shelf emptyShelf(int y, int height) const;
    [[nodiscard]] glm::ivec3 takeFrom(int page, std::size_t shelf, glm::ivec2 size);

    glm::ivec2 pageSize_;
    std::vector<Page> pages_;
};

}  // namespace voxprite
