// The skins of a glTF file, with their joints as the nodes stand. Private to core/io: fields that
// are wrong throw JsonFieldError (json_value.h).
#pragma once

#include <glm/mat4x4.hpp>
#include <map>
#include <optional>
#include <vector>

#include "core/io/gltf_buffers.h"

namespace voxprite {

class GltfSkins {
  public:
    using Matrices = std::vector<glm::dmat4>;

    GltfSkins(JsonObject& root, GltfBuffers& buffers);

    // What each joint of the skin that `reference` names does to a vertex; null where a joint has
    // no place: `worldFromNode` is that of each node in the scene. The same in every call.
    [[nodiscard]] const Matrices* jointsOf(
        const JsonValue& reference, const std::vector<std::optional<glm::dmat4>>& worldFromNode);

  private:
    GltfBuffers& buffers_;
    std::vector<JsonValue> skinJson_;
    std::map<int, std::optional<Matrices>> skins_;
};

// Of the vertices of one primitive.
class GltfWeights {
  public:
    // `matching` gives the accessor of an attribute, checked to have four numbers a vertex.
    // `joints` outlives this.
    template <class Matching>
    GltfWeights(JsonObject& attributes, const GltfSkins::Matrices& joints, const Matching& matching)
        : joints_(&joints) {
        for (int set = 0;; ++set) {
            const std::string number = std::to_string(set);
            const auto which = attributes.find(("JOINTS_" + number).c_str());
            const auto weights = attributes.find(("WEIGHTS_" + number).c_str());
            if (!which || !weights) break;
            sets_.push_back({*which, matching(*which), matching(*weights)});
        }
    }

    [[nodiscard]] bool empty() const { return sets_.empty() || joints_->empty(); }
    // Not empty: the joints' matrices, weighted.
    [[nodiscard]] glm::dmat4 worldFromVertex(std::size_t vertex) const;

  private:
    struct Set {
        JsonValue place;
        GltfAccessor joints, weights;
    };
    const GltfSkins::Matrices* joints_;
    std::vector<Set> sets_;
};

}  // namespace voxprite
