// What OpenVDB's library does for us, as opposed to its headers (core/model/voxel_grid.cpp): shells
// of voxels, triangles made into cells, .vdb files and their packing.
//
// Behind interfaces, because a program that links that library binds some 61,000 of its symbols
// before its own first line: 62 of the 76 ms of any command. volumeLibrary() is defined twice:
// - voxprite_volume does the work itself, for whoever links the core;
// - voxprite_volume_late loads it when it is first asked, for the program (which sets the target
//   property VOXPRITE_LATE_OPENVDB).
//
// Everything throws what OpenVDB throws, std::exception and std::bad_alloc among it: callers make
// errors of that. Blocks are 8 x 8 x 8 voxels in the order of VoxelBlock (core/model/voxel_grid.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <string>

#include "core/base/box.h"
#include "core/base/result.h"

namespace voxprite {

// Which voxels are solid, no more; grows and shrinks through faces.
class SolidVoxels {
  public:
    virtual ~SolidVoxels() = default;
    virtual void fill(const IBox& box) = 0;
    // `solid`: eight words, as VoxelBlock has them.
    virtual void setBlock(glm::ivec3 origin, const std::uint64_t* solid) = 0;
    // Both divide large cubes down to blocks.
    virtual void dilate() = 0;
    virtual void erode(int layers) = 0;
    // The words of the block at `origin`, null where it is empty. Valid until the next change.
    [[nodiscard]] virtual const std::uint64_t* blockAt(glm::ivec3 origin) const = 0;
    virtual void forEachBlock(
        const std::function<void(glm::ivec3 origin, const std::uint64_t* solid)>& visit) const = 0;
};

// Corner k % 3 of triangle k / 3, in cells; a cell's centre is at + 0.5.
struct TriangleCorners {
    std::size_t triangles = 0;  // at least one
    std::function<glm::dvec3(std::size_t corner)> at;
};

// The triangle nearest to the centre of each cell that a surface comes near to: every cell whose
// centre is within 0.86 of it, and some that are a little farther away. Distances are OpenVDB's,
// in single precision; of equal ones the lowest index. The result does not depend on the number of
// threads. Reading from several threads at once is safe.
class NearestTriangles {
  public:
    virtual ~NearestTriangles() = default;
    // Those of the block at `origin`, a multiple of 8; -1 where the surface is farther; null when
    // it is for all of them.
    [[nodiscard]] virtual const std::int32_t* blockAt(glm::ivec3 origin) const = 0;
};

// Grids of 32-bit whole numbers, which become the bytes of a .vdb file.
class VdbWriter {
  public:
    virtual ~VdbWriter() = default;
    // What follows goes into a grid of this name.
    virtual void beginGrid(const std::string& name, double voxelSizeMetres) = 0;
    virtual void fill(const IBox& box, std::uint8_t value) = 0;
    virtual void set(glm::ivec3 voxel, std::uint8_t value) = 0;
    // Of all of them, with a text among the file's metadata.
    [[nodiscard]] virtual std::string file(const std::string& textName,
                                           const std::string& text) const = 0;
};

class VolumeLibrary {
  public:
    virtual ~VolumeLibrary() = default;
    [[nodiscard]] virtual std::unique_ptr<SolidVoxels> solidVoxels() const = 0;
    [[nodiscard]] virtual std::unique_ptr<NearestTriangles> nearestTriangles(
        const TriangleCorners& corners) const = 0;
    // Calls visit(cell) for those of [0, size) that a flood from outside does not reach, going
    // round the surface, by the sign of OpenVDB's level set. Holes of more than about a cell let
    // it in.
    virtual void forEachFloodedInside(const TriangleCorners& corners, glm::ivec3 size,
                                      const std::function<void(glm::ivec3 cell)>& visit) const = 0;
    [[nodiscard]] virtual std::unique_ptr<VdbWriter> vdbWriter() const = 0;
    // A Blosc chunk whose header says that it is as long as `packed` and unpacks to `bytes`.
    virtual void unpackBlosc(std::span<const std::uint8_t> packed,
                             std::span<std::uint8_t> bytes) const = 0;
};

// Fails where it has to be loaded and cannot be. Lives as long as the program.
[[nodiscard]] Result<const VolumeLibrary*> volumeLibrary();

}  // namespace voxprite
