// The other files that a model file names: buffers, materials, textures. Only regular files beside
// it or below its folder are opened, links followed; anything else is refused.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace voxprite {

// What a name in a model means, relative to the model's folder; slashes of either kind. None where
// that would lie outside.
[[nodiscard]] std::optional<std::filesystem::path> pathInFolder(std::string name);

class ModelFolder {
  public:
    ModelFolder() = default;  // of a model that is no file: has no neighbours
    explicit ModelFolder(const std::filesystem::path& modelFile);

    // `name` as the model has it, slashes of either kind. Errors name it and say why.
    [[nodiscard]] Result<Bytes> read(const std::string& name) const;

  private:
    bool exists_ = false;
    std::filesystem::path folder_;
};

}  // namespace voxprite
