#include "tests/runtime/sprite_jobs.h"

#include "core/io/svo_file.h"
#include "core/sprite/sprite_buffer.h"
#include "core/svo/bake.h"
#include "tests/render/views.h"
#include "tests/runtime/exported_samples.h"
#include "tests/support/random.h"

namespace voxprite::test {
namespace {

// Along the axes, along face and space diagonals, from above and below, and anywhere.
std::vector<OrbitAngles> twentyViews() {
    const std::vector<OrbitAngles> all = allKindsOfViews(6, 77);
    std::vector<OrbitAngles> views;
    for (const std::size_t i : {0, 1, 2, 5, 9, 11, 17, 19, 21, 23, 25, 40, 41, 44}) {
        views.push_back(all[i]);
    }
    views.insert(views.end(), all.end() - 6, all.end());
    return views;
}

nlohmann::json vectorJson(glm::ivec3 v) {
    return {v.x, v.y, v.z};
}

SpriteJob jobOf(const SvoFile& file, std::uint32_t model, const OrbitAngles& angles, double sigma,
                const Outline& outline) {
    const Octree& octree = file.models[model].octree;
    const glm::dmat3 basis = orbitBasis(angles);
    const LatticeView lattice = must(quantiseView(
        {voxelFromWorld(basis[0]), voxelFromWorld(basis[1]), voxelFromWorld(basis[2]), sigma},
        octree.size));
    const FaceLights lights(faceLight(lattice.D, {0.35, -0.55, 0.8}, 0.55));
    Palette palette;
    palette.colours = file.palette;
    const SpriteBuffer buffer =
        castSprite(octree.view(), lattice, litPalette(palette, lights, outline));
    SpriteJob job;
    job.model = model;
    job.narrow = fitsNarrow(lattice, octree.size);
    job.shot["lattice"] = {{"bits",
                            {{"position", lattice.positionBits},
                             {"direction", lattice.directionBits},
                             {"step", kStepShift}}},
                           {"C", vectorJson(lattice.C)},
                           {"D", vectorJson(lattice.D)},
                           {"U", vectorJson(lattice.U)},
                           {"V", vectorJson(lattice.V)},
                           {"first", {lattice.first.x, lattice.first.y}},
                           {"size", {lattice.size.x, lattice.size.y}}};
    job.shot["lit"] = {{"light8", lights.open},
                       {"shading", "multiply"},
                       {"face_rays", false},
                       {"outline", nullptr}};
    if (outline.enabled) job.shot["lit"]["outline"] = vectorJson(glm::ivec3(outline.colour));
    job.size = std::to_string(buffer.size.x) + "x" + std::to_string(buffer.size.y);
    job.colours = buffer.sha256();
    job.ids = buffer.idsSha256();
    return job;
}

// Thousands of voxels along, so that products outgrow 31 bits unless the direction is a short
// vector; of aligned cubes, so that the file stays small.
JobSet largeModel() {
    Random random(5);
    VoxelGrid voxels;
    for (int i = 1; i < 60; ++i) {
        const auto coordinate = [&](int cubes) {
            return 64 * static_cast<int>(cubes * random.unit());
        };
        const int x = coordinate(62);
        const int y = coordinate(47);
        const glm::ivec3 corner(x, y, coordinate(55));
        voxels.fill({corner, corner + 64}, static_cast<std::uint8_t>(i));
    }
    voxels.set({3999, 3007, 3519}, 7);
    SvoFile file;
    file.models = {{"large", must(bake(voxels))}};
    file.palette = Palette::standard().colours;
    JobSet set{"large", must(writeSvo(file)), {}};
    for (const OrbitAngles& angles : twentyViews()) {
        set.jobs.push_back(jobOf(file, 0, angles, 1.0 / 64.0, {}));
    }
    return set;
}

// All samples in one file, unlike in size and palette.
JobSet allInOne() {
    std::vector<SvoFile> files;
    for (const ExportedSample& sample : exportedSamples()) {
        files.push_back(must(readSvo(sample.bytes)));
    }
    JobSet set{"all", must(writeSvoSet(files)), {}};
    const std::vector<OrbitAngles> views = twentyViews();
    for (std::size_t entity = 0; entity < files.size(); ++entity) {
        const auto last = static_cast<std::uint32_t>(files[entity].models.size() - 1);
        for (const std::size_t view : {entity, entity + 8}) {
            SpriteJob job = jobOf(files[entity], view % 2 == 0 ? 0 : last, views[view], 1.0, {});
            job.entity = static_cast<std::uint32_t>(entity);
            set.jobs.push_back(std::move(job));
        }
    }
    return set;
}

}  // namespace

nlohmann::json oneShot() {
    return jobOf(must(readSvo(exportedSamples()[0].bytes)), 0, {33.0, 12.0, 0.0}, 1.0, {}).shot;
}

std::vector<JobSet> spriteJobs() {
    std::vector<JobSet> sets;
    const std::vector<OrbitAngles> views = twentyViews();
    const Outline outlines[] = {{true, {0, 0, 0, 255}}, {true, {90, 20, 140, 255}}, {false, {}}};
    for (ExportedSample& sample : exportedSamples()) {
        const SvoFile file = must(readSvo(sample.bytes));
        const bool vast = file.models[0].octree.maxDepth > 6;
        JobSet set{sample.name, std::move(sample.bytes), {}};
        std::size_t next = 0;
        // Small ones, for software drivers; and two of every sample as games show them.
        const auto add = [&](const OrbitAngles& angles, double sigma) {
            set.jobs.push_back(jobOf(file, static_cast<std::uint32_t>(next % file.models.size()),
                                     angles, sigma, outlines[next / 2 % 3]));
            ++next;
        };
        for (const double sigma : {0.5, 1.0, 1.5}) {
            for (std::size_t i = 0; i < views.size(); i += vast && sigma > 1.0 ? 5 : 1) {
                add(views[i], sigma);
            }
        }
        add(views[9], vast ? 2.0 : 4.0);
        add(views.back(), vast ? 2.5 : 3.0);
        sets.push_back(std::move(set));
    }
    sets.push_back(largeModel());
    sets.push_back(allInOne());
    return sets;
}

}  // namespace voxprite::test
