#include "core/io/neighbours.h"

#include <algorithm>

#include "core/base/file.h"

namespace voxprite {

Status mayReplaceNeighbour(const std::filesystem::path& neighbour, ByteView bytes,
                           const std::filesystem::path& asked,
                           const std::function<bool()>& isOurs) {
    std::error_code unknown;
    if (!std::filesystem::exists(neighbour, unknown)) return {};
    if (const Result<Bytes> there = readFile(neighbour);
        there && std::ranges::equal(*there, bytes)) {
        return {};
    }
    if (isOurs()) return {};
    return failInFile(neighbour.string(),
                      "would be replaced by what is written beside " + asked.filename().string() +
                          ", and no such file refers to it; move it away, choose another name or "
                          "force it (nothing was written)");
}

}  // namespace voxprite
