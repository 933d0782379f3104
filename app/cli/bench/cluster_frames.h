// Frames of the voxel view by rays and by clusters, for benchClusters.
#pragma once

#include <string>

#include "app/cli/bench/bench.h"

namespace voxprite::bench {

// Adds the time of a frame of the edit view (1024x768, edges and occlusion shown) by rays, and by
// clusters at several budgets with their share of wrong pixels: made shells of 64 to 512 voxels
// (128 with `quick`), then `models`; near, at a distance where the model fills the picture, and
// far. Needs a current GL context.
[[nodiscard]] Status benchClusterFrames(const std::vector<BenchModel>& models, const Effort& effort,
                                        Json& out);

// Those figures as a table in Markdown: a row a model and distance, a column a budget. Milliseconds
// are those of one core, which depend little on what else the machine does.
[[nodiscard]] std::string clusterFrameTable(const Json& figures);

}  // namespace voxprite::bench
