// Numbers by which glTF 2.0 names what OpenGL names by them.
#pragma once

namespace voxprite::gltf {

// Types of an accessor's components.
inline constexpr int kByte = 5120, kUByte = 5121, kShort = 5122, kUShort = 5123, kUInt = 5125,
                     kFloat = 5126;
// What a buffer view is for.
inline constexpr int kVertices = 34962, kIndices = 34963;
// A sampler's filter and wrapping.
inline constexpr int kNearest = 9728;
inline constexpr int kClamp = 33071, kMirror = 33648;

}  // namespace voxprite::gltf
