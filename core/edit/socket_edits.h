// Edits of the entity's sockets as actions: pure functions of a document. `socket` is an index into
// Document::sockets, positions are in entity space.
#pragma once

#include <string>

#include "core/edit/history.h"

namespace voxprite {

// The last one; its name, "Socket" or "Socket 2", is one that no other has.
[[nodiscard]] Action addSocket(const Document& document, glm::dvec3 positionVoxels);
[[nodiscard]] Action renameSocket(const Document& document, int socket, std::string name);
// To `positionVoxels` in `frame`: in this frame alone, or by the same step in all.
enum class SocketReach : std::uint8_t { allFrames, thisFrame };
[[nodiscard]] Action moveSocket(const Document& document, int socket, int frame,
                                glm::dvec3 positionVoxels, SocketReach reach,
                                std::uint64_t mergeKey);
[[nodiscard]] Action deleteSocket(const Document& document, int socket);

}  // namespace voxprite
