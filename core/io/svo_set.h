// Many entities into one .svo, unlike each other in size, palette, anchor, clips and sockets.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/model/document.h"
#include "core/model/game_profile.h"

namespace voxprite {

struct SetMember {
    const Document& document;
    const GameProfile& profile;  // its values are recorded as authored
    // The document's entity, or this one of its models alone, without its placement.
    std::optional<int> model;
    std::string name;  // of the entity where the document has none
};

// The bytes of a file with an entity for each member, in their order. They are read back and every
// voxel compared before this succeeds. A name that stands before gets a number, so that games can
// find entities by name. One member is what writeSvo() makes of it.
[[nodiscard]] Result<Bytes> exportSvoSet(std::span<const SetMember> members);

// Every model of the document that has voxels, an entity each, in their order: named by the object
// that shows it, else "`name` 1", "`name` 2" ... The members refer to document and profile.
[[nodiscard]] std::vector<SetMember> modelsOneByOne(const Document& document,
                                                    const GameProfile& profile,
                                                    const std::string& name);

}  // namespace voxprite
