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

}  // namespace voxprite
