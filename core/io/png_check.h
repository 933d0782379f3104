// Looks over a PNG before it is decoded: stb neither verifies checksums nor bounds what it unfolds.
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace voxprite {

// Signature, order and bounds of the chunks, CRC-32 of each, edges of at most `maxEdge`, a known
// pixel format, and exactly as many bytes of packed pixels as the picture needs.
[[nodiscard]] Status checkPng(ByteView bytes, int maxEdge);

}  // namespace voxprite
