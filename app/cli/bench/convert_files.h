// Whole conversions, program against program: voxprite's command line and Goxel's.
#pragma once

#include "app/cli/bench/bench.h"

namespace voxprite::bench {

// .vox to .glb and to .obj, of every file model and of a box of 256 cubed that is full: start,
// disk and end of the program included. Goxel (Debian package goxel) needs a display; where it
// is not installed or does not run, its figures are null and say so. Appends to `figures`:
// {"file", "job", "program", "ms", "cpu_ms", "peak_mib"}.
[[nodiscard]] Status benchConversions(const std::vector<BenchModel>& models, const Effort& effort,
                                      Json& figures);

// Markdown of all figures of benchFiles: a row a job, times added up over the files.
[[nodiscard]] std::string fileTable(const Json& figures);

}  // namespace voxprite::bench
