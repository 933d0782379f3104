// The performance figures of this machine, part by part. Every figure is measured here and now:
//   most            the median of repeated runs, after one that is not counted (medianMs)
//   cast            the shortest of two or three rounds, each as often as fills four milliseconds
//   update          the median over many places; no run before it
//   start           the median of whole starts; no run before it
//   loops           one run, the first, so that instructions are counted once
//   conversions     of files by whole programs: the shortest of three runs that succeed
//   timesFaster     of one sprite: by the fastest frames of either way
//   clusters        building: the median; no run before it
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/model/document.h"
#include "core/model/voxel_grid.h"
#include "core/svo/octree.h"

namespace voxprite::bench {

using Json = nlohmann::ordered_json;

struct BenchModel {
    std::string name;            // a path without its ending, or that of a made one: "shell128"
    std::filesystem::path file;  // empty for made ones
    Document document;           // of files
    VoxelGrid voxels;            // of the entity's first frame
    Octree octree;               // baked from them
};

// Made models, then the samples, then those of `corpus` (empty: none). With `quick` smaller made
// ones, and few files.
[[nodiscard]] Result<std::vector<BenchModel>> benchModels(bool quick,
                                                          const std::filesystem::path& corpus);

// A hollow ball, one voxel thick: "shell128".
[[nodiscard]] Result<BenchModel> shellModel(int size);
// One voxel in 100 is solid, anywhere: "random512".
[[nodiscard]] Result<BenchModel> scatteredModel(int size);

struct Effort {
    bool quick = false;
    [[nodiscard]] double budgetMs() const { return quick ? 20.0 : 300.0; }
    [[nodiscard]] int minRuns() const { return quick ? 2 : 5; }
};

[[nodiscard]] double median(std::vector<double> values);  // of at least one

// The median time of `run`, in milliseconds: run once uncounted, then minRuns() times at least,
// until budgetMs() are used up.
[[nodiscard]] double medianMs(const Effort& effort, const std::function<void()>& run);

// Says on stderr what is being measured; nothing with `quick`, which takes no time worth telling.
void progress(const Effort& effort, const std::string& what);

// Memory of this process that is in use, as the system counts it; 0 where it does not say.
[[nodiscard]] std::uint64_t processBytes();

// Each returns a list of figures, as the command line's contract has them. A rival that does not
// give the same result as voxprite is a failure, or its disagreement is in the figure
// (`differing`).
[[nodiscard]] Json machine();  // without "gl"
// On shells and scattered models of 64 to 512 cubed, the samples and five models of the corpus.
[[nodiscard]] Result<Json> benchCast(const std::vector<BenchModel>& models, const Effort& effort);
[[nodiscard]] Result<Json> benchBake(const std::vector<BenchModel>& models, const Effort& effort);
[[nodiscard]] Result<Json> benchUpdate(const std::vector<BenchModel>& models, const Effort& effort);
// Bytes, and bytes a solid voxel.
[[nodiscard]] Result<Json> benchMemory(const std::vector<BenchModel>& models, const Effort& effort);
// The hot loops on a shell of 128 cubed, over the same work in every run.
[[nodiscard]] Result<Json> benchLoops(const std::vector<BenchModel>& models, const Effort& effort);
[[nodiscard]] Result<Json> benchFiles(const std::vector<BenchModel>& models, const Effort& effort);
// These need a current GL context.
[[nodiscard]] Result<Json> benchFrame(const std::vector<BenchModel>& models, const Effort& effort);
[[nodiscard]] Result<Json> benchShade(const std::vector<BenchModel>& models, const Effort& effort);
[[nodiscard]] Result<Json> benchClusters(const std::vector<BenchModel>& models,
                                         const Effort& effort);
// Of the editor: milliseconds from the start of its process until each part is done, "first frame"
// among them, without a shader cache. Starts a virtual display where there is none.
[[nodiscard]] Result<Json> benchStart(const std::vector<BenchModel>& models, const Effort& effort);
// On models of its own; rays that OpenGL sees end elsewhere are in the figure (`differing`). The
// processor's rays become whole numbers within the time, OpenGL's before it.
[[nodiscard]] Result<Json> benchRaycast(const std::vector<BenchModel>& models,
                                        const Effort& effort);
// In the editor, from input to picture; on models of its own.
[[nodiscard]] Result<Json> benchLatency(const std::vector<BenchModel>& models,
                                        const Effort& effort);

}  // namespace voxprite::bench
