// Is an octree from outside safe to traverse, and is it canonical? Apart from the reader, so that
// both a file and a live octree can be checked.
#pragma once

#include "core/svo/octree.h"

namespace voxprite {

// Every child and payload index in range, no node reached twice (so no cycles), no stray bits,
// depth within maxDepth, nothing solid outside the size. The error's offset is the node's index.
[[nodiscard]] Status validateOctree(const OctreeView& octree);
// Also collapsed, breadth first, without unused nodes or payloads (see octree.h).
[[nodiscard]] Status validateCanonical(const Octree& octree);

}  // namespace voxprite
