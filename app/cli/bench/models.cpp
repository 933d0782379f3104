#include <algorithm>
#include <limits>
#include <random>
#include <system_error>

#include "app/cli/bench/bench.h"
#include "core/io/formats.h"
#include "core/model/entity_voxels.h"
#include "core/svo/bake.h"

namespace voxprite::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kQuickFiles = 2;

// A colour for each octant of the model, so that faces and bricks are not all alike.
std::uint8_t octantColour(glm::ivec3 v, int size) {
    const int half = size / 2;
    return static_cast<std::uint8_t>(1 + (v.x >= half) + 2 * (v.y >= half) + 4 * (v.z >= half));
}

// Voxels whose centre lies at most size/2 from the middle, and not nearer than `hollow`.
VoxelGrid ball(int size, double hollow) {
    VoxelGrid grid;
    const double radius = size / 2.0;
    for (int z = 0; z < size; ++z) {
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const glm::dvec3 d = glm::dvec3(x, y, z) + 0.5 - radius;
                const double squared = d.x * d.x + d.y * d.y + d.z * d.z;
                if (squared > radius * radius || squared < hollow * hollow) continue;
                grid.set({x, y, z}, octantColour({x, y, z}, size));
            }
        }
    }
    return grid;
}

// One voxel in 100 is solid, anywhere: the worst that an octree can be given.
VoxelGrid scattered(int size) {
    VoxelGrid grid;
    std::mt19937 random(64);
    const auto count = static_cast<std::uint64_t>(size) * static_cast<std::uint64_t>(size) *
                       static_cast<std::uint64_t>(size) / 100;
    const auto edge = static_cast<std::uint32_t>(size);
    const auto coordinate = [&] { return static_cast<int>(random() % edge); };
    for (std::uint64_t k = 0; k < count; ++k) {
        const int x = coordinate();
        const int y = coordinate();
        const int z = coordinate();
        grid.set({x, y, z}, static_cast<std::uint8_t>(1 + random() % 255));
    }
    return grid;
}

Result<BenchModel> made(const std::string& name, VoxelGrid voxels) {
    Result<Octree> octree = bake(voxels);
    if (!octree) return Failure(octree.error());
    return BenchModel{name, {}, {}, std::move(voxels), std::move(*octree)};
}

// Models in `folder` and `depth` levels of folders below it, by path; named by their path from it,
// after `prefix`.
std::vector<std::pair<std::string, fs::path>> filesBelow(const fs::path& folder, int depth,
                                                         const std::string& prefix) {
    std::vector<std::pair<std::string, fs::path>> files;
    std::error_code error;
    for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end;
         it.increment(error)) {
        if (it.depth() >= depth) it.disable_recursion_pending();
        const Result<Format> format = formatOf(it->path());
        // Folders hold pictures of other kinds, too.
        if (!it->is_regular_file() || !format || *format == Format::png) continue;
        files.emplace_back(
            prefix + it->path().lexically_relative(folder).replace_extension("").generic_string(),
            it->path());
    }
    std::sort(files.begin(), files.end());
    return files;
}

// samples/ of the working folder, or beside the build folder that the program lies in.
fs::path samplesFolder() {
    std::error_code error;
    if (fs::is_directory("samples", error)) return "samples";
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    const fs::path beside = program.parent_path().parent_path() / "samples";
    return fs::is_directory(beside, error) ? beside : fs::path();
}

// Nothing for files that cannot be read (a corpus holds broken ones, too), hold no voxels or have
// more than an octree takes.
std::optional<BenchModel> loaded(const std::string& name, const fs::path& path) {
    Result<LoadedDocument> file = loadDocument(path);
    if (!file) return std::nullopt;
    BenchModel model{name, path, std::move(file->document), {}, {}};
    model.voxels = flatten(model.document, 0);
    if (model.voxels.empty()) return std::nullopt;
    Result<Octree> octree = bake(model.voxels);
    if (!octree) return std::nullopt;
    model.octree = std::move(*octree);
    return model;
}

}  // namespace

Result<BenchModel> scatteredModel(int size) {
    return made("random" + std::to_string(size), scattered(size));
}

Result<BenchModel> shellModel(int size) {
    return made("shell" + std::to_string(size), ball(size, size / 2.0 - 1.0));
}

Result<std::vector<BenchModel>> benchModels(bool quick, const std::filesystem::path& corpus) {
    std::vector<BenchModel> models;
    const auto addMade = [&](const std::string& name, VoxelGrid voxels) -> Status {
        Result<BenchModel> model = made(name, std::move(voxels));
        if (!model) return Failure(model.error());
        models.push_back(std::move(*model));
        return {};
    };
    const int solid = quick ? 64 : 256;
    const int random = quick ? 128 : 512;
    Status status = addMade("shell128", ball(128, 63.0));
    if (status) status = addMade("solid" + std::to_string(solid), ball(solid, 0.0));
    if (status) status = addMade("random" + std::to_string(random), scattered(random));
    if (!status) return Failure(status.error());

    const auto addFiles = [&](const fs::path& folder, int depth, const std::string& prefix) {
        std::size_t added = 0;
        for (const auto& [name, path] : filesBelow(folder, depth, prefix)) {
            if (quick && added == kQuickFiles) break;
            if (std::optional<BenchModel> model = loaded(name, path)) {
                models.push_back(std::move(*model));
                ++added;
            }
        }
    };
    // What lies in folders below the samples is for other programs' readers.
    if (const fs::path samples = samplesFolder(); !samples.empty())
        addFiles(samples, 0, "samples/");
    if (!corpus.empty()) {
        if (!fs::is_directory(corpus)) {
            return failInFile(corpus.string(), "the corpus is not a folder");
        }
        addFiles(corpus, std::numeric_limits<int>::max(), "");
    }
    return models;
}

}  // namespace voxprite::bench
