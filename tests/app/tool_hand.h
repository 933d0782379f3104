// A hand over the edit view, without a window: tools are told frame by frame what it does, as the
// view tells them, and what they ask for is performed.
#pragma once

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "app/editor/tools/tool_box.h"
#include "app/editor/views/orbit_camera.h"
#include "core/edit/make_action.h"
#include "core/model/entity_voxels.h"
#include "core/sprite/camera.h"

namespace voxprite::test {

class ToolHand : public testing::Test {
  protected:
    static constexpr glm::ivec2 kView{640, 480};

    [[nodiscard]] Camera camera() const { return orbit.camera(kView); }
    // Where the middle of a voxel's face is on screen.
    [[nodiscard]] glm::dvec2 faceOf(glm::ivec3 voxel, glm::ivec3 normal = {0, 0, 1}) const {
        const glm::dvec3 middle = glm::dvec3(voxel) + 0.5 + glm::dvec3(normal) * 0.5;
        return camera().project(worldFromVoxel(middle)).screenPx;
    }
    [[nodiscard]] std::optional<editor::Pick> pickAt(glm::dvec2 px) const {
        return editor::pick(session.octree(), session.bounds(), camera().rayThrough(px));
    }

    // One frame in which the pointer goes along `path` from where it was.
    void frame(const std::vector<glm::dvec2>& path, bool pressed, bool released) {
        editor::ToolInput input;
        input.pathPx = {pointer};
        input.pathPx.insert(input.pathPx.end(), path.begin(), path.end());
        pointer = input.pathPx.back();
        input.pointerPx = pointer;
        input.hovered = true;
        down = (down || pressed) && !released;
        input.pressed = pressed;
        input.held = down;
        input.released = released;
        input.shift = shift;
        input.alt = alt;
        input.wheel = std::exchange(wheel, 0.0);
        const Camera eye = camera();
        const editor::ToolContext context{session, settings, eye, input, pickAt(pointer), 1.0f};
        carryOut(tools.update(context, alt));
    }
    void carryOut(editor::ToolBox::Outcome outcome) {
        refusal = outcome.refusal;
        for (Action& action : outcome.actions) {
            const Status done = session.perform(std::move(action));
            EXPECT_TRUE(done) << done.error().message;
        }
    }
    void moveTo(glm::dvec2 px) { frame({px}, false, false); }
    void press() { frame({}, true, false); }
    void release() { frame({}, false, true); }
    void click(glm::dvec2 px) {
        moveTo(px);
        press();
        release();
    }
    // With few points, as a fast hand leaves them.
    void drag(const std::vector<glm::dvec2>& path) {
        moveTo(path.front());
        press();
        for (std::size_t i = 1; i < path.size(); ++i) moveTo(path[i]);
        release();
    }
    void keep() {
        auto action = tools.confirm(session);
        if (action) {
            ASSERT_TRUE(session.perform(std::move(*action)));
        }
    }
    void attachBox(const IBox& box, std::uint8_t colour) {
        ASSERT_TRUE(session.perform(
            makeAction("fixture", patchBox(session.document(), 0, box, EditMode::attach, colour))));
    }

    // What is seen: the document, and with the coming edit.
    [[nodiscard]] VoxelGrid made() const { return flatten(session.document(), session.frame()); }
    [[nodiscard]] VoxelGrid shown() const {
        VoxelGrid grid;
        const IBox box = session.shownBounds();
        for (int x = box.min.x; x < box.max.x; ++x) {
            for (int y = box.min.y; y < box.max.y; ++y) {
                for (int z = box.min.z; z < box.max.z; ++z) {
                    const std::uint8_t value = session.shownOctree().at({x, y, z});
                    if (value != 0) grid.set({x, y, z}, value);
                }
            }
        }
        return grid;
    }

    editor::Session session;
    editor::ToolSettings settings;
    editor::OrbitCamera orbit;
    editor::ToolBox tools;
    glm::dvec2 pointer{-1000.0};
    bool down = false, shift = false, alt = false;
    double wheel = 0.0;
    std::string refusal;
};

}  // namespace voxprite::test
