// .svo: octrees for the game's runtime. Versioned, little-endian, checksummed; sections are aligned
// so that the file can be memory-mapped and its arrays handed to a GPU without a copy.
// [The byte diagram stands here: it is part of the format's definition.]
#pragma once

#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/model/document.h"
#include "core/model/game_profile.h"
#include "core/svo/octree.h"

namespace voxprite {

struct SvoModel {
    std::string name;
    Octree octree;  // canonical; all frames of one entity have the same size and origin
};

struct SvoClip {
    std::string name;
    std::vector<std::uint32_t> models;                 // one a frame, indices into SvoFile::models
    std::vector<std::uint32_t> durationsMilliseconds;  // one a frame
    bool loop = true;
    bool operator==(const SvoClip&) const = default;
};

struct SvoFile {
    std::vector<SvoModel> models;
    std::vector<SvoClip> clips;
    std::array<Rgba8, 256> palette{};
    std::array<std::string, 256> colourNames;
    std::string name;
    double voxelSizeMetres = 0.1;
    double sigma = 4.0;
    glm::dvec3 anchor{0.0};  // voxels, from the minimum corner
    Outline outline;
};

// Frames of a document baked into a file, with the authored values of the profile. One model a
// frame; equal frames are shared.
[[nodiscard]] Result<SvoFile> bakeForExport(const Document& document, const GameProfile& profile);
// Only source model `model` of the document, without its placement.
[[nodiscard]] Result<SvoFile> bakeModelForExport(const Document& document,
                                                 const GameProfile& profile, int model);

[[nodiscard]] Result<Bytes> writeSvo(const SvoFile& file);
// Checks magic, version, checksums, every index, every string; unknown later sections are skipped.
[[nodiscard]] Result<SvoFile> readSvo(ByteView bytes);

// Reads `bytes` back and compares every voxel of every frame with the document (through flatten(),
// not through the bake). What `export` calls before it reports success.
[[nodiscard]] Status verifyExport(ByteView bytes, const Document& document);

// The octrees as a document again: one object, a model a frame.
[[nodiscard]] Document documentFromSvo(const SvoFile& file);

}  // namespace voxprite
