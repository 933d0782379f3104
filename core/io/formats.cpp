#include "core/io/formats.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "core/base/file.h"
#include "core/io/csm_reader.h"
#include "core/io/csm_writer.h"
#include "core/io/project_file.h"
#include "core/io/svo_file.h"
#include "core/io/vox.h"

namespace voxprite {
namespace {

constexpr std::array kFormats{std::pair{Format::voxprite, "voxprite"},
                              std::pair{Format::vox, "vox"}, std::pair{Format::svo, "svo"},
                              std::pair{Format::csm, "csm"}};

std::string knownEndings() {
    std::string known;
    for (const std::string& ending : modelEndings()) known += (known.empty() ? "" : ", ") + ending;
    return known;
}

Result<LoadedDocument> readAs(Format format, ByteView bytes) {
    LoadedDocument loaded;
    loaded.format = format;
    switch (format) {
        case Format::vox: {
            Result<VoxImport> import = readVox(bytes);
            if (!import) return Failure(import.error());
            loaded.document = std::move(import->document);
            loaded.warnings = std::move(import->warnings);
            break;
        }
        case Format::voxprite: {
            Result<Document> document = readProject(bytes);
            if (!document) return Failure(document.error());
            loaded.document = std::move(*document);
            break;
        }
        case Format::svo: {
            const Result<SvoFile> file = readSvo(bytes);
            if (!file) return Failure(file.error());
            loaded.document = documentFromSvo(*file);
            break;
        }
        case Format::csm: {
            Result<Document> document = readCsm(bytes);
            if (!document) return Failure(document.error());
            loaded.document = std::move(*document);
            if (loaded.document.models[0].voxels.empty()) {
                loaded.warnings.emplace_back("the text assigns no voxel");
            }
            break;
        }
    }
    return loaded;
}

Result<Bytes> exportOf(const Document& document, const GameProfile& profile) {
    const Result<SvoFile> baked = bakeForExport(document, profile);
    if (!baked) return Failure(baked.error());
    Result<Bytes> bytes = writeSvo(*baked);
    if (!bytes) return bytes;
    if (Status same = verifyExport(*bytes, document); !same) return Failure(same.error());
    return bytes;
}

Result<Bytes> writeAs(Format format, const Document& document, const GameProfile& profile) {
    switch (format) {
        case Format::vox:
            return writeVox(document);
        case Format::voxprite:
            return writeProject(document, {profile.voxelSizeMetres, profile.sigma});
        case Format::svo:
            return exportOf(document, profile);
        case Format::csm:
            return writeCsm(document);
    }
    return fail("unknown format");
}

}  // namespace

Result<Format> formatOf(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    for (const auto& [format, name] : kFormats) {
        if (ending == std::string(".") + name) return format;
    }
    return failInFile(path.string(),
                      ending.empty()
                          ? "the file's name has no ending (" + knownEndings() + ")"
                          : "unknown file ending " + ending + " (known: " + knownEndings() + ")");
}

const char* nameOf(Format format) {
    for (const auto& [value, name] : kFormats) {
        if (value == format) return name;
    }
    return "unknown";
}

std::vector<std::string> modelEndings() {
    std::vector<std::string> endings;
    for (const auto& [format, name] : kFormats) endings.push_back(std::string(".") + name);
    return endings;
}

Result<LoadedDocument> loadDocument(const std::filesystem::path& path) {
    const Result<Format> format = formatOf(path);
    if (!format) return Failure(format.error());
    const Result<Bytes> bytes = readFile(path);
    if (!bytes) return inFile(Result<LoadedDocument>(Failure(bytes.error())), path.string());
    return inFile(readAs(*format, *bytes), path.string());
}

std::vector<std::string> lossesOf(const Document& document, Format format) {
    std::vector<std::string> losses;
    if (format == Format::voxprite) return losses;
    if (format == Format::csm) return csmLosses(document);
    const std::string where = std::string(".") + nameOf(format);
    const Palette& palette = document.palette;
    if (!palette.variants.empty()) {
        std::string names;
        for (const PaletteVariant& variant : palette.variants) {
            names += (names.empty() ? "" : ", ") + variant.name;
        }
        losses.push_back(where + " holds one palette: the variants are left out (" + names + ")");
    }
    if (!palette.ramps.empty()) {
        losses.push_back(where + " has no colour ramps: " + std::to_string(palette.ramps.size()) +
                         " left out");
    }
    if (format != Format::vox) return losses;
    const auto leftOut = [&](std::size_t count, const char* what) {
        if (count == 0) return;
        losses.push_back(where + " has no " + what + ": " + std::to_string(count) + " left out");
    };
    leftOut(document.clips.size(), "clips");
    leftOut(document.sockets.size(), "sockets");
    return losses;
}

Status saveDocument(const std::filesystem::path& path, const Document& document,
                    const GameProfile& profile, std::stop_token stop) {
    const Result<Format> format = formatOf(path);
    if (!format) return Failure(format.error());
    const Result<Bytes> bytes = writeAs(*format, document, profile);
    if (stop.stop_requested()) return failInFile(path.string(), "cancelled, nothing written");
    if (!bytes) return inFile(Status(Failure(bytes.error())), path.string());
    return inFile(writeFileAtomically(path, *bytes), path.string());
}

}  // namespace voxprite
