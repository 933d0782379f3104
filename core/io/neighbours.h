// Files that are written beside the one that a person asked for: they never replace what is
// somebody else's.
#pragma once

#include <filesystem>
#include <functional>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace voxprite {

// May `bytes` be written to `neighbour`, because `asked` was asked for? Yes, where nothing lies
// there or the same bytes do, and where `isOurs` says that what lies there belongs to an earlier
// `asked`; else it fails, naming the neighbour. All are asked about before the first is written.
[[nodiscard]] Status mayReplaceNeighbour(const std::filesystem::path& neighbour, ByteView bytes,
                                         const std::filesystem::path& asked,
                                         const std::function<bool()>& isOurs);

}  // namespace voxprite
