// A lattice view as JSON, so that another runtime can cast the very same rays.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "app/cli/command.h"
#include "core/trace/lattice.h"

namespace voxprite::cli {

// {"bits": {"position", "direction", "step"}, "C", "D", "U", "V", "first", "size"}
[[nodiscard]] Json latticeJson(const LatticeView& lattice);

// What `render --json` printed, or only its `lattice`, checked against the model.
struct LatticeFile {
    LatticeView lattice;
    std::optional<double> sigmaInForce;  // when it is the whole output
};
[[nodiscard]] Result<LatticeFile> readLatticeFile(const std::string& path, glm::ivec3 modelSize);

}  // namespace voxprite::cli
