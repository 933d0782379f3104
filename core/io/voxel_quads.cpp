#include "core/io/voxel_quads.h"

#include <algorithm>
#include <string>
#include <tuple>

#include "core/lod/greedy_rectangles.h"

namespace voxprite {
namespace {

constexpr int kLog2Square = 10;
constexpr int kSquare = 1 << kLog2Square;

struct Face {
    int layer = 0;  // of its plane, along the axis
    int squareV = 0, squareU = 0;
    std::uint16_t v = 0, u = 0;  // within the square
    std::uint8_t material = 0;

    [[nodiscard]] auto square() const { return std::tie(layer, squareV, squareU); }
};

class FaceFinder {
  public:
    FaceFinder(const VoxelGrid& voxels, int face)
        : voxels_(voxels),
          reader_(voxels),
          axis_(face % 3),
          u_((face + 1) % 3),
          v_((face + 2) % 3),
          step_(face < 3 ? 1 : -1) {}

    Result<std::vector<Face>> run() {
        bool fits = true;
        voxels_.forEachBlock([&](const VoxelBlock& block) {
            if (!fits) return;
            if (block.voxels == nullptr) {
                border(block);
            } else {
                leaf(block);
            }
            fits = faces_.size() <= kMaxOpenFaces;
        });
        if (!fits) {
            return fail("the model has more than " + std::to_string(kMaxOpenFaces) +
                        " open faces to one side; that is too many for a mesh");
        }
        std::sort(faces_.begin(), faces_.end(), [](const Face& a, const Face& b) {
            return std::tuple(a.square(), a.v, a.u) < std::tuple(b.square(), b.v, b.u);
        });
        return std::move(faces_);
    }

  private:
    void add(glm::ivec3 voxel, std::uint8_t material) {
        faces_.push_back({step_ > 0 ? voxel[axis_] + 1 : voxel[axis_], voxel[v_] >> kLog2Square,
                          voxel[u_] >> kLog2Square,
                          static_cast<std::uint16_t>(voxel[v_] & (kSquare - 1)),
                          static_cast<std::uint16_t>(voxel[u_] & (kSquare - 1)), material});
    }

    void test(glm::ivec3 voxel, std::uint8_t material) {
        glm::ivec3 beside = voxel;
        beside[axis_] += step_;
        if (!isInVoxelRange(beside) || reader_.get(beside) == 0) add(voxel, material);
    }

    void leaf(const VoxelBlock& block) {
        const glm::ivec3 stride(64, 8, 1);
        for (int k = 0; k < 512; ++k) {
            const std::uint8_t material = block.voxels[k];
            if (material == 0) continue;
            const glm::ivec3 at(k >> 6, k >> 3 & 7, k & 7);
            const int next = at[axis_] + step_;
            if (next < 0 || next > 7) {
                test(block.origin + at, material);
            } else if (block.voxels[k + step_ * stride[axis_]] == 0) {
                add(block.origin + at, material);
            }
        }
    }

    void border(const VoxelBlock& block) {
        glm::ivec3 at = block.origin;
        at[axis_] += step_ > 0 ? block.edgeVoxels - 1 : 0;
        for (int v = 0; v < block.edgeVoxels; ++v) {
            for (int u = 0; u < block.edgeVoxels; ++u) {
                glm::ivec3 voxel = at;
                voxel[u_] += u;
                voxel[v_] += v;
                test(voxel, block.uniformValue);
            }
        }
    }

    const VoxelGrid& voxels_;
    VoxelGrid::Reader reader_;
    int axis_, u_, v_, step_;
    std::vector<Face> faces_;
};

void mergeSquare(std::span<const Face> faces, int face, std::vector<std::uint8_t>& cells,
                 std::vector<VoxelQuad>& quads) {
    int minU = kSquare, maxU = 0;
    for (const Face& f : faces) {
        minU = std::min<int>(minU, f.u);
        maxU = std::max<int>(maxU, f.u + 1);
    }
    const int minV = faces.front().v, width = maxU - minU, height = faces.back().v + 1 - minV;
    cells.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
    for (const Face& f : faces) {
        cells[static_cast<std::size_t>((f.v - minV) * width + f.u - minU)] = f.material;
    }
    const Face& first = faces.front();
    const int axis = face % 3, uAxis = (face + 1) % 3, vAxis = (face + 2) % 3;
    takeRectangles(cells, width, height, [&](int u, int v, int across, int down, std::uint8_t m) {
        VoxelQuad quad;
        quad.min[axis] = first.layer;
        quad.min[uAxis] = first.squareU * kSquare + minU + u;
        quad.min[vAxis] = first.squareV * kSquare + minV + v;
        quad.max = quad.min;
        quad.max[uAxis] += across;
        quad.max[vAxis] += down;
        quad.material = m;
        quad.face = static_cast<std::uint8_t>(face);
        quads.push_back(quad);
    });
}

}  // namespace

Result<std::vector<VoxelQuad>> openQuads(const VoxelGrid& voxels) {
    std::vector<VoxelQuad> quads;
    std::vector<std::uint8_t> cells;
    for (int face = 0; face < 6; ++face) {
        const Result<std::vector<Face>> faces = FaceFinder(voxels, face).run();
        if (!faces) return Failure(faces.error());
        for (auto first = faces->begin(); first != faces->end();) {
            const auto last = std::find_if(
                first, faces->end(), [&](const Face& f) { return f.square() != first->square(); });
            mergeSquare({first, last}, face, cells, quads);
            first = last;
        }
    }
    return quads;
}

}  // namespace voxprite
