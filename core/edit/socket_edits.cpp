#include "core/edit/socket_edits.h"

#include <algorithm>

#include "core/edit/free_name.h"
#include "core/edit/make_action.h"
#include "core/model/entity_voxels.h"

namespace voxprite {
namespace {

template <class Edit>
Action socketsAction(std::string label, const Document& document, Edit edit) {
    SocketsEdit part{document.sockets, document.sockets};
    edit(part.after);
    return makeAction(std::move(label), std::move(part));
}

// From `frame` on it lies at `position`; before, it lies where it did.
void setKey(Socket& socket, int frame, glm::dvec3 position) {
    auto key = std::ranges::lower_bound(socket.positions, frame, {}, &SocketKey::frame);
    if (key == socket.positions.end() || key->frame != frame) {
        key = socket.positions.insert(key, SocketKey{frame, {}});
    }
    key->positionVoxels = position;
}

}  // namespace

Action addSocket(const Document& document, glm::dvec3 positionVoxels) {
    return socketsAction("Add socket", document, [&](std::vector<Socket>& sockets) {
        Socket socket;
        socket.name = freeName("Socket", sockets);
        socket.positions[0].positionVoxels = positionVoxels;
        sockets.push_back(std::move(socket));
    });
}

Action renameSocket(const Document& document, int socket, std::string name) {
    return socketsAction("Rename socket", document, [&](std::vector<Socket>& sockets) {
        sockets[static_cast<std::size_t>(socket)].name = std::move(name);
    });
}

Action moveSocket(const Document& document, int socket, int frame, glm::dvec3 positionVoxels,
                  SocketReach reach, std::uint64_t mergeKey) {
    Action action = socketsAction("Move socket", document, [&](std::vector<Socket>& sockets) {
        Socket& moved = sockets[static_cast<std::size_t>(socket)];
        const glm::dvec3 step = positionVoxels - positionAt(moved, frame);
        if (reach == SocketReach::allFrames) {
            for (SocketKey& key : moved.positions) key.positionVoxels += step;
            return;
        }
        const Socket before = moved;
        setKey(moved, 0, positionAt(before, 0));
        if (frame + 1 < frameCount(document)) {
            setKey(moved, frame + 1, positionAt(before, frame + 1));
        }
        setKey(moved, frame, positionVoxels);
    });
    action.mergeKey = mergeKey;
    return action;
}

Action deleteSocket(const Document& document, int socket) {
    return socketsAction("Delete socket", document, [&](std::vector<Socket>& sockets) {
        sockets.erase(sockets.begin() + socket);
    });
}

}  // namespace voxprite
