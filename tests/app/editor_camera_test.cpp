// What moves the cameras: habits of the hand, turns, the view cube, views kept under a name.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/editor/views/camera_bookmarks.h"
#include "app/editor/views/camera_turn.h"
#include "app/editor/views/navigation.h"
#include "app/editor/views/view_canvas.h"
#include "app/editor/views/view_cube.h"
#include "tests/support/random.h"

namespace voxprite::editor {
namespace {

constexpr glm::ivec2 kView(460, 700);
constexpr int kLeft = 0, kRight = 1, kMiddle = 2;
constexpr HeldKeys kNone{}, kShift{true, false, false}, kControl{false, true, false},
    kSpace{false, false, true};

TEST(EditorNavigation, PresetsAreTheHabitsOfTheirPrograms) {
    using enum NavigationPreset;
    using enum CameraMove;
    EXPECT_EQ(moveByDrag(magicaVoxel, kRight, kNone), orbit);
    EXPECT_EQ(moveByDrag(magicaVoxel, kMiddle, kNone), pan);
    EXPECT_EQ(moveByDrag(magicaVoxel, kLeft, kSpace), pan);
    EXPECT_EQ(moveByDrag(blender, kMiddle, kNone), orbit);
    EXPECT_EQ(moveByDrag(blender, kMiddle, kShift), pan);
    EXPECT_EQ(moveByDrag(blender, kMiddle, kControl), zoom);
    EXPECT_EQ(moveByDrag(goxel, kMiddle, kNone), orbit);
    EXPECT_EQ(moveByDrag(goxel, kRight, kNone), pan);
    EXPECT_EQ(moveByWheel(trackpad, kNone), orbit);
    EXPECT_EQ(moveByWheel(trackpad, kShift), pan);
    EXPECT_EQ(moveByWheel(trackpad, kControl), zoom);
    for (const NavigationPreset preset : {magicaVoxel, blender, goxel, trackpad}) {
        // The left button is the tools', in every program, with any key but Space.
        EXPECT_EQ(moveByDrag(preset, kLeft, kNone), none);
        EXPECT_EQ(moveByDrag(preset, kLeft, kShift), none);
        EXPECT_EQ(moveByDrag(preset, kLeft, kSpace), pan);
        if (preset == trackpad) continue;
        EXPECT_EQ(moveByWheel(preset, kShift), zoom);
    }
}

TEST(EditorNavigation, TheWheelZoomsToThePointerAndCanBeReversed) {
    ViewInput input;
    input.sizePx = kView;
    input.pointerPx = {100, 200};
    input.wheel = 2.0;
    OrbitCamera nearer, farther;
    ViewCanvas::navigate(input, nearer);
    EXPECT_LT(nearer.distance, OrbitCamera{}.distance);
    input.invertWheel = true;
    ViewCanvas::navigate(input, farther);
    EXPECT_GT(farther.distance, OrbitCamera{}.distance);
    // Two fingers: the picture follows them, as under a drag.
    input.roll = CameraMove::orbit;
    input.wheelAcross = -1.0;
    OrbitCamera turned;
    ViewCanvas::navigate(input, turned);
    EXPECT_GT(turned.yawDegrees, OrbitCamera{}.yawDegrees);
    EXPECT_EQ(turned.distance, OrbitCamera{}.distance);
}

TEST(EditorOrbitCamera, WithoutPerspectiveTheTargetKeepsItsSize) {
    test::Random random(5);
    for (int i = 0; i < 50; ++i) {
        OrbitCamera orbit;
        orbit.yawDegrees = random.unit() * 360 - 180;
        orbit.pitchDegrees = random.unit() * 180 - 90;
        orbit.distance = std::exp(random.unit() * 6 - 1);
        const glm::dvec3 beside = orbit.target + orbit.camera(kView).right * orbit.distance * 0.1;
        const glm::dvec2 with = orbit.camera(kView).project(beside).screenPx;
        orbit.orthographic = true;
        const glm::dvec2 without = orbit.camera(kView).project(beside).screenPx;
        EXPECT_NEAR(with.x, without.x, 1e-6);
        EXPECT_NEAR(with.y, without.y, 1e-6);
        // And nothing is nearer than anything: depth does not move a point.
        const Camera camera = orbit.camera(kView);
        const glm::dvec2 behind = camera.project(beside + camera.forward * 7.0).screenPx;
        EXPECT_NEAR(behind.x, without.x, 1e-6);

        const glm::dvec2 pointer(random.unit() * kView.x, random.unit() * kView.y);
        const glm::dvec3 under = camera.rayThrough(pointer).origin;
        orbit.zoom(3.0, pointer, kView);
        const glm::dvec2 after = orbit.camera(kView).project(under).screenPx;
        EXPECT_NEAR(after.x, pointer.x, 1e-6);
        EXPECT_NEAR(after.y, pointer.y, 1e-6);
    }
}

TEST(EditorOrbitCamera, LooksAtTheSameVoxelOfATurnedBox) {
    test::Random random(6);
    const IBox bounds{{-3, 2, 5}, {9, 11, 20}};
    for (int i = 0; i < 50; ++i) {
        Entity entity;
        entity.yawDegrees = random.unit() * 360 - 180;
        entity.pitchDegrees = random.unit() * 180 - 90;
        entity.rollDegrees = random.unit() * 360 - 180;
        entity.scale = 0.5 + random.unit();
        entity.positionMetres = {random.unit(), random.unit(), random.unit()};
        const PlacedEntity inEdit = Session::placedForEditing(bounds);
        const PlacedEntity inGame = placeEntity(entity, bounds, GameProfile{});
        const glm::dvec3 voxel(random.unit() * 20, random.unit() * 20, random.unit() * 20);
        OrbitCamera edit, sprite;
        edit.target = inEdit.worldFromVoxel(voxel);
        edit.yawDegrees = random.unit() * 360 - 180;
        edit.pitchDegrees = random.unit() * 180 - 90;
        edit.orthographic = true;
        sprite.lookLike(edit, inEdit, inGame);
        EXPECT_NEAR(glm::distance(sprite.target, inGame.worldFromVoxel(voxel)), 0.0, 1e-9);
        EXPECT_EQ(sprite.yawDegrees, edit.yawDegrees);
        EXPECT_EQ(sprite.pitchDegrees, edit.pitchDegrees);
        EXPECT_NEAR(sprite.distance, edit.distance * inGame.metresPerVoxel(), 1e-9);
        EXPECT_TRUE(sprite.orthographic);

        OrbitCamera again;
        again.lookLike(sprite, inGame, inEdit);
        EXPECT_NEAR(glm::distance(again.target, edit.target), 0.0, 1e-9);
        EXPECT_NEAR(again.distance, edit.distance, 1e-9);
    }
}

TEST(EditorCameraTurn, ArrivesExactlyWithinAFifthOfASecondTheShorterWay) {
    OrbitCamera camera, wanted;
    camera.yawDegrees = 170;
    camera.pitchDegrees = 10;
    wanted.yawDegrees = -170;
    wanted.pitchDegrees = 90;
    CameraTurn turn;
    turn.start(camera, wanted);
    double seconds = 0.0;
    while (turn.running()) {
        turn.advance(camera, 1.0 / 60.0);
        seconds += 1.0 / 60.0;
        // By 180, not by way of 0.
        EXPECT_GT(std::abs(std::remainder(camera.yawDegrees, 360.0)), 165.0);
        ASSERT_LT(seconds, 0.2);
    }
    EXPECT_EQ(camera.yawDegrees, wanted.yawDegrees);
    EXPECT_EQ(camera.pitchDegrees, wanted.pitchDegrees);
    EXPECT_GT(seconds, 0.05);
}

TEST(EditorCameraTurn, AHandOnTheCameraEndsIt) {
    OrbitCamera camera, wanted;
    wanted.yawDegrees = 90;
    CameraTurn turn;
    turn.start(camera, wanted);
    turn.advance(camera, 0.02);
    camera.orbit({5, 0});
    const OrbitCamera moved = camera;
    turn.advance(camera, 0.02);
    EXPECT_FALSE(turn.running());
    EXPECT_EQ(camera, moved);
}

TEST(EditorViewCube, EachFaceEdgeAndCornerLooksFromThere) {
    for (int i = 0; i < 27; ++i) {
        const glm::ivec3 part(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        if (part == glm::ivec3(0)) continue;
        OrbitCamera camera;
        camera.yawDegrees = 77;
        camera.lookFrom(glm::dvec3(part));
        // The eye, in voxel axes, is where the part points.
        const glm::dvec3 eye =
            voxelFromWorld(camera.camera(kView).eyeMetres - camera.target) / camera.distance;
        const glm::dvec3 toward = glm::normalize(glm::dvec3(part));
        EXPECT_NEAR(glm::dot(eye, toward), 1.0, 1e-12);
        // And in the middle of the cube is the part itself.
        EXPECT_EQ(viewCubePartAt(camera, 20.0, {0.0, 0.0}), part);
        const bool level = part.x != 0 || part.y != 0;
        EXPECT_TRUE(level || std::remainder(camera.yawDegrees, 90.0) == 0.0);
    }
}

TEST(EditorViewCube, ThePartUnderThePointerIsTheOneThatIsDrawnThere) {
    test::Random random(9);
    int hits = 0;
    for (int i = 0; i < 400; ++i) {
        OrbitCamera camera;
        camera.yawDegrees = random.unit() * 360 - 180;
        camera.pitchDegrees = random.unit() * 170 - 85;
        camera.orthographic = true;
        camera.target = glm::dvec3(0.0);
        // A point of the cube's surface that looks this way, seen by the camera itself.
        const int axis = random.between(0, 2);
        glm::dvec3 point(random.unit() * 2 - 1, random.unit() * 2 - 1, random.unit() * 2 - 1);
        const Camera eye = camera.camera({2, 2});
        const glm::dvec3 forward = voxelFromWorld(eye.forward);
        if (std::abs(forward[axis]) < 0.05) continue;
        point[axis] = forward[axis] < 0 ? 1.0 : -1.0;
        const glm::dvec3 world = worldFromVoxel(point) * 20.0;
        const glm::dvec2 px(glm::dot(world, eye.right), -glm::dot(world, eye.up));
        const auto part = viewCubePartAt(camera, 20.0, px);
        ASSERT_TRUE(part);
        for (int a = 0; a < 3; ++a) {
            const double size = std::abs(point[a]);
            if (std::abs(size - 0.56) < 1e-9) continue;
            const int expected = size > 0.56 ? (point[a] > 0 ? 1 : -1) : 0;
            EXPECT_EQ((*part)[a], expected);
        }
        ++hits;
    }
    EXPECT_GT(hits, 300);
    EXPECT_EQ(viewCubePartAt(OrbitCamera{}, 20.0, {41.0, 0.0}), std::nullopt);
}

TEST(EditorSavedCamera, ShowsEveryModelFromTheSameSideAsLarge) {
    OrbitCamera camera;
    camera.yawDegrees = 33;
    camera.pitchDegrees = -12;
    camera.target = {4, 5, 6};
    camera.distance = 50;
    camera.orthographic = true;
    const ModelSphere here{{3, 3, 3}, 10.0};
    const SavedCamera saved = savedFrom(camera, here, "Hero");
    const OrbitCamera again = cameraFrom(saved, here);
    EXPECT_NEAR(glm::distance(again.target, camera.target), 0.0, 1e-12);
    EXPECT_EQ(again.yawDegrees, 33.0);
    EXPECT_EQ(again.pitchDegrees, -12.0);
    EXPECT_NEAR(again.distance, 50.0, 1e-12);
    EXPECT_TRUE(again.orthographic);

    // A point of the sphere is at the same place on screen with any sphere.
    const ModelSphere there{{-100, 0, 7}, 0.25};
    const OrbitCamera other = cameraFrom(saved, there);
    const glm::dvec3 unit = glm::normalize(glm::dvec3(1, 2, -2));
    const glm::dvec2 a = camera.camera(kView).project(here.centre + unit * here.radius).screenPx;
    const glm::dvec2 b = other.camera(kView).project(there.centre + unit * there.radius).screenPx;
    EXPECT_NEAR(a.x, b.x, 1e-6);
    EXPECT_NEAR(a.y, b.y, 1e-6);
}

}  // namespace
}  // namespace voxprite::editor
