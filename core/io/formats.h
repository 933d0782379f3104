// Every file that voxprite reads or writes as a model, by its ending: the one door for files.
//
// What there is stands in one table (core/io/format_table.cpp), a row a format; dialogs, the
// command line's help and the errors about unknown endings are made from it. A new format takes a
// value of Format, a row, and what the row points to.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/io/holds.h"
#include "core/io/mesh_options.h"
#include "core/io/slices.h"
#include "core/io/vdb.h"
#include "core/model/document.h"
#include "core/model/game_profile.h"

namespace voxprite {

enum class Format : std::uint8_t { voxprite, vox, svo, csm, qb, png, vdb, glb, gltf, obj };

struct LoadedDocument {
    Document document;
    Format format = Format::vox;
    // False where some of the file was passed over or made anew: written in its place, the document
    // would lose that.
    bool whole = true;
    // What was odd but harmless, and what a reader chose where the file left a choice; a sentence
    // each.
    std::vector<std::string> warnings{};
};

// What the caller may choose where a file leaves a choice: a member for each format that does.
struct ReadOptions {
    // Of a .svo with several entities: which one. Without it such a file is refused, and the error
    // names them.
    std::optional<std::size_t> entity;
    MeshReadOptions mesh;
    SliceReadOptions slices;
    VdbReadOptions vdb;
};
// The same for writing.
struct WriteOptions {
    MeshWriteOptions mesh;
    // Whoever asks for a file means to replace that one; what is written beside it replaces only
    // what an earlier file of its name refers to, unless this says that all of it may go.
    bool replaceNeighbours = false;
};

// What a reader gets. A format that is spread over several files finds the others by `path`, and
// never outside its folder.
struct FileSource {
    std::filesystem::path path;
    ByteView bytes;  // of the file at `path`
    const ReadOptions& options;
};

struct SaveRequest {
    const Document& document;
    const GameProfile& profile;
    const WriteOptions& options;
    std::filesystem::path name;  // of the file, without a folder; neighbours are named after it
    std::stop_token stop;
    std::filesystem::path folder{};  // where it will lie
};

// A file to be written: its name without a folder.
struct NamedBytes {
    std::string name;
    Bytes bytes;
};

struct FormatInfo {
    Format format = Format::vox;
    const char* name = "";    // "vox": what JSON and `--to` call it
    const char* ending = "";  // ".vox", in lower case
    const char* title = "";   // "MagicaVoxel": what people call it
    // Fills document and warnings. Null: the format is not read.
    Result<LoadedDocument> (*load)(const FileSource& source) = nullptr;
    // The file's bytes, a pure function of the request. Null: the format is not written.
    Result<Bytes> (*save)(const SaveRequest& request) = nullptr;
    // In place of `save` for formats of several files side by side: the last of them is the one
    // that was asked for, `request.name`, and refers to the others.
    Result<std::vector<NamedBytes>> (*saveFiles)(const SaveRequest& request) = nullptr;
    // With `saveFiles`: the names of all files that a document would be written to, the one that
    // was asked for last.
    std::vector<std::string> (*names)(const std::filesystem::path& name,
                                      const Document& document) = nullptr;
    // The other files that the one at `path`, as it lies there, refers to, relative to its folder.
    std::vector<std::filesystem::path> (*refersTo)(const std::filesystem::path& path) = nullptr;
    // A folder of such files is a document, too; then `load` gets no bytes.
    bool folders = false;
    // False of meshes, which hold surfaces: reading them makes voxels anew.
    bool keepsVoxels = true;
    // What the format has words for: the losses of a document follow from it.
    Holds holds{};
    // What else is lost of a document, one sentence each; null where that is all.
    std::vector<std::string> (*losses)(const Document& document) = nullptr;

    [[nodiscard]] bool reads() const { return load != nullptr; }
    [[nodiscard]] bool writes() const { return save != nullptr || saveFiles != nullptr; }
    [[nodiscard]] bool severalFiles() const { return saveFiles != nullptr; }
};

// The table; the native format first.
[[nodiscard]] std::span<const FormatInfo> formats();
[[nodiscard]] const FormatInfo& infoOf(Format format);
[[nodiscard]] const char* nameOf(Format format);

// By the ending, in upper or lower case.
[[nodiscard]] Result<Format> formatOf(const std::filesystem::path& path);
// By the name ("vox").
[[nodiscard]] Result<Format> formatNamed(const std::string& name);

// Of every format that is read, with the dot; the native one first.
[[nodiscard]] std::vector<std::string> modelEndings();
// Of every format that is written.
[[nodiscard]] std::vector<std::string> writtenEndings();
// ".voxprite, .vox, ... or .csm", for help and errors.
[[nodiscard]] std::string listed(const std::vector<std::string>& endings);

// Errors name the file, the place in it and the reason. Nothing is half loaded.
[[nodiscard]] Result<LoadedDocument> loadDocument(const std::filesystem::path& path,
                                                  const ReadOptions& options = {});
// All files that loading `path` reads: itself, the layers of its stack, what it refers to. Those of
// a file that cannot be read are not known.
[[nodiscard]] std::vector<std::filesystem::path> filesReadFor(const std::filesystem::path& path);
// What writing the document in this format leaves out, one sentence each; none for .voxprite.
[[nodiscard]] std::vector<std::string> lossesOf(const Document& document, Format format);
// The files that saving would replace, those beside `path` first: what a person has to agree to.
[[nodiscard]] std::vector<std::filesystem::path> replacedBySaving(const std::filesystem::path& path,
                                                                  const Document& document);
// Each file atomically, the one that refers to the others last. For .svo this is the verified
// export: the bytes are read back and compared voxel by voxel before the file appears under its
// name. Asked to stop before it writes the first it fails, having written nothing; then it goes on
// to its end.
[[nodiscard]] Status saveDocument(const std::filesystem::path& path, const Document& document,
                                  const GameProfile& profile, std::stop_token stop = {},
                                  const WriteOptions& options = {});

}  // namespace voxprite
