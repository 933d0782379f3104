#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace voxprite {

// "Hand", or the first of "Hand 2", "Hand 3" ... that none of `items` is called.
template <class Item>
[[nodiscard]] std::string freeName(const std::string& stem, const std::vector<Item>& items) {
    std::string name = stem;
    for (int number = 2; std::ranges::find(items, name, &Item::name) != items.end(); ++number) {
        name = stem + " " + std::to_string(number);
    }
    return name;
}

}  // namespace voxprite
