// What a snapshot holds: its camera, its pixels, and the sprite that the other kind is.
#include "core/billboard/snapshot.h"

#include <cmath>
#include <limits>

#include "core/sprite/sprite_view.h"
#include "tests/core/billboard/snapshot_support.h"

namespace voxprite::test {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(SnapshotCamera, StandsEightRadiiFromTheCentreAndFramesTheSphere) {
    const glm::ivec3 size{32, 16, 65};
    const ViewSet views;
    for (int view = 0; view < views.count(); ++view) {
        const SnapshotCamera camera(views, view, size, kUsualSnapshotPx);
        EXPECT_EQ(camera.sizePx, 128);
        EXPECT_EQ(camera.centre, glm::dvec3(16.0, 8.0, 32.5));  // of the box, rounded to nothing
        EXPECT_NEAR(camera.radius, 0.5 * std::sqrt(32.0 * 32 + 16 * 16 + 65 * 65), 1e-12);
        EXPECT_NEAR(glm::length(camera.eye - camera.centre), 8.0 * camera.radius, 1e-9);
        EXPECT_NEAR(camera.focalPx, 4.0 * 128, 1e-9);  // N D / 2R
        EXPECT_EQ(camera.axes, views.axes(view));
        // What is R beside the centre lies on the picture's edge.
        const glm::dvec2 edge = camera.project(camera.centre + camera.axes[0] * camera.radius);
        EXPECT_NEAR(edge.x, 128.0, 1e-9);
        EXPECT_NEAR(edge.y, 64.0, 1e-9);
        const glm::dvec2 above = camera.project(camera.centre + camera.axes[1] * camera.radius);
        EXPECT_NEAR(above.y, 0.0, 1e-9);
        // All of the box is in the picture, but for what perspective makes of the sphere's rim.
        const double most = 64.0 * 8.0 / std::sqrt(63.0) + 1e-9;
        for (unsigned octant = 0; octant < 8; ++octant) {
            const glm::dvec2 corner =
                camera.project(glm::dvec3(size) * glm::dvec3(octantCorner(octant)));
            EXPECT_LE(std::hypot(corner.x - 64.0, corner.y - 64.0), most);
        }
    }
    // A radius of at least one voxel, so that nothing is framed by nothing.
    EXPECT_EQ(SnapshotCamera(views, 0, {1, 1, 1}, 16).radius, 1.0);
    EXPECT_EQ(SnapshotCamera(views, 0, {0, 0, 0}, 16).distance, 8.0);
}

TEST(SnapshotCamera, SeesAtAPixelWhatItsRayMeets) {
    const ViewSet views;
    for (const int view : {0, 5, 13, 25}) {
        const SnapshotCamera camera(views, view, {9, 4, 7}, 50);
        for (const auto& [column, row] : {std::pair(0, 0), std::pair(49, 3), std::pair(20, 41)}) {
            const Ray ray = camera.rayThrough(column, row);
            for (const double t : {1.0, 30.0}) {
                const glm::dvec2 seen = camera.project(ray.origin + ray.direction * t);
                EXPECT_NEAR(seen.x, column + 0.5, 1e-9);
                EXPECT_NEAR(seen.y, row + 0.5, 1e-9);
            }
        }
    }
}

struct Nearest {
    std::uint32_t id = kIdEmpty;
    double distance = kInfinity;
    double second = kInfinity;
};

// Every solid voxel's cube against the ray.
Nearest bruteForce(const Octree& octree, const std::vector<glm::ivec3>& solid, const Ray& ray) {
    Nearest nearest;
    const glm::dvec3 direction = glm::normalize(ray.direction);
    for (const glm::ivec3 voxel : solid) {
        double enter = 0.0;
        double leave = kInfinity;
        for (int a = 0; a < 3; ++a) {
            const double first = (voxel[a] - ray.origin[a]) / direction[a];
            const double last = (voxel[a] + 1 - ray.origin[a]) / direction[a];
            enter = std::max(enter, std::min(first, last));
            leave = std::min(leave, std::max(first, last));
        }
        if (!(enter < leave)) continue;
        if (enter < nearest.distance) {
            nearest.second = nearest.distance;
            nearest.distance = enter;
            nearest.id =
                kIdFirstVoxel + static_cast<std::uint32_t>(
                                    voxel.x + octree.size.x * (voxel.y + octree.size.y * voxel.z));
        } else {
            nearest.second = std::min(nearest.second, enter);
        }
    }
    return nearest;
}

TEST(Snapshots, EveryPixelIsTheNearestVoxelOnItsRay) {
    const GameProfile profile;
    const SnapshotLight light = lightOf(profile);
    const ViewSet views;
    const int edge = 24;
    int pixels = 0;
    int other = 0;
    for (const auto& [name, octree] : smallModels()) {
        std::vector<glm::ivec3> solid;
        for (int z = 0; z < octree.size.z; ++z)
            for (int y = 0; y < octree.size.y; ++y)
                for (int x = 0; x < octree.size.x; ++x)
                    if (materialAt(octree.view(), {x, y, z}) != 0) solid.push_back({x, y, z});
        for (int view = 0; view < views.count(); ++view) {
            const SnapshotCamera camera(views, view, octree.size, edge);
            const Snapshot snapshot = castSnapshot(octree.view(), light, views, view, edge);
            ASSERT_EQ(snapshot.buffer.size, glm::ivec2(edge));
            EXPECT_EQ(snapshot.view, view);
            for (int row = 0; row < edge; ++row) {
                for (int column = 0; column < edge; ++column) {
                    const auto at = static_cast<std::size_t>(row * edge + column);
                    const Nearest nearest =
                        bruteForce(octree, solid, camera.rayThrough(column, row));
                    ++pixels;
                    if (snapshot.buffer.ids[at] != nearest.id) {
                        ++other;
                        continue;
                    }
                    if (nearest.id == kIdEmpty) {
                        EXPECT_EQ(snapshot.buffer.colours[at], Rgba8(0));
                        EXPECT_EQ(snapshot.depth[at], kInfinity);
                    } else {
                        EXPECT_EQ(snapshot.buffer.colours[at].w, 255);
                        EXPECT_NEAR(snapshot.depth[at], nearest.distance, 1e-3) << name;
                    }
                }
            }
        }
    }
    // Rays through edges of voxels may be seen to pass on either side.
    EXPECT_LE(other, pixels / 2000) << "of " << pixels;
}

TEST(Snapshots, ColoursAreThoseOfTheLitFaces) {
    GameProfile profile;
    const Palette palette = manyColours();
    const Octree cube = must(bake(solidBox({8, 8, 8}, 5)));
    const ViewSet views;
    const glm::dvec3 towardLight = voxelAxesFromWorld() * profile.light.towardLight;
    for (int view = 0; view < 6; ++view) {
        const Snapshot snapshot =
            castSnapshot(cube.view(), lightOf(profile, palette), views, view, 32);
        // Straight from a side nothing else shows: one face, one colour.
        const glm::ivec3 along(-views.direction(view));
        const int axis = view / 2;
        const std::uint8_t light8 =
            faceLight(along, towardLight, profile.light.ambient)[static_cast<std::size_t>(axis)];
        const Rgba8 base = palette.colours[5];
        const Rgba8 expected((base.x * light8 + 127) / 255, (base.y * light8 + 127) / 255,
                             (base.z * light8 + 127) / 255, 255);
        for (std::size_t at = 0; at < snapshot.buffer.ids.size(); ++at)
            EXPECT_EQ(snapshot.buffer.colours[at],
                      snapshot.buffer.ids[at] == kIdEmpty ? Rgba8(0) : expected)
                << view;
    }
}

TEST(Snapshots, ShowTheModelUprightAndNotMirrored) {
    // One voxel high up at the right, as seen from -y.
    VoxelGrid voxels;
    voxels.set({6, 3, 6}, 1);
    const Octree octree = baked(voxels, {7, 7, 7});
    const Snapshot front = castSnapshot(octree.view(), lightOf(GameProfile{}), ViewSet(), 3, 64);
    glm::dvec2 mean(0.0);
    int count = 0;
    for (int row = 0; row < 64; ++row)
        for (int column = 0; column < 64; ++column)
            if (front.buffer.ids[static_cast<std::size_t>(64 * row + column)] != kIdEmpty) {
                mean += glm::dvec2(column, row);
                ++count;
            }
    ASSERT_GT(count, 0);
    EXPECT_GT(mean.x / count, 40.0);
    EXPECT_LT(mean.y / count, 24.0);
}

TEST(Snapshots, OfAnEmptyModelAreAllSky) {
    const Octree empty;
    const ViewSet views;
    for (int view = 0; view < views.count(); ++view) {
        const Snapshot snapshot =
            castSnapshot(empty.view(), lightOf(GameProfile{}), views, view, 16);
        EXPECT_EQ(snapshot.buffer.colours, UnfilledVector<Rgba8>(256, Rgba8(0)));
        EXPECT_EQ(snapshot.buffer.ids, UnfilledVector<std::uint32_t>(256, kIdEmpty));
        EXPECT_EQ(snapshot.depth, std::vector<float>(256, kInfinity));
    }
}

TEST(Snapshots, DoNotDependOnThreads) {
    const Octree octree = must(bake(figure()));
    const SnapshotLight light = lightOf(GameProfile{});
    EXPECT_TRUE(same(castSnapshot(octree.view(), light, ViewSet(), 25, 60, 1),
                     castSnapshot(octree.view(), light, ViewSet(), 25, 60, 0)));
}

TEST(Snapshots, HaveTheSpritesOcclusionAndShadow) {
    GameProfile profile;
    const Octree octree = must(bake(figure()));
    const Snapshot plain = castSnapshot(octree.view(), lightOf(profile), ViewSet(), 25, 64);
    profile.light.occlusion = 1.0;
    const Snapshot occluded = castSnapshot(octree.view(), lightOf(profile), ViewSet(), 25, 64);
    profile.light.shadow = 1.0;
    const Snapshot shadowed = castSnapshot(octree.view(), lightOf(profile), ViewSet(), 25, 64);
    EXPECT_EQ(plain.buffer.ids, occluded.buffer.ids);
    int darker = 0;
    int darkerStill = 0;
    for (std::size_t at = 0; at < plain.buffer.ids.size(); ++at) {
        EXPECT_LE(occluded.buffer.colours[at].x, plain.buffer.colours[at].x);
        EXPECT_LE(shadowed.buffer.colours[at].x, occluded.buffer.colours[at].x);
        darker += occluded.buffer.colours[at] != plain.buffer.colours[at] ? 1 : 0;
        darkerStill += shadowed.buffer.colours[at] != occluded.buffer.colours[at] ? 1 : 0;
    }
    EXPECT_GT(darker, 20);
    EXPECT_GT(darkerStill, 20);
}

// Kind `sprite`: at one of its views a snapshot is what viewSprite shows, of which it is the cast.
TEST(SpriteSnapshots, AreTheVerySpritesOfTheirViews) {
    const ViewSet sets[] = {ViewSet(), must(ViewSet::octahedral(8)), must(ViewSet::hemisphere(12))};
    for (const auto& [name, octree] : smallModels()) {
        for (const ViewSet& views : sets) {
            for (const double sigma : {0.5, 3.0, 4.0}) {
                GameProfile profile;
                profile.sigma = sigma;
                profile.minification = false;
                const PlacedEntity entity = centred(octree, profile);
                for (int view = 0; view < views.count(); view += views.count() / 7) {
                    const Camera camera = cameraAt(views, view, 9.0, {200, 200});
                    for (const ViewRule rule : {ViewRule::towardEntity, ViewRule::cameraForward}) {
                        profile.view = rule;
                        const auto exact = must(viewSprite(entity, camera, profile)).view;
                        const auto snapped =
                            must(viewSnapshot(entity, camera, profile, views)).view;
                        ASSERT_TRUE(exact && snapped);
                        ASSERT_EQ(snapped->viewOfSet, view) << name << ' ' << views.name();
                        EXPECT_NEAR(snapped->degreesOff, 0.0, 1e-9);
                        EXPECT_EQ(exact->lattice, snapped->lattice) << name << ' ' << view;
                        EXPECT_EQ(exact->right, snapped->right);
                        EXPECT_EQ(exact->up, snapped->up);
                        EXPECT_EQ(exact->light8, snapped->light8);
                        const SnapshotLight light = lightOf(profile);
                        const Snapshot snapshot =
                            must(castSpriteSnapshot(octree.view(), light, views, view, sigma));
                        const SpriteBuffer sprite =
                            castSprite(octree.view(), exact->lattice,
                                       litPalette(manyColours(), exact->light8, profile.outline));
                        EXPECT_EQ(snapshot.buffer.first, sprite.first);
                        EXPECT_EQ(snapshot.buffer.ids, sprite.ids);
                        EXPECT_EQ(snapshot.buffer.colours, sprite.colours);
                    }
                }
            }
        }
    }
}

TEST(SpriteSnapshots, BetweenTheirViewsTheNearestIsShownWholeAndTurnedToMatch) {
    const Octree octree = must(bake(figure()));
    GameProfile profile;
    profile.minification = false;
    const PlacedEntity entity = centred(octree, profile);
    ViewSet views;
    // Some 12 degrees from the pole, upright: the pole's own up is off by most of a quarter turn.
    const Camera camera = orbitCamera({20.0, 78.0, 0.0}, glm::dvec3(0.0), 9.0, 45.0, {200, 200});
    const SpriteView seen = must(viewSnapshot(entity, camera, profile, views)).view.value();
    EXPECT_EQ(seen.viewOfSet, 4);
    EXPECT_NEAR(seen.degreesOff, 12.0, 1e-6);
    EXPECT_EQ(seen.lattice, must(snapshotLattice(views, 4, profile.sigma, octree.size)));
    // Points of the model are drawn near their true places ...
    const auto meanOff = [&](const SpriteView& shown) {
        double sum = 0.0;
        for (const glm::dvec3 point : {glm::dvec3(8, 0, 0), glm::dvec3(0, 8, 0)}) {
            const glm::dvec3 drawn = shown.right * glm::dot(shown.ortho.right, point) +
                                     shown.up * glm::dot(shown.ortho.up, point);
            const glm::dvec3 world = worldFromVoxel(point);
            const glm::dvec3 truth = camera.right * glm::dot(camera.right, world) +
                                     camera.up * glm::dot(camera.up, world);
            sum += 0.5 * glm::length(drawn - truth);
        }
        return sum;
    };
    EXPECT_LT(meanOff(seen), 0.3);
    // ... and by the cache's own rule, without its roll matched, they are not.
    views.roll = SnapshotRoll::own;
    EXPECT_GT(meanOff(must(viewSnapshot(entity, camera, profile, views)).view.value()), 5.0);
    // Hysteresis: the view before stays a little past the middle.
    ViewHistory history;
    const auto viewAt = [&](double pitch) {
        const Camera eye = orbitCamera({0.0, pitch, 0.0}, glm::dvec3(0.0), 9.0, 45.0, {200, 200});
        return *must(viewSnapshot(entity, eye, profile, views, &history)).view->viewOfSet;
    };
    const int side = viewAt(0.0);
    EXPECT_EQ(viewAt(24.0), side);
    EXPECT_NE(viewAt(40.0), side);
    EXPECT_NE(viewAt(21.0), side);
    EXPECT_EQ(viewAt(10.0), side);
}

TEST(SpriteSnapshots, SmallerThanAScreenPixelAreNotSeen) {
    const Octree octree = must(bake(figure()));
    GameProfile profile;
    const PlacedEntity entity = centred(octree, profile);
    Camera camera = cameraAt(ViewSet(), 3, 1.0, {512, 512});
    const double depth = entity.radiusMetres() / camera.metresPerScreenPx(1.0);
    camera.eyeMetres = camera.forward * (-depth * 0.99);
    EXPECT_TRUE(must(viewSnapshot(entity, camera, profile, ViewSet())).view);
    camera.eyeMetres = camera.forward * (-depth * 1.01);
    EXPECT_EQ(must(viewSnapshot(entity, camera, profile, ViewSet())).unseen, Unseen::subPixel);
    EXPECT_TRUE(must(viewSprite(entity, camera, profile)).view);
}

}  // namespace
}  // namespace voxprite::test
