// MagicaVoxel .vox, versions 150 and 200, with the scene graph extension.
//
// Format: github.com/ephtracy/voxel-model (the base format and its extension), and what real files
// do: RGBA entry i is colour i + 1; a short RGBA chunk fills the colours that it has; no RGBA means
// the default palette; IMAP orders the display only; unknown chunks are skipped by their length.
// A model's pivot is floor(size / 2): it becomes the origin of its model space, so that voxel v of
// the file is v - floor(size / 2) here and canvas.min is -floor(size / 2).
#pragma once

#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/model/document.h"

namespace voxprite {

struct VoxImport {
    Document document;
    std::vector<std::string> warnings;  // what was odd but harmless, one sentence each
};

// All or nothing. Fails with the byte offset on anything that is not a .vox, is cut short, refers
// to what is not there, or would exceed the limits on size; memory stays bounded by the file's own
// length times a small constant.
[[nodiscard]] Result<VoxImport> readVox(ByteView bytes);

// Version 200 with scene graph, layers, materials, palette order and animation. Models larger than
// 256 on an edge are split into several under a group. Fails when a coordinate cannot be held.
[[nodiscard]] Result<Bytes> writeVox(const Document& document);

}  // namespace voxprite
