// .voxprite, the native file: a ZIP (libzip) with `project.json` and one compressed, checksummed
// voxel payload a model. Holds everything of a Document; reads back equal.
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/model/document.h"

namespace voxprite {

[[nodiscard]] Result<Bytes> writeProject(const Document& document);
// All or nothing; bounded: sizes claimed in the file are checked before memory is taken.
[[nodiscard]] Result<Document> readProject(ByteView bytes);

}  // namespace voxprite
