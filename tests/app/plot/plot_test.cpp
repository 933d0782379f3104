#include "app/plot/plot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "app/plot/lettering.h"

namespace voxprite::plot {
namespace {

Plot smallPlot() {
    Plot plot;
    plot.title = "Speed & <accuracy>";
    plot.x = {"ms", true, false};
    plot.y = {"error", false, true};
    Series red;
    red.name = "red";
    red.colour = {200, 30, 30, 255};
    red.line = true;
    red.data = {
        {1.0, 0.5, {}, "first", "here"}, {10.0, 0.1, {}, "second", ""}, {0.0, 0.3, {}, "", ""}};
    Series none;
    none.name = "without data";
    plot.series = {red, none};
    return plot;
}

std::vector<Shape> of(const Drawing& drawing, Shape::Kind kind) {
    std::vector<Shape> shapes;
    std::copy_if(drawing.shapes.begin(), drawing.shapes.end(), std::back_inserter(shapes),
                 [&](const Shape& shape) { return shape.kind == kind; });
    return shapes;
}

TEST(Ticks, AreRoundAndWithinTheRange) {
    EXPECT_EQ(ticksOf(0.0, 10.0, false, 5), (std::vector<double>{0, 2, 4, 6, 8, 10}));
    EXPECT_EQ(ticksOf(-0.5, 1.2, false, 4), (std::vector<double>{-0.5, 0, 0.5, 1}));
    EXPECT_EQ(ticksOf(0.7, 30.0, true, 8), (std::vector<double>{1, 2, 5, 10, 20}));
    const std::vector<double> decades = ticksOf(1.0, 1e12, true, 6);
    EXPECT_LE(decades.size(), 8u);
    for (const double tick : decades) EXPECT_EQ(std::log10(tick), std::round(std::log10(tick)));
    EXPECT_TRUE(ticksOf(1.0, 1.0, false, 5).empty());
    EXPECT_TRUE(ticksOf(-1.0, 1.0, true, 5).empty());
    EXPECT_TRUE(ticksOf(0.0, INFINITY, false, 5).empty());
    EXPECT_EQ(tickText(0.05), "0.05");
    EXPECT_EQ(tickText(100000.0), "100 000");
}

TEST(Plots, StandWhereTheirFiguresSay) {
    const Drawing drawing = layOut(smallPlot());
    // Two points (a logarithm of 0 is none) and the one series with data in the legend.
    const std::vector<Shape> marks = of(drawing, Shape::Kind::mark);
    ASSERT_EQ(marks.size(), 3u);
    EXPECT_LT(marks[0].a.x, marks[1].a.x);
    EXPECT_LT(marks[0].a.y, marks[1].a.y);  // 0.5 is above 0.1
    int named = 0;
    for (const Shape& text : of(drawing, Shape::Kind::text)) {
        named += text.text == "red" || text.text == "without data" ? 1 : 0;
        EXPECT_GE(text.a.x, 0.0);
        EXPECT_LE(text.a.y, drawing.size.y);
    }
    EXPECT_EQ(named, 1);
    EXPECT_FALSE(layOut(Plot{}).shapes.empty());  // axes without points
}

TEST(Plots, AreThePageAndThePicture) {
    const Drawing drawing = layOut(smallPlot());
    const std::string svg = svgOf(drawing);
    EXPECT_NE(svg.find("Speed &amp; &lt;accuracy&gt;"), std::string::npos);
    EXPECT_NE(svg.find("<title>first</title>"), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("http"), std::string::npos);
    const Image picture = pictureOf(drawing, 1.0);
    EXPECT_EQ(picture.width, drawing.size.x);
    const glm::ivec2 at(glm::floor(of(drawing, Shape::Kind::mark)[1].a));
    EXPECT_EQ(picture.at(at.x, at.y), Rgba8(200, 30, 30, 255));
    EXPECT_EQ(pictureOf(drawing, 1.0), picture);
}

TEST(Lettering, IsAsWideAsWhatItDraws) {
    const Lettering letters = Lettering::regular();
    EXPECT_EQ(letters.widthOf(20.0f, ""), 0.0f);
    EXPECT_GT(letters.widthOf(20.0f, "WW"), 1.9f * letters.widthOf(20.0f, "W") - 1.0f);
    EXPECT_GT(letters.widthOf(20.0f, "°"), 1.0f);
    EXPECT_EQ(letters.widthOf(20.0f, "\xff"), letters.widthOf(20.0f, "\xef\xbf\xbd"));
    Image picture(60, 30, Rgba8(255));
    letters.draw(picture, 4, 22, 24.0f, Rgba8(0, 0, 0, 255), "H");
    int dark = 0, beyond = 0;
    const auto width = static_cast<int>(letters.widthOf(24.0f, "H")) + 5;
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 60; ++x) {
            dark += picture.at(x, y).x < 64 ? 1 : 0;
            beyond += x > width && picture.at(x, y) != Rgba8(255) ? 1 : 0;
        }
    EXPECT_GT(dark, 40);
    EXPECT_EQ(beyond, 0);
    // At the edges it is cut off.
    letters.draw(picture, -10, 200, 24.0f, Rgba8(0, 0, 0, 255), "HHHHHHHHH");
    letters.draw(picture, 50, 10, 24.0f, Rgba8(0, 0, 0, 255), "HHHHHHHHH");
}

}  // namespace
}  // namespace voxprite::plot
