// The other files that a model file names: buffers, materials, textures. Only regular files beside
// it or below its folder are opened, links followed; anything else is refused.
#pragma once

#include <filesystem>
#include <string>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace voxprite {

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
