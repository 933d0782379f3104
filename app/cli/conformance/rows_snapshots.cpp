// Row 18: how far is what a snapshot shows from what there is to see?
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "app/cli/conformance/conformance.h"
#include "app/cli/conformance/subjects.h"
#include "core/billboard/snapshot_blit.h"
#include "core/measure/compare.h"
#include "core/sprite/composite.h"
#include "core/sprite/view_axes.h"

namespace voxprite::conformance {
namespace {

ViewSet octahedral36() {
    return *ViewSet::octahedral(36);  // within the bounds of sets
}

struct Off {
    double mean = 0.0;
    double worst = 0.0;
};

// Of the nearest view from any direction, in degrees.
Off degreesOff(const ViewSet& views) {
    Sequence random(18);
    Off off;
    const int tries = 20'000;
    for (int n = 0; n < tries; ++n) {
        // In braces, which are evaluated in order; a ball's points have all directions alike.
        glm::dvec3 v(2.0);
        while (!(glm::length(v) <= 1.0 && glm::length(v) > 0.1))
            v = glm::dvec3{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        v = glm::normalize(v);
        const double degrees = glm::degrees(angleBetween(views.direction(*views.nearest(v)), v));
        off.mean += degrees / tries;
        off.worst = std::max(off.worst, degrees);
    }
    return off;
}

// By how many degrees a model's upright and lying axes are drawn turned from where they are, on
// average, ten degrees from the pole.
double rollOff(SnapshotRoll roll) {
    const Subject subject = cube32();
    const GameProfile profile = plainProfile();
    const PlacedEntity entity = subject.centredAt(glm::dvec3(0.0), profile);
    ViewSet views;
    views.roll = roll;
    double sum = 0.0;
    int count = 0;
    for (int yaw = 0; yaw < 360; yaw += 15) {
        const Camera camera = orbit(yaw, 80.0, 12.0);
        const SpriteView view = viewSnapshot(entity, camera, profile, views).value().view.value();
        for (const glm::dvec3 axis : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)}) {
            const glm::dvec3 world = worldFromVoxel(axis);
            const glm::dvec3 drawn = view.right * glm::dot(view.ortho.right, axis) +
                                     view.up * glm::dot(view.ortho.up, axis);
            const glm::dvec3 truth = world - camera.forward * glm::dot(world, camera.forward);
            sum += glm::degrees(angleBetween(glm::normalize(drawn), glm::normalize(truth)));
            ++count;
        }
    }
    return sum / count;
}

// With the eye at each view: pixels unlike the exact sprite's, of those that show something.
double unlikeAtViews(SnapshotKind kind) {
    const Subject subject = figure();
    const GameProfile profile = plainProfile();
    const PlacedEntity entity = subject.centredAt(glm::dvec3(0.0), profile);
    const Palette palette = Palette::standard();
    const SnapshotLight light(palette, profile.light, glm::transpose(entity.worldFromVoxelAxes),
                              profile.outline, profile.shading);
    const ViewSet views;
    std::uint64_t unlike = 0;
    std::uint64_t shown = 0;
    for (int view = 0; view < views.count(); ++view) {
        const glm::dmat3 axes = views.axes(view);
        Camera camera;
        camera.right = worldFromVoxel(axes[0]);
        camera.up = worldFromVoxel(axes[1]);
        camera.forward = worldFromVoxel(axes[2]);
        camera.eyeMetres = camera.forward * -8.0 * entity.radiusMetres();
        camera.viewportPx = glm::ivec2(256);
        camera.verticalFovDegrees = 20.0;
        const SpriteView exact = seen(entity, camera, profile);
        const SpriteBuffer buffer = castSprite(subject.octree.view(), exact.lattice,
                                               litPalette(palette, exact.light8, profile.outline));
        const CompositeSprite sprite{&exact, &buffer, nullptr};
        const Image expected = composite({&sprite, 1}, camera, Rgba8(0));

        SnapshotCanvas canvas(camera.viewportPx, Rgba8(0));
        SpriteView plane;
        Snapshot snapshot;
        if (kind == SnapshotKind::sprite) {
            plane = viewSnapshot(entity, camera, profile, views).value().view.value();
            snapshot = castSpriteSnapshot(subject.octree.view(), light, views, *plane.viewOfSet,
                                          plane.ortho.sigmaInForce)
                           .value();
        } else {
            plane = seeSnapshots(entity, camera, views, kUsualSnapshotPx, {})
                        .value()
                        .shown.front()
                        .plane;
            snapshot = castSnapshot(subject.octree.view(), light, views, *plane.viewOfSet,
                                    kUsualSnapshotPx);
        }
        const BlitSource source{&snapshot, &plane, 1.0};
        blitSnapshots({&source, 1}, entity.metresPerVoxel(), SnapshotDepth::centre, camera, canvas);
        for (std::size_t at = 0; at < expected.pixels.size(); ++at) {
            const bool some = expected.pixels[at].w != 0 || canvas.colours.pixels[at].w != 0;
            shown += some ? 1 : 0;
            unlike += expected.pixels[at] != canvas.colours.pixels[at] ? 1 : 0;
        }
    }
    return 100.0 * static_cast<double>(unlike) / static_cast<double>(shown);
}

}  // namespace

void compareSnapshots(Comparisons& all) {
    const Off canonical = degreesOff(ViewSet());
    const Off dense = degreesOff(octahedral36());
    all.push_back({18, "view_off_mean", "the nearest snapshot's view off the true one, on average",
                   canonical.mean, dense.mean, 2.5, "degrees",
                   "20,000 directions: the 26 views against an octahedral set of 36 x 36"});
    all.push_back({18, "view_off_worst", "the same, the worst", canonical.worst, dense.worst, 5.0,
                   "degrees", "the same directions"});
    all.push_back({18, "roll_off", "axes of the model drawn turned, near the pole",
                   rollOff(SnapshotRoll::own), rollOff(SnapshotRoll::matched), 1.0, "degrees",
                   "cube, 10 degrees from above at 24 yaws, the canonical view from above"});
    all.push_back({18, "unlike_at_views", "pixels unlike the exact sprite's with the eye at a view",
                   unlikeAtViews(SnapshotKind::seed), unlikeAtViews(SnapshotKind::sprite), 0.0, "%",
                   "figure, 26 views from 8 radii, sigma 4: snapshots of 128 x 128 in perspective "
                   "against those that are sprites"});
}

}  // namespace voxprite::conformance
