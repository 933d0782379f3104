// The figures of frames, rays and clusters as tables for a page.
#pragma once

#include <string>

#include "app/cli/bench/bench.h"

namespace voxprite::bench {

// Markdown of what benchFrame has measured: one sprite by both modes; crowds, a row for each number
// of entities, a column for each way of drawing.
[[nodiscard]] std::string frameTables(const Json& figures);

// The same of benchClusters: a row a model, with what building costs and the finest three levels;
// then what budgets save, and what they show.
[[nodiscard]] std::string clusterTables(const Json& figures);

// The same of benchShade: a row a model.
[[nodiscard]] std::string shadeTable(const Json& figures);

// The same of benchCast: a row a model, parallel and eye rays in each cell; one thread, but for the
// packets of all threads.
[[nodiscard]] std::string castTable(const Json& figures);

// The same of benchRaycast: a row for each model, depth and limit.
[[nodiscard]] std::string raycastTable(const Json& figures);

}  // namespace voxprite::bench
