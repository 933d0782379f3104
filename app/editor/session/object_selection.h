// What the artist has chosen in the list of objects: nodes of the scene graph, or a socket. The
// active object, which tools edit, is the session's; of the chosen objects it is the last.
#pragma once

#include <optional>
#include <vector>

#include "app/editor/session/session.h"

namespace voxprite::editor {

class ObjectSelection {
  public:
    // Once a frame, first: drops what the document no longer has.
    void follow(const Session& session);

    // The chosen nodes; without any the active object. Empty when there is no object.
    [[nodiscard]] std::vector<int> nodes(const Session& session) const;
    // The one that what makes sense for a single node is about; -1 when there is none.
    [[nodiscard]] int node(const Session& session) const;
    [[nodiscard]] bool isChosen(const Session& session, int node) const;
    void choose(Session& session, int node);
    // Adds or takes away.
    void toggle(Session& session, int node);

    [[nodiscard]] std::optional<int> socket() const { return socket_; }
    void chooseSocket(std::optional<int> socket) { socket_ = socket; }

    // The node, or the socket, whose name is being typed in the list.
    [[nodiscard]] std::optional<int> renaming() const { return renaming_; }
    [[nodiscard]] std::optional<int> renamingSocket() const { return renamingSocket_; }
    void rename(std::optional<int> node) { renaming_ = node; }
    void renameSocket(std::optional<int> socket) { renamingSocket_ = socket; }

  private:
    void takeActive(Session& session, int node);

    std::vector<int> nodes_;  // in the order of choosing
    std::size_t nodeCount_ = 0, socketCount_ = 0;
    std::optional<int> socket_;
    std::optional<int> renaming_, renamingSocket_;
};

}  // namespace voxprite::editor
