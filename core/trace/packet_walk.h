// One packet down the octree, with the widest vectors that the machine has.
#pragma once

#include "core/trace/packet_caster.h"
#include "core/trace/packet_tables.h"

namespace voxprite {

void walkPacket(const PacketTables& tables, glm::ivec2 first, glm::ivec2 size, PacketHits& hits);

}  // namespace voxprite
