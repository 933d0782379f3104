#include "core/base/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <optional>
#include <system_error>

namespace voxprite {

namespace {

class FileDescriptor {
  public:
    explicit FileDescriptor(int descriptor) : descriptor_(descriptor) {}
    ~FileDescriptor() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;

    [[nodiscard]] bool isOpen() const { return descriptor_ >= 0; }
    [[nodiscard]] int get() const { return descriptor_; }
    // Closing may report an error of a write before; 0 when all is well.
    int close() { return ::close(std::exchange(descriptor_, -1)); }

  private:
    int descriptor_;
};

Failure systemFailure(const std::filesystem::path& path, const std::string& doing) {
    const int code = errno;
    return failInFile(path.string(), doing + ": " + std::generic_category().message(code));
}

// Fills `bytes`, or as much as there is, and says how much; -1 for an error.
ssize_t readAll(int descriptor, Bytes& bytes) {
    std::size_t filled = 0;
    while (filled < bytes.size()) {
        const ssize_t got = ::read(descriptor, bytes.data() + filled, bytes.size() - filled);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return -1;
        if (got == 0) break;
        filled += static_cast<std::size_t>(got);
    }
    return static_cast<ssize_t>(filled);
}

bool writeAll(int descriptor, ByteView bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0) {
            if (errno == EINTR) continue;
            return false;
        }
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return true;
}

// Writes, makes durable and closes; the temporary file stays for the caller to rename or remove.
Status writeTemporary(const std::filesystem::path& temporary, const std::filesystem::path& path,
                      ByteView bytes) {
    FileDescriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!file.isOpen()) return systemFailure(path, "cannot be written");
    struct stat old {};
    struct stat made {};
    // A file that is there keeps its permissions; a new one has those of the process. Asked for
    // only where they differ, since network shares may refuse any change of them.
    const bool differs = ::stat(path.c_str(), &old) == 0 && ::fstat(file.get(), &made) == 0 &&
                         old.st_mode != made.st_mode;
    if (differs && ::fchmod(file.get(), old.st_mode & 07777) != 0) {
        return systemFailure(path, "cannot keep its permissions");
    }
    if (!writeAll(file.get(), bytes)) return systemFailure(path, "cannot be written");
    if (::fsync(file.get()) != 0) return systemFailure(path, "cannot be written");
    if (file.close() != 0) return systemFailure(path, "cannot be written");
    return {};
}

// A device or a pipe: it takes bytes, but must not be replaced by a file.
bool isStream(const std::filesystem::path& path) {
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) &&
           !S_ISDIR(status.st_mode);
}

Status writeToStream(FileDescriptor stream, const std::filesystem::path& path, ByteView bytes) {
    if (!stream.isOpen()) return systemFailure(path, "cannot be opened");
    if (!writeAll(stream.get(), bytes)) return systemFailure(path, "cannot be written");
    if (stream.close() != 0) return systemFailure(path, "cannot be written");
    return {};
}

std::filesystem::path folderOf(const std::filesystem::path& path) {
    return path.has_parent_path() ? path.parent_path() : ".";
}

// Where a name leads. Writing through a symbolic link replaces what it points to, there or not, and
// keeps the link. /dev/stdout and its like lead to a descriptor of this process: even if that is of
// a file, others write to it as well, and it must not be replaced.
struct Destination {
    std::filesystem::path path;
    std::optional<int> descriptor{};
};

Destination destinationOf(const std::filesystem::path& requested) {
    constexpr int kMaxLinks = 40;
    Destination to{requested};
    std::error_code error;
    if (!std::filesystem::is_symlink(requested, error)) return to;
    const std::filesystem::path descriptors = std::filesystem::canonical("/proc/self/fd", error);
    for (int k = 0; k < kMaxLinks && std::filesystem::is_symlink(to.path, error); ++k) {
        const std::filesystem::path folder = std::filesystem::canonical(folderOf(to.path), error);
        if (!error && folder == descriptors) {
            to.descriptor = std::atoi(to.path.filename().c_str());
            return to;
        }
        const std::filesystem::path target = std::filesystem::read_symlink(to.path, error);
        if (error) return {requested};
        to.path = folderOf(to.path) / target;
    }
    return to;
}

// The folder alone decides whether a file can be replaced; who made it read-only meant the file.
Status checkNotReadOnly(const std::filesystem::path& path) {
    if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0 || errno == ENOENT) return {};
    return systemFailure(path, "cannot be written");
}

}  // namespace

std::optional<FileStamp> stampOf(const std::filesystem::path& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return std::nullopt;
    return FileStamp{status.st_dev, status.st_ino, static_cast<std::uint64_t>(status.st_size),
                     std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec};
}

Result<Bytes> readFile(const std::filesystem::path& path) {
    // Not blocking, so that opening a pipe nobody writes to returns (and is refused below).
    const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (!file.isOpen()) return systemFailure(path, "cannot be opened");
    struct stat status {};
    if (::fstat(file.get(), &status) != 0) return systemFailure(path, "cannot be read");
    if (S_ISDIR(status.st_mode)) return failInFile(path.string(), "is a folder, not a file");
    if (!S_ISREG(status.st_mode)) return failInFile(path.string(), "is not a regular file");
    const auto size = static_cast<std::uint64_t>(status.st_size);
    if (size > kMaxFileBytes) {
        return failInFile(path.string(), "has " + std::to_string(size) + " bytes; at most " +
                                             std::to_string(kMaxFileBytes) + " can be read");
    }
    Bytes bytes(static_cast<std::size_t>(size));
    const ssize_t filled = readAll(file.get(), bytes);
    if (filled < 0) return systemFailure(path, "cannot be read");
    bytes.resize(static_cast<std::size_t>(filled));  // it may have become shorter meanwhile
    return bytes;
}

Result<std::string> readTextFile(const std::filesystem::path& path) {
    return readFile(path).map(
        [](const Bytes& bytes) { return std::string(bytes.begin(), bytes.end()); });
}

Status checkWritable(const std::filesystem::path& requested) {
    const auto [path, descriptor] = destinationOf(requested);
    if (descriptor || isStream(requested)) return {};
    if (Status may = checkNotReadOnly(path); !may) return may;
    std::error_code missing;
    if (std::filesystem::is_directory(path, missing)) {
        return failInFile(path.string(), "is a folder, not a file");
    }
    if (::faccessat(AT_FDCWD, folderOf(path).c_str(), W_OK | X_OK, AT_EACCESS) == 0) return {};
    return systemFailure(path, "cannot be written");
}

Status writeFileAtomically(const std::filesystem::path& requested, ByteView bytes) {
    if (isStream(requested)) {
        return writeToStream(FileDescriptor(::open(requested.c_str(), O_WRONLY | O_CLOEXEC)),
                             requested, bytes);
    }
    const auto [path, descriptor] = destinationOf(requested);
    if (descriptor) return writeToStream(FileDescriptor(::dup(*descriptor)), requested, bytes);
    if (Status may = checkNotReadOnly(path); !may) return may;
    const std::filesystem::path folder = folderOf(path);
    // Names may have 255 bytes: room for what is added.
    constexpr std::size_t kKept = 200;
    static std::atomic<unsigned> counter{0};
    const std::filesystem::path temporary =
        folder / ("." + path.filename().string().substr(0, kKept) + "." +
                  std::to_string(::getpid()) + "." + std::to_string(counter++) + ".part");

    Status written = writeTemporary(temporary, path, bytes);
    if (written && ::rename(temporary.c_str(), path.c_str()) != 0) {
        written = systemFailure(path, "cannot be replaced");
    }
    if (!written) {
        ::unlink(temporary.c_str());
        return written;
    }
    // The file has its new content; without this a power cut might bring the old name back.
    const FileDescriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (directory.isOpen()) ::fsync(directory.get());
    return {};
}

Status writeFileAtomically(const std::filesystem::path& path, const std::string& text) {
    return writeFileAtomically(
        path, ByteView(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

}  // namespace voxprite
