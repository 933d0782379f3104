#include "core/io/gltf_materials.h"

#include <algorithm>
#include <cmath>

#include "core/io/gltf_numbers.h"
#include "core/io/gltf_reader.h"
#include "core/io/mesh_texture.h"

namespace voxprite {
namespace {

// Below this a blended surface is as good as not there.
constexpr double kInvisible = 0.02;

const JsonValue& elementOf(const std::vector<JsonValue>& list, const JsonValue& reference,
                           const char* what) {
    if (list.empty()) reference.fail(std::string("the file has no ") + what);
    return list[static_cast<std::size_t>(reference.integer(0, static_cast<int>(list.size()) - 1))];
}

TextureWrap wrapOf(JsonObject& sampler, const char* key) {
    int wrap = 0;
    sampler.read(key, wrap);
    return wrap == gltf::kClamp    ? TextureWrap::clamp
           : wrap == gltf::kMirror ? TextureWrap::mirror
                                   : TextureWrap::repeat;
}

glm::dvec2 pairOf(JsonObject& json, const char* key, const glm::dvec2& otherwise) {
    const auto value = json.find(key);
    if (!value) return otherwise;
    const std::vector<JsonValue> numbers = value->list(2);
    return {numbers[0].number(), numbers[1].number()};
}

}  // namespace

glm::vec2 GltfMaterialUse::transformed(glm::dvec2 uv) const {
    const glm::dvec2 scaled = uv * scale;
    const double cosine = std::cos(rotation), sine = std::sin(rotation);
    return glm::vec2(offset + glm::dvec2(cosine * scaled.x + sine * scaled.y,
                                         cosine * scaled.y - sine * scaled.x));
}

GltfMaterials::GltfMaterials(JsonObject& root, GltfBuffers& buffers, const ModelFolder& folder,
                             MeshImport& import)
    : buffers_(buffers), folder_(folder), import_(import) {
    const auto listOf = [&](const char* key) {
        const std::optional<JsonValue> found = root.find(key);
        return found ? found->list() : std::vector<JsonValue>{};
    };
    materialJson_ = listOf("materials");
    textureJson_ = listOf("textures");
    imageJson_ = listOf("images");
    samplerJson_ = listOf("samplers");
}

std::uint32_t GltfMaterials::indexOf(const std::optional<JsonValue>& reference) {
    const int index =
        reference ? reference->integer(0, static_cast<int>(materialJson_.size()) - 1) : -1;
    if (const auto found = materials_.find(index); found != materials_.end()) return found->second;
    MeshMaterial material;
    GltfMaterialUse use;
    if (reference) {
        JsonObject json(materialJson_[static_cast<std::size_t>(index)]);
        read(json, material, use);
    }
    const auto at = static_cast<std::uint32_t>(import_.mesh.materials.size());
    import_.mesh.materials.push_back(material);
    uses_.push_back(use);
    materials_.emplace(index, at);
    return at;
}

void GltfMaterials::read(JsonObject& json, MeshMaterial& material, GltfMaterialUse& use) {
    auto look = json.find("pbrMetallicRoughness");
    const char *factorKey = "baseColorFactor", *textureKey = "baseColorTexture";
    // The older way; what stands beside it is for those who do not know it.
    if (const auto extensions = json.find("extensions")) {
        JsonObject named(*extensions);
        if (const auto older = named.find("KHR_materials_pbrSpecularGlossiness")) {
            look = older;
            factorKey = "diffuseFactor";
            textureKey = "diffuseTexture";
        }
    }
    if (look) {
        JsonObject fields(*look);
        if (const auto factor = fields.find(factorKey)) {
            const std::vector<JsonValue> numbers = factor->list(4);
            for (int k = 0; k < 4; ++k) {
                material.colour[k] =
                    std::clamp(numbers[static_cast<std::size_t>(k)].number(), 0.0, 1.0);
            }
        }
        if (const auto texture = fields.find(textureKey)) readTexture(*texture, material, use);
    }
    std::string alpha = "OPAQUE";
    json.read("alphaMode", alpha);
    if (alpha == "MASK") {
        material.leastAlpha = 0.5;
        json.read("alphaCutoff", material.leastAlpha);
    }
    if (alpha == "BLEND") material.leastAlpha = kInvisible;
}

void GltfMaterials::readTexture(const JsonValue& info, MeshMaterial& material,
                                GltfMaterialUse& use) {
    JsonObject fields(info);
    JsonObject texture(elementOf(textureJson_, fields.need("index"), "textures"));
    fields.read("texCoord", use.texCoord);
    if (const auto extensions = fields.find("extensions")) {
        JsonObject named(*extensions);
        if (const auto transform = named.find("KHR_texture_transform")) {
            JsonObject values(*transform);
            use.offset = pairOf(values, "offset", use.offset);
            use.scale = pairOf(values, "scale", use.scale);
            values.read("rotation", use.rotation);
            values.read("texCoord", use.texCoord);
        }
    }
    if (const auto sampler = texture.find("sampler")) {
        JsonObject values(elementOf(samplerJson_, *sampler, "samplers"));
        material.wrapU = wrapOf(values, "wrapS");
        material.wrapV = wrapOf(values, "wrapT");
    }
    // None where an extension brings a picture of another kind.
    const auto source = texture.find("source");
    if (source) material.texture = imageOf(*source);
    if (!source) import_.warnings.push_back(info.place() + ": the texture has no PNG or JPEG");
}

int GltfMaterials::imageOf(const JsonValue& reference) {
    const JsonValue& place = elementOf(imageJson_, reference, "images");
    const int index = reference.integer();
    if (const auto found = images_.find(index); found != images_.end()) return found->second;
    JsonObject json(place);
    const auto image = [&]() -> Result<Image> {
        if (const auto uri = json.find("uri")) {
            const Result<Bytes> bytes = bytesOfUri(uri->text(), folder_);
            if (!bytes) return Failure(bytes.error());
            return voxprite::readTexture(*bytes, kMaxTexturePixels - pixels_);
        }
        return voxprite::readTexture(buffers_.view(json.need("bufferView")),
                                     kMaxTexturePixels - pixels_);
    }();
    int at = -1;
    if (image) {
        at = static_cast<int>(import_.mesh.textures.size());
        pixels_ += image->pixels.size();
        import_.mesh.textures.push_back(*image);
    } else {
        import_.warnings.push_back(place.place() + " is left out: " + image.error().message);
    }
    images_.emplace(index, at);
    return at;
}

}  // namespace voxprite
