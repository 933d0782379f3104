#include "core/io/obj_reader.h"

#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <sstream>

#include "core/base/srgb.h"
#include "core/io/mesh_texture.h"
#include "core/io/obj_statements.h"

namespace voxprite {
namespace {

// What tinyobjloader calls the materials: their numbers in ObjStatements.
class Numbers : public tinyobj::MaterialReader {
  public:
    explicit Numbers(std::size_t count) : count_(count) {}

    bool operator()(const std::string& /*name*/, std::vector<tinyobj::material_t>* /*materials*/,
                    std::map<std::string, int>* indices, std::string* /*warn*/,
                    std::string* /*err*/) override {
        for (std::size_t k = 0; k < count_; ++k) {
            indices->emplace(std::to_string(k), static_cast<int>(k));
        }
        return true;
    }

  private:
    std::size_t count_;
};

// The materials of all libraries by their names.
class Materials {
  public:
    // `named` is what follows a mtllib: one name with blanks, or several names.
    void read(const std::string& named, const ModelFolder& folder,
              std::vector<std::string>& warnings) {
        const std::vector<std::string> words = namesIn(named);
        Result<Bytes> whole = folder.read(withoutEscapes(named));
        if (whole) return add(*whole);
        std::vector<std::string> problems;
        for (const std::string& word : words) {
            const Result<Bytes> file = words.size() > 1 ? folder.read(word) : whole;
            if (file) add(*file);
            if (!file) problems.push_back(file.error().message);
        }
        if (problems.size() == words.size()) problems = {whole.error().message};
        for (const std::string& problem : problems) {
            warnings.push_back("materials are left out: " + problem);
        }
    }

    // None where no library has it. What follows the name may be a note.
    [[nodiscard]] const tinyobj::material_t* find(const std::string& name) const {
        for (const std::size_t end : {name.size(), name.find(" #"), name.find_first_of(" \t")}) {
            const std::string_view part = withoutBlanks(std::string_view(name).substr(0, end));
            if (const auto found = materials_.find(part); found != materials_.end()) {
                return &found->second;
            }
        }
        return nullptr;
    }

  private:
    // A backslash before a blank says that it belongs to the name.
    static std::string withoutEscapes(const std::string& text) {
        std::string plain;
        for (std::size_t k = 0; k < text.size(); ++k) {
            if (text[k] != '\\' || k + 1 == text.size() || text[k + 1] != ' ') plain += text[k];
        }
        return plain;
    }

    static std::vector<std::string> namesIn(const std::string& text) {
        std::vector<std::string> names(1);
        for (std::size_t k = 0; k < text.size(); ++k) {
            const bool blank = text[k] == ' ' || text[k] == '\t';
            if (!blank || (k > 0 && text[k - 1] == '\\')) {
                names.back() += text[k];
            } else if (!names.back().empty()) {
                names.emplace_back();
            }
        }
        for (std::string& name : names) name = withoutEscapes(name);
        return names;
    }

    void add(ByteView file) {
        std::string given(textWithoutMark(file)), text;
        std::ranges::replace(given, '\r', '\n');
        std::istringstream lines(given);
        for (std::string line; std::getline(lines, line);) {
            text += line + '\n';
            const std::string_view statement = withoutBlanks(line);
            // tinyobjloader's own would be black.
            if (statement.substr(0, statement.find_first_of(" \t")) == "newmtl") {
                text += "Kd 1 1 1\n";
            }
        }
        std::istringstream stream(text);
        std::map<std::string, int> indices;
        std::vector<tinyobj::material_t> list;
        std::string warning, error;
        tinyobj::LoadMtl(&indices, &list, &stream, &warning, &error);
        for (const auto& [name, index] : indices) {
            if (name.empty()) continue;
            materials_.emplace(withoutBlanks(name), list[static_cast<std::size_t>(index)]);
        }
    }

    std::map<std::string, tinyobj::material_t, std::less<>> materials_;
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

    Result<MeshImport> run(const ObjStatements& statements) {
        Materials libraries;
        for (const std::string& named : statements.libraries) {
            libraries.read(named, folder_, import_.warnings);
        }
        for (const std::string& name : statements.materials) {
            materials_.push_back(libraries.find(name));
        }
        warnOfUnknown(statements.materials);
        // The last is for faces without a material.
        uses_.resize(materials_.size() + 1);
        std::istringstream stream("mtllib all\n" + statements.text);
        Numbers numbers(materials_.size());
        std::vector<tinyobj::material_t> none;
        std::string warning, error;
        const bool read = tinyobj::LoadObj(&attributes_, &shapes_, &none, &warning, &error, &stream,
                                           &numbers, /*triangulate=*/true,
                                           /*default_vcols_fallback=*/true);
        if (!read) return fail(error.empty() ? "the text cannot be read" : onOneLine(error));
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

    void warnOfUnknown(const std::vector<std::string>& names) {
        constexpr int kMostNamed = 8;
        std::string list;
        int unknown = 0;
        for (std::size_t k = 0; k < names.size(); ++k) {
            if (materials_[k] != nullptr || ++unknown > kMostNamed) continue;
            list += (list.empty() ? "\"" : ", \"") + onOneLine(names[k]) + '"';
        }
        if (unknown > kMostNamed) list += " and " + std::to_string(unknown - kMostNamed) + " more";
        if (unknown > 0)
            import_.warnings.push_back("materials that no .mtl has are white: " + list);
    }

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
        // That indices are there and numbers are finite, objStatements() has seen to.
        const auto vertex = static_cast<std::size_t>(index.vertex_index);
        const double* position = &attributes_.vertices.at(3 * vertex);
        corner.position = {position[0], position[1], position[2]};
        if (up_ == MeshUpAxis::y) corner.position = {position[0], -position[2], position[1]};
        corner.colour = glm::vec4(linear(&attributes_.colors.at(3 * vertex)), 1.0f);
        if (index.texcoord_index == -1) return corner;
        const auto point = static_cast<std::size_t>(index.texcoord_index);
        const glm::dvec2 uv =
            glm::dvec2(attributes_.texcoords.at(2 * point), attributes_.texcoords[2 * point + 1]) *
                use.scale +
            use.offset;
        constexpr double kMost = 1e30;
        if (!(std::abs(uv.x) <= kMost && std::abs(uv.y) <= kMost)) {
            return fail("texture point " + std::to_string(point + 1) + " is not a number");
        }
        corner.uv = glm::vec2(uv.x, 1.0 - uv.y);
        return corner;
    }

    // Reads the material when a triangle first uses it.
    const Use& useOf(int material) {
        const std::size_t at =
            material >= 0 ? static_cast<std::size_t>(material) : materials_.size();
        Use& use = uses_[at];
        if (use.read) return use;
        use.read = true;
        use.index = static_cast<std::uint32_t>(import_.mesh.materials.size());
        MeshMaterial made;
        if (material >= 0 && materials_[at] != nullptr) {
            const tinyobj::material_t& from = *materials_[at];
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
    std::vector<const tinyobj::material_t*> materials_;  // of ObjStatements; null is unknown
    std::vector<Use> uses_;
    std::map<std::string, int> textures_;
    std::uint64_t pixels_ = 0;
};

}  // namespace

Result<MeshImport> readObj(ByteView file, const ModelFolder& folder, MeshUpAxis up) {
    const Result<ObjStatements> statements = objStatements(file);
    if (!statements) return Failure(statements.error());
    try {
        return ObjReader(folder, up).run(*statements);
    } catch (const std::exception& problem) {
        return fail(std::string("the text cannot be read: ") + problem.what());
    }
}

}  // namespace voxprite
