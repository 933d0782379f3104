#include "app/cli/mesh_options.h"

#include <map>
#include <string>

#include "core/io/mesh_voxels.h"

namespace voxprite::cli {

void addMeshReadOptions(CLI::App& app, ReadOptions& options) {
    MeshReadOptions& mesh = options.mesh;
    app.add_option("--resolution", mesh.resolution,
                   "Of meshes: voxels along the longest side (default 64)")
        ->check(CLI::Range(1, kMaxMeshResolution));
    app.add_option("--voxels-per-unit", mesh.voxelsPerUnit,
                   "Of meshes: voxels a unit of the file (glTF: a metre), in place of --resolution")
        ->check(CLI::Range(1e-6, 1e6))
        ->excludes("--resolution");
    app.add_flag("--solid", mesh.solid, "Of meshes: fill the inside of the surface");
    app.add_option("--up", mesh.objUp, "The axis that is up in .obj: y (default) or z")
        ->transform(CLI::CheckedTransformer(
            std::map<std::string, MeshUpAxis>{{"y", MeshUpAxis::y}, {"z", MeshUpAxis::z}}));
}

void addMeshWriteOptions(CLI::App& app, WriteOptions& options) {
    app.add_flag("--vertex-colours", options.mesh.vertexColours,
                 "Of meshes: colours at the vertices in place of a texture of the palette");
}

}  // namespace voxprite::cli
