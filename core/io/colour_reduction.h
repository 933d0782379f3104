// Colours of a file that has as many as it likes, brought down to the 255 of a palette. The one
// home for this: readers of formats with free colours, meshes and animated GIFs come here.
//
// Up to the limit every colour keeps its own index, exactly, in the order in which it was added.
// Beyond it they are grouped by how they look (OKLab): the group that is most at odds with itself
// is cut in two where that helps most, until there are enough (Wu, "Color quantization by dynamic
// programming and principal analysis", 1992, by the plain axes), then each colour goes to the
// nearest group for some rounds (Lloyd, "Least squares quantization in PCM", 1982). What stands for
// a group is the one of its own colours that is nearest to its mean, so that no colour is made up.
// The result depends on the colours and how often each was added, and not on the order; it is laid
// out as a painter would, greys first, then by hue and from dark to light.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/base/image.h"
#include "core/model/palette.h"

namespace voxprite {

// How often each colour occurs. Two that differ in alpha alone are two.
class ColourCount {
  public:
    void add(Rgba8 colour, std::uint64_t times = 1);
    [[nodiscard]] std::size_t distinct() const { return entries_.size(); }

    struct Entry {
        Rgba8 colour{0};
        std::uint64_t times = 0;
    };
    [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }  // as added

  private:
    std::vector<Entry> entries_;
    std::unordered_map<std::uint32_t, std::size_t> places_;
};

class ReducedColours {
  public:
    // Colours stand from index 1 on, without names; what is not needed is vacant.
    Palette palette;
    int used = 0;              // colours in `palette`
    std::size_t distinct = 0;  // colours that there were
    // How far the colours moved, in OKLab (white is 1 from black): on average and at most.
    double meanDistance = 0.0;
    double maxDistance = 0.0;

    [[nodiscard]] bool exact() const { return distinct == static_cast<std::size_t>(used); }
    // 1 ... 255, of a colour that was counted; of any other the nearest.
    [[nodiscard]] std::uint8_t indexOf(Rgba8 colour) const;
    // A sentence that says what was done; nothing where every colour is as it was.
    [[nodiscard]] std::optional<std::string> warning() const;

  private:
    friend ReducedColours reduceColours(const ColourCount& count, int limit);
    std::unordered_map<std::uint32_t, std::uint8_t> indices_;
};

// `limit`: 1 ... 255.
[[nodiscard]] ReducedColours reduceColours(const ColourCount& count, int limit = 255);

}  // namespace voxprite
