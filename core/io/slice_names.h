// Names of the pictures of a stack. Private to core/io.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace voxprite {

inline constexpr std::size_t kMaxSlices = 65'536;

// "hut_007.png": what it begins with, its number, and how many digits that has.
struct SliceName {
    std::string beginning;
    int number = 0;
    std::size_t digits = 0;
};
// Nothing where the name does not end in a number of at most nine digits.
[[nodiscard]] std::optional<SliceName> sliceNameOf(const std::filesystem::path& path);
// Is a picture of this name one of a stack whatever lies beside it?
[[nodiscard]] bool isSurelyNumbered(const SliceName& name);

}  // namespace voxprite
