#include "core/io/voxel_payload.h"

#include <algorithm>
#include <bit>

namespace voxprite {
namespace {

constexpr std::string_view kPayloadMark = "VXL1";
constexpr int kDenseEdgeLog2 = 3;
constexpr int kMaxEdgeLog2 = 9;
constexpr std::size_t kDenseVoxels = 512;
constexpr std::size_t kBlockHeaderBytes = 14;

struct BlockHeader {
    glm::ivec3 origin{0};
    int edgeVoxels = 8;
    std::uint8_t value = 0;  // 0: dense
};

bool isMultipleOf(glm::ivec3 origin, int edge) {
    return origin.x % edge == 0 && origin.y % edge == 0 && origin.z % edge == 0;
}

bool withinLimits(glm::ivec3 v) {
    return glm::clamp(v, -kMaxCoordinate, kMaxCoordinate) == v;
}

Result<BlockHeader> readBlockHeader(ByteReader& reader) {
    const std::uint64_t start = reader.offset();
    // One bounded take, then fields that cannot fail.
    const Result<ByteView> bytes = reader.take(kBlockHeaderBytes, "a block of voxels");
    if (!bytes) return Failure(bytes.error());
    ByteReader fields(*bytes, start);
    BlockHeader header;
    header.origin.x = *fields.i32("x");
    header.origin.y = *fields.i32("y");
    header.origin.z = *fields.i32("z");
    const int edgeLog2 = *fields.u8("edge");
    header.value = *fields.u8("value");
    if (edgeLog2 < kDenseEdgeLog2 || edgeLog2 > kMaxEdgeLog2 ||
        (header.value == 0 && edgeLog2 != kDenseEdgeLog2)) {
        return failAtByte(start, "a block of voxels has an unknown size");
    }
    header.edgeVoxels = 1 << edgeLog2;
    if (!withinLimits(header.origin) || !isMultipleOf(header.origin, header.edgeVoxels)) {
        return failAtByte(start, "a block of voxels lies off its grid or beyond the limits");
    }
    return header;
}

Status readBlock(ByteReader& reader, BudgetedGrid& grid) {
    const std::uint64_t start = reader.offset();
    const Result<BlockHeader> header = readBlockHeader(reader);
    if (!header) return Failure(header.error());
    const IBox box{header->origin, header->origin + header->edgeVoxels};
    if (header->value != 0) {
        if (!withinLimits(box.max - 1)) return failAtByte(start, "voxels beyond the limits");
        if (!grid.fill(box, header->value)) return failAtByte(start, GridBudget::refusal());
        return {};
    }
    const Result<ByteView> values = reader.take(kDenseVoxels, "the voxels of a block");
    if (!values) return Failure(values.error());
    for (int k = 0; k < static_cast<int>(kDenseVoxels); ++k) {
        const std::uint8_t value = (*values)[static_cast<std::size_t>(k)];
        if (value == 0) continue;
        const glm::ivec3 voxel = header->origin + glm::ivec3(k >> 6, (k >> 3) & 7, k & 7);
        if (!withinLimits(voxel)) return failAtByte(start, "voxels beyond the limits");
        grid.setUnpaid(voxel, value);
    }
    return {};
}

}  // namespace

Result<Bytes> writeVoxelPayload(const VoxelGrid& voxels) {
    ByteWriter writer;
    writer.raw(kPayloadMark);
    writer.u32(0);
    std::uint64_t blocks = 0;
    bool knownSizes = true;
    const auto writeHeader = [&](glm::ivec3 origin, int edgeLog2, std::uint8_t value) {
        writer.i32(origin.x);
        writer.i32(origin.y);
        writer.i32(origin.z);
        writer.u8(static_cast<std::uint8_t>(edgeLog2));
        writer.u8(value);
        ++blocks;
    };
    voxels.forEachBlock([&](const VoxelBlock& block) {
        if (block.voxels == nullptr) {
            const auto edge = static_cast<unsigned>(block.edgeVoxels);
            const int edgeLog2 = std::countr_zero(edge);
            knownSizes = knownSizes && std::has_single_bit(edge) && edgeLog2 >= kDenseEdgeLog2 &&
                         edgeLog2 <= kMaxEdgeLog2;
            writeHeader(block.origin, edgeLog2, block.uniformValue);
            return;
        }
        const std::span values(block.voxels, kDenseVoxels);
        // Uniform blocks have one form, however the grid keeps them.
        const bool uniform = std::all_of(values.begin(), values.end(),
                                         [&](std::uint8_t v) { return v == values[0]; });
        if (uniform && values[0] == 0) return;
        writeHeader(block.origin, kDenseEdgeLog2, uniform ? values[0] : std::uint8_t{0});
        if (!uniform) writer.raw(ByteView(values));
    });
    if (!knownSizes) return fail("the grid holds blocks of a size that the format does not know");
    if (blocks > UINT32_MAX) return fail("a model has more than 4,294,967,295 blocks of voxels");
    writer.patchU32(kPayloadMark.size(), static_cast<std::uint32_t>(blocks));
    return writer.release();
}

Result<VoxelGrid> readVoxelPayload(ByteView bytes, GridBudget& budget) {
    ByteReader reader(bytes);
    const Result<ByteView> magic = reader.take(kPayloadMark.size(), "the voxels' mark");
    if (!magic) return Failure(magic.error());
    if (!std::equal(magic->begin(), magic->end(), kPayloadMark.begin())) {
        return failAtByte(0, "these are not voxels of a .voxprite file");
    }
    const Result<std::uint32_t> count = reader.u32("the number of blocks");
    if (!count) return Failure(count.error());
    if (*count > reader.remaining() / kBlockHeaderBytes) {
        return failAtByte(kPayloadMark.size(), "more blocks of voxels are claimed than there are");
    }
    BudgetedGrid grid(budget);
    for (std::uint32_t k = 0; k < *count; ++k) {
        if (Status status = readBlock(reader, grid); !status) return Failure(status.error());
    }
    if (!reader.atEnd()) return failAtByte(reader.offset(), "bytes after the last block");
    return grid.release();
}

}  // namespace voxprite
