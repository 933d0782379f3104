// `project.json` inside a .voxprite file: all of a document but the voxels. Private to core/io.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/model/document.h"

namespace voxprite {

inline constexpr int kProjectVersion = 1;

// Where the voxels of a model are, and how to know that they are the right ones.
struct VoxelEntry {
    std::string file;
    std::uint32_t crc32 = 0;
    std::uint64_t solidVoxels = 0;
};

// One entry a model, in the order of Document::models; `authored` in place of the document's own.
[[nodiscard]] std::string writeProjectJson(const Document& document, const AuthoredValues& authored,
                                           const std::vector<VoxelEntry>& entries);

struct ProjectJson {
    Document document;  // its models have no voxels yet
    std::vector<VoxelEntry> entries;
};
[[nodiscard]] Result<ProjectJson> readProjectJson(std::string_view text);

}  // namespace voxprite
