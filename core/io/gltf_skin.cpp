#include "core/io/gltf_skin.h"

#include <cmath>

namespace voxprite {

GltfSkins::GltfSkins(JsonObject& root, GltfBuffers& buffers) : buffers_(buffers) {
    if (const auto skins = root.find("skins")) skinJson_ = skins->list();
}

const GltfSkins::Matrices* GltfSkins::jointsOf(
    const JsonValue& reference, const std::vector<std::optional<glm::dmat4>>& worldFromNode) {
    if (skinJson_.empty()) reference.fail("the file has no skins");
    const int index = reference.integer(0, static_cast<int>(skinJson_.size()) - 1);
    const auto [found, fresh] = skins_.try_emplace(index);
    std::optional<Matrices>& matrices = found->second;
    if (!fresh) return matrices ? &*matrices : nullptr;
    const JsonValue& place = skinJson_[static_cast<std::size_t>(index)];
    JsonObject json(place);
    const std::vector<JsonValue> joints = json.need("joints").list();
    std::optional<GltfAccessor> inverse;
    if (const auto bind = json.find("inverseBindMatrices")) {
        inverse = buffers_.accessor(*bind);
        if (inverse->components() != 16) bind->fail("matrices have 16 components");
        if (inverse->count() < joints.size())
            bind->fail("has fewer matrices than there are joints");
    }
    Matrices made;
    for (std::size_t k = 0; k < joints.size(); ++k) {
        const int last = static_cast<int>(worldFromNode.size()) - 1;
        const auto node = static_cast<std::size_t>(joints[k].integer(0, last));
        if (!worldFromNode[node]) return nullptr;
        glm::dmat4 jointFromVertex(1.0);
        for (int n = 0; inverse && n < 16; ++n)
            jointFromVertex[n / 4][n % 4] = inverse->number(k, n);
        made.push_back(*worldFromNode[node] * jointFromVertex);
    }
    matrices = std::move(made);
    return &*matrices;
}

glm::dmat4 GltfWeights::worldFromVertex(std::size_t vertex) const {
    glm::dmat4 sum(0.0);
    double total = 0.0;
    for (const Set& set : sets_) {
        for (int k = 0; k < 4; ++k) {
            const double weight = set.weights.number(vertex, k);
            if (weight == 0.0) continue;
            const double joint = set.joints.number(vertex, k);
            if (!(joint >= 0.0 && joint < static_cast<double>(joints_->size()))) {
                set.place.fail("a joint is beyond the " + std::to_string(joints_->size()) +
                               " of the skin");
            }
            sum += weight * (*joints_)[static_cast<std::size_t>(joint)];
            total += weight;
        }
    }
    // Weights are meant to add up to 1; a vertex without any hangs on the first joint.
    return total == 0.0 ? joints_->front() : sum / total;
}

}  // namespace voxprite
