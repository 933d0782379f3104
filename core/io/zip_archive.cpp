#include "core/io/zip_archive.h"

#include <zip.h>

namespace voxprite {
namespace {

// Deflate never packs more than 1032 bytes into one.
constexpr std::uint64_t kMaxDeflateRatio = 1032;

struct ZipError {
    zip_error_t value{};
    ZipError() { zip_error_init(&value); }
    ~ZipError() { zip_error_fini(&value); }
    ZipError(const ZipError&) = delete;
    ZipError& operator=(const ZipError&) = delete;
    [[nodiscard]] std::string text() { return zip_error_strerror(&value); }
};

struct FreeSource {
    void operator()(zip_source_t* source) const { zip_source_free(source); }
};
struct DiscardArchive {
    void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseEntry {
    void operator()(zip_file_t* file) const { zip_fclose(file); }
};
using Source = std::unique_ptr<zip_source_t, FreeSource>;

Failure failToWrite(const std::string& reason) {
    return fail("cannot make the ZIP: " + reason);
}

Result<Bytes> bytesOf(zip_source_t* source) {
    const auto failure = [&] { return failToWrite(zip_error_strerror(zip_source_error(source))); };
    if (zip_source_open(source) != 0) return failure();
    zip_source_seek(source, 0, SEEK_END);
    const zip_int64_t size = zip_source_tell(source);
    zip_source_seek(source, 0, SEEK_SET);
    Bytes bytes(static_cast<std::size_t>(std::max<zip_int64_t>(size, 0)));
    const bool complete = zip_source_read(source, bytes.data(), bytes.size()) == size;
    if (!complete) return failure();
    zip_source_close(source);
    return bytes;
}

}  // namespace

Result<Bytes> writeZip(const std::vector<ZipEntry>& entries) {
    ZipError error;
    const Source target(zip_source_buffer_create(nullptr, 0, 0, &error.value));
    if (!target) return failToWrite(error.text());
    std::unique_ptr<zip_t, DiscardArchive> archive(
        zip_open_from_source(target.get(), ZIP_TRUNCATE, &error.value));
    if (!archive) return failToWrite(error.text());
    zip_source_keep(target.get());  // the archive took one reference, the target keeps its own

    const auto failure = [&] { return failToWrite(zip_strerror(archive.get())); };
    for (const ZipEntry& entry : entries) {
        Source source(zip_source_buffer(archive.get(), entry.bytes.data(), entry.bytes.size(), 0));
        if (!source) return failure();
        const zip_int64_t index =
            zip_file_add(archive.get(), entry.name.c_str(), source.get(), ZIP_FL_ENC_UTF_8);
        if (index < 0) return failure();
        static_cast<void>(source.release());  // the archive owns it now
        const auto at = static_cast<zip_uint64_t>(index);
        constexpr zip_uint16_t firstDayOf1980 = (1 << 5) | 1;
        if (zip_set_file_compression(archive.get(), at, ZIP_CM_DEFLATE, 6) != 0 ||
            zip_file_set_dostime(archive.get(), at, 0, firstDayOf1980, 0) != 0) {
            return failure();
        }
    }
    if (zip_close(archive.get()) != 0) return failure();
    static_cast<void>(archive.release());
    return bytesOf(target.get());
}

void ZipReader::Close::operator()(zip* archive) const {
    zip_discard(archive);
}

Result<ZipReader> ZipReader::open(ByteView bytes) {
    if (bytes.empty()) return fail("not a ZIP archive: it is empty");
    ZipError error;
    Source source(zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error.value));
    if (!source) return fail("not a ZIP archive: " + error.text());
    zip_t* const archive =
        zip_open_from_source(source.get(), ZIP_RDONLY | ZIP_CHECKCONS, &error.value);
    if (archive == nullptr) return fail("not a sound ZIP archive: " + error.text());
    static_cast<void>(source.release());  // the archive owns it now
    return ZipReader(archive);
}

Result<Bytes> ZipReader::read(const std::string& name, std::uint64_t maxBytes) const {
    const auto failure = [&](const std::string& reason) { return fail(name + ": " + reason); };
    zip_stat_t stat;
    zip_stat_init(&stat);
    if (zip_stat(archive_.get(), name.c_str(), 0, &stat) != 0) {
        return failure("no such entry in the archive");
    }
    if (stat.encryption_method != ZIP_EM_NONE) return failure("encrypted entries are not read");
    if (stat.comp_method != ZIP_CM_DEFLATE && stat.comp_method != ZIP_CM_STORE) {
        return failure("compressed by a method other than deflate");
    }
    if (stat.size > maxBytes) {
        return failure("claims " + std::to_string(stat.size) + " bytes, the limit is " +
                       std::to_string(maxBytes));
    }
    if (stat.size > stat.comp_size * kMaxDeflateRatio) {
        return failure("claims more bytes than its compressed bytes can hold");
    }
    const std::unique_ptr<zip_file_t, CloseEntry> file(
        zip_fopen_index(archive_.get(), stat.index, 0));
    if (!file) return failure(zip_strerror(archive_.get()));
    // One byte more than claimed: reading on to the end is what makes libzip check the CRC.
    Bytes bytes(stat.size + 1);
    std::uint64_t count = 0;
    while (count < bytes.size()) {
        const zip_int64_t got = zip_fread(file.get(), bytes.data() + count, bytes.size() - count);
        if (got < 0) return failure(zip_file_strerror(file.get()));
        if (got == 0) break;
        count += static_cast<std::uint64_t>(got);
    }
    if (count != stat.size) return failure("does not have the size that it claims");
    bytes.resize(stat.size);
    return bytes;
}

}  // namespace voxprite
