// Snapshots on the screen: where they land, what they cover, and how they hide each other.
#include "core/billboard/snapshot_blit.h"

#include <cmath>
#include <limits>

#include "core/sprite/composite.h"
#include "tests/core/billboard/snapshot_support.h"
#include "tests/support/random.h"

namespace voxprite::test {
namespace {

constexpr Rgba8 kBackground{10, 20, 200, 255};

// A picture of numbered colours without any sky, and one with a hole.
Snapshot checkers(int edge, glm::ivec2 holeMin = {}, glm::ivec2 holeMax = {}) {
    Snapshot snapshot;
    snapshot.buffer.size = glm::ivec2(edge);
    for (int row = 0; row < edge; ++row) {
        for (int column = 0; column < edge; ++column) {
            const bool hole =
                column >= holeMin.x && column < holeMax.x && row >= holeMin.y && row < holeMax.y;
            snapshot.buffer.ids.push_back(hole ? kIdEmpty : kIdFirstVoxel);
            snapshot.buffer.colours.push_back(hole ? Rgba8(0) : Rgba8(column, row, 7, 255));
            snapshot.depth.push_back(hole ? std::numeric_limits<float>::infinity() : 100.0f);
        }
    }
    return snapshot;
}

PlacedEntity cubeAt(glm::dvec3 centreMetres, glm::ivec3 size = {10, 10, 10}) {
    PlacedEntity entity = placeEntity(Entity{}, {glm::ivec3(0), size}, GameProfile{});
    entity.anchorMetres = glm::dvec3(0.0);
    entity.anchorMetres = centreMetres - entity.centreMetres();
    return entity;
}

Camera frontCamera(double metres, glm::ivec2 viewportPx = {300, 200}) {
    return cameraAt(ViewSet(), 3, metres, viewportPx);
}

SeenSnapshots seenBy(const PlacedEntity& entity, const Camera& camera, int edge,
                     const SnapshotChoice& choice = {}, const ViewSet& views = ViewSet()) {
    return must(seeSnapshots(entity, camera, views, edge, choice));
}

void draw(const Snapshot& snapshot, const SpriteView& plane, const Camera& camera,
          SnapshotCanvas& canvas, SnapshotDepth depth = SnapshotDepth::centre) {
    const BlitSource source{&snapshot, &plane, 1.0};
    blitSnapshots({&source, 1}, 0.1, depth, camera, canvas);
}

// A square of the sphere's width around the projected centre, each screen pixel showing the
// snapshot's pixel under its middle.
TEST(SnapshotBlit, CoversTheSpheresSquareByNearestPixels) {
    const int edge = 32;
    const Snapshot snapshot = checkers(edge);
    Random random(4);
    for (int n = 0; n < 20; ++n) {
        const double x = 4.0 * random.unit() - 2.0;
        const double y = 3.0 * random.unit() - 1.5;
        const PlacedEntity entity = cubeAt({x, y, 2.0 * random.unit()});
        const Camera camera = frontCamera(6.0);
        // A roll matched would turn the square of what is seen off the axis.
        ViewSet upright;
        upright.roll = SnapshotRoll::own;
        const SeenSnapshots seen = seenBy(entity, camera, edge, {}, upright);
        ASSERT_EQ(seen.shown.size(), 1u);
        SnapshotCanvas canvas(camera.viewportPx, kBackground);
        draw(snapshot, seen.shown[0].plane, camera, canvas);

        // The same by the cache's own formulas, in double.
        const Camera::Projected centre = camera.project(entity.centreMetres());
        const double radius = entity.radiusMetres() / camera.metresPerScreenPx(centre.depthMetres);
        int shown = 0;
        for (int row = 0; row < canvas.colours.height; ++row) {
            for (int column = 0; column < canvas.colours.width; ++column) {
                const glm::dvec2 at = (glm::dvec2(column, row) + 0.5 - centre.screenPx + radius) *
                                      (edge / (2.0 * radius));
                // Beside the edge of a pixel both are right.
                if (std::abs(at.x - std::round(at.x)) < 1e-6 ||
                    std::abs(at.y - std::round(at.y)) < 1e-6)
                    continue;
                const bool inside = at.x >= 0 && at.y >= 0 && at.x < edge && at.y < edge;
                const Rgba8 expected =
                    inside ? Rgba8(std::floor(at.x), std::floor(at.y), 7, 255) : kBackground;
                ASSERT_EQ(canvas.colours.at(column, row), expected) << column << ' ' << row;
                const float depth =
                    canvas.depths[static_cast<std::size_t>(row * canvas.colours.width + column)];
                EXPECT_EQ(depth, inside ? camera.reversedDepth(centre.depthMetres) : 0.0f);
                shown += inside ? 1 : 0;
            }
        }
        EXPECT_GT(shown, 300);
    }
}

TEST(SnapshotBlit, SkyLeavesWhatIsThere) {
    const Snapshot snapshot = checkers(16, {4, 4}, {12, 12});
    const Camera camera = frontCamera(6.0);
    const SeenSnapshots seen = seenBy(cubeAt(glm::dvec3(0.0)), camera, 16);
    SnapshotCanvas canvas(camera.viewportPx, kBackground);
    canvas.depths.assign(canvas.depths.size(), 1e-9f);  // far, but there
    draw(snapshot, seen.shown[0].plane, camera, canvas);
    EXPECT_EQ(canvas.colours.at(150, 100), kBackground);
    EXPECT_EQ(canvas.depths[100 * 300 + 150], 1e-9f);
    EXPECT_NE(canvas.colours.at(125, 100), kBackground);
}

TEST(SnapshotBlit, TheNearerHidesTheFartherInEitherOrder) {
    const Snapshot snapshot = checkers(16);
    const Camera camera = frontCamera(6.0);
    const PlacedEntity near = cubeAt({0.2, 0.0, 1.0});
    const PlacedEntity far = cubeAt({-0.9, 0.1, -1.0});
    const SpriteView nearPlane = seenBy(near, camera, 16).shown[0].plane;
    const SpriteView farPlane = seenBy(far, camera, 16).shown[0].plane;
    SnapshotCanvas one(camera.viewportPx, kBackground);
    draw(snapshot, nearPlane, camera, one);
    const Image nearAlone = one.colours;
    draw(snapshot, farPlane, camera, one);
    SnapshotCanvas other(camera.viewportPx, kBackground);
    draw(snapshot, farPlane, camera, other);
    draw(snapshot, nearPlane, camera, other);
    EXPECT_EQ(one.colours, other.colours);
    EXPECT_EQ(one.depths, other.depths);
    int behind = 0;
    for (std::size_t at = 0; at < nearAlone.pixels.size(); ++at) {
        if (nearAlone.pixels[at] != kBackground)
            EXPECT_EQ(one.colours.pixels[at], nearAlone.pixels[at]);
        else
            behind += one.colours.pixels[at] != kBackground ? 1 : 0;
    }
    EXPECT_GT(behind, 50);
    // Of equal depths what is there stays.
    SnapshotCanvas twice(camera.viewportPx, kBackground);
    draw(snapshot, nearPlane, camera, twice);
    Snapshot red = snapshot;
    for (Rgba8& colour : red.buffer.colours) colour = Rgba8(255, 0, 0, 255);
    draw(red, nearPlane, camera, twice);
    EXPECT_EQ(twice.colours, nearAlone);
}

TEST(SnapshotBlit, NothingIsSeenBehindTheCameraUnderAPixelOrOfNothing) {
    const Camera camera = frontCamera(6.0);
    // Two metres behind the eye, and in its very plane.
    EXPECT_EQ(seenBy(cubeAt(camera.forward * -8.0), camera, 16).unseen, Unseen::behindCamera);
    EXPECT_EQ(seenBy(cubeAt(camera.eyeMetres + camera.right), camera, 16).unseen,
              Unseen::behindCamera);
    EXPECT_TRUE(seenBy(cubeAt(camera.forward * -8.0), camera, 16).shown.empty());
    // A radius of 0.99 and of 1.01 screen pixels.
    const double radius = cubeAt(glm::dvec3(0.0)).radiusMetres();
    const double depth = radius / camera.metresPerScreenPx(1.0);
    EXPECT_EQ(seenBy(cubeAt(camera.eyeMetres + camera.forward * (depth * 1.01)), camera, 16).unseen,
              Unseen::subPixel);
    EXPECT_EQ(
        seenBy(cubeAt(camera.eyeMetres + camera.forward * (depth * 0.99)), camera, 16).shown.size(),
        1u);
    EXPECT_EQ(seenBy(cubeAt(glm::dvec3(0.0), {0, 0, 0}), camera, 16).unseen, Unseen::emptyModel);
    // Close up, the eye inside the sphere, a snapshot is still a flat picture.
    EXPECT_EQ(seenBy(cubeAt(camera.eyeMetres + camera.forward * 0.2), camera, 16).shown.size(), 1u);
    PlacedEntity nowhere = cubeAt(glm::dvec3(0.0));
    nowhere.anchorMetres.x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(seeSnapshots(nowhere, camera, ViewSet(), 16, {}));
}

TEST(SnapshotBlit, OfEveryCanonicalViewTheSnapshotIsTheViewFromThere) {
    const PlacedEntity entity = cubeAt(glm::dvec3(0.0));
    const ViewSet views;
    for (int view = 0; view < views.count(); ++view) {
        const SeenSnapshots seen = seenBy(entity, cameraAt(views, view, 7.0, {100, 100}), 16);
        EXPECT_EQ(seen.shown.at(0).view, view);
        EXPECT_NEAR(seen.degreesOff, 0.0, 1e-9);
    }
}

// From afar, at one of its views, a perspective snapshot is nearly the perspective picture.
TEST(SnapshotBlit, AtItsViewItShowsTheModel) {
    const Octree octree = must(bake(figure()));
    const GameProfile profile;
    const PlacedEntity entity = centred(octree, profile);
    const ViewSet views;
    for (const int view : {3, 16, 25}) {
        // As far away as its own eye.
        const Camera camera =
            cameraAt(views, view, kSnapshotDistance * entity.radiusMetres(), {120, 120});
        const int edge = 256;
        const Snapshot snapshot = castSnapshot(octree.view(), lightOf(profile), views, view, edge);
        SnapshotCanvas canvas(camera.viewportPx, Rgba8(0));
        draw(snapshot, seenBy(entity, camera, edge).shown.at(0).plane, camera, canvas);
        int other = 0;
        int shown = 0;
        for (int row = 0; row < 120; ++row) {
            for (int column = 0; column < 120; ++column) {
                const Camera::Ray ray = camera.rayThrough(glm::dvec2(column, row) + 0.5);
                const RaycastHit hit = raycast(octree.view(), {voxelFromWorld(ray.origin) / 0.1 +
                                                                   glm::dvec3(octree.size) * 0.5,
                                                               voxelFromWorld(ray.direction)});
                const bool covered = canvas.colours.at(column, row).w == 255;
                shown += covered ? 1 : 0;
                other += covered != hit.hit ? 1 : 0;
            }
        }
        EXPECT_GT(shown, 30);
        EXPECT_LE(other, shown / 8) << view;
    }
}

TEST(SnapshotBlit, EachPixelsOwnDepthLetsThingsStandInEachOther) {
    // A wall that runs away from the eye, half of it before a plane and half behind.
    VoxelGrid voxels;
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 12; ++x)
            for (int z = 0; z < 12; ++z)
                if (x == y) voxels.set({x, y, z}, 3);
    const Octree octree = baked(voxels, {12, 12, 12});
    const GameProfile profile;
    const PlacedEntity entity = centred(octree, profile);
    const Camera camera = cameraAt(ViewSet(), 3, 6.0, {200, 200});
    const Snapshot snapshot = castSnapshot(octree.view(), lightOf(profile), ViewSet(), 3, 128);
    const auto drawn = [&](SnapshotDepth depth) {
        SnapshotCanvas canvas(camera.viewportPx, kBackground);
        canvas.depths.assign(canvas.depths.size(), camera.reversedDepth(6.0));
        draw(snapshot, seenBy(entity, camera, 128, {.depth = depth}).shown.at(0).plane, camera,
             canvas, depth);
        return canvas;
    };
    const SnapshotCanvas flat = drawn(SnapshotDepth::centre);
    const SnapshotCanvas deep = drawn(SnapshotDepth::perPixel);
    int left = 0;
    int right = 0;
    for (int row = 0; row < 200; ++row) {
        for (int column = 0; column < 200; ++column) {
            EXPECT_EQ(flat.colours.at(column, row), kBackground);  // no nearer than the plane
            if (deep.colours.at(column, row) == kBackground) continue;
            ++(column < 100 ? left : right);
            // x == y: as far before the plane as it is left of the middle, to a voxel.
            const double metres = (column + 0.5 - 100.0) * camera.metresPerScreenPx(6.0);
            const double depth =
                camera.nearMetres / deep.depths[static_cast<std::size_t>(200 * row + column)];
            EXPECT_NEAR(depth, 6.0 + metres, 0.13);
        }
    }
    EXPECT_GT(left, 200);
    EXPECT_LT(right, left / 10);
}

TEST(SnapshotBlit, ABlendIsTheMeanOfWhatIsNotSky) {
    const Camera camera = frontCamera(6.0);
    Snapshot red = checkers(16);
    Snapshot blue = checkers(16, {0, 0}, {8, 16});
    for (std::size_t at = 0; at < 256; ++at) {
        red.buffer.colours[at] = Rgba8(200, 0, 0, 255);
        if (blue.buffer.ids[at] != kIdEmpty) blue.buffer.colours[at] = Rgba8(0, 0, 100, 255);
    }
    const SpriteView plane = seenBy(cubeAt(glm::dvec3(0.0)), camera, 16).shown.at(0).plane;
    const auto mixed = [&](double redWeight) {
        SnapshotCanvas canvas(camera.viewportPx, kBackground);
        const BlitSource sources[] = {{&red, &plane, redWeight}, {&blue, &plane, 1.0 - redWeight}};
        blitSnapshots(sources, 0.1, SnapshotDepth::centre, camera, canvas);
        return std::pair(canvas.colours.at(140, 100), canvas.colours.at(160, 100));
    };
    EXPECT_EQ(mixed(0.75), std::pair(Rgba8(200, 0, 0, 255), Rgba8(150, 0, 25, 255)));
    EXPECT_EQ(mixed(0.25), std::pair(kBackground, Rgba8(50, 0, 75, 255)));
    // Between views three are shown, at a view it alone.
    const ViewSet views;
    SnapshotChoice blend;
    blend.blend = true;
    const Camera between = orbitCamera({20.0, 20.0, 0.0}, glm::dvec3(0.0), 6.0, 45.0, {99, 99});
    const SeenSnapshots three = seenBy(cubeAt(glm::dvec3(0.0)), between, 16, blend);
    ASSERT_EQ(three.shown.size(), 3u);
    EXPECT_NEAR(three.shown[0].weight + three.shown[1].weight + three.shown[2].weight, 1.0, 1e-12);
    EXPECT_GT(seenBy(cubeAt(glm::dvec3(0.0)), camera, 16, blend).shown.at(0).weight, 1.0 - 1e-6);
}

// Kind `sprite`: through the cache of snapshots the picture is the exact sprite's, pixel by pixel.
TEST(SpriteSnapshotBlit, EqualsTheCompositeOfTheExactSprite) {
    const ViewSet sets[] = {ViewSet(), must(ViewSet::octahedral(12))};
    for (const auto& [name, octree] : smallModels()) {
        for (const ViewSet& views : sets) {
            for (const double sigma : {1.0, 1.5, 4.0}) {
                GameProfile profile;
                profile.sigma = sigma;
                profile.minification = false;
                for (int view = 0; view < views.count(); view += views.count() / 6) {
                    profile.view = view % 2 == 0 ? ViewRule::towardEntity : ViewRule::cameraForward;
                    profile.registration =
                        view % 3 == 0 ? Registration::anchor : Registration::modelCentre;
                    profile.depth = view % 4 < 2 ? DepthRule::perPixel : DepthRule::groundSafe;
                    PlacedEntity entity = centred(octree, profile);
                    const Camera camera = cameraAt(views, view, 6.0, {160, 120});
                    const SpriteView exact = must(viewSprite(entity, camera, profile)).view.value();
                    const SpriteBuffer buffer =
                        castSprite(octree.view(), exact.lattice,
                                   litPalette(manyColours(), exact.light8, profile.outline));
                    const bool deep = profile.depth == DepthRule::perPixel;
                    const std::vector<float> depths = pixelDepths(exact, octree.view(), buffer);
                    const CompositeSprite sprite{&exact, &buffer, deep ? &depths : nullptr};
                    const Image expected = composite({&sprite, 1}, camera, kBackground);

                    const SpriteView plane =
                        must(viewSnapshot(entity, camera, profile, views)).view.value();
                    const Snapshot snapshot = must(castSpriteSnapshot(
                        octree.view(), lightOf(profile), views, *plane.viewOfSet, sigma));
                    SnapshotCanvas canvas(camera.viewportPx, kBackground);
                    draw(snapshot, plane, camera, canvas,
                         deep ? SnapshotDepth::perPixel : SnapshotDepth::centre);
                    EXPECT_EQ(canvas.colours, expected) << name << ' ' << views.name() << view;
                }
            }
        }
    }
}

TEST(SpriteSnapshotBlit, PixelDepthsAreThoseOfTheExactSprite) {
    const Octree octree = must(bake(figure()));
    GameProfile profile;
    profile.depth = DepthRule::perPixel;
    profile.minification = false;
    const PlacedEntity entity = centred(octree, profile);
    const ViewSet views;
    const Camera camera = cameraAt(views, 16, 5.0, {300, 300});
    const SpriteView exact = must(viewSprite(entity, camera, profile)).view.value();
    const Snapshot snapshot =
        must(castSpriteSnapshot(octree.view(), lightOf(profile), views, 16, profile.sigma));
    const std::vector<float> expected = pixelDepths(exact, octree.view(), snapshot.buffer);
    SnapshotCanvas canvas(camera.viewportPx, kBackground);
    draw(snapshot, exact, camera, canvas, SnapshotDepth::perPixel);
    int compared = 0;
    for (int row = 0; row < 300; ++row) {
        for (int column = 0; column < 300; ++column) {
            const float depth = canvas.depths[static_cast<std::size_t>(300 * row + column)];
            if (depth == 0.0f) continue;
            const glm::ivec2 pixel =
                pixelUnder(exact, camera, glm::dvec2(column, row) + 0.5).value() -
                exact.lattice.first;
            const int line = exact.lattice.size.y - 1 - pixel.y;
            const float metres =
                expected[static_cast<std::size_t>(line * exact.lattice.size.x + pixel.x)];
            EXPECT_NEAR(camera.nearMetres / depth, metres, 1e-3);
            ++compared;
        }
    }
    EXPECT_GT(compared, 1000);
}

}  // namespace
}  // namespace voxprite::test
