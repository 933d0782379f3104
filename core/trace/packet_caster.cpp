#include "core/trace/packet_caster.h"

#include <bit>
#include <glm/common.hpp>

#include "core/base/parallel.h"
#include "core/trace/packet_tables.h"
#include "core/trace/packet_walk.h"

namespace voxprite {

PacketCaster::PacketCaster(const OctreeView& octree, const LatticeView& lattice)
    : scalar_(octree, lattice) {
    if (std::optional<PacketTables> tables = PacketTables::of(octree, lattice))
        tables_ = std::make_unique<const PacketTables>(*tables);
}

PacketCaster::~PacketCaster() = default;

bool PacketCaster::fast() const {
    return tables_ != nullptr;
}

void PacketCaster::cast(glm::ivec2 first, glm::ivec2 size, PacketHits& hits) const {
    if (size.x <= 0 || size.y <= 0) return;
    if (tables_) return walkPacket(*tables_, first, size, hits);
    hits.clear(size.y);
    for (int row = 0; row < size.y; ++row)
        for (int column = 0; column < size.x; ++column)
            hits.add(column, row, scalar_.cast(first + glm::ivec2(column, row)));
}

void castLattice(const OctreeView& octree, const LatticeView& lattice, glm::ivec2 first,
                 glm::ivec2 size, int threads, const OnLatticeHit& onHit) {
    constexpr int kEdge = PacketHits::kEdge;
    if (size.x <= 0 || size.y <= 0) return;
    const glm::ivec2 packets = (size + (kEdge - 1)) / kEdge;
    const PacketCaster caster(octree, lattice);
    parallelFor(packets.x * packets.y, threads, [&](int firstPacket, int lastPacket) {
        const auto hits = std::make_unique_for_overwrite<PacketHits>();
        for (int packet = firstPacket; packet < lastPacket; ++packet) {
            const glm::ivec2 corner{packet % packets.x * kEdge, packet / packets.x * kEdge};
            const glm::ivec2 part = glm::min(size - corner, glm::ivec2(kEdge));
            caster.cast(first + corner, part, *hits);
            for (int row = 0; row < part.y; ++row)
                for (std::uint64_t bits = hits->rows[static_cast<std::size_t>(row)]; bits != 0;
                     bits &= bits - 1) {
                    const int column = std::countr_zero(bits);
                    onHit(first + corner + glm::ivec2(column, row), hits->at(column, row));
                }
        }
    });
}

}  // namespace voxprite
