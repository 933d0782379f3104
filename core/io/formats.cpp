#include "core/io/formats.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "core/base/check.h"
#include "core/base/ending.h"
#include "core/base/file.h"
#include "core/io/neighbours.h"

namespace voxprite {
namespace {

std::vector<std::string> endingsWhere(bool (FormatInfo::*has)() const) {
    std::vector<std::string> endings;
    for (const FormatInfo& info : formats()) {
        if ((info.*has)()) endings.emplace_back(info.ending);
    }
    return endings;
}

std::string allEndings() {
    std::string all;
    for (const FormatInfo& info : formats())
        all += (all.empty() ? "" : ", ") + std::string(info.ending);
    return all;
}

Result<std::vector<NamedBytes>> filesOf(const FormatInfo& info, const SaveRequest& request) {
    if (info.saveFiles != nullptr) return info.saveFiles(request);
    if (info.save == nullptr) {
        return fail(std::string(info.ending) +
                    " is read but not written (written: " + listed(writtenEndings()) + ")");
    }
    Result<Bytes> bytes = info.save(request);
    if (!bytes) return Failure(bytes.error());
    std::vector<NamedBytes> files(1);
    files[0] = {request.name.string(), std::move(*bytes)};
    return files;
}

Result<LoadedDocument> loadFolder(const std::filesystem::path& path, const ReadOptions& options) {
    const auto info = std::ranges::find_if(formats(), &FormatInfo::folders);
    if (info == formats().end()) return failInFile(path.string(), "is a folder, not a file");
    Result<LoadedDocument> loaded = inFile(info->load({path, {}, options}), path.string());
    if (loaded) loaded->format = info->format;
    return loaded;
}

// Nobody asked for what lies beside a file to be replaced, unless that file refers to it.
Status keepNeighbours(const FormatInfo& info, const std::filesystem::path& path,
                      const std::vector<NamedBytes>& files) {
    for (const NamedBytes& file : files) {
        if (&file == &files.back()) continue;
        const auto isOurs = [&] {
            std::error_code unknown;
            if (!std::filesystem::exists(path, unknown)) return false;
            if (info.refersTo == nullptr) return true;
            const std::vector<std::filesystem::path> named = info.refersTo(path);
            return std::ranges::find(named, std::filesystem::path(file.name)) != named.end();
        };
        if (Status may =
                mayReplaceNeighbour(path.parent_path() / file.name, file.bytes, path, isOurs);
            !may) {
            return may;
        }
    }
    return {};
}

}  // namespace

const FormatInfo& infoOf(Format format) {
    const auto found = std::ranges::find(formats(), format, &FormatInfo::format);
    VOXPRITE_CHECK(found != formats().end());
    return *found;
}

const char* nameOf(Format format) {
    return infoOf(format).name;
}

Result<Format> formatOf(const std::filesystem::path& path) {
    const std::string ending = lowerEndingOf(path);
    for (const FormatInfo& info : formats()) {
        if (ending == info.ending) return info.format;
    }
    return failInFile(path.string(),
                      ending.empty()
                          ? "the file's name has no ending (" + allEndings() + ")"
                          : "unknown file ending " + ending + " (known: " + allEndings() + ")");
}

Result<Format> formatNamed(const std::string& name) {
    for (const FormatInfo& info : formats()) {
        if (name == info.name) return info.format;
    }
    return fail("unknown format \"" + name + "\" (known: " + allEndings() + ", without the dot)");
}

std::vector<std::string> modelEndings() {
    return endingsWhere(&FormatInfo::reads);
}

std::vector<std::string> writtenEndings() {
    return endingsWhere(&FormatInfo::writes);
}

std::string listed(const std::vector<std::string>& endings) {
    std::string list;
    for (std::size_t k = 0; k < endings.size(); ++k) {
        if (k > 0) list += k + 1 == endings.size() ? " or " : ", ";
        list += endings[k];
    }
    return list;
}

Result<LoadedDocument> loadDocument(const std::filesystem::path& path, const ReadOptions& options) {
    std::error_code unknown;
    const bool isFolder = std::filesystem::is_directory(path, unknown);
    const Result<Format> format = formatOf(path);
    if (!format && !isFolder) return Failure(format.error());
    if (options.entity && (isFolder || *format != Format::svo)) {
        return failInFile(path.string(), "there is no entity " + std::to_string(*options.entity) +
                                             " to choose: only .svo files hold several");
    }
    if (isFolder) return loadFolder(path, options);
    const FormatInfo& info = infoOf(*format);
    if (!info.reads()) {
        return failInFile(path.string(),
                          std::string(info.ending) +
                              " is written but not read (read: " + listed(modelEndings()) + ")");
    }
    const Result<Bytes> bytes = readFile(path);
    if (!bytes) return inFile(Result<LoadedDocument>(Failure(bytes.error())), path.string());
    Result<LoadedDocument> loaded = inFile(info.load({path, *bytes, options}), path.string());
    if (loaded) loaded->format = *format;
    return loaded;
}

std::vector<std::filesystem::path> filesReadFor(const std::filesystem::path& path) {
    std::vector<std::filesystem::path> files{path};
    const Result<Format> format = formatOf(path);
    std::error_code unknown;
    if (std::filesystem::is_directory(path, unknown) || (format && *format == Format::png)) {
        const Result<SliceFiles> layers = sliceFilesOf(path);
        if (layers) files.insert(files.end(), layers->files.begin(), layers->files.end());
    } else if (format && infoOf(*format).refersTo != nullptr) {
        for (const std::filesystem::path& file : infoOf(*format).refersTo(path)) {
            files.push_back(path.parent_path() / file);
        }
    }
    return files;
}

std::vector<std::string> lossesOf(const Document& document, Format format) {
    const FormatInfo& info = infoOf(format);
    std::vector<std::string> losses = lossesBy(info.holds, document, info.ending);
    if (info.losses != nullptr) {
        for (std::string& loss : info.losses(document)) losses.push_back(std::move(loss));
    }
    return losses;
}

std::vector<std::filesystem::path> replacedBySaving(const std::filesystem::path& path,
                                                    const Document& document) {
    std::vector<std::string> names{path.filename().string()};
    const Result<Format> format = formatOf(path);
    if (format && infoOf(*format).names != nullptr) {
        names = infoOf(*format).names(path.filename(), document);
    }
    std::vector<std::filesystem::path> replaced;
    for (const std::string& name : names) {
        std::error_code unknown;
        const std::filesystem::path file = path.parent_path() / name;
        if (std::filesystem::exists(file, unknown)) replaced.push_back(file);
    }
    return replaced;
}

Status saveDocument(const std::filesystem::path& path, const Document& document,
                    const GameProfile& profile, std::stop_token stop, const WriteOptions& options) {
    const Result<Format> format = formatOf(path);
    if (!format) return Failure(format.error());
    const SaveRequest request{document,        profile, options,
                              path.filename(), stop,    path.parent_path()};
    const Result<std::vector<NamedBytes>> files = filesOf(infoOf(*format), request);
    if (stop.stop_requested()) return failInFile(path.string(), "cancelled, nothing written");
    if (!files) return inFile(Status(Failure(files.error())), path.string());
    if (!options.replaceNeighbours) {
        if (Status s = keepNeighbours(infoOf(*format), path, *files); !s) return s;
    }
    for (const NamedBytes& file : *files) {
        const std::filesystem::path target = path.parent_path() / file.name;
        if (Status s = inFile(writeFileAtomically(target, ByteView(file.bytes)), target.string());
            !s) {
            return s;
        }
    }
    return {};
}

}  // namespace voxprite
