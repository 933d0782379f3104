// Looking around, the layout of the window, and the handles of the proxy box.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "app/editor/panels/layout.h"
#include "app/editor/views/gizmo.h"
#include "app/editor/views/orbit_camera.h"
#include "app/editor/views/view_canvas.h"
#include "tests/support/random.h"

namespace voxprite::editor {
namespace {

constexpr glm::ivec2 kView(460, 700);

OrbitCamera randomCamera(test::Random& random) {
    OrbitCamera camera;
    camera.target = {random.unit() * 100 - 50, random.unit() * 100 - 50, random.unit() * 100 - 50};
    camera.yawDegrees = random.unit() * 360 - 180;
    camera.pitchDegrees = random.unit() * 180 - 90;
    camera.distance = std::exp(random.unit() * 8 - 2);
    return camera;
}

TEST(EditorOrbitCamera, ZoomKeepsWhatLiesUnderThePointer) {
    test::Random random(1);
    for (int i = 0; i < 100; ++i) {
        OrbitCamera orbit = randomCamera(random);
        const glm::dvec2 pointer(random.unit() * kView.x, random.unit() * kView.y);
        const Camera before = orbit.camera(kView);
        const Camera::Ray ray = before.rayThrough(pointer);
        const double t = orbit.distance / glm::dot(ray.direction, before.forward);
        const glm::dvec3 under = ray.origin + ray.direction * t;
        orbit.zoom(random.unit() * 8 - 4, pointer, kView);
        const glm::dvec2 after = orbit.camera(kView).project(under).screenPx;
        EXPECT_NEAR(after.x, pointer.x, 1e-6);
        EXPECT_NEAR(after.y, pointer.y, 1e-6);
    }
}

TEST(EditorOrbitCamera, PanMovesThePictureWithThePointer) {
    test::Random random(2);
    for (int i = 0; i < 100; ++i) {
        OrbitCamera orbit = randomCamera(random);
        const glm::dvec3 target = orbit.target;
        const glm::dvec2 moved(random.unit() * 200 - 100, random.unit() * 200 - 100);
        orbit.pan(moved, kView);
        const glm::dvec2 after = orbit.camera(kView).project(target).screenPx;
        EXPECT_NEAR(after.x, kView.x * 0.5 + moved.x, 1e-6);
        EXPECT_NEAR(after.y, kView.y * 0.5 + moved.y, 1e-6);
    }
}

TEST(EditorOrbitCamera, OrbitTurnsTheNearSideWithThePointerAndStopsAtThePoles) {
    OrbitCamera orbit;
    orbit.yawDegrees = 0;
    orbit.pitchDegrees = 0;
    const glm::dvec3 nearSide = orbit.target - orbit.camera(kView).forward;
    orbit.orbit({30, 20});
    const glm::dvec2 after = orbit.camera(kView).project(nearSide).screenPx;
    EXPECT_GT(after.x, kView.x * 0.5);
    EXPECT_GT(after.y, kView.y * 0.5);
    orbit.orbit({0, 10'000});
    EXPECT_EQ(orbit.pitchDegrees, 90.0);
    orbit.orbit({0, -20'000});
    EXPECT_EQ(orbit.pitchDegrees, -90.0);
}

TEST(EditorOrbitCamera, FramingShowsAllAndFillsTheView) {
    test::Random random(3);
    for (int i = 0; i < 100; ++i) {
        OrbitCamera orbit = randomCamera(random);
        std::vector<glm::dvec3> corners;
        const glm::dvec3 size(random.unit() * 30 + 1, random.unit() * 30 + 1,
                              random.unit() * 30 + 1);
        for (int o = 0; o < 8; ++o) {
            corners.push_back(
                {(o & 1) != 0 ? size.x : 0, (o & 2) != 0 ? size.y : 0, (o & 4) != 0 ? size.z : 0});
        }
        orbit.frame(corners, 0.2, kView);
        double most = 0.0;
        for (const glm::dvec3 corner : corners) {
            const auto seen = orbit.camera(kView).project(corner);
            ASSERT_GT(seen.depthMetres, 0.0);
            const glm::dvec2 share = glm::abs(seen.screenPx / glm::dvec2(kView) - 0.5) * 2.0;
            most = std::max({most, share.x, share.y});
        }
        EXPECT_NEAR(most, 1.0 / 1.2, 1e-9);
    }
}

bool overlap(const Area& a, const Area& b) {
    return a.min.x < b.max().x && b.min.x < a.max().x && a.min.y < b.max().y && b.min.y < a.max().y;
}

// As an artist may have left the panels.
std::vector<WindowSettings> arrangements() {
    std::vector<WindowSettings> all;
    for (const float split : {0.15f, 0.5f, 0.85f}) {
        for (int folded = 0; folded < 8; ++folded) {
            WindowSettings& settings = all.emplace_back();
            settings.split = split;
            settings.showsTools = (folded & 1) == 0;
            settings.showsSide = (folded & 2) == 0;
            settings.showsDock = (folded & 4) == 0;
            settings.sideWidth = split < 0.5f ? kLeastSide : kMostSide;
            settings.dockShare = split > 0.5f ? kMostDock : kLeastDock;
        }
    }
    return all;
}

TEST(EditorLayout, PartsTouchButNeverOverlapAndStayInTheWindow) {
    for (const float scale : {1.0f, 1.25f, 1.5f, 2.0f}) {
        Theme theme;
        theme.scale = scale;
        for (const ImVec2 window : {ImVec2(1280, 800), ImVec2(1920, 1080), ImVec2(2560, 1600),
                                    ImVec2(1281, 803), ImVec2(640 * scale, 400 * scale)}) {
            for (const WindowSettings& settings : arrangements()) {
                const Layout layout = layoutFor(theme, window, settings, 90.0f * scale);
                std::vector<Area> areas{layout.menu,     layout.tools,   layout.options,
                                        layout.edit,     layout.divider, layout.sprite,
                                        layout.timeline, layout.sideBar, layout.inspector,
                                        layout.dockBar,  layout.dock,    layout.status};
                std::erase_if(areas, [](const Area& area) { return !area.shown(); });
                EXPECT_EQ(layout.tools.shown(), settings.showsTools);
                EXPECT_EQ(layout.dock.shown(), settings.showsSide);
                ASSERT_TRUE(layout.edit.shown() && layout.sprite.shown());
                for (std::size_t i = 0; i < areas.size(); ++i) {
                    EXPECT_GE(areas[i].min.x, 0.0f);
                    EXPECT_LE(areas[i].max().x, window.x);
                    EXPECT_LE(areas[i].max().y, window.y);
                    EXPECT_GE(areas[i].size.x, 1.0f);
                    EXPECT_GE(areas[i].size.y, 1.0f);
                    EXPECT_EQ(areas[i].min.x, std::round(areas[i].min.x));
                    for (std::size_t j = i + 1; j < areas.size(); ++j) {
                        EXPECT_FALSE(overlap(areas[i], areas[j])) << i << " and " << j;
                    }
                }
                EXPECT_EQ(layout.edit.max().x, layout.divider.min.x);
                EXPECT_EQ(layout.divider.max().x, layout.sprite.min.x);
                const Area& last = settings.showsSide ? layout.inspector : layout.sideBar;
                EXPECT_EQ(last.max().x, window.x);
            }
        }
    }
}

// A gizmo and a hand that drags it.
class EditorGizmo : public testing::Test {
  protected:
    EditorGizmo() {
        target.entity.positionMetres = {1.0, 0.0, -2.0};
        place();
        orbit.target = target.placed.anchorMetres;
        orbit.yawDegrees = 30;
        orbit.pitchDegrees = 35;
        orbit.distance = 8;
        camera = orbit.camera(kView);
    }
    void place() {
        target.placed = placeEntity(target.entity, IBox{{0, 0, 0}, {8, 6, 12}}, GameProfile{});
    }
    void step(glm::dvec2 px, bool pressed, bool held, bool snap) {
        ViewInput input;
        input.sizePx = kView;
        input.pointerPx = px;
        input.hovered = true;
        input.pressed = pressed;
        input.held = held;
        if (const auto entity = gizmo.update(target, camera, input, 1.0f, snap)) {
            target.entity = *entity;
            place();
        }
    }
    void drag(glm::dvec2 from, glm::dvec2 to, bool snap = false) {
        step(from, false, false, snap);
        EXPECT_TRUE(gizmo.engaged()) << "no handle at " << from.x << ", " << from.y;
        step(from, true, true, snap);
        for (int i = 1; i <= 10; ++i) step(from + (to - from) * (i / 10.0), false, true, snap);
        step(to, false, false, snap);
        EXPECT_FALSE(gizmo.dragging());
    }
    // A world point near the entity on screen; arms are 84 pixels long.
    [[nodiscard]] glm::dvec2 screen(glm::dvec3 fromAnchorArms) const {
        const glm::dvec3 origin = target.placed.anchorMetres;
        const double arm = camera.metresPerScreenPx(camera.project(origin).depthMetres) * 84.0;
        return camera.project(origin + fromAnchorArms * arm).screenPx;
    }

    GizmoTarget target{GizmoKind::move, {}, {}, 4.0, 0.1};
    OrbitCamera orbit;
    Camera camera;
    Gizmo gizmo;
};

TEST_F(EditorGizmo, ArrowsMoveAlongTheirAxisAndFollowThePointer) {
    const std::array<glm::dvec3, 3> axes{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0),
                                         glm::dvec3(0, 0, 1)};
    for (const glm::dvec3 axis : axes) {
        const Entity before = target.entity;
        const glm::dvec2 from = screen(axis * 0.8), to = screen(axis * 1.7);
        const glm::dvec3 grabbed = target.placed.anchorMetres;
        drag(from, to);
        const glm::dvec3 moved = target.entity.positionMetres - before.positionMetres;
        const double along = glm::dot(moved, axis);
        EXPECT_GT(along, 0.1);
        EXPECT_NEAR(glm::length(moved - axis * along), 0.0, 1e-9);
        // The pixel that was grabbed is under the pointer again.
        const double arm = camera.metresPerScreenPx(camera.project(grabbed).depthMetres) * 84.0;
        EXPECT_NEAR(along, 0.9 * arm, 1e-6);
    }
}

TEST_F(EditorGizmo, TheSquareMovesOnTheGroundAlone) {
    const Entity before = target.entity;
    drag(screen({0.35, 0, 0.35}), screen({-0.6, 0, 0.9}));
    EXPECT_EQ(target.entity.positionMetres.y, before.positionMetres.y);
    EXPECT_LT(target.entity.positionMetres.x, before.positionMetres.x);
    EXPECT_GT(target.entity.positionMetres.z, before.positionMetres.z);
}

TEST_F(EditorGizmo, MovingSnapsToVoxels) {
    drag(screen({0.8, 0, 0}), screen({1.53, 0, 0}), true);
    const double voxels = target.entity.positionMetres.x / 0.1;
    EXPECT_NEAR(voxels, std::round(voxels), 1e-9);
    EXPECT_NE(target.entity.positionMetres.x, 1.0);
}

TEST_F(EditorGizmo, EachRingTurnsOneAngleTheWayThePointerGoes) {
    target.kind = GizmoKind::rotate;
    // On the yaw ring, about the world's up axis, a quarter turn counter-clockwise from above.
    const auto at = [&](double degrees) {
        const double angle = degrees * 3.141592653589793 / 180.0;
        return screen({std::cos(angle), 0.0, -std::sin(angle)});
    };
    step(at(290), false, false, false);
    step(at(290), true, true, false);
    for (int degrees = 291; degrees <= 330; ++degrees) step(at(degrees), false, true, false);
    step(at(330), false, false, false);
    EXPECT_NEAR(target.entity.yawDegrees, 40.0, 1.0);
    EXPECT_EQ(target.entity.pitchDegrees, 0.0);
    EXPECT_EQ(target.entity.rollDegrees, 0.0);
}

TEST_F(EditorGizmo, CornersScaleAboutTheAnchor) {
    target.kind = GizmoKind::scale;
    const auto corner = camera.project(proxyCorners(target.placed, 4.0)[7]).screenPx;
    const auto anchor = camera.project(target.placed.anchorMetres).screenPx;
    drag(corner, anchor + (corner - anchor) * 1.5);
    EXPECT_NEAR(target.entity.scale, 1.5, 1e-6);
    EXPECT_EQ(target.entity.positionMetres, glm::dvec3(1.0, 0.0, -2.0));
}

// A key changes the handles under the hand that drags one, to a kind that has fewer.
TEST_F(EditorGizmo, AnotherKindEndsTheDrag) {
    target.kind = GizmoKind::scale;
    const Entity before = target.entity;
    const auto corner = camera.project(proxyCorners(target.placed, 4.0)[7]).screenPx;
    for (const GizmoKind other : {GizmoKind::rotate, GizmoKind::move, GizmoKind::none}) {
        target.kind = GizmoKind::scale;
        step(corner, false, false, false);
        step(corner, true, true, false);
        ASSERT_TRUE(gizmo.dragging());
        target.kind = other;
        for (int i = 1; i <= 3; ++i) step(corner + glm::dvec2(30.0 * i, 5.0), false, true, false);
        EXPECT_FALSE(gizmo.dragging());
        EXPECT_EQ(target.entity, before);
        step(corner, false, false, false);
    }
}

// Not even one that lies between the steps of a drag, or beyond its range.
TEST_F(EditorGizmo, AClickOnAHandleChangesNothing) {
    target.entity.yawDegrees = 22.5;
    target.entity.pitchDegrees = 35.264;
    target.entity.rollDegrees = 10.5;
    target.entity.scale = 0.005;
    place();
    const Entity before = target.entity;
    const double angle = 290.0 * 3.141592653589793 / 180.0;
    const auto click = [&](GizmoKind kind, glm::dvec2 px) {
        target.kind = kind;
        step(px, false, false, false);
        step(px, true, true, false);
        EXPECT_TRUE(gizmo.dragging());
        step(px, false, true, false);
        step(px, false, false, false);
        EXPECT_EQ(target.entity, before);
    };
    click(GizmoKind::move, screen({0.8, 0, 0}));
    click(GizmoKind::rotate, screen({std::cos(angle), 0.0, -std::sin(angle)}));
    click(GizmoKind::scale, camera.project(proxyCorners(target.placed, 4.0)[7]).screenPx);
}

TEST_F(EditorGizmo, AHandThatLetGoUnseenDragsNoMore) {
    const Entity before = target.entity;
    const glm::dvec2 arrow = screen({0.8, 0, 0});
    step(arrow, false, false, false);
    step(arrow, true, true, false);
    ASSERT_TRUE(gizmo.dragging());
    // The model was empty for a while: nobody asked the handles.
    step(arrow + glm::dvec2(60, 20), false, false, false);
    EXPECT_FALSE(gizmo.dragging());
    EXPECT_EQ(target.entity, before);
}

TEST(ViewMotion, TheWheelDoesWhatTheHabitsSay) {
    ViewInput input;
    input.wheel = 2.0;
    input.wheelAcross = -1.0;
    EXPECT_EQ(motionOf(input).wheelNotches, 2.0);
    EXPECT_EQ(motionOf(input).orbitPx, glm::dvec2(0.0));
    input.invertWheel = true;
    EXPECT_EQ(motionOf(input).wheelNotches, -2.0);
    input.roll = CameraMove::orbit;
    EXPECT_EQ(motionOf(input).wheelNotches, 0.0);
    EXPECT_GT(motionOf(input).orbitPx.y, 0.0);
    EXPECT_LT(motionOf(input).orbitPx.x, 0.0);
    input.roll = CameraMove::pan;
    EXPECT_EQ(motionOf(input).orbitPx, glm::dvec2(0.0));
    EXPECT_GT(motionOf(input).panPx.y, 0.0);
}

TEST(ViewMotion, ADragMovesWhatItWasBegunFor) {
    ViewInput input;
    input.movedPx = {10.0, -30.0};
    input.drag = CameraMove::zoom;
    EXPECT_EQ(motionOf(input).dragNotches, 1.0);  // upwards is nearer
    input.drag = CameraMove::pan;
    EXPECT_EQ(motionOf(input).dragNotches, 0.0);
    EXPECT_EQ(motionOf(input).panPx, input.movedPx);
    OrbitCamera camera;
    camera.yawDegrees = 190.0;  // that nothing was moved must not even show here
    const OrbitCamera before = camera;
    ViewCanvas::navigate(ViewInput{}, camera);
    EXPECT_EQ(camera, before);
}

}  // namespace
}  // namespace voxprite::editor
