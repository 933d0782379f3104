#include "core/trace/packet_caster.h"

#include "core/trace/packet_tables.h"
#include "core/trace/packet_walk.h"
#include "core/trace/picture_packets.h"

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
    const PacketCaster caster(octree, lattice);
    forEachPacket<PacketHits>(size, threads, [&] {
        return [&](glm::ivec2 corner, glm::ivec2 part, PacketHits& hits) {
            caster.cast(first + corner, part, hits);
            hits.forEachHit(part.y, [&](int column, int row) {
                onHit(first + corner + glm::ivec2(column, row), hits.at(column, row));
            });
        };
    });
}

}  // namespace voxprite
