#include "core/io/gltf_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <set>
#include <string_view>

#include "core/io/gltf_buffers.h"
#include "core/io/gltf_materials.h"
#include "core/io/gltf_skin.h"

namespace voxprite {
namespace {

// Modes of primitives.
constexpr int kTriangles = 4, kStrip = 5, kFan = 6;

// What changes only looks or motion, or is read. (Textures that cannot be read are left out one by
// one, with a warning.)
bool isHarmless(const std::string& extension) {
    static constexpr std::array<std::string_view, 7> kKnown{
        "KHR_texture_transform", "KHR_mesh_quantization", "KHR_xmp_json_ld",
        "KHR_animation_pointer", "KHR_texture_basisu",    "EXT_texture_webp",
        "MSFT_texture_dds"};
    return extension.starts_with("KHR_materials_") || extension.starts_with("KHR_lights_") ||
           std::ranges::find(kKnown, extension) != kKnown.end();
}

std::vector<double> numbersOf(const JsonValue& value, std::size_t count) {
    std::vector<double> numbers;
    for (const JsonValue& number : value.list(count)) numbers.push_back(number.number());
    return numbers;
}

glm::dmat4 transformOf(JsonObject& node) {
    if (const auto matrix = node.find("matrix")) {
        const std::vector<double> m = numbersOf(*matrix, 16);
        glm::dmat4 transform(1.0);
        for (int k = 0; k < 16; ++k) transform[k / 4][k % 4] = m[static_cast<std::size_t>(k)];
        return transform;
    }
    glm::dvec3 translation(0.0), scale(1.0);
    glm::dquat rotation(1.0, 0.0, 0.0, 0.0);
    node.read("translation", translation);
    node.read("scale", scale);
    if (const auto value = node.find("rotation")) {
        const std::vector<double> q = numbersOf(*value, 4);
        rotation = glm::dquat(q[3], q[0], q[1], q[2]);
        const double length = glm::length(rotation);
        if (!(length > 1e-9) || !std::isfinite(length)) value->fail("is no rotation");
        rotation /= length;
    }
    const glm::dmat3 turn = glm::mat3_cast(rotation);
    glm::dmat4 transform(1.0);
    for (int column = 0; column < 3; ++column) {
        transform[column] = glm::dvec4(turn[column] * scale[column], 0.0);
    }
    transform[3] = glm::dvec4(translation, 1.0);
    return transform;
}

class GltfReader {
  public:
    GltfReader(const JsonValue& root, std::optional<ByteView> binary, const ModelFolder& folder)
        : root_(root),
          buffers_(root_, binary, folder),
          materials_(root_, buffers_, folder, import_),
          skins_(root_, buffers_) {}

    MeshImport run() {
        checkHeader();
        if (const auto nodes = root_.find("nodes")) nodes_ = nodes->list();
        if (const auto meshes = root_.find("meshes")) meshes_ = meshes->list();
        walk();
        for (const Placed& placed : placed_) addMesh(placed);
        if (root_.find("animations")) {
            import_.warnings.emplace_back("animations are left out: the mesh is in its rest pose");
        }
        if (instanced_) {
            import_.warnings.emplace_back(
                "EXT_mesh_gpu_instancing is not read: meshes of many instances are shown once");
        }
        if (unplacedSkins_) {
            import_.warnings.emplace_back(
                "skins with joints outside of the scene are left out: their meshes stay in place");
        }
        if (skipped_ > 0) {
            import_.warnings.push_back(std::to_string(skipped_) +
                                       " primitives of points or lines are left out");
        }
        return std::move(import_);
    }

  private:
    void checkHeader() {
        JsonObject asset(root_.need("asset"));
        const JsonValue version = asset.need("version");
        if (!version.text().starts_with("2.")) version.fail("only glTF 2 is read");
        const auto required = root_.find("extensionsRequired");
        if (!required) return;
        for (const JsonValue& extension : required->list()) {
            if (isHarmless(extension.text())) continue;
            extension.fail("the file requires " + extension.text() + ", which is not read");
        }
    }

    // The nodes that the scene begins with: of the file's default scene, of its first, or all
    // that are nobody's children.
    std::vector<JsonValue> roots() {
        if (const auto scenes = root_.find("scenes")) {
            const std::vector<JsonValue> list = scenes->list();
            const auto chosen = root_.find("scene");
            const int index = chosen ? chosen->integer(0, static_cast<int>(list.size()) - 1) : 0;
            if (list.empty()) return {};
            JsonObject scene(list[static_cast<std::size_t>(index)]);
            const auto nodes = scene.find("nodes");
            return nodes ? nodes->list() : std::vector<JsonValue>{};
        }
        return {};
    }

    struct Visit {
        std::size_t node = 0;
        glm::dmat4 worldFromParent{1.0};
    };
    struct Placed {
        JsonValue mesh;
        std::optional<JsonValue> skin;
        glm::dmat4 world{1.0};
    };

    void walk() {
        std::vector<Visit> waiting;
        std::vector<bool> seen(nodes_.size());
        worldFromNode_.resize(nodes_.size());
        const auto reach = [&](const JsonValue& reference, const glm::dmat4& worldFromParent) {
            const int last = static_cast<int>(nodes_.size()) - 1;
            if (last < 0) reference.fail("the file has no nodes");
            const auto node = static_cast<std::size_t>(reference.integer(0, last));
            if (seen[node]) reference.fail("the node has several parents");
            seen[node] = true;
            waiting.push_back({node, worldFromParent});
        };
        // From our axes: x is x, y (up) becomes z, z (toward the viewer) becomes -y.
        glm::dmat4 ours(0.0);
        ours[0][0] = 1.0;
        ours[1][2] = 1.0;
        ours[2][1] = -1.0;
        ours[3][3] = 1.0;
        const auto later = [&](std::size_t from) {
            std::reverse(waiting.begin() + static_cast<std::ptrdiff_t>(from), waiting.end());
        };
        if (root_.find("scenes")) {
            for (const JsonValue& reference : roots()) reach(reference, ours);
        } else {
            for (std::size_t node : orphans()) {
                seen[node] = true;
                waiting.push_back({node, ours});
            }
        }
        later(0);
        while (!waiting.empty()) {
            const Visit visit = waiting.back();
            waiting.pop_back();
            JsonObject node(nodes_[visit.node]);
            const glm::dmat4 world = visit.worldFromParent * transformOf(node);
            worldFromNode_[visit.node] = world;
            if (const auto mesh = node.find("mesh")) {
                placed_.push_back({*mesh, node.find("skin"), world});
                if (const auto extensions = node.find("extensions")) {
                    instanced_ =
                        instanced_ || JsonObject(*extensions).find("EXT_mesh_gpu_instancing");
                }
            }
            const std::size_t from = waiting.size();
            if (const auto children = node.find("children")) {
                for (const JsonValue& child : children->list()) reach(child, world);
            }
            later(from);
        }
    }

    std::vector<std::size_t> orphans() {
        std::vector<bool> child(nodes_.size());
        for (const JsonValue& value : nodes_) {
            JsonObject node(value);
            const auto children = node.find("children");
            if (!children) continue;
            for (const JsonValue& reference : children->list()) {
                const int last = static_cast<int>(nodes_.size()) - 1;
                child[static_cast<std::size_t>(reference.integer(0, last))] = true;
            }
        }
        std::vector<std::size_t> orphans;
        for (std::size_t k = 0; k < child.size(); ++k) {
            if (!child[k]) orphans.push_back(k);
        }
        return orphans;
    }

    void addMesh(const Placed& placed) {
        const JsonValue& reference = placed.mesh;
        if (meshes_.empty()) reference.fail("the file has no meshes");
        const int last = static_cast<int>(meshes_.size()) - 1;
        JsonObject mesh(meshes_[static_cast<std::size_t>(reference.integer(0, last))]);
        const GltfSkins::Matrices* joints = nullptr;
        if (placed.skin) {
            joints = skins_.jointsOf(*placed.skin, worldFromNode_);
            unplacedSkins_ = unplacedSkins_ || joints == nullptr;
        }
        for (const JsonValue& primitive : mesh.need("primitives").list()) {
            addPrimitive(primitive, placed.world, joints);
        }
    }

    // With joints the node's own place says nothing.
    void addPrimitive(const JsonValue& place, const glm::dmat4& worldFromMesh,
                      const GltfSkins::Matrices* joints) {
        JsonObject json(place);
        int mode = kTriangles;
        json.read("mode", mode);
        if (mode != kTriangles && mode != kStrip && mode != kFan) {
            ++skipped_;
            return;
        }
        if (json.find("targets") && !targets_) {
            import_.warnings.emplace_back("morph targets are left out");
            targets_ = true;
        }
        JsonObject attributes(json.need("attributes"));
        const JsonValue positionPlace = attributes.need("POSITION");
        const GltfAccessor positions = buffers_.accessor(positionPlace);
        if (positions.components() != 3) positionPlace.fail("positions have three components");
        const std::uint32_t material = materials_.indexOf(json.find("material"));
        const GltfMaterialUse use = materials_.use(material);

        std::optional<GltfAccessor> uvs, colours;
        if (import_.mesh.materials[material].texture >= 0) {
            const std::string name = "TEXCOORD_" + std::to_string(use.texCoord);
            if (const auto found = attributes.find(name.c_str())) {
                uvs = matching(*found, positions, 2, 2);
            }
        }
        if (const auto found = attributes.find("COLOR_0")) {
            colours = matching(*found, positions, 3, 4);
        }
        std::optional<GltfWeights> weights;
        if (joints != nullptr) {
            weights.emplace(attributes, *joints, [&](const JsonValue& attribute) {
                return matching(attribute, positions, 4, 4);
            });
            if (weights->empty()) weights.reset();
        }
        std::optional<GltfAccessor> indices;
        const auto indexPlace = json.find("indices");
        if (indexPlace) {
            indices = buffers_.accessor(*indexPlace);
            if (!indices->holdsIndices()) indexPlace->fail("indices are unsigned integers");
        }

        const std::size_t count = indices ? indices->count() : positions.count();
        const std::size_t triangles = mode == kTriangles ? count / 3 : count < 3 ? 0 : count - 2;
        if (triangles > kMaxMeshTriangles - import_.mesh.triangles.size()) {
            place.fail("more than " + std::to_string(kMaxMeshTriangles) +
                       " triangles are not read");
        }
        const auto isMirrored = [](const glm::dmat4& world) {
            return glm::determinant(glm::dmat3(world)) < 0.0;
        };
        const bool meshMirrored = isMirrored(worldFromMesh);
        const auto vertexAt = [&](std::size_t k) {
            const std::size_t at = indices ? indices->index(k) : k;
            if (at >= positions.count()) {
                indexPlace->fail("index " + std::to_string(at) + " is beyond the " +
                                 std::to_string(positions.count()) + " vertices");
            }
            return at;
        };
        const auto cornerAt = [&](std::size_t k) {
            const std::size_t at = vertexAt(k);
            const glm::dmat4 world = weights ? weights->worldFromVertex(at) : worldFromMesh;
            MeshCorner corner;
            const glm::dvec4 position(positions.number(at, 0), positions.number(at, 1),
                                      positions.number(at, 2), 1.0);
            corner.position = glm::dvec3(world * position);
            if (!isFinite(corner.position)) positionPlace.fail("a position is not a number");
            if (uvs) corner.uv = use.transformed({uvs->number(at, 0), uvs->number(at, 1)});
            if (!std::isfinite(corner.uv.x) || !std::isfinite(corner.uv.y)) {
                place.fail("a texture coordinate is not a number");
            }
            if (colours) corner.colour = colourOf(*colours, at, place);
            return corner;
        };
        for (std::size_t k = 0; k < triangles; ++k) {
            std::array<std::size_t, 3> at{3 * k, 3 * k + 1, 3 * k + 2};
            if (mode == kStrip) at = {k, k + 1 + k % 2, k + 2 - k % 2};
            if (mode == kFan) at = {k + 1, k + 2, 0};
            const bool mirrored =
                weights ? isMirrored(weights->worldFromVertex(vertexAt(at[0]))) : meshMirrored;
            if (mirrored) std::swap(at[1], at[2]);
            import_.mesh.triangles.push_back(
                {{cornerAt(at[0]), cornerAt(at[1]), cornerAt(at[2])}, material});
        }
    }

    // An accessor with an element a vertex.
    GltfAccessor matching(const JsonValue& place, const GltfAccessor& positions, int least,
                          int most) {
        const GltfAccessor accessor = buffers_.accessor(place);
        if (accessor.components() < least || accessor.components() > most) {
            place.fail("has " + std::to_string(accessor.components()) + " components");
        }
        if (accessor.count() != positions.count()) {
            place.fail("has not as many elements as there are positions");
        }
        return accessor;
    }

    static bool isFinite(const glm::dvec3& v) {
        // Far beyond what may be meant, and where sums of squares still are numbers.
        constexpr double kMost = 1e30;
        return std::abs(v.x) <= kMost && std::abs(v.y) <= kMost && std::abs(v.z) <= kMost;
    }

    static glm::vec4 colourOf(const GltfAccessor& colours, std::size_t at, const JsonValue& place) {
        glm::vec4 colour(1.0f);
        for (int k = 0; k < colours.components(); ++k) {
            colour[k] = static_cast<float>(colours.number(at, k));
            if (!std::isfinite(colour[k])) place.fail("a colour is not a number");
        }
        return glm::clamp(colour, 0.0f, 1.0f);
    }

    MeshImport import_;
    JsonObject root_;
    GltfBuffers buffers_;
    GltfMaterials materials_;
    GltfSkins skins_;
    std::vector<JsonValue> nodes_, meshes_;
    std::vector<std::optional<glm::dmat4>> worldFromNode_;  // of those that the scene reaches
    std::vector<Placed> placed_;
    int skipped_ = 0;
    bool targets_ = false, instanced_ = false, unplacedSkins_ = false;
};

}  // namespace

Result<MeshImport> readGltf(ByteView file, const ModelFolder& folder) {
    const Result<GltfContainer> container = gltfContainer(file);
    if (!container) return Failure(container.error());
    const Result<nlohmann::ordered_json> json = parseJson(container->json);
    if (!json) return Failure(json.error());
    return readFields(
        [&] { return GltfReader(JsonValue(*json, ""), container->binary, folder).run(); });
}

}  // namespace voxprite
