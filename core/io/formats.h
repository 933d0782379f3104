// Every file that voxprite reads or writes, by its ending. The one door for files.
#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/model/document.h"
#include "core/model/game_profile.h"

namespace voxprite {

enum class Format : std::uint8_t { vox, voxprite, svo, csm };

struct LoadedDocument {
    Document document;
    Format format = Format::vox;
    std::vector<std::string> warnings;
};

[[nodiscard]] Result<Format> formatOf(const std::filesystem::path& path);
[[nodiscard]] const char* nameOf(Format format);
// Of every format, with the dot; the native one first.
[[nodiscard]] std::vector<std::string> modelEndings();
// Errors name the file, the place in it and the reason. Nothing is half loaded.
[[nodiscard]] Result<LoadedDocument> loadDocument(const std::filesystem::path& path);
// What writing the document in this format leaves out, one sentence each; none for .voxprite.
[[nodiscard]] std::vector<std::string> lossesOf(const Document& document, Format format);
// Atomic. For .svo this is the verified export: the bytes are read back and compared voxel by voxel
// before the file appears under its name. Asked to stop while it works it fails, having written
// nothing.
[[nodiscard]] Status saveDocument(const std::filesystem::path& path, const Document& document,
                                  const GameProfile& profile, std::stop_token stop = {});

}  // namespace voxprite
