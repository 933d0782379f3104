// The materials of a glTF file and their textures, read when a triangle first uses them. Private
// to core/io.
#pragma once

#include <glm/vec2.hpp>
#include <map>
#include <optional>
#include <vector>

#include "core/io/gltf_buffers.h"
#include "core/io/triangle_mesh.h"

namespace voxprite {

struct MeshImport;

// How a material looks up its texture: u' = scale and rotation applied to u, then the offset.
struct GltfMaterialUse {
    int texCoord = 0;
    glm::dvec2 offset{0.0};
    glm::dvec2 scale{1.0};
    double rotation = 0.0;  // radians

    [[nodiscard]] glm::vec2 transformed(glm::dvec2 uv) const;
};

class GltfMaterials {
  public:
    GltfMaterials(JsonObject& root, GltfBuffers& buffers, const ModelFolder& folder,
                  MeshImport& import);

    // Index into the mesh's materials of what `reference` names; none is the default material.
    [[nodiscard]] std::uint32_t indexOf(const std::optional<JsonValue>& reference);
    [[nodiscard]] const GltfMaterialUse& use(std::uint32_t index) const { return uses_[index]; }

  private:
    void read(JsonObject& json, MeshMaterial& material, GltfMaterialUse& use);
    void readTexture(const JsonValue& info, MeshMaterial& material, GltfMaterialUse& use);
    // Index into the mesh's textures, or -1 and a warning.
    [[nodiscard]] int imageOf(const JsonValue& reference);

    GltfBuffers& buffers_;
    const ModelFolder& folder_;
    MeshImport& import_;
    std::vector<JsonValue> materialJson_, textureJson_, imageJson_, samplerJson_;
    std::map<int, std::uint32_t> materials_;  // from the file's index; -1 is the default
    std::map<int, int> images_;
    std::vector<GltfMaterialUse> uses_;
    std::uint64_t pixels_ = 0;
};

}  // namespace voxprite
