// Voxels of a mesh: surfaces through OpenVDB, insides by crossings, colours of the nearest point.
//
// Grid    The longest side of the mesh is `resolution` voxels. On a shorter side that is no whole
//         number of voxels the mesh stands in the middle. The model begins at voxel (0,0,0).
// Closed  A voxel is solid when its centre is inside. Where walls are so thin that no centre is,
//         the voxels through which the surface passes stand for it.
// Open    A voxel is solid when its centre is within half a voxel of the surface (just half: when
//         it is behind), or with `solid` when a flood from outside does not reach it.
// Hollow  Without `solid` a closed mesh is the voxels of the above that have an empty neighbour at
//         one of their six faces. From outside both look the same.
// Colour  That of the surface's nearest point to the voxel's centre, of equally near ones on the
//         triangle that comes last in the file, as what is drawn last shows, and of touching
//         bodies the one that the voxel is in; deeper than 8 voxels, to the centre of the cube
//         of 8 voxels that it is in. More than 255 colours are reduced (colour_reduction.h), by
//         those of voxels with an open face; the others take the nearest.
//
// So a voxel model that was written as a mesh and is read with its longest side's voxels is the
// same again: all its voxels with `solid`, and the colours of all that an open face shows.
#pragma once

#include <optional>

#include "core/base/result.h"
#include "core/io/formats.h"
#include "core/io/triangle_mesh.h"

namespace voxprite {

inline constexpr int kMaxMeshResolution = 1024;

// Every number in range, or the reason.
[[nodiscard]] Status validate(const MeshReadOptions& options);

// One object. The mesh's origin becomes the anchor, unless it is far from the mesh; the voxel's
// edge in the file's unit becomes the authored VoxelSize. Refuses meshes without triangles or
// extent and such as would take too much work or memory at the resolution (about two gigabytes).
// The result does not depend on the number of threads.
[[nodiscard]] Result<LoadedDocument> voxelsOf(TriangleMesh mesh, const MeshReadOptions& options);

}  // namespace voxprite
