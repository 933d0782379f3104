#include "render/shelf_packer.h"

#include <algorithm>

namespace voxprite {

namespace {

// Heights of shelves grow in steps, so that sprites of nearly the same height share one.
constexpr int kShelfStepPx = 8;

int shelfHeight(int height) {
    return (height + kShelfStepPx - 1) / kShelfStepPx * kShelfStepPx;
}

// A shelf in use takes what leaves less than a step, or at most a third of its height, unused;
// others only where there is no empty one.
bool worthwhile(int shelfHeight, int height) {
    const int unused = shelfHeight - height;
    return unused < kShelfStepPx || 3 * unused <= shelfHeight;
}

}  // namespace

ShelfPacker::Shelf ShelfPacker::emptyShelf(int y, int height) const {
    return {y, height, {{0, pageSize_.x}}, pageSize_.x};
}

void ShelfPacker::addPage() {
    pages_.push_back({emptyShelf(0, pageSize_.y)});
}

std::optional<glm::ivec3> ShelfPacker::take(glm::ivec2 size) {
    if (size.x > pageSize_.x || size.y > pageSize_.y) return std::nullopt;
    struct Choice {
        int page;
        std::size_t shelf;
    };
    std::optional<Choice> empty, wasteful;
    for (int page = 0; page < pages(); ++page) {
        const Page& shelves = pages_[static_cast<std::size_t>(page)];
        for (std::size_t i = 0; i < shelves.size(); ++i) {
            const Shelf& shelf = shelves[i];
            if (shelf.height < size.y || shelf.widest < size.x) continue;
            if (isEmpty(shelf)) {
                if (!empty) empty = Choice{page, i};
            } else if (worthwhile(shelf.height, size.y)) {
                return takeFrom(page, i, size);
            } else if (!wasteful) {
                wasteful = Choice{page, i};
            }
        }
    }
    if (!empty && !wasteful) return std::nullopt;
    if (!empty) return takeFrom(wasteful->page, wasteful->shelf, size);
    Page& shelves = pages_[static_cast<std::size_t>(empty->page)];
    Shelf& whole = shelves[empty->shelf];
    const int height = std::min(shelfHeight(size.y), whole.height);
    if (height < whole.height) {
        const Shelf rest = emptyShelf(whole.y + height, whole.height - height);
        whole.height = height;
        shelves.insert(shelves.begin() + static_cast<std::ptrdiff_t>(empty->shelf) + 1, rest);
    }
    return takeFrom(empty->page, empty->shelf, size);
}

glm::ivec3 ShelfPacker::takeFrom(int page, std::size_t index, glm::ivec2 size) {
    Shelf& shelf = pages_[static_cast<std::size_t>(page)][index];
    const auto gap =
        std::ranges::find_if(shelf.gaps, [&](const Gap& g) { return g.width >= size.x; });
    const glm::ivec3 place(gap->x, shelf.y, page);
    gap->x += size.x;
    gap->width -= size.x;
    if (gap->width == 0) shelf.gaps.erase(gap);
    shelf.widest = 0;
    for (const Gap& g : shelf.gaps) shelf.widest = std::max(shelf.widest, g.width);
    return place;
}

void ShelfPacker::giveBack(glm::ivec3 place, glm::ivec2 size) {
    Page& shelves = pages_[static_cast<std::size_t>(place.z)];
    const auto shelf = std::ranges::lower_bound(shelves, place.y, {}, &Shelf::y);
    std::vector<Gap>& gaps = shelf->gaps;
    const auto next = std::ranges::upper_bound(gaps, place.x, {}, &Gap::x);
    auto gap = gaps.insert(next, {place.x, size.x});
    if (const auto after = gap + 1; after != gaps.end() && gap->x + gap->width == after->x) {
        gap->width += after->width;
        gaps.erase(after);
    }
    if (gap != gaps.begin()) {
        if (const auto before = gap - 1; before->x + before->width == gap->x) {
            before->width += gap->width;
            gap = gaps.erase(gap) - 1;
        }
    }
    shelf->widest = std::max(shelf->widest, gap->width);
    if (!isEmpty(*shelf)) return;
    // Empty neighbours become one.
    if (const auto above = shelf + 1; above != shelves.end() && isEmpty(*above)) {
        shelf->height += above->height;
        shelves.erase(above);
    }
    if (shelf != shelves.begin()) {
        if (const auto below = shelf - 1; isEmpty(*below)) {
            below->height += shelf->height;
            shelves.erase(shelf);
        }
    }
}

}  // namespace voxprite
