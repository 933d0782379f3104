// The fixed-function state of one pass, set whole before it draws: passes never depend on what
// another one, or the user interface, left behind.
#pragma once

#include <cstdint>

namespace voxprite::gl {

enum class DepthTest : std::uint8_t {
    off,
    nearer,         // strictly: of equal depths the first stays
    nearerOrEqual,  // for what is drawn onto a surface
    behind          // only where something nearer is
};
enum class Cull : std::uint8_t { none, frontFaces, backFaces };

struct DrawState {
    DepthTest depthTest = DepthTest::off;
    bool depthWrite = false;
    bool colourWrite = true;
    bool blend = false;  // straight alpha over what is there
    Cull cull = Cull::none;
};

void apply(const DrawState& state);

}  // namespace voxprite::gl
