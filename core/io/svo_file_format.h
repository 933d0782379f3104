// What writer and reader of .svo share: the constants of the byte diagram in svo_file.h, and the
// checks that a file must pass on its way out as well as on its way in.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/io/svo_file.h"

namespace voxprite::svo {

inline constexpr std::array<std::uint8_t, 8> kMagic{0x89, 'S', 'V', 'O', '\r', '\n', 0x1A, '\n'};
inline constexpr std::uint16_t kMajorVersion = 1;
inline constexpr std::uint16_t kMinorOfSockets = 1;
inline constexpr std::uint16_t kMinorOfSets = 2;
inline constexpr std::size_t kMaxEntities = 4096;
inline constexpr std::uint64_t kAlignment = 64;
inline constexpr std::size_t kHeaderBytes = 64;
inline constexpr std::size_t kHeaderCrcAt = 60;
inline constexpr std::uint32_t kMustKnow = 1;  // flag of a section

enum Section : std::size_t {
    MODL,
    NODE,
    PAYL,
    PALT,
    CNAM,
    CLIP,
    FRAM,
    AUTH,
    STRS,
    kRequired,  // the sections up to here
    SOCK = kRequired,
    SPOS,
    ENTY,
    kSections
};

struct SectionLayout {
    std::string_view tag;
    std::size_t recordBytes;
    std::size_t records;  // exactly so many an entity, or 0 where the number is free
};
inline constexpr std::array<SectionLayout, kSections> kLayouts{{{"MODL", 64, 0},
                                                                {"NODE", 4, 0},
                                                                {"PAYL", 8, 0},
                                                                {"PALT", 4, 256},
                                                                {"CNAM", 8, 256},
                                                                {"CLIP", 32, 0},
                                                                {"FRAM", 8, 0},
                                                                {"AUTH", 64, 1},
                                                                {"STRS", 1, 0},
                                                                {"SOCK", 16, 0},
                                                                {"SPOS", 24, 0},
                                                                {"ENTY", 32, 0}}};
inline constexpr std::size_t kSectionEntryBytes = 32;

// CRC-32 of header and section table, the checksum's own four bytes taken as 0.
[[nodiscard]] std::uint32_t headerCrc(ByteView headerAndTable);

[[nodiscard]] Status checkText(std::string_view text);
// The error's offset is the index of a node, if it is about one.
[[nodiscard]] Status checkModel(const SvoModel& model);
// The models are checked before.
[[nodiscard]] Status checkClip(const SvoClip& clip, const std::vector<SvoModel>& models);
// The models and clips are checked before.
[[nodiscard]] Status checkSocket(const SvoSocket& socket, const SvoFile& file);
// Palette and authored values.
[[nodiscard]] Status checkValues(const SvoFile& file);
// The limits on the file as a whole; everything else is checked before.
[[nodiscard]] Status checkLimits(std::span<const SvoFile> entities);

// Frames of all clips together.
[[nodiscard]] std::size_t clipFrames(const SvoFile& file);
// Indices of the models that no clip shows, ascending.
[[nodiscard]] std::vector<std::uint32_t> modelsWithoutClip(const SvoFile& file);

}  // namespace voxprite::svo
