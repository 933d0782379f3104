// Many entities in one .svo, unlike each other in size, palette, anchor, clips and sockets: made,
// and looked over before one of them is chosen.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/io/svo_file.h"
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

// The entities of a .svo that holds several; none of a file with one alone, or of any other file:
// whoever opens that is told what there is to tell. Costs such files no more than reading them.
[[nodiscard]] Result<std::vector<SvoFile>> severalEntities(const std::filesystem::path& path);
// How many entities would go with the file at `path`: as many as it says it holds, unchecked; 0
// where it is no .svo.
[[nodiscard]] std::size_t entitiesAt(const std::filesystem::path& path);

// What tells an entity from the others in a list.
struct EntityFigures {
    // Index into SvoFile::models of the one that its document shows first.
    std::size_t firstModel = 0;
    glm::ivec3 size{0};        // voxels, of all its models together
    std::uint64_t voxels = 0;  // solid ones of that first model
    std::size_t frames = 1;    // that its document has
};
[[nodiscard]] EntityFigures figuresOf(const SvoFile& entity);

}  // namespace voxprite
