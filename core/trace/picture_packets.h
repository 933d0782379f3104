// A picture cut into packets, spread over threads: the one loop of all that cast by packets.
#pragma once

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <memory>

#include "core/base/parallel.h"
#include "core/trace/packet_caster.h"

namespace voxprite {

// Covers the pixels [0, size) with packets of at most kEdge on either axis. makeCast() is called
// once for every run of packets, on the thread that takes them, and gives what is called for each:
// (first pixel, size, hits). `hits`, a PacketHits or what is made of it, is scratch of the run.
// threads <= 0: all cores.
template <class Hits, class MakeCast>
void forEachPacket(glm::ivec2 size, int threads, const MakeCast& makeCast) {
    constexpr int kEdge = PacketHits::kEdge;
    if (size.x <= 0 || size.y <= 0) return;
    const glm::ivec2 packets = (size + (kEdge - 1)) / kEdge;
    parallelFor(packets.x * packets.y, threads, [&](int firstPacket, int lastPacket) {
        const auto hits = std::make_unique_for_overwrite<Hits>();
        auto cast = makeCast();
        for (int packet = firstPacket; packet < lastPacket; ++packet) {
            const glm::ivec2 first{packet % packets.x * kEdge, packet / packets.x * kEdge};
            cast(first, glm::min(size - first, glm::ivec2(kEdge)), *hits);
        }
    });
}

}  // namespace voxprite
