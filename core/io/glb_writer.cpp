// The bytes of a .glb (glTF 2.0): a chunk of JSON and one of vertices, indices and the palette.
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/srgb.h"
#include "core/io/gltf_numbers.h"
#include "core/io/json_text.h"
#include "core/io/mesh_writer.h"
#include "core/io/quad_mesh.h"
#include "core/model/entity_voxels.h"

namespace voxprite {
namespace {

using Json = nlohmann::ordered_json;

// Voxel axes to those of glTF.
glm::dvec3 yUp(const glm::dvec3& v) {
    return {v.x, v.z, -v.y};
}

Json listOf(const glm::dvec3& v) {
    // Never "-0.0".
    return {v.x + 0.0, v.y + 0.0, v.z + 0.0};
}

class GlbWriter {
  public:
    explicit GlbWriter(const SaveRequest& request)
        : document_(request.document),
          metres_(request.profile.voxelSizeMetres),
          vertexColours_(request.options.mesh.vertexColours),
          meshes_(document_.models.size(), kNoMesh) {}

    Result<Bytes> run() {
        json_["asset"] = {{"version", "2.0"}, {"generator", "voxprite"}};
        json_["scene"] = 0;
        json_["scenes"] = Json::array({{{"nodes", {0}}}});
        if (Status s = addNodes(); !s) return Failure(s.error());
        if (!json_["meshes"].empty()) {
            if (Status s = addMaterial(); !s) return Failure(s.error());
        } else {
            json_.erase("meshes");
        }
        return container();
    }

  private:
    static constexpr int kNoMesh = -1;

    // Node 0 puts the anchor at the origin; below it the scene graph, without what is hidden.
    Status addNodes() {
        json_["nodes"] = Json::array();
        json_["meshes"] = Json::array();
        const std::string& name = document_.entity.name;
        Json root{{"name", jsonTextFromBytes(name.empty() ? "voxprite" : name)}};
        const glm::dvec3 origin = yUp(-originOf(document_)) * metres_;
        if (origin != glm::dvec3(0.0)) root["translation"] = listOf(origin);
        json_["nodes"].push_back(std::move(root));
        struct Visit {
            int node = 0;
            std::size_t parent = 0;
        };
        std::vector<Visit> waiting{{0, 0}};
        while (!waiting.empty()) {
            const Visit visit = waiting.back();
            waiting.pop_back();
            const SceneNode& node = document_.nodes[static_cast<std::size_t>(visit.node)];
            if (node.hidden || isOnHiddenLayer(node)) continue;
            Json json;
            json["name"] =
                jsonTextFromBytes(node.name.empty() && visit.node == 0 ? "scene" : node.name);
            place(placementAt(node, 0), json);
            if (!node.isGroup()) {
                const Result<int> mesh = meshOf(modelAt(node, 0));
                if (!mesh) return Failure(mesh.error());
                if (*mesh != kNoMesh) json["mesh"] = *mesh;
            }
            const std::size_t at = json_["nodes"].size();
            json_["nodes"].push_back(std::move(json));
            json_["nodes"][visit.parent]["children"].push_back(at);
            for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
                waiting.push_back({*child, at});
            }
        }
        return {};
    }

    [[nodiscard]] bool isOnHiddenLayer(const SceneNode& node) const {
        return node.layer >= 0 && document_.layers[static_cast<std::size_t>(node.layer)].hidden;
    }

    // Turns are written as a matrix, whose entries are exact.
    void place(const Placement& placement, Json& node) const {
        const glm::dvec3 translation = yUp(glm::dvec3(placement.translation)) * metres_;
        if (placement.rotation == SignedPermutation{}) {
            if (translation != glm::dvec3(0.0)) node["translation"] = listOf(translation);
            return;
        }
        Json matrix = Json::array();
        // Our axes of glTF's x, y and z, turned.
        for (const glm::ivec3 axis :
             {glm::ivec3(1, 0, 0), glm::ivec3(0, 0, 1), glm::ivec3(0, -1, 0)}) {
            const glm::dvec3 column = yUp(glm::dvec3(placement.rotation.apply(axis)));
            for (int k = 0; k < 3; ++k) matrix.push_back(static_cast<int>(column[k]));
            matrix.push_back(0);
        }
        for (int k = 0; k < 3; ++k) matrix.push_back(translation[k] + 0.0);
        matrix.push_back(1);
        node["matrix"] = std::move(matrix);
    }

    Result<int> meshOf(int model) {
        int& mesh = meshes_[static_cast<std::size_t>(model)];
        if (mesh != kNoMesh) return mesh;
        const Result<QuadMesh> quads =
            quadMeshOf(document_.models[static_cast<std::size_t>(model)].voxels);
        if (!quads) return Failure(quads.error());
        if (quads->vertices.empty()) return kNoMesh;
        Json attributes;
        attributes["POSITION"] = addPositions(quads->vertices);
        attributes["NORMAL"] =
            addVertices(quads->vertices, "VEC3", gltf::kFloat, [this](const QuadVertex& vertex) {
                const glm::dvec3 normal = yUp(glm::dvec3(normalOf(vertex.face)));
                for (int k = 0; k < 3; ++k) f32(static_cast<float>(normal[k] + 0.0));
            });
        if (vertexColours_) {
            attributes["COLOR_0"] = addVertices(
                quads->vertices, "VEC4", gltf::kUShort, [this](const QuadVertex& vertex) {
                    const Rgba8 colour = document_.palette.colours[vertex.material];
                    for (int k = 0; k < 3; ++k) {
                        bytes_.u16(static_cast<std::uint16_t>(
                            std::lround(linearFromSrgb(colour[k]) * 65535.0)));
                    }
                    bytes_.u16(65535);
                });
            json_["accessors"].back()["normalized"] = true;
        } else {
            attributes["TEXCOORD_0"] = addVertices(quads->vertices, "VEC2", gltf::kFloat,
                                                   [this](const QuadVertex& vertex) {
                                                       f32(paletteU(vertex.material));
                                                       f32(0.5f);
                                                   });
        }
        Json primitive{{"attributes", std::move(attributes)}};
        primitive["indices"] = addIndices(*quads);
        primitive["material"] = 0;
        mesh = static_cast<int>(json_["meshes"].size());
        json_["meshes"].push_back({{"name", "model " + std::to_string(model)},
                                   {"primitives", Json::array({std::move(primitive)})}});
        return mesh;
    }

    void f32(float value) { bytes_.u32(std::bit_cast<std::uint32_t>(value)); }

    [[nodiscard]] glm::vec3 positionOf(const QuadVertex& vertex) const {
        return glm::vec3(yUp(glm::dvec3(vertex.x, vertex.y, vertex.z)) * metres_ + 0.0);
    }

    int addPositions(const std::vector<QuadVertex>& vertices) {
        constexpr float kFar = std::numeric_limits<float>::infinity();
        glm::vec3 low(kFar), high(-kFar);
        const int accessor =
            addVertices(vertices, "VEC3", gltf::kFloat, [&](const QuadVertex& vertex) {
                const glm::vec3 position = positionOf(vertex);
                for (int k = 0; k < 3; ++k) f32(position[k]);
                low = glm::min(low, position);
                high = glm::max(high, position);
            });
        // As floats, so that a reader that compares finds them equal.
        json_["accessors"].back()["min"] = listOf(glm::dvec3(low));
        json_["accessors"].back()["max"] = listOf(glm::dvec3(high));
        return accessor;
    }

    template <class Write>
    int addVertices(const std::vector<QuadVertex>& vertices, const char* type, int component,
                    const Write& write) {
        const std::size_t first = bytes_.size();
        for (const QuadVertex& vertex : vertices) write(vertex);
        return addAccessor(first, gltf::kVertices, vertices.size(), type, component);
    }

    int addIndices(const QuadMesh& mesh) {
        const bool narrow = mesh.vertices.size() < 65535;
        const std::size_t first = bytes_.size();
        for (const std::uint32_t index : mesh.indices) {
            if (narrow) bytes_.u16(static_cast<std::uint16_t>(index));
            if (!narrow) bytes_.u32(index);
        }
        return addAccessor(first, gltf::kIndices, mesh.indices.size(), "SCALAR",
                           narrow ? gltf::kUShort : gltf::kUInt);
    }

    std::size_t addView(std::size_t first) {
        json_["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", first}, {"byteLength", bytes_.size() - first}});
        bytes_.alignTo(4);
        return json_["bufferViews"].size() - 1;
    }

    int addAccessor(std::size_t first, int target, std::size_t count, const char* type,
                    int component) {
        const std::size_t view = addView(first);
        json_["bufferViews"].back()["target"] = target;
        json_["accessors"].push_back(
            {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
        return static_cast<int>(json_["accessors"].size()) - 1;
    }

    Status addMaterial() {
        Json material{{"name", "palette"},
                      {"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 1}}}};
        if (!vertexColours_) {
            material["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
            const Result<Bytes> png = paletteTexture(document_.palette);
            if (!png) return Failure(png.error());
            const std::size_t first = bytes_.size();
            bytes_.raw(ByteView(*png));
            json_["images"] = Json::array(
                {{{"name", "palette"}, {"mimeType", "image/png"}, {"bufferView", addView(first)}}});
            json_["samplers"] = Json::array({{{"magFilter", gltf::kNearest},
                                              {"minFilter", gltf::kNearest},
                                              {"wrapS", gltf::kClamp},
                                              {"wrapT", gltf::kClamp}}});
            json_["textures"] = Json::array({{{"sampler", 0}, {"source", 0}}});
        }
        json_["materials"] = Json::array({std::move(material)});
        return {};
    }

    Result<Bytes> container() {
        if (bytes_.size() > 0) json_["buffers"] = Json::array({{{"byteLength", bytes_.size()}}});
        std::string text = json_.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        const std::size_t total =
            12 + 8 + text.size() + (bytes_.size() > 0 ? 8 : 0) + bytes_.size();
        if (total > std::numeric_limits<std::uint32_t>::max()) {
            return fail("the mesh is larger than the 4 GiB that .glb can hold");
        }
        ByteWriter file;
        file.raw("glTF");
        file.u32(2);
        file.u32(static_cast<std::uint32_t>(total));
        file.u32(static_cast<std::uint32_t>(text.size()));
        file.raw("JSON");
        file.raw(text);
        if (bytes_.size() > 0) {
            file.u32(static_cast<std::uint32_t>(bytes_.size()));
            file.raw(std::string_view("BIN\0", 4));
            file.raw(ByteView(bytes_.bytes()));
        }
        return file.release();
    }

    const Document& document_;
    double metres_;
    bool vertexColours_;
    std::vector<int> meshes_;  // index of a model's mesh in the file
    Json json_;
    ByteWriter bytes_;
};

}  // namespace

Result<Bytes> writeGlb(const SaveRequest& request) {
    return GlbWriter(request).run();
}

}  // namespace voxprite
