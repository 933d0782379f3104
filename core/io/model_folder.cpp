#include "core/io/model_folder.h"

#include <algorithm>
#include <system_error>

#include "core/base/file.h"

namespace voxprite {

namespace fs = std::filesystem;

std::optional<fs::path> pathInFolder(std::string name) {
    std::ranges::replace(name, '\\', '/');
    const fs::path path(name);
    const bool climbs = std::find(path.begin(), path.end(), "..") != path.end();
    const bool hasDrive = name.size() > 1 && name[1] == ':';
    if (path.is_absolute() || climbs || hasDrive) return std::nullopt;
    return path.lexically_normal();
}

ModelFolder::ModelFolder(const fs::path& modelFile) : exists_(true) {
    folder_ = modelFile.has_parent_path() ? modelFile.parent_path() : fs::path(".");
}

Result<Bytes> ModelFolder::read(const std::string& name) const {
    const std::string quoted = "\"" + name + "\"";
    if (!exists_) return fail(quoted + " is not part of the file");
    if (name.empty() || name.find('\0') != std::string::npos) {
        return fail(quoted + " is no file's name");
    }
    const std::optional<fs::path> path = pathInFolder(name);
    const Failure outside = fail(quoted + " is outside of the model's folder and is not opened");
    if (!path) return outside;
    std::error_code error;
    const fs::path folder = fs::canonical(folder_, error);
    if (error) return fail(quoted + ": " + error.message());
    const fs::path file = fs::canonical(folder / *path, error);
    if (error) return fail(quoted + ": " + error.message());
    const auto [inFolder, rest] =
        std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
    if (inFolder != folder.end()) return outside;
    if (!fs::is_regular_file(file, error)) return fail(quoted + " is no regular file");
    Result<Bytes> bytes = readFile(file);
    if (!bytes) return fail(quoted + ": " + bytes.error().message);
    return bytes;
}

}  // namespace voxprite
