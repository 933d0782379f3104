// .voxprite, the native file: a ZIP (libzip) with `project.json` and one compressed, checksummed
// voxel payload a model. Holds everything of a Document; reads back equal.
//
//   project.json        "voxprite_project": 1, the scene graph, palette, entity, ...; each of its
//                       models names the entry with its voxels, their CRC-32 and their number
//   models/0.voxels     the voxels of models[0] (core/io/voxel_payload.h), deflated
//   models/1.voxels     ...
//
// Equal documents that keep their voxels alike give equal bytes: entries have no times.
#pragma once

#include <cstdint>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/model/document.h"

namespace voxprite {

// What a file may claim to inflate to; more is refused before memory is taken, and never written.
inline constexpr std::uint64_t kMaxProjectJsonBytes = std::uint64_t{64} << 20;
inline constexpr std::uint64_t kMaxProjectVoxelBytes = std::uint64_t{2} << 30;  // all models

// Fails on a document that is not valid or larger than could be read back. `authored` is written
// instead of the document's own record (the profile's values at the time of saving).
[[nodiscard]] Result<Bytes> writeProject(const Document& document, const AuthoredValues& authored);
[[nodiscard]] Result<Bytes> writeProject(const Document& document);
// All or nothing; bounded: sizes claimed in the file are checked before memory is taken.
[[nodiscard]] Result<Document> readProject(ByteView bytes);

}  // namespace voxprite
