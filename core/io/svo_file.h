// clang-format off
// .svo: octrees for the game's runtime. Versioned, little-endian, checksummed; sections are aligned
// so that the file can be memory-mapped and its arrays handed to a GPU without a copy.
//
// All numbers are little-endian; u is unsigned, i two's complement, f64 IEEE 754 double. "Reserved"
// bytes are written as 0 and ignored by readers. CRC-32 is the one of PNG and ZIP (polynomial
// 0xEDB88320 reflected, start and final xor 0xFFFFFFFF).
//
//   byte  type    header (64 bytes)
//      0  u8[8]   magic: 89 53 56 4F 0D 0A 1A 0A  ("\x89SVO\r\n\x1A\n")
//      8  u16     major version, 1: a reader refuses any other
//     10  u16     minor version: later ones only add sections and use reserved bytes. The least
//                 that has what the file holds: 2 with several entities, 1 with sockets, else 0
//     12  u32     number of sections
//     16  u64     length of the whole file
//     24  u8[36]  reserved
//     60  u32     CRC-32 of header and section table, these four bytes taken as 0
//
//     64          section table: 32 bytes a section, in ascending order of their offsets
//      0  u8[4]   tag, four ASCII letters; none occurs twice
//      4  u32     flags; bit 0: a reader that does not know the tag must refuse the file
//                 (else it skips the section), other bits reserved
//      8  u64     offset in the file, a multiple of 64; bytes between sections are 0
//     16  u64     length
//     24  u32     CRC-32 of the section
//     28  u32     reserved
//
// The sections of version 1.0, all of them required. Their order in the file is free; writeSvo
// writes this one. A text is a pair (u32 offset into STRS, u32 length): UTF-8, no terminating zero;
// no two texts share bytes, (0, 0) is the empty text.
//
//   MODL  64 bytes a model, at least one: the descriptors
//      0  u32     NodeOffset: first node of this model in NODE, in nodes
//      4  u32     PayloadOffset: first payload in PAYL, in payloads
//      8  u32     MaxDepth, 1 ... 16: the root is a cube of edge 2^MaxDepth
//     12  u32[3]  VoxelDimensions x, y, z, at most 65,536; all 0 for an empty model
//     24  u32     number of nodes, 1 ... 8,388,608
//     28  u32     number of payloads
//     32  i32[3]  origin: where voxel (0,0,0) lies in the entity's own coordinates
//     44  text    name
//     52  u8[12]  reserved
//   NODE  4 bytes a node: the node words of all models (core/svo/octree.h), one model after the
//         other without gaps; child indices count from the model's own first node
//   PAYL  8 bytes a payload, in the same manner. Read as two u32, the low one comes first
//   PALT  256 x 4 bytes: R, G, B, A of every material; entry 0 is 0, 0, 0, 0
//   CNAM  256 texts: the materials' names
//   CLIP  32 bytes a clip, possibly none
//      0  text    name
//      8  u32     first frame in FRAM; clips follow one another without gaps
//     12  u32     number of frames, at least 1
//     16  u32     flags; bit 0: the clip loops
//     20  u8[12]  reserved
//   FRAM  8 bytes a frame. The models of one clip have the same VoxelDimensions and origin
//      0  u32     index of the model shown
//      4  u32     duration in milliseconds, 1 ... 1,000,000
//   AUTH  64 bytes: the values the entity was authored with (the game's own profile wins)
//      0  f64     VoxelSize, metres a voxel, 1e-6 ... 1e6
//      8  f64     sigma, virtual pixels a voxel, 1/64 ... 64
//     16  f64[3]  anchor x, y, z in voxels from the models' minimum corner
//     40  u32     flags; bit 0: the sprite has an outline
//     44  u8[4]   the outline's colour R, G, B, A; A is 255
//     48  text    name of the entity
//     56  u8[8]   reserved
//   STRS  the bytes of all texts
//
// Since version 1.1 there may be two more, which a reader may skip. Both are there or none:
//
//   SOCK  16 bytes a socket: a named point where the game fastens things
//      0  text    name
//      8  u32     first position in SPOS; sockets follow one another without gaps
//     12  u32     number of positions: 1, which holds always, or one for each frame in FRAM
//   SPOS  24 bytes a position
//      0  f64[3]  x, y, z in voxels from the models' minimum corner, as the anchor
//
// Without more a file is one entity. Since version 1.2 it may be a set of them, unlike in size,
// palette, anchor, clips and sockets. Then there is one more section, with flag bit 0, so that a
// reader of one entity refuses the file in place of mixing them up:
//
//   ENTY  32 bytes an entity, 2 ... 4,096. Entities follow one another without gaps in MODL, CLIP
//         and SOCK; PALT and CNAM have 256 records for each of them, AUTH one
//      0  u32     first model in MODL
//      4  u32     number of models, at least 1; the entity's clips show no others. A frame's index
//                 counts from the file's first model
//      8  u32     first clip in CLIP
//     12  u32     number of clips
//     16  u32     first socket in SOCK; sockets have a position for each frame of the entity's
//                 clips
//     20  u32     number of sockets
//     24  u8[8]   reserved
//
// Limits, so that a small file cannot unfold into more than a machine holds: 65,536 frames (those
// of the clips, and one for each model that no clip shows) and 2^40 solid voxels in all models.
//
// A minimal reader in C: check magic and major version, find the sections MODL, NODE and PAYL in
// the table, and point at them. Voxel (x,y,z) of model m, with n = NODE + m.NodeOffset and
// p = PAYL + m.PayloadOffset:
//
//     uint32_t w = n[0];
//     for (int bit = m.MaxDepth - 1;; --bit) {
//         unsigned o = (z >> bit & 1) << 2 | (y >> bit & 1) << 1 | (x >> bit & 1);
//         if (!(w >> 31)) return w >> 30 ? (uint8_t)(p[w & 0x3FFFFFFF] >> 8 * o) : w;
//         if (!(w >> o & 1)) return 0;
//         w = n[(w >> 8 & 0x7FFFFF) + popcount(w & ((1u << o) - 1))];
//     }
// clang-format on
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
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
    bool operator==(const SvoModel&) const = default;
};

struct SvoClip {
    std::string name;
    std::vector<std::uint32_t> models;                 // one a frame, indices into SvoFile::models
    std::vector<std::uint32_t> durationsMilliseconds;  // one a frame
    bool loop = true;
    bool operator==(const SvoClip&) const = default;
};

struct SvoSocket {
    std::string name;
    // Voxels, from the minimum corner: one, or one for each frame of the clips, one clip after the
    // other.
    std::vector<glm::dvec3> positions;
    bool operator==(const SvoSocket&) const = default;
};

// One entity: a whole file, or one of a set.
struct SvoFile {
    std::vector<SvoModel> models;
    std::vector<SvoClip> clips;
    std::vector<SvoSocket> sockets;
    std::array<Rgba8, 256> palette{};
    std::array<std::string, 256> colourNames;
    std::string name;
    double voxelSizeMetres = 0.1;
    double sigma = 4.0;
    glm::dvec3 anchor{0.0};  // voxels, from the minimum corner
    Outline outline;
    bool operator==(const SvoFile&) const = default;
};

// Frames of a document baked into a file, with the authored values of the profile. One model a
// frame; equal frames are shared. The document's clips; without any, more than one frame make one
// clip "all". Where a socket lies in frames that no clip shows is not written.
[[nodiscard]] Result<SvoFile> bakeForExport(const Document& document, const GameProfile& profile);
// Only source model `model` of the document, without its placement; its anchor is its bottom
// centre.
[[nodiscard]] Result<SvoFile> bakeModelForExport(const Document& document,
                                                 const GameProfile& profile, int model);

// The same bytes for the same file, always. Fails where readSvo() would.
[[nodiscard]] Result<Bytes> writeSvo(const SvoFile& file);
// Entities in one file, in their order: 1 ... 4,096. Of one it is writeSvo().
[[nodiscard]] Result<Bytes> writeSvoSet(std::span<const SvoFile> entities);
// Checks magic, version, checksums, every index, every string, every octree; unknown later sections
// are skipped. All or nothing, with the byte offset. At least one entity.
[[nodiscard]] Result<std::vector<SvoFile>> readSvoSet(ByteView bytes);
// The file's only entity, or that of the index. Fails, naming all, where neither chooses one.
[[nodiscard]] Result<SvoFile> readSvo(ByteView bytes,
                                      std::optional<std::size_t> entity = std::nullopt);

// Reads `bytes` back and compares every voxel of every frame with the document (through flatten(),
// not through the bake). What `export` calls before it reports success.
[[nodiscard]] Status verifyExport(ByteView bytes, const Document& document);
// The same for one entity that was read from a set.
[[nodiscard]] Status verifyExport(const SvoFile& file, const Document& document);
// The same for what bakeModelForExport() made.
[[nodiscard]] Status verifyModelExport(ByteView bytes, const Document& document, int model);
[[nodiscard]] Status verifyModelExport(const SvoFile& file, const Document& document, int model);

// The octrees as a document again: one object; the frames of the clips one after another, then
// those models that no clip shows.
[[nodiscard]] Document documentFromSvo(const SvoFile& file);

}  // namespace voxprite
