#include "app/cli/mesh_options.h"

#include <optional>
#include <string_view>

#include "app/cli/arguments.h"
#include "core/io/mesh_voxels.h"

namespace voxprite::cli {
namespace {

std::optional<MeshUpAxis> upAxisFrom(std::string_view text) {
    if (text == "y") return MeshUpAxis::y;
    if (text == "z") return MeshUpAxis::z;
    return std::nullopt;
}

}  // namespace

void addMeshReadOptions(CLI::App& app, ReadOptions& options) {
    MeshReadOptions& mesh = options.mesh;
    app.add_option("--resolution", mesh.resolution,
                   "Of meshes: voxels along the longest side (default 64)")
        ->check(CLI::Range(1, kMaxMeshResolution));
    addParsed(app, "--voxels-per-unit", "NUMBER",
              "Of meshes: voxels a unit of the file (glTF: a metre), in place of --resolution",
              numberFrom, [&mesh](double voxels) { mesh.voxelsPerUnit = voxels; })
        ->check(CLI::Range(1e-6, 1e6))
        ->excludes("--resolution");
    app.add_flag("--solid", mesh.solid, "Of meshes: fill the inside of the surface");
    addParsed(app, "--up", "y|z", "The axis that is up in .obj (y)", upAxisFrom,
              [&mesh](MeshUpAxis up) { mesh.objUp = up; });
}

void addMeshWriteOptions(CLI::App& app, WriteOptions& options) {
    app.add_flag("--vertex-colours", options.mesh.vertexColours,
                 "Of meshes: colours at the vertices in place of a texture of the palette");
}

}  // namespace voxprite::cli
