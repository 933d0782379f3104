// Rays a second, ours and rivals': parallel rays of sprites and perspective rays of the voxel view.
// 512 x 512 rays over the model's bounding sphere from each of eight oblique directions. All
// casters take turns on one picture after another; a figure is the sum over pictures of each one's
// shortest time, which on one thread is the thread's own (what else the machine does counts
// little).

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <span>
#include <string_view>
#include <tuple>

#include "app/cli/bench/bench.h"
#include "app/cli/bench/counters.h"
#include "app/cli/bench/nanovdb_rival.h"
#include "app/cli/bench/openvdb_rivals.h"
#include "app/cli/bench/rivals.h"
#include "app/cli/stopwatch.h"
#include "core/base/parallel.h"
#include "core/base/thread_stopwatch.h"
#include "core/model/game_profile.h"
#include "core/sprite/sprite_buffer.h"
#include "core/sprite/sprite_view.h"
#include "core/sprite/voxel_placement.h"
#include "core/trace/lattice_caster.h"
#include "core/trace/picture_packets.h"
#include "core/trace/ray_packet.h"
#include "core/trace/raycast.h"

namespace voxprite::bench {
namespace {

// One in each octant.
constexpr OrbitAngles kViews[] = {{28, 19, 0},  {66, -31, 0},  {118, 24, 0}, {152, -14, 0},
                                  {205, 41, 0}, {248, -22, 0}, {293, 12, 0}, {337, -37, 0}};

// A picture is cast again and again for so long: one of a tenth of a millisecond would else measure
// how long a thread takes to wake up.
constexpr double kLeastMs = 4.0;

// One picture of each kind, its rays made beforehand: what is measured is casting alone.
struct View {
    LatticeView lattice;
    std::vector<Ray> parallelRays;
    EyePicture eyePicture;
    std::vector<Ray> eyeRays;  // of that picture
};

std::vector<Ray> parallelRays(const LatticeView& lattice) {
    std::vector<Ray> rays;
    for (int row = 0; row < lattice.size.y; ++row) {
        for (int column = 0; column < lattice.size.x; ++column) {
            const LatticeRay ray = rayOf(lattice, lattice.first + glm::ivec2(column, row));
            rays.push_back({glm::dvec3(ray.origin) / std::ldexp(1.0, ray.positionBits),
                            glm::dvec3(ray.direction), -std::numeric_limits<double>::infinity()});
        }
    }
    return rays;
}

std::vector<Ray> eyeRays(const EyePicture& picture, glm::ivec2 size) {
    std::vector<Ray> rays;
    for (int row = 0; row < size.y; ++row) {
        for (int column = 0; column < size.x; ++column) {
            const voxprite::Ray ray = picture.ray({column, row});
            rays.push_back({ray.origin, ray.direction, 0.0});
        }
    }
    return rays;
}

Result<View> viewOf(const BenchModel& model, const OrbitAngles& angles, int edgePx) {
    const glm::ivec3 size = model.octree.size;
    const glm::dmat3 basis = orbitBasis(angles);
    OrthoView ortho{basis[0], basis[1], basis[2]};
    ortho.sigmaInForce =
        std::clamp(edgePx / glm::length(glm::dvec3(size)), kLeastSigma, kMostSigma);
    const Result<LatticeView> lattice = quantiseView(ortho, size);
    if (!lattice) return Failure(lattice.error());
    View view{*lattice, {}, {}, {}};
    view.lattice.first = glm::ivec2(-edgePx / 2);
    view.lattice.size = glm::ivec2(edgePx);
    view.parallelRays = parallelRays(view.lattice);
    const PlacedEntity placed = placeEntity(Entity{}, {{0, 0, 0}, size}, GameProfile{});
    view.eyePicture = eyePicture(
        voxelPlacement(placed), orbitCamera(angles, placed.centreMetres(),
                                            2.7 * placed.radiusMetres(), 45.0, glm::ivec2(edgePx)));
    view.eyeRays = eyeRays(view.eyePicture, glm::ivec2(edgePx));
    return view;
}

using Materials = std::vector<std::uint8_t>;

// Casts every ray of a picture on so many threads.
using CastPicture = std::function<void(const View& view, int threads, Materials& hits)>;

struct Caster {
    const char* name;
    CastPicture parallel, perspective;
    bool often = true;
};

// makeCaster() gives what casts the k-th ray, one for each thread.
template <class MakeCaster>
void castEach(Materials& hits, int threads, const MakeCaster& makeCaster) {
    constexpr int kChunk = 1024;
    const int count = static_cast<int>(hits.size());
    parallelFor((count + kChunk - 1) / kChunk, threads, [&](int first, int last) {
        auto&& cast = makeCaster();
        const auto end = static_cast<std::size_t>(std::min(count, last * kChunk));
        for (auto k = static_cast<std::size_t>(first * kChunk); k < end; ++k) hits[k] = cast(k);
    });
}

// A caster of single rays, parallel and perspective alike.
template <class MakeCaster>
Caster rayByRay(const char* name, const MakeCaster& makeCaster) {
    const auto over = [makeCaster](std::vector<Ray> View::*rays) {
        return [makeCaster, rays](const View& view, int threads, Materials& hits) {
            castEach(hits, threads, [&] {
                return [&view, rays, cast = makeCaster()](std::size_t k) {
                    return cast((view.*rays)[k]);
                };
            });
        };
    };
    const bool often = std::string_view(name) == "nanovdb";
    return {name, over(&View::parallelRays), over(&View::eyeRays), often};
}

Caster scalarCaster(const OctreeView& octree) {
    return {"scalar",
            [octree](const View& view, int threads, Materials& hits) {
                const LatticeCaster caster(octree, view.lattice);
                castEach(hits, threads, [&] {
                    return [&](std::size_t k) {
                        const int width = view.lattice.size.x;
                        const int at = static_cast<int>(k);
                        const glm::ivec2 pixel(at % width, at / width);
                        return caster.cast(view.lattice.first + pixel).material;
                    };
                });
            },
            [octree](const View& view, int threads, Materials& hits) {
                castEach(hits, threads, [&] {
                    return [&](std::size_t k) {
                        const Ray& ray = view.eyeRays[k];
                        return raycast(octree, {ray.origin, ray.direction}).value;
                    };
                });
            }};
}

// Packets over the picture: cast(first pixel, size, hits) casts one of them.
template <class Hits, class Cast>
void castPackets(glm::ivec2 size, int threads, Materials& materials, const Cast& cast) {
    forEachPacket<Hits>(size, threads, [&] {
        return [&](glm::ivec2 first, glm::ivec2 part, Hits& hits) {
            cast(first, part, hits);
            hits.forEachHit(part.y, [&](int column, int row) {
                const int at = (first.y + row) * size.x + first.x + column;
                materials[static_cast<std::size_t>(at)] = hits.at(column, row).material;
            });
        };
    });
}

Caster packetCaster(const OctreeView& octree) {
    return {"packet",
            [octree](const View& view, int threads, Materials& hits) {
                const PacketCaster caster(octree, view.lattice);
                castPackets<PacketHits>(view.lattice.size, threads, hits,
                                        [&](glm::ivec2 first, glm::ivec2 size, PacketHits& met) {
                                            caster.cast(view.lattice.first + first, size, met);
                                        });
            },
            [octree](const View& view, int threads, Materials& hits) {
                castPackets<RayPacketHits>(
                    view.lattice.size, threads, hits,
                    [&](glm::ivec2 first, glm::ivec2 size, RayPacketHits& met) {
                        castRayPacket(octree, view.eyePicture, first, size, kMaxOctreeDepth, met);
                    });
            }};
}

double shareDiffering(const Materials& a, const Materials& b) {
    std::size_t count = 0;
    for (std::size_t k = 0; k < a.size(); ++k) count += a[k] != b[k] ? 1 : 0;
    return static_cast<double>(count) / static_cast<double>(a.size());
}

class CastBench {
  public:
    CastBench(const BenchModel& model, const Effort& effort, Json& out)
        : model_(model), octree_(model.octree.view()), effort_(effort), out_(out) {}

    Status run() {
        progress(effort_, "cast: " + model_.name);
        std::vector<Caster> casters{scalarCaster(octree_), packetCaster(octree_)};
        const NanoVdbRival nanovdb(octree_);
        casters.push_back(rayByRay("nanovdb", [&] {
            auto caster = std::make_shared<NanoVdbRival::Caster>(nanovdb);
            return [caster](const Ray& ray) { return caster->cast(ray); };
        }));
        const Result<const OpenVdbRivals*> rivals = openVdbRivals();
        if (!rivals) return Failure(rivals.error());
        const std::unique_ptr<OpenVdbVolume> openvdb = (*rivals)->volume(octree_.size);
        forEachSolid(octree_,
                     [&](glm::ivec3 v, std::uint8_t material) { openvdb->set(v, material); });
        casters.push_back(rayByRay("openvdb", [&] {
            const std::shared_ptr<OpenVdbVolume::Caster> caster = openvdb->caster();
            return [caster](const Ray& ray) { return caster->cast(ray); };
        }));
        casters.push_back(rayByRay("octree_restart", [&] {
            return [&](const Ray& ray) { return castByRestart(octree_, ray); };
        }));
        const glm::dvec3 size(octree_.size);
        std::optional<DenseGrid> dense;
        if (size.x * size.y * size.z <= static_cast<double>(DenseGrid::kMaxVoxels)) {
            dense.emplace(octree_);
            casters.push_back(rayByRay(
                "dense_dda", [&] { return [&](const Ray& ray) { return dense->cast(ray); }; }));
        }
        const std::span<const OrbitAngles> views = std::span(kViews).first(effort_.quick ? 2 : 8);
        for (const OrbitAngles& angles : views) {
            const Result<View> view = viewOf(model_, angles, effort_.quick ? 128 : 512);
            if (!view) return Failure(view.error());
            measure("parallel", casters, &Caster::parallel, *view, view->parallelRays.size());
            measure("perspective", casters, &Caster::perspective, *view, view->eyeRays.size());
            measureSprite(*view);
        }
        report(casters);
        const auto& [bare, outlined, onThreads] = spriteMs_;
        const auto pictures = static_cast<double>(views.size());
        out_.push_back({{"model", model_.name},
                        {"kind", "sprite"},
                        {"caster", "packet"},
                        {"ms", outlined / pictures},
                        {"outline_share", outlined / bare - 1.0},
                        {"threads", hardwareThreads()},
                        {"times_one_thread", outlined / onThreads}});
        return {};
    }

  private:
    struct Figure {
        double ms = 0.0;
        std::size_t rays = 0, hits = 0;
        double differing = 0.0;
        HardwareCounters::Counts counts;  // of the thread that calls
        std::size_t counted = 0;          // rays that they are of
    };
    using Key = std::tuple<std::string, std::string, int>;  // kind, caster, threads

    void measure(const char* kind, const std::vector<Caster>& casters,
                 CastPicture Caster::*castPicture, const View& view, std::size_t count) {
        std::vector<int> threadCounts{1};
        if (hardwareThreads() > 1) threadCounts.push_back(hardwareThreads());
        std::map<std::pair<std::string, int>, double> shortest;
        Materials truth(count);
        for (int round = 0; round < (effort_.quick ? 2 : 3); ++round) {
            for (const Caster& caster : casters) {
                if (!(caster.*castPicture)) continue;
                // The slow ones get two tries, and one thread.
                const bool often = caster.often || effort_.quick;
                if (!often && round > 1) continue;
                for (const int threads : threadCounts) {
                    if (!often && threads > 1) continue;
                    Materials hits(count);
                    int casts = 0;
                    const cli::Stopwatch wall;
                    const ThreadStopwatch own;
                    counters_.start();
                    do {
                        (caster.*castPicture)(view, threads, hits);
                        ++casts;
                    } while (wall.milliseconds() < kLeastMs);
                    const double ms =
                        (threads == 1 ? own.milliseconds() : wall.milliseconds()) / casts;
                    const HardwareCounters::Counts counts = counters_.stop();
                    double& best = shortest.try_emplace({caster.name, threads}, ms).first->second;
                    best = std::min(best, ms);
                    if (round != 0) continue;
                    if (&caster == &casters.front() && threads == 1) truth = hits;
                    Figure& figure = figures_[{kind, caster.name, threads}];
                    figure.rays += count;
                    figure.counts += counts;
                    figure.counted += count * static_cast<std::size_t>(casts);
                    figure.hits +=
                        count - static_cast<std::size_t>(std::count(hits.begin(), hits.end(), 0));
                    figure.differing += shareDiffering(hits, truth) * static_cast<double>(count);
                }
            }
        }
        for (const auto& [who, ms] : shortest) figures_[{kind, who.first, who.second}].ms += ms;
    }

    // What a sprite takes on one thread and on all, and what its outline adds on one.
    void measureSprite(const View& view) {
        LitPalette bare, outlined;
        bare.outline.enabled = false;
        outlined.outline.enabled = true;
        struct Way {
            const LitPalette& lit;
            int threads;
            double shortestMs = std::numeric_limits<double>::max();
        };
        std::array<Way, 3> ways{{{bare, 1}, {outlined, 1}, {outlined, hardwareThreads()}}};
        for (int round = 0; round < (effort_.quick ? 3 : 12); ++round) {
            for (Way& way : ways) {
                int casts = 0;
                const cli::Stopwatch wall;
                const ThreadStopwatch own;
                do {
                    const SpriteBuffer sprite =
                        castSprite(octree_, view.lattice, way.lit, way.threads);
                    ++casts;
                } while (wall.milliseconds() < kLeastMs);
                const double ms = way.threads == 1 ? own.milliseconds() : wall.milliseconds();
                way.shortestMs = std::min(way.shortestMs, ms / casts);
            }
        }
        for (std::size_t way = 0; way < ways.size(); ++way) spriteMs_[way] += ways[way].shortestMs;
    }

    void report(const std::vector<Caster>& casters) {
        for (const char* kind : {"parallel", "perspective"})
            for (const Caster& caster : casters)
                for (const auto& [key, figure] : figures_) {
                    const auto& [ofKind, name, threads] = key;
                    if (ofKind != kind || name != caster.name) continue;
                    const auto rays = static_cast<double>(figure.rays);
                    const double rate = rays / figure.ms / 1000.0;
                    const Figure& nanovdb = figures_.at({kind, "nanovdb", threads});
                    const double nanovdbRate =
                        static_cast<double>(nanovdb.rays) / nanovdb.ms / 1000.0;
                    Json json{{"model", model_.name},
                              {"kind", kind},
                              {"caster", name},
                              {"threads", threads},
                              {"mrays_per_s", rate},
                              {"times_nanovdb", rate / nanovdbRate},
                              {"rays", figure.rays},
                              {"hit", static_cast<double>(figure.hits) / rays},
                              {"differing", figure.differing / rays}};
                    if (threads == 1) {
                        addCounts(json, figure.counts, static_cast<double>(figure.counted), "ray");
                    } else {
                        json["times_one_thread"] = figures_.at({kind, name, 1}).ms / figure.ms;
                    }
                    out_.push_back(std::move(json));
                }
    }

    const BenchModel& model_;
    OctreeView octree_;
    Effort effort_;
    Json& out_;
    std::map<Key, Figure> figures_;
    HardwareCounters counters_;
    std::array<double, 3> spriteMs_{};  // bare, outlined, outlined on all threads
};

// Real models that the casters are compared on, where the corpus has them.
constexpr std::array kCorpusModels{"spotvox/Tree", "vengi/test-transform", "voxel2pixel/NumberCube",
                                   "mmmm/scene_store8", "mmmm/chr_army4a"};

}  // namespace

Result<Json> benchCast(const std::vector<BenchModel>& models, const Effort& effort) {
    Json figures = Json::array();
    const auto measure = [&](const BenchModel& model) {
        return CastBench(model, effort, figures).run();
    };
    for (const auto& make : {&shellModel, &scatteredModel}) {
        for (const int edge : {64, 128, 256, 512}) {
            if (effort.quick && edge > 128) break;
            const Result<BenchModel> model = make(edge);
            if (!model) return Failure(model.error());
            if (Status ok = measure(*model); !ok) return Failure(ok.error());
        }
    }
    for (const BenchModel& model : models) {
        const bool wanted = model.name.starts_with("samples/") ||
                            std::ranges::find(kCorpusModels, model.name) != kCorpusModels.end();
        if (!wanted) continue;
        if (Status ok = measure(model); !ok) return Failure(ok.error());
    }
    return figures;
}

}  // namespace voxprite::bench
