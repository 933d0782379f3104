#include "core/edit/brush.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/edit/shapes.h"
#include "tests/support/positions.h"
#include "tests/support/random.h"

namespace voxprite {
namespace {

using test::key;
using test::Positions;
using test::positionsOf;
using test::Random;

int longest(glm::ivec3 v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

TEST(Brush, TipsFillTheirBox) {
    EXPECT_EQ(tipBox({TipShape::cube, 3, 2}, {5, 5, 5}), (IBox{{4, 4, 4}, {7, 7, 7}}));
    EXPECT_EQ(tipBox({TipShape::cube, 4, 2}, {5, 5, 5}), (IBox{{4, 4, 4}, {8, 8, 8}}));
    EXPECT_EQ(tipBox({TipShape::disc, 3, 0}, {5, 5, 5}), (IBox{{5, 4, 4}, {6, 7, 7}}));
    for (const TipShape shape : {TipShape::cube, TipShape::sphere, TipShape::disc}) {
        for (const int edge : {1, 2, 3, 8, 15, kMaxTipEdge}) {
            const BrushTip tip{shape, edge, 1};
            IBox bounds;
            for (const glm::ivec3 v : tipVoxels(tip, {-7, 20, 3})) {
                bounds = bounds.united({v, v + 1});
            }
            EXPECT_EQ(bounds, tipBox(tip, {-7, 20, 3}));
        }
    }
    const std::size_t edge = kMaxTipEdge;
    EXPECT_EQ(tipVoxels({TipShape::cube, kMaxTipEdge, 2}, {0, 0, 0}).size(), edge * edge * edge);
    EXPECT_EQ(tipVoxels({TipShape::disc, 8, 2}, {0, 0, 0}).size(), 4u + 6 + 8 + 8 + 8 + 8 + 6 + 4);
}

TEST(Brush, LinesStayWithinHalfAVoxelAndHaveNoGaps) {
    Random random(17);
    for (int round = 0; round < 400; ++round) {
        const glm::ivec3 a = random.voxel(-20, 20);
        const glm::ivec3 b = random.voxel(-20, 20);
        const std::vector<glm::ivec3> line = voxelLine(a, b);
        const int steps = longest(b - a);
        ASSERT_EQ(line.size(), static_cast<std::size_t>(steps) + 1);
        EXPECT_EQ(line.front(), a);
        EXPECT_EQ(line.back(), b);
        for (std::size_t i = 0; i < line.size(); ++i) {
            const glm::ivec3 step = line[i] - line[i == 0 ? 0 : i - 1];
            ASSERT_EQ(longest(step), i == 0 ? 0 : 1);
            for (int axis = 0; axis < 3 && steps > 0; ++axis) {
                const double exact =
                    a[axis] + double(b[axis] - a[axis]) * static_cast<double>(i) / steps;
                ASSERT_LE(std::abs(line[i][axis] - exact), 0.5 + 1e-9);
            }
        }
        std::vector<glm::ivec3> back = voxelLine(b, a);
        std::reverse(back.begin(), back.end());
        EXPECT_EQ(back, line);
    }
}

TEST(Brush, TrailsCoverEveryVoxelOnceAndLeaveNoGap) {
    Random random(23);
    for (int round = 0; round < 40; ++round) {
        const BrushTip tip{static_cast<TipShape>(round % 3), random.between(1, 9),
                           random.between(0, 2)};
        BrushTrail trail(tip);
        Positions expected;
        Positions seen;
        glm::ivec3 at{0};
        for (int stroke = 0; stroke < 6; ++stroke) {
            const glm::ivec3 to = random.voxel(-15, 15);
            const bool jumps = stroke > 0 && random.chance(0.3);
            const std::vector<glm::ivec3> fresh = jumps ? trail.startAt(to) : trail.lineTo(to);
            for (const glm::ivec3 v : fresh) ASSERT_TRUE(seen.insert(key(v)).second);
            const auto path =
                jumps || stroke == 0 ? std::vector<glm::ivec3>{to} : voxelLine(at, to);
            for (const glm::ivec3 v : path) {
                for (const glm::ivec3 covered : tipVoxels(tip, v)) expected.insert(key(covered));
            }
            at = to;
            ASSERT_EQ(seen, expected);
        }
        EXPECT_EQ(positionsOf(trail.covered()), expected);
    }
}

TEST(Brush, ALineOfTheShapeToolIsATrail) {
    const BrushTip tip{TipShape::sphere, 5, 2};
    BrushTrail trail(tip);
    trail.startAt({0, 0, 0});
    trail.lineTo({20, 9, -4});
    EXPECT_EQ(lineVoxels(tip, {0, 0, 0}, {20, 9, -4}).value(), trail.covered());
    EXPECT_EQ(lineVoxels(tip, {20, 9, -4}, {0, 0, 0}).value(), trail.covered());
}

}  // namespace
}  // namespace voxprite
