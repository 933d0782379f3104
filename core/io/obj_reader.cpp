#include "core/io/obj_reader.h"

#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <sstream>
#include <string_view>

#include "core/base/srgb.h"
#include "core/io/mesh_texture.h"

namespace voxprite {
namespace {

constexpr int kMostCorners = 255;
constexpr std::string_view kSpace = " \t\r";

// The statements that are read, each in its line. The others are emptied, not to be parsed: among
// them are some whose counts tinyobjloader trusts. Faces of very many corners are refused, for
// which it takes time beyond measure.
Result<std::string> knownStatements(ByteView file) {
    const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
    std::string kept;
    kept.reserve(text.size() + 1);
    int number = 0;
    for (std::size_t at = 0; at < text.size(); kept += '\n') {
        ++number;
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string_view line = text.substr(at, end - at);
        at = end + 1;
        line.remove_prefix(std::min(line.find_first_not_of(kSpace), line.size()));
        const std::string_view name = line.substr(0, line.find_first_of(kSpace));
        const bool known =
            name == "v" || name == "vt" || name == "f" || name == "usemtl" || name == "mtllib";
        if (!known || line.find('\0') != std::string_view::npos) continue;
        if (name == "f") {
            int corners = 0;
            for (std::size_t k = 1; k < line.size(); ++k) {
                const bool space = kSpace.find(line[k]) != std::string_view::npos;
                corners += !space && kSpace.find(line[k - 1]) != std::string_view::npos;
            }
            if (corners > kMostCorners) {
                return failAtLine(number, 1,
                                  "a face has " + std::to_string(corners) + " corners; at most " +
                                      std::to_string(kMostCorners) + " are read");
            }
        }
        kept += line;
    }
    return kept;
}

std::string oneLine(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
    std::ranges::replace(text, '\n', ' ');
    return text;
}

// Opens .mtl files where ModelFolder allows it.
class Materials : public tinyobj::MaterialReader {
  public:
    Materials(const ModelFolder& folder, std::vector<std::string>& warnings)
        : folder_(folder), warnings_(warnings) {}

    bool operator()(const std::string& name, std::vector<tinyobj::material_t>* materials,
                    std::map<std::string, int>* indices, std::string* /*warn*/,
                    std::string* /*err*/) override {
        const Result<Bytes> bytes = folder_.read(name);
        if (!bytes) {
            warnings_.push_back("materials are left out: " + bytes.error().message);
            return true;
        }
        std::istringstream stream(std::string(bytes->begin(), bytes->end()));
        std::string warning, error;
        tinyobj::LoadMtl(indices, materials, &stream, &warning, &error);
        if (!error.empty()) warnings_.push_back(name + ": " + oneLine(error));
        return true;
    }

  private:
    const ModelFolder& folder_;
    std::vector<std::string>& warnings_;
};

glm::dvec3 linear(const double* srgb) {
    glm::dvec3 light(0.0);
    for (int k = 0; k < 3; ++k) {
        const double value = std::isfinite(srgb[k]) ? std::clamp(srgb[k], 0.0, 1.0) : 0.0;
        light[k] = linearFromSrgb(static_cast<std::uint8_t>(std::lround(value * 255.0)));
    }
    return light;
}

class ObjReader {
  public:
    ObjReader(const ModelFolder& folder, MeshUpAxis up) : folder_(folder), up_(up) {}

    Result<MeshImport> run(const std::string& text) {
        std::istringstream stream(text);
        Materials materials(folder_, import_.warnings);
        std::string warning, error;
        const bool read = tinyobj::LoadObj(&attributes_, &shapes_, &materials_, &warning, &error,
                                           &stream, &materials, /*triangulate=*/true,
                                           /*default_vcols_fallback=*/false);
        if (!read) return fail(oneLine(error.empty() ? "the text cannot be read" : error));
        // The last is for faces without a material.
        uses_.resize(materials_.size() + 1);
        for (const tinyobj::shape_t& shape : shapes_) {
            if (Status s = addShape(shape.mesh); !s) return Failure(s.error());
        }
        return std::move(import_);
    }

  private:
    struct Use {
        bool read = false;
        std::uint32_t index = 0;
        glm::dvec2 offset{0.0}, scale{1.0};
    };

    Status addShape(const tinyobj::mesh_t& mesh) {
        const std::size_t triangles = mesh.indices.size() / 3;
        if (triangles > kMaxMeshTriangles - import_.mesh.triangles.size()) {
            return fail("more than " + std::to_string(kMaxMeshTriangles) +
                        " triangles are not read");
        }
        for (std::size_t k = 0; k < triangles; ++k) {
            const int material = k < mesh.material_ids.size() ? mesh.material_ids[k] : -1;
            const Use& use = useOf(material);
            MeshTriangle triangle;
            triangle.material = use.index;
            for (std::size_t corner = 0; corner < 3; ++corner) {
                Result<MeshCorner> read = cornerAt(mesh.indices[3 * k + corner], use);
                if (!read) return Failure(read.error());
                triangle.corners[corner] = *read;
            }
            import_.mesh.triangles.push_back(triangle);
        }
        return {};
    }

    Result<MeshCorner> cornerAt(const tinyobj::index_t& index, const Use& use) const {
        MeshCorner corner;
        const auto vertex = static_cast<std::size_t>(index.vertex_index);
        if (index.vertex_index < 0 || 3 * vertex + 2 >= attributes_.vertices.size()) {
            return fail("a face uses vertex " + std::to_string(index.vertex_index + 1) +
                        "; the file has " + std::to_string(attributes_.vertices.size() / 3));
        }
        const double* position = &attributes_.vertices[3 * vertex];
        constexpr double kMost = 1e30;
        for (int k = 0; k < 3; ++k) {
            if (!(std::abs(position[k]) <= kMost)) {
                return fail("vertex " + std::to_string(vertex + 1) + " is not a number");
            }
        }
        corner.position = {position[0], position[1], position[2]};
        if (up_ == MeshUpAxis::y) corner.position = {position[0], -position[2], position[1]};
        if (3 * vertex + 2 < attributes_.colors.size()) {
            corner.colour = glm::vec4(linear(&attributes_.colors[3 * vertex]), 1.0f);
        }
        if (index.texcoord_index == -1) return corner;
        const auto point = static_cast<std::size_t>(index.texcoord_index);
        if (index.texcoord_index < 0 || 2 * point + 1 >= attributes_.texcoords.size()) {
            return fail("a face uses texture point " + std::to_string(index.texcoord_index + 1) +
                        "; the file has " + std::to_string(attributes_.texcoords.size() / 2));
        }
        const glm::dvec2 uv =
            glm::dvec2(attributes_.texcoords[2 * point], attributes_.texcoords[2 * point + 1]) *
                use.scale +
            use.offset;
        if (!(std::abs(uv.x) <= kMost && std::abs(uv.y) <= kMost)) {
            return fail("texture point " + std::to_string(point + 1) + " is not a number");
        }
        corner.uv = glm::vec2(uv.x, 1.0 - uv.y);
        return corner;
    }

    // Reads the material when a triangle first uses it.
    const Use& useOf(int material) {
        const bool known = material >= 0 && static_cast<std::size_t>(material) < materials_.size();
        const std::size_t at = known ? static_cast<std::size_t>(material) : materials_.size();
        Use& use = uses_[at];
        if (use.read) return use;
        use.read = true;
        use.index = static_cast<std::uint32_t>(import_.mesh.materials.size());
        MeshMaterial made;
        if (known) {
            const tinyobj::material_t& from = materials_[at];
            made.colour = glm::dvec4(linear(from.diffuse), 1.0);
            if (!from.diffuse_texname.empty()) addTexture(from, made, use);
        }
        import_.mesh.materials.push_back(made);
        return use;
    }

    void addTexture(const tinyobj::material_t& from, MeshMaterial& made, Use& use) {
        made.texture = textureOf(from.diffuse_texname);
        if (made.texture < 0) return;
        made.colour = glm::dvec4(1.0);
        made.leastAlpha = 0.5;
        const tinyobj::texture_option_t& options = from.diffuse_texopt;
        if (options.clamp) made.wrapU = made.wrapV = TextureWrap::clamp;
        for (int k = 0; k < 2; ++k) {
            use.offset[k] = options.origin_offset[k];
            use.scale[k] = options.scale[k];
        }
    }

    int textureOf(const std::string& name) {
        const auto [found, fresh] = textures_.try_emplace(name, -1);
        if (!fresh) return found->second;
        const Result<Image> image = folder_.read(name).and_then([&](const Bytes& bytes) {
            return inFile(readTexture(bytes, kMaxTexturePixels - pixels_), name);
        });
        if (!image) {
            import_.warnings.push_back("a texture is left out: " + image.error().describe());
            return -1;
        }
        pixels_ += image->pixels.size();
        found->second = static_cast<int>(import_.mesh.textures.size());
        import_.mesh.textures.push_back(*image);
        return found->second;
    }

    const ModelFolder& folder_;
    MeshUpAxis up_;
    MeshImport import_;
    tinyobj::attrib_t attributes_;
    std::vector<tinyobj::shape_t> shapes_;
    std::vector<tinyobj::material_t> materials_;
    std::vector<Use> uses_;
    std::map<std::string, int> textures_;
    std::uint64_t pixels_ = 0;
};

}  // namespace

Result<MeshImport> readObj(ByteView file, const ModelFolder& folder, MeshUpAxis up) {
    const Result<std::string> text = knownStatements(file);
    if (!text) return Failure(text.error());
    try {
        return ObjReader(folder, up).run(*text);
    } catch (const std::exception& problem) {
        return fail(std::string("the text cannot be read: ") + problem.what());
    }
}

}  // namespace voxprite
