// Wavefront .obj, and beside it .mtl and the palette as .png.
#include <algorithm>
#include <charconv>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <tuple>

#include "core/io/mesh_writer.h"
#include "core/io/model_folder.h"
#include "core/io/quad_mesh.h"
#include "core/model/entity_voxels.h"

namespace voxprite {
namespace {

void addNumber(std::string& text, float value) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof(digits), value + 0.0f).ptr;
    text += ' ';
    text.append(digits, end);
}

// One word of a line: what would end it, or the line, is replaced.
std::string word(std::string name, const std::string& otherwise) {
    for (char& c : name) {
        if (static_cast<unsigned char>(c) <= ' ' || c == '#' || c == '\\') c = '_';
    }
    return name.empty() ? otherwise : name;
}

class ObjWriter {
  public:
    ObjWriter(const SaveRequest& request, const std::string& materials)
        : document_(request.document),
          metres_(request.profile.voxelSizeMetres),
          vertexColours_(request.options.mesh.vertexColours),
          origin_(originOf(document_)) {
        text_ = "# voxprite\nmtllib " + materials + '\n';
    }

    Result<std::string> run() {
        for (std::uint8_t face = 0; face < 6; ++face) {
            const glm::ivec3 normal = normalOf(face);
            // All 48 ways of standing only permute these.
            addLine("vn", {static_cast<float>(normal.x), static_cast<float>(normal.z),
                           static_cast<float>(-normal.y)});
        }
        int number = 0;
        for (const Instance& instance : instancesOf(document_, 0)) {
            ++number;
            const SceneNode& node = document_.nodes[static_cast<std::size_t>(instance.node)];
            const Result<QuadMesh> mesh =
                quadMeshOf(document_.models[static_cast<std::size_t>(instance.model)].voxels);
            if (!mesh) return Failure(mesh.error());
            if (mesh->vertices.empty()) continue;
            text_ += "o " + word(node.name, "object_" + std::to_string(number)) + '\n';
            addObject(*mesh, instance.entityFromModel);
        }
        return std::move(text_);
    }

  private:
    void addLine(const char* kind, std::initializer_list<float> numbers) {
        text_ += kind;
        for (const float number : numbers) addNumber(text_, number);
        text_ += '\n';
    }

    void addObject(const QuadMesh& mesh, const Placement& entityFromModel) {
        const SignedPermutation& turn = entityFromModel.rotation;
        // Positions are shared by the sides that meet in them, and with vertex colours only by
        // those of one colour.
        std::map<std::tuple<float, float, float, int>, std::size_t> places;
        std::vector<std::size_t> positions;
        for (const QuadVertex& vertex : mesh.vertices) {
            const int colour = vertexColours_ ? vertex.material : 0;
            const auto [found, fresh] =
                places.try_emplace({vertex.x, vertex.y, vertex.z, colour}, positionCount_ + 1);
            if (fresh) {
                ++positionCount_;
                addPosition(vertex, entityFromModel);
            }
            positions.push_back(found->second);
        }
        if (!vertexColours_) {
            for (const QuadVertex& vertex : mesh.vertices) addTexturePoint(vertex.material);
        }
        text_ += "usemtl palette\n";
        const bool mirrored = turn.determinant() < 0;
        for (std::size_t k = 0; k < mesh.indices.size(); k += 3) {
            text_ += 'f';
            for (const std::size_t corner : {k, k + (mirrored ? 2 : 1), k + (mirrored ? 1 : 2)}) {
                const std::uint32_t index = mesh.indices[corner];
                const QuadVertex& vertex = mesh.vertices[index];
                text_ += ' ' + std::to_string(positions[index]) + '/';
                if (!vertexColours_) {
                    text_ += std::to_string(texturePoints_.at(vertex.material));
                }
                text_ += '/' + std::to_string(normalNumber(turn.apply(normalOf(vertex.face))));
            }
            text_ += '\n';
        }
    }

    void addPosition(const QuadVertex& vertex, const Placement& entityFromModel) {
        const glm::ivec3 corner(glm::vec3(vertex.x, vertex.y, vertex.z));
        const glm::ivec3 at = entityFromModel.rotation.apply(corner) + entityFromModel.translation;
        const glm::dvec3 metres = (glm::dvec3(at) - origin_) * metres_;
        text_ += 'v';
        addNumber(text_, static_cast<float>(metres.x));
        addNumber(text_, static_cast<float>(metres.z));
        addNumber(text_, static_cast<float>(-metres.y));
        if (vertexColours_) {
            const Rgba8 colour = document_.palette.colours[vertex.material];
            for (int k = 0; k < 3; ++k) {
                addNumber(text_, static_cast<float>(colour[k]) / 255.0f);
            }
        }
        text_ += '\n';
    }

    void addTexturePoint(std::uint8_t material) {
        if (!texturePoints_.try_emplace(material, texturePoints_.size() + 1).second) return;
        addLine("vt", {paletteU(material), 0.5f});
    }

    static int normalNumber(const glm::ivec3& normal) {
        for (std::uint8_t face = 0; face < 6; ++face) {
            if (normalOf(face) == normal) return face + 1;
        }
        return 1;
    }

    const Document& document_;
    double metres_;
    bool vertexColours_;
    glm::dvec3 origin_;
    std::string text_;
    std::size_t positionCount_ = 0;
    std::map<std::uint8_t, std::size_t> texturePoints_;
};

std::string stemOf(const std::filesystem::path& name) {
    return word(name.stem().string(), "model");
}

// The files that lines of a text file name after a keyword, relative to the model's folder.
std::vector<std::filesystem::path> filesAfter(const std::string& keyword,
                                              const std::filesystem::path& path) {
    std::string head(std::size_t{64} << 10, '\0');
    std::ifstream in(path, std::ios::binary);
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
    std::vector<std::filesystem::path> files;
    std::istringstream lines(head);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string first;
        words >> first >> std::ws;
        if (first != keyword) continue;
        std::string name;
        std::getline(words, name);
        while (!name.empty() && (name.back() == '\r' || name.back() == ' ')) name.pop_back();
        if (const auto file = pathInFolder(name)) files.push_back(*file);
    }
    return files;
}

Bytes bytesOf(const std::string& text) {
    return {text.begin(), text.end()};
}

}  // namespace

std::vector<std::string> objNames(const std::filesystem::path& name, const Document& document) {
    static_cast<void>(document);
    const std::string stem = stemOf(name);
    return {stem + ".png", stem + ".mtl", name.string()};
}

std::vector<std::filesystem::path> objRefersTo(const std::filesystem::path& path) {
    std::vector<std::filesystem::path> files = filesAfter("mtllib", path);
    const std::size_t libraries = files.size();
    for (std::size_t k = 0; k < libraries; ++k) {
        for (std::filesystem::path& texture : filesAfter("map_Kd", path.parent_path() / files[k])) {
            files.push_back(std::move(texture));
        }
    }
    return files;
}

Result<std::vector<NamedBytes>> writeObj(const SaveRequest& request) {
    const std::string stem = stemOf(request.name);
    std::string materials = "# voxprite\nnewmtl palette\nKd 1 1 1\n";
    std::vector<NamedBytes> files;
    if (!request.options.mesh.vertexColours) {
        Result<Bytes> png = paletteTexture(request.document.palette);
        if (!png) return Failure(png.error());
        materials += "map_Kd " + stem + ".png\n";
        files.push_back({stem + ".png", std::move(*png)});
    }
    files.push_back({stem + ".mtl", bytesOf(materials)});
    const Result<std::string> text = ObjWriter(request, stem + ".mtl").run();
    if (!text) return Failure(text.error());
    files.push_back({request.name.string(), bytesOf(*text)});
    return files;
}

}  // namespace voxprite
