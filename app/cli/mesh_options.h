// The options of commands that read and write meshes.
#pragma once

#include <CLI/CLI.hpp>

#include "core/io/formats.h"

namespace voxprite::cli {

// --resolution, --voxels-per-unit, --solid and --up: of meshes that are read.
void addMeshReadOptions(CLI::App& app, ReadOptions& options);
// --vertex-colours: of meshes that are written.
void addMeshWriteOptions(CLI::App& app, WriteOptions& options);

}  // namespace voxprite::cli
