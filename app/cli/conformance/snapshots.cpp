#include "app/cli/conformance/snapshots.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "app/cli/conformance/subjects.h"
#include "app/cli/stopwatch.h"
#include "core/billboard/snapshot_blit.h"
#include "core/measure/compare.h"
#include "core/sprite/composite.h"

namespace voxprite::conformance {
namespace {

constexpr int kDirections = 6;
constexpr int kViewsTimed = 8;
constexpr Rgba8 kNothing{0};

struct Way {
    double yaw, pitch;
};

std::vector<Way> randomWays() {
    Sequence random(2026);
    std::vector<Way> ways;
    for (int n = 0; n < kDirections; ++n) {
        // By the sine, so that all directions count alike.
        const double yaw = random.between(0.0, 360.0);
        const double sine = random.between(-0.17, 1.0);
        ways.push_back({yaw, std::asin(sine) * 57.29577951308232});
    }
    return ways;
}

// A picture with the voxel that each pixel shows.
struct Seen {
    Image colours;
    std::vector<std::uint32_t> ids;
};

Seen shownBy(const SpriteView& view, const SpriteBuffer& buffer, const Camera& camera) {
    SpriteOnScreen shown = onScreen(view, buffer, camera);
    return {std::move(shown.image), std::move(shown.ids)};
}

// One model, seen exactly and by snapshots.
class Onlooker {
  public:
    explicit Onlooker(const TurningModel& model)
        : model_(model),
          profile_(plainProfile()),
          entity_(placeEntity(Entity{}, {glm::ivec3(0), model.octree.size}, profile_)),
          light_(model.palette, profile_.light, glm::transpose(entity_.worldFromVoxelAxes),
                 profile_.outline, profile_.shading) {
        entity_.anchorMetres -= entity_.centreMetres();
    }

    // A square picture with the model in it, a virtual pixel so many screen pixels wide.
    [[nodiscard]] Camera camera(const Way& way, double screenPxPerPx) const {
        const double metresPerScreenPx = profile_.voxelSizeMetres / profile_.sigma / screenPxPerPx;
        const int edge =
            2 * static_cast<int>(entity_.radiusMetres() / metresPerScreenPx + 4.0 * screenPxPerPx);
        Camera result = orbit(way.yaw, way.pitch, 1.0, edge);
        result.eyeMetres *= metresPerScreenPx / result.metresPerScreenPx(1.0);
        return result;
    }
    [[nodiscard]] Seen exact(const Camera& camera) const {
        const SpriteView view = seen(entity_, camera, profile_);
        return shownBy(view,
                       castSprite(model_.octree.view(), view.lattice,
                                  litPalette(model_.palette, view.light8, profile_.outline)),
                       camera);
    }
    // `degreesOff` grows by the view's.
    [[nodiscard]] Seen sprite(const ViewSet& views, const Camera& camera, double& degreesOff) {
        const SpriteView view = viewSnapshot(entity_, camera, profile_, views).value().view.value();
        degreesOff += view.degreesOff;
        return shownBy(view, castSprites(views, *view.viewOfSet).buffer, camera);
    }
    [[nodiscard]] Seen seed(const ViewSet& views, bool blend, const Camera& camera,
                            double& degreesOff) {
        SnapshotChoice choice;
        choice.blend = blend;
        const SeenSnapshots seen =
            seeSnapshots(entity_, camera, views, kUsualSnapshotPx, choice).value();
        degreesOff += seen.degreesOff;
        if (!blend) {
            const ShownSnapshot& one = seen.shown.front();
            return shownBy(one.plane, castSeed(views, one.view).buffer, camera);
        }
        std::vector<Snapshot> snapshots;
        std::vector<BlitSource> sources;
        snapshots.reserve(seen.shown.size());
        for (const ShownSnapshot& one : seen.shown) {
            snapshots.push_back(castSeed(views, one.view));
            sources.push_back({&snapshots.back(), &one.plane, one.weight});
        }
        SnapshotCanvas canvas(camera.viewportPx, kNothing);
        blitSnapshots(sources, entity_.metresPerVoxel(), SnapshotDepth::centre, camera, canvas);
        return {std::move(canvas.colours), {}};
    }
    [[nodiscard]] Snapshot castSprites(const ViewSet& views, int view) const {
        return castSpriteSnapshot(model_.octree.view(), light_, views, view, profile_.sigma)
            .value();
    }
    [[nodiscard]] Snapshot castSeed(const ViewSet& views, int view) const {
        return castSnapshot(model_.octree.view(), light_, views, view, kUsualSnapshotPx);
    }

  private:
    const TurningModel& model_;
    GameProfile profile_;
    PlacedEntity entity_;
    SnapshotLight light_;
};

SnapshotFigures::Unlike compared(const Seen& exact, const Seen& other) {
    SnapshotFigures::Unlike unlike;
    unlike.flip = flipInside(exact.colours, other.colours).value();
    double either = 0.0;
    double voxels = 0.0;
    double ofEither = 0.0;
    for (std::size_t at = 0; at < exact.ids.size(); ++at) {
        const bool a = exact.colours.pixels[at].w != 0;
        const bool b = other.colours.pixels[at].w != 0;
        either += a || b ? 1.0 : 0.0;
        unlike.silhouette += a != b ? 1.0 : 0.0;
        if (other.ids.empty()) continue;
        const bool voxel = exact.ids[at] >= kIdFirstVoxel || other.ids[at] >= kIdFirstVoxel;
        ofEither += voxel ? 1.0 : 0.0;
        voxels += voxel && exact.ids[at] != other.ids[at] ? 1.0 : 0.0;
    }
    unlike.silhouette *= 100.0 / either;
    unlike.voxels =
        other.ids.empty() ? std::numeric_limits<double>::quiet_NaN() : 100.0 * voxels / ofEither;
    return unlike;
}

// What one row of the table shows.
struct Rule {
    const char* kind;
    ViewSet views;
    bool seed = false;
    bool blend = false;
};

std::vector<Rule> rules() {
    std::vector<Rule> all;
    for (const char* name : {"canonical26", "octahedral:8", "octahedral:12", "octahedral:18",
                             "octahedral:36", "hemisphere:12"}) {
        all.push_back({"sprite", ViewSet::named(name).value()});
    }
    for (const char* name : {"canonical26", "octahedral:18"}) {
        all.push_back({"seed", ViewSet::named(name).value(), true});
        all.push_back({"seed, blended", ViewSet::named(name).value(), true, true});
    }
    return all;
}

// Bytes and milliseconds of all views, from some.
void measureCost(const Onlooker& onlooker, const Rule& rule, SnapshotFigures& figures) {
    const cli::Stopwatch watch;
    double bytes = 0.0;
    for (int n = 0; n < kViewsTimed; ++n) {
        const int view = n * rule.views.count() / kViewsTimed;
        bytes += static_cast<double>((rule.seed ? onlooker.castSeed(rule.views, view)
                                                : onlooker.castSprites(rule.views, view))
                                         .bytes());
    }
    const double share = static_cast<double>(rule.views.count()) / kViewsTimed;
    figures.milliseconds += watch.milliseconds() * share;
    figures.bytes += bytes * share;
}

}  // namespace

std::vector<SnapshotFigures> measureSnapshots(const std::vector<TurningModel>& models) {
    const std::vector<Rule> all = rules();
    std::vector<SnapshotFigures> figures;
    figures.reserve(all.size());
    for (const Rule& rule : all)
        figures.push_back({rule.kind, rule.views.name(), rule.views.count()});
    const std::vector<Way> ways = randomWays();
    for (const TurningModel& model : models) {
        Onlooker onlooker(model);
        for (std::size_t d = 0; d < kSnapshotDistances.size(); ++d) {
            for (const Way& way : ways) {
                const Camera camera = onlooker.camera(way, kSnapshotDistances[d]);
                const Seen exact = onlooker.exact(camera);
                for (std::size_t k = 0; k < all.size(); ++k) {
                    const Rule& rule = all[k];
                    double& off = figures[k].meanDegreesOff;
                    const SnapshotFigures::Unlike one = compared(
                        exact, rule.seed ? onlooker.seed(rule.views, rule.blend, camera, off)
                                         : onlooker.sprite(rule.views, camera, off));
                    figures[k].unlike[d].flip += one.flip;
                    figures[k].unlike[d].silhouette += one.silhouette;
                    figures[k].unlike[d].voxels += one.voxels;
                }
            }
        }
        for (std::size_t k = 0; k < all.size(); ++k) measureCost(onlooker, all[k], figures[k]);
    }
    const auto count = static_cast<double>(models.size());
    const double looks = count * static_cast<double>(ways.size());
    for (SnapshotFigures& one : figures) {
        one.meanDegreesOff /= looks * static_cast<double>(kSnapshotDistances.size());
        one.bytes /= count;
        one.milliseconds /= count;
        for (SnapshotFigures::Unlike& unlike : one.unlike) {
            unlike.flip /= looks;
            unlike.silhouette /= looks;
            unlike.voxels /= looks;
        }
    }
    return figures;
}

}  // namespace voxprite::conformance
