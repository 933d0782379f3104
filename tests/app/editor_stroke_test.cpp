// Tools without a window: what the pointer does to the voxels.
#include "app/editor/stroke.h"

#include <gtest/gtest.h>

#include "app/editor/orbit_camera.h"
#include "core/edit/make_action.h"
#include "core/edit/scene_edits.h"
#include "tests/support/random.h"

namespace voxprite::editor {
namespace {

constexpr glm::ivec2 kView(640, 480);

// A plate of 40 x 40 x 1 voxels, seen from above.
class PlateUnderAStroke : public testing::Test {
  protected:
    PlateUnderAStroke() {
        attachBox({{-20, -20, 0}, {20, 20, 1}}, 5);
        orbit.yawDegrees = 25.0;
        orbit.pitchDegrees = 55.0;
        orbit.target = worldFromVoxel({0, 0, 1});
        orbit.distance = 60.0;
    }
    void attachBox(const IBox& box, std::uint8_t colour) {
        ASSERT_TRUE(session.perform(
            makeAction("fixture", patchBox(session.document(), 0, box, EditMode::attach, colour))));
    }
    // Where the centre of a voxel's top face is on screen.
    [[nodiscard]] glm::dvec2 topOf(glm::ivec3 voxel) const {
        const glm::dvec3 centre = glm::dvec3(voxel) + glm::dvec3(0.5, 0.5, 1.0);
        return orbit.camera(kView).project(worldFromVoxel(centre)).screenPx;
    }
    [[nodiscard]] std::optional<Pick> pickAt(glm::dvec2 px) const {
        return pick(session.octree(), session.bounds(), orbit.camera(kView).rayThrough(px));
    }
    // Press, along the path, release; with few events, as a fast hand makes them.
    void stroke(const Brush& brush, const std::vector<glm::dvec2>& path, int deepen = 0) {
        const auto start = pickAt(path.front());
        ASSERT_TRUE(start.has_value());
        Result<Stroke> drawn = Stroke::begin(session, brush, *start);
        ASSERT_TRUE(drawn) << drawn.error().describe();
        const Camera camera = orbit.camera(kView);
        for (std::size_t i = 0; i < path.size(); ++i) {
            const std::size_t from = i > 0 ? i - 1 : 0;
            const std::vector<glm::dvec2> part(path.begin() + static_cast<long>(from),
                                               path.begin() + static_cast<long>(i) + 1);
            if (auto action = drawn->drag(session, camera, part)) {
                ASSERT_TRUE(session.perform(std::move(*action)));
            }
        }
        if (deepen != 0) drawn->deepen(deepen);
        if (auto action = drawn->finish(session)) {
            ASSERT_TRUE(session.perform(std::move(*action)));
        }
    }
    [[nodiscard]] const VoxelGrid& voxels() const { return session.document().models[0].voxels; }

    Session session;
    OrbitCamera orbit;
};

TEST_F(PlateUnderAStroke, PicksTheFaceUnderThePointer) {
    test::Random random(3);
    for (int i = 0; i < 200; ++i) {
        const glm::ivec3 voxel(random.between(-19, 18), random.between(-19, 18), 0);
        const auto found = pickAt(topOf(voxel));
        ASSERT_TRUE(found.has_value());
        EXPECT_EQ(found->voxel, voxel);
        EXPECT_EQ(found->normal, glm::ivec3(0, 0, 1));
        EXPECT_FALSE(found->ground);
    }
}

TEST_F(PlateUnderAStroke, AttachedLineHasNoGapAndOneLayer) {
    stroke({EditMode::attach, BrushShape::voxel, 9}, {topOf({-15, -9, 0}), topOf({15, 12, 0})});
    EXPECT_EQ(voxels().get({-15, -9, 1}), 9);
    EXPECT_EQ(voxels().get({15, 12, 1}), 9);
    EXPECT_EQ(session.bounds().max.z, 2);
    // Every column that the line crosses, each voxel touching the one before.
    for (int x = -15; x < 15; ++x) {
        bool touches = false;
        for (int y = -20; y < 20; ++y) {
            for (int next = y - 1; next <= y + 1; ++next) {
                touches = touches ||
                          (voxels().get({x, y, 1}) == 9 && voxels().get({x + 1, next, 1}) == 9);
            }
        }
        EXPECT_TRUE(touches) << "gap after x = " << x;
    }
}

TEST_F(PlateUnderAStroke, ScribblingOnOnePlaceNeverClimbs) {
    std::vector<glm::dvec2> path;
    for (int i = 0; i < 60; ++i) path.push_back(topOf({i % 2, (i / 2) % 2, 0}));
    stroke({EditMode::attach, BrushShape::voxel, 9}, path);
    EXPECT_EQ(session.bounds().max.z, 2);
    EXPECT_EQ(voxels().solidCount(), 1600u + 4u);
}

TEST_F(PlateUnderAStroke, ErasingDigsOneLayer) {
    attachBox({{-20, -20, -5}, {20, 20, 0}}, 6);
    std::vector<glm::dvec2> path;
    for (int i = 0; i < 40; ++i) path.push_back(topOf({i % 2, 0, 0}));
    const std::uint64_t before = voxels().solidCount();
    stroke({EditMode::erase, BrushShape::voxel, 9}, path);
    EXPECT_EQ(voxels().solidCount(), before - 2);
    EXPECT_EQ(voxels().get({0, 0, -1}), 6);
}

TEST_F(PlateUnderAStroke, OneStrokeIsOneStep) {
    const std::size_t before = session.history().position();
    stroke({EditMode::paint, BrushShape::voxel, 77},
           {topOf({-9, 0, 0}), topOf({-3, 2, 0}), topOf({4, -2, 0}), topOf({9, 0, 0})});
    EXPECT_EQ(session.history().position(), before + 1);
    EXPECT_EQ(voxels().get({-9, 0, 0}), 77);
    EXPECT_EQ(voxels().get({9, 0, 0}), 77);
    EXPECT_EQ(voxels().solidCount(), 1600u);
    ASSERT_TRUE(session.undo());
    EXPECT_EQ(voxels().get({-9, 0, 0}), 5);
    EXPECT_EQ(voxels().get({9, 0, 0}), 5);
    // The next stroke is a step of its own.
    stroke({EditMode::paint, BrushShape::voxel, 78}, {topOf({0, 0, 0})});
    stroke({EditMode::paint, BrushShape::voxel, 79}, {topOf({1, 0, 0})});
    EXPECT_EQ(session.history().position(), before + 2);
}

TEST_F(PlateUnderAStroke, BoxesAttachEraseAndPaint) {
    const std::vector<glm::dvec2> path{topOf({-4, -3, 0}), topOf({5, 6, 0})};
    stroke({EditMode::attach, BrushShape::box, 9}, path, 2);
    EXPECT_EQ(voxels().solidCount(), 1600u + 10 * 10 * 3);
    EXPECT_EQ(voxels().get({-4, -3, 1}), 9);
    EXPECT_EQ(voxels().get({5, 6, 3}), 9);
    ASSERT_TRUE(session.undo());
    EXPECT_EQ(voxels().solidCount(), 1600u);

    stroke({EditMode::erase, BrushShape::box, 9}, path);
    EXPECT_EQ(voxels().solidCount(), 1500u);
    ASSERT_TRUE(session.undo());

    stroke({EditMode::paint, BrushShape::box, 33}, path, 4);
    EXPECT_EQ(voxels().solidCount(), 1600u);
    EXPECT_EQ(voxels().get({0, 0, 0}), 33);
    EXPECT_EQ(voxels().get({6, 6, 0}), 5);
}

TEST_F(PlateUnderAStroke, AttachesThroughATurnedAndMirroredObject) {
    // The same plate, its object turned upside down and mirrored: entity space decides.
    SceneEdit edit{sceneOf(session.document()), sceneOf(session.document()), 1, {}};
    edit.after.nodes[1].placements[0].placement = {{{1, 0, 2}, {1, -1, -1}}, {0, 0, 0}};
    ASSERT_TRUE(session.perform(makeAction("turn", edit)));
    const glm::ivec3 top(7, -3, session.bounds().max.z - 1);
    stroke({EditMode::attach, BrushShape::voxel, 44}, {topOf(top)});
    EXPECT_EQ(session.octree().at(top + glm::ivec3(0, 0, 1)), 44);
    EXPECT_EQ(flatten(session.document(), 0).get(top + glm::ivec3(0, 0, 1)), 44);
}

TEST_F(PlateUnderAStroke, ErasingTakesTheObjectThatWasHit) {
    ASSERT_TRUE(session.perform(addObject(session.document(), "hat")));
    session.setActiveNode(2);
    const std::vector<glm::ivec3> hat{{0, 0, 1}, {1, 0, 1}};
    ASSERT_TRUE(session.perform(
        makeAction("hat", patchVoxels(session.document(), 1, hat, EditMode::attach, 8))));
    // From the hat onto the plate: only the hat is touched.
    stroke({EditMode::erase, BrushShape::voxel, 0}, {topOf({0, 0, 1}), topOf({8, 0, 0})});
    EXPECT_EQ(session.document().models[1].voxels.solidCount(), 0u);
    EXPECT_EQ(voxels().solidCount(), 1600u);
    EXPECT_EQ(session.activeNode(), 2);
    stroke({EditMode::erase, BrushShape::voxel, 0}, {topOf({8, 0, 0})});
    EXPECT_EQ(session.activeNode(), 1);
    EXPECT_EQ(voxels().solidCount(), 1599u);
}

TEST_F(PlateUnderAStroke, LockedAndHiddenObjectsAreRefusedByName) {
    ASSERT_TRUE(session.perform(rename(session.document(), 1, "plate")));
    ASSERT_TRUE(session.perform(setLocked(session.document(), 1, true)));
    const auto start = pickAt(topOf({0, 0, 0}));
    ASSERT_TRUE(start.has_value());
    const Result<Stroke> locked = Stroke::begin(session, {EditMode::attach}, *start);
    ASSERT_FALSE(locked);
    EXPECT_NE(locked.error().message.find("plate"), std::string::npos);
    ASSERT_TRUE(session.perform(setLocked(session.document(), 1, false)));
    ASSERT_TRUE(session.perform(setHidden(session.document(), 1, true)));
    EXPECT_FALSE(Stroke::begin(session, {EditMode::attach}, *start));
}

TEST(EditorPicking, EmptyModelIsStartedOnTheGround) {
    const Session session;
    OrbitCamera orbit;
    orbit.distance = 30.0;
    orbit.pitchDegrees = 40.0;
    const Camera camera = orbit.camera(kView);
    const glm::dvec2 px = camera.project(worldFromVoxel({3.5, -2.5, 0.0})).screenPx;
    const auto found = pick(session.octree(), session.bounds(), camera.rayThrough(px));
    ASSERT_TRUE(found.has_value());
    EXPECT_TRUE(found->ground);
    EXPECT_EQ(found->attachTo(), glm::ivec3(3, -3, 0));
    // Above the horizon there is nothing; nor is there from below.
    EXPECT_FALSE(pick(session.octree(), session.bounds(), camera.rayThrough({320, -900})));
    orbit.pitchDegrees = -40.0;
    EXPECT_FALSE(
        pick(session.octree(), session.bounds(), orbit.camera(kView).rayThrough({320, 240})));
}

TEST(EditorPicking, FaceCornersLieOnTheFace) {
    test::Random random(8);
    for (int axis = 0; axis < 3; ++axis) {
        for (const int sign : {-1, 1}) {
            Pick face;
            face.voxel = random.voxel(-50, 50);
            face.normal = glm::ivec3(0);
            face.normal[axis] = sign;
            const glm::dvec3 centre = glm::dvec3(face.voxel) + 0.5 + glm::dvec3(face.normal) * 0.5;
            glm::dvec3 sum(0.0);
            for (const glm::dvec3 corner : faceCorners(face)) {
                EXPECT_EQ(corner[axis], centre[axis]);
                sum += corner;
            }
            EXPECT_EQ(sum / 4.0, centre);
        }
    }
}

}  // namespace
}  // namespace voxprite::editor
