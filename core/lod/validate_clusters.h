// Do clusters keep what a cut without holes or overlaps counts on? For pages from elsewhere, and in
// debug builds for those that buildClusters makes.
#pragma once

#include <cstddef>
#include <span>

#include "core/base/result.h"
#include "core/lod/cluster_page.h"

namespace voxprite {

// The error's offset is the byte of the page in question. What is asked of the pages:
// - Every number is finite (but a root's parentError), every radius and error at least 0; errors
//   and reach at most 1e6, positive errors at least 1e-6.
// - A page's triangles are whole, and within the `indexCount` indices there are.
// - lodError <= parentError, twice as much where lodError is not 0, and the sphere of the parents'
//   group holds that of the page's own up to rounding: then no camera sees a coarser error smaller.
// - Groups fit together. What replaces a page is a group of pages with just that error as their
//   lodError and just that sphere, bit for bit; and what a page of some error replaces is likewise
//   there. So the intervals of every way from the finest pages to a root tile [0, infinity).
[[nodiscard]] Status validateClusters(std::span<const ClusterPage> pages, std::size_t indexCount);

}  // namespace voxprite
