#include <algorithm>

#include "core/io/grid_layers.h"
#include "core/io/qb.h"
#include "core/io/qb_runs.h"
#include "core/model/entity_voxels.h"

namespace voxprite {
namespace {

constexpr std::size_t kMaxName = 255;
constexpr std::uint32_t kShortestRun = 4;  // shorter ones are no longer cell by cell

// As long as fits, whole characters.
std::string nameThatFits(const std::string& name) {
    std::size_t length = std::min(name.size(), kMaxName);
    const auto continues = [&](std::size_t at) {
        return at < name.size() && (static_cast<unsigned char>(name[at]) & 0xC0) == 0x80;
    };
    while (length > 0 && continues(length)) --length;
    return name.substr(0, length);
}

std::uint32_t wordOf(Rgba8 colour) {
    return std::uint32_t{colour.x} | std::uint32_t{colour.y} << 8 | std::uint32_t{colour.z} << 16 |
           0xFF00'0000u;
}

void writeSlice(ByteWriter& out, const Palette& palette, std::span<const std::uint8_t> cells) {
    // What is empty to the end of the slice need not be said.
    std::size_t end = cells.size();
    while (end > 0 && cells[end - 1] == 0) --end;
    const auto word = [&](std::size_t at) {
        return cells[at] == 0 ? 0 : wordOf(palette.colours[cells[at]]);
    };
    for (std::size_t at = 0; at < end;) {
        const std::uint32_t colour = word(at);
        std::uint32_t count = 1;
        while (at + count < end && word(at + count) == colour) ++count;
        if (count >= kShortestRun) {
            out.u32(qb::kRun);
            out.u32(count);
            out.u32(colour);
        } else {
            for (std::uint32_t k = 0; k < count; ++k) out.u32(colour);
        }
        at += count;
    }
    out.u32(qb::kNextSlice);
}

VoxelGrid turned(const VoxelGrid& voxels, const SignedPermutation& rotation) {
    VoxelGrid grid;
    const Placement placement{rotation, glm::ivec3(0)};
    voxels.forEachSolid(
        [&](glm::ivec3 v, std::uint8_t value) { grid.set(placement.applyToVoxel(v), value); });
    return grid;
}

Status writeMatrix(ByteWriter& out, const Document& document, const Instance& instance) {
    const std::string name =
        nameThatFits(document.nodes[static_cast<std::size_t>(instance.node)].name);
    const VoxelGrid& voxels = document.models[static_cast<std::size_t>(instance.model)].voxels;
    const SignedPermutation& rotation = instance.entityFromModel.rotation;
    const VoxelGrid own = rotation == SignedPermutation{} ? VoxelGrid() : turned(voxels, rotation);
    const VoxelGrid& seen = rotation == SignedPermutation{} ? voxels : own;
    IBox box = seen.bounds();
    if (box.empty()) box = {glm::ivec3(0), glm::ivec3(1)};

    out.u8(static_cast<std::uint8_t>(name.size()));
    out.raw(name);
    const glm::ivec3 size = box.max - box.min;
    const glm::ivec3 corner = box.min + instance.entityFromModel.translation;
    for (const int edge : {size.x, size.z, size.y}) out.u32(static_cast<std::uint32_t>(edge));
    for (const int coordinate : {corner.x, corner.z, corner.y}) out.i32(coordinate);
    const Status written =
        forEachLayer(seen, box, 1, [&](int, std::span<const std::uint8_t> cells) -> Status {
            writeSlice(out, document.palette, cells);
            return {};
        });
    if (!written) return fail("the object \"" + name + "\": " + written.error().message);
    return {};
}

}  // namespace

Result<Bytes> writeQb(const Document& document) {
    if (Status s = validate(document); !s) return Failure(s.error());
    const std::vector<Instance> instances = instancesOf(document, 0);
    ByteWriter out;
    out.u32(0x0101);  // version 1.1.0.0
    out.u32(0);       // red first
    out.u32(0);       // left-handed
    out.u32(1);       // runs
    out.u32(0);       // no mask
    out.u32(static_cast<std::uint32_t>(instances.size()));
    for (const Instance& instance : instances) {
        if (Status s = writeMatrix(out, document, instance); !s) return Failure(s.error());
    }
    return out.release();
}

std::vector<std::string> qbLosses(const Document& document) {
    std::size_t tooLong = 0;
    for (const Instance& instance : instancesOf(document, 0)) {
        const std::string& name = document.nodes[static_cast<std::size_t>(instance.node)].name;
        if (name.size() > kMaxName) ++tooLong;
    }
    if (tooLong == 0) return {};
    return {".qb has names of at most " + std::to_string(kMaxName) +
            " bytes: " + std::to_string(tooLong) + " cut off"};
}

}  // namespace voxprite
