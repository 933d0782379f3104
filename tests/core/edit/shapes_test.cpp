#include "core/edit/shapes.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/positions.h"
#include "tests/support/random.h"

namespace voxprite {
namespace {

using test::forEachVoxel;
using test::key;
using test::Positions;
using test::positionsOf;
using test::Random;

IBox boxOfSize(glm::ivec3 size, glm::ivec3 at = glm::ivec3(0)) {
    return {at, at + size};
}

Positions voxelsOf(const Shape& shape) {
    return positionsOf(shapeVoxels(shape).value());
}

// The layer z = 0 of a shape, a string a row.
std::vector<std::string> picture(const Shape& shape) {
    const Positions voxels = voxelsOf(shape);
    std::vector<std::string> rows;
    for (int y = shape.box.min.y; y < shape.box.max.y; ++y) {
        std::string row;
        for (int x = shape.box.min.x; x < shape.box.max.x; ++x) {
            row += voxels.contains({x, y, shape.box.min.z}) ? '#' : '.';
        }
        rows.push_back(row);
    }
    return rows;
}

std::vector<std::string> circle(int diameter, bool hollow = false) {
    // A ring: the wall of a tall cylinder, seen a layer below its lid.
    const Shape shape{ShapeKind::cylinder, boxOfSize({diameter, diameter, 3}), 2, hollow};
    const Positions voxels = voxelsOf(shape);
    std::vector<std::string> rows(static_cast<std::size_t>(diameter));
    for (int y = 0; y < diameter; ++y) {
        for (int x = 0; x < diameter; ++x) {
            rows[static_cast<std::size_t>(y)] += voxels.contains({x, y, 1}) ? '#' : '.';
        }
    }
    return rows;
}

using Rows = std::vector<std::string>;

TEST(Shapes, CirclesLookDrawnByHand) {
    EXPECT_EQ(circle(1), (Rows{"#"}));
    EXPECT_EQ(circle(2), (Rows{"##", "##"}));
    EXPECT_EQ(circle(3), (Rows{".#.", "###", ".#."}));
    EXPECT_EQ(circle(4), (Rows{".##.", "####", "####", ".##."}));
    EXPECT_EQ(circle(5), (Rows{".###.", "#####", "#####", "#####", ".###."}));
    EXPECT_EQ(circle(7),
              (Rows{"..###..", ".#####.", "#######", "#######", "#######", ".#####.", "..###.."}));
    EXPECT_EQ(circle(8), (Rows{"..####..", ".######.", "########", "########", "########",
                               "########", ".######.", "..####.."}));
    EXPECT_EQ(circle(8, true), (Rows{"..####..", ".#....#.", "#......#", "#......#", "#......#",
                                     "#......#", ".#....#.", "..####.."}));
}

TEST(Shapes, EllipsesReachTheirEnds) {
    const Shape flat{ShapeKind::ellipsoid, boxOfSize({12, 4, 1})};
    EXPECT_EQ(picture(flat),
              (Rows{"..########..", "############", "############", "..########.."}));
}

// Whether the voxel centre lies within the ellipsoid of the box, by fractions over a common
// denominator: the rule that the header states.
bool centreIsInside(const Shape& shape, glm::ivec3 v) {
    const glm::ivec3 n = shape.box.size();
    const glm::ivec3 o = 2 * (v - shape.box.min) + 1 - n;
    const auto square = [](int x) { return static_cast<long double>(x) * x; };
    if (shape.kind == ShapeKind::box) return true;
    long double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (shape.kind == ShapeKind::cylinder && axis == shape.axis) continue;
        sum += square(o[axis]) / square(n[axis]);
    }
    return sum <= 1.0L + 1e-12L;
}

// On one of the lines through the middle: there the shape runs the full length.
bool isOnSpine(const Shape& shape, glm::ivec3 v) {
    const glm::ivec3 n = shape.box.size();
    const glm::ivec3 o = glm::abs(2 * (v - shape.box.min) + 1 - n);
    int off = 0;
    for (int axis = 0; axis < 3; ++axis) {
        if (shape.kind == ShapeKind::cylinder && axis == shape.axis) continue;
        off += o[axis] > 1;
    }
    return off <= 1;
}

TEST(Shapes, FollowTheRuleTouchEverySideAndEqualTheirMirrors) {
    Random random(5);
    for (int round = 0; round < 150; ++round) {
        Shape shape;
        shape.kind = static_cast<ShapeKind>(round % 3);
        shape.axis = random.between(0, 2);
        glm::ivec3 size = random.voxel(1, 22);
        if (round % 5 == 0) size[random.between(0, 2)] = random.between(1, 4);
        if (round % 7 == 0) size = glm::ivec3(size.x);
        shape.box = boxOfSize(size, random.voxel(-40, 40));
        const Positions solid = voxelsOf(shape);
        const bool crossOfThree = shape.kind == ShapeKind::cylinder &&
                                  size[(shape.axis + 1) % 3] == 3 &&
                                  size[(shape.axis + 2) % 3] == 3;
        const bool flatOfThree = shape.kind == ShapeKind::ellipsoid &&
                                 size.x * size.y * size.z == 9 && size.x + size.y + size.z == 7;
        Positions wall;
        IBox bounds;
        forEachVoxel(shape.box, [&](glm::ivec3 v) {
            const bool inside = solid.contains(key(v));
            if (!crossOfThree && !flatOfThree) {
                ASSERT_EQ(inside, centreIsInside(shape, v) || isOnSpine(shape, v));
            }
            for (int axis = 0; axis < 3; ++axis) {
                glm::ivec3 mirror = v;
                mirror[axis] = shape.box.min[axis] + shape.box.max[axis] - 1 - v[axis];
                ASSERT_EQ(solid.contains(key(mirror)), inside);
            }
            if (!inside) return;
            bounds = bounds.united({v, v + 1});
            for (int i = 0; i < 6; ++i) {
                glm::ivec3 neighbour = v;
                neighbour[i / 2] += i % 2 == 0 ? 1 : -1;
                if (!solid.contains(key(neighbour))) wall.insert(key(v));
            }
        });
        EXPECT_EQ(bounds, shape.box);
        shape.hollow = true;
        EXPECT_EQ(voxelsOf(shape), wall);
        if (HasFailure()) return;
    }
}

TEST(Shapes, ASphereIsTheSameAlongEachAxis) {
    for (const int n : {1, 2, 3, 4, 9, 16, 31}) {
        const Positions ball = voxelsOf({ShapeKind::ellipsoid, boxOfSize(glm::ivec3(n))});
        for (const auto& [x, y, z] : ball) {
            ASSERT_TRUE(ball.contains({y, z, x}));
            ASSERT_TRUE(ball.contains({y, x, z}));
        }
    }
    // 3 cubed without its corners; 4 cubed without its edges.
    EXPECT_EQ(voxelsOf({ShapeKind::ellipsoid, boxOfSize(glm::ivec3(3))}).size(), 27u - 8u);
    EXPECT_EQ(voxelsOf({ShapeKind::ellipsoid, boxOfSize(glm::ivec3(4))}).size(), 64u - 32u);
}

TEST(Shapes, LargeOnesAreSparse) {
    const Shape ball{ShapeKind::ellipsoid, boxOfSize(glm::ivec3(200), glm::ivec3(-100))};
    const VoxelSet set = shapeVoxels(ball).value();
    // pi / 6 of the cube, and whole blocks inside cost one entry.
    const double fraction = static_cast<double>(set.count()) / (200.0 * 200.0 * 200.0);
    EXPECT_NEAR(fraction, 0.5236, 0.002);
    EXPECT_LT(set.grid().bytes(), 4'000'000u);
}

TEST(Shapes, LimitsAreErrors) {
    EXPECT_TRUE(shapeVoxels({ShapeKind::box, IBox{}}).value().empty());
    EXPECT_TRUE(shapeVoxels({ShapeKind::box, boxOfSize({kMaxShapeEdge, 1, 1})}));
    const auto tooLong = shapeVoxels({ShapeKind::box, boxOfSize({kMaxShapeEdge + 1, 1, 1})});
    ASSERT_FALSE(tooLong);
    EXPECT_EQ(tooLong.error().message,
              "A shape of 1025 x 1 x 1 voxels is too large: an edge has at most 1024");
    EXPECT_FALSE(shapeVoxels({ShapeKind::box, boxOfSize({2, 2, 2}, glm::ivec3(kMaxCoordinate))}));
    EXPECT_FALSE(lineVoxels({}, {0, 0, 0}, {2000, 0, 0}));
}

}  // namespace
}  // namespace voxprite
