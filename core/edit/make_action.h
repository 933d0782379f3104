#pragma once

#include <string>
#include <utility>

#include "core/edit/history.h"

namespace voxprite {

// An action of one part.
template <class Part>
[[nodiscard]] Action makeAction(std::string label, Part part, std::uint64_t mergeKey = 0) {
    Action action;
    action.label = std::move(label);
    action.parts.emplace_back(std::move(part));
    action.mergeKey = mergeKey;
    return action;
}

// An action whose voxels are found when it is carried out.
[[nodiscard]] inline Action makeActionLater(std::string label, MakePatches makePatches) {
    Action action;
    action.label = std::move(label);
    action.makePatches = std::move(makePatches);
    return action;
}

}  // namespace voxprite
