// Contexts, programs, shader sources and frames.
#include <glad/gl.h>

#include <algorithm>
#include <regex>
#include <set>

#include "render/frame.h"
#include "render/gl/program.h"
#include "render/gl/shader_library.h"
#include "tests/render/gl_test.h"

namespace voxprite {
namespace {

using test::must;

class GlBasics : public test::GlTest {};

TEST_F(GlBasics, TheContextHasTheConventionsThatPassesRelyOn) {
    const gl::DriverInfo info = gl::driverInfo();
    EXPECT_FALSE(info.renderer.empty());
    GLint major = 0;
    GLint minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    EXPECT_GE(10 * major + minor, 45);
    GLint depthMode = 0;
    GLint origin = 0;
    glGetIntegerv(GL_CLIP_DEPTH_MODE, &depthMode);
    glGetIntegerv(GL_CLIP_ORIGIN, &origin);
    EXPECT_EQ(depthMode, GL_ZERO_TO_ONE);
    EXPECT_EQ(origin, GL_LOWER_LEFT);
    EXPECT_EQ(glIsEnabled(GL_DITHER), GL_FALSE);
}

TEST_F(GlBasics, MisuseIsReportedAsSevere) {
    glBindTexture(GL_TEXTURE_2D, 987'654);  // no such texture
    EXPECT_EQ(gl::takeSevereMessages().size(), 1U);
    EXPECT_TRUE(gl::takeSevereMessages().empty());
    EXPECT_NE(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(GlBasics, WhatNobodyTakesDoesNotPileUp) {
    for (int k = 0; k < 150; ++k) glBindTexture(GL_TEXTURE_2D, 987'654);
    EXPECT_EQ(gl::takeSevereMessages().size(), 100U);
    EXPECT_NE(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

// OpenGL 4.5 promises eight places for buffers; and a shader's own must not share one.
TEST_F(GlBasics, BuffersLieWhereEveryDriverHasPlaces) {
    const std::regex buffer(R"(std430,\s*binding\s*=\s*(\d+))");
    int found = 0;
    for (const auto& [name, source] : embeddedShaders()) {
        if (name.starts_with("shared/")) continue;
        const std::string text = must(gl::assembleShader(name)).text;
        std::set<int> places;
        for (std::sregex_iterator match(text.begin(), text.end(), buffer), end; match != end;
             ++match, ++found) {
            const int place = std::stoi((*match)[1]);
            EXPECT_LT(place, 8) << name;
            EXPECT_TRUE(places.insert(place).second) << name << ": " << place;
        }
    }
    EXPECT_GE(found, 10);
}

TEST_F(GlBasics, AContextMayFollowAnother) {
    // The fixture's own stays valid, but the new one is current.
    Result<gl::HeadlessContext> second = gl::HeadlessContext::create();
    ASSERT_TRUE(second) << second.error().describe();
    EXPECT_NE(glGetString(GL_VERSION), nullptr);
}

TEST_F(GlBasics, EveryShaderCompilesInEveryVariant) {
    const std::vector<std::pair<std::string, std::string>> programs{
        {"sprite_quad.vert", "sprite_single.frag"},
        {"sprite_quad.vert", "sprite_blit.frag"},
        {"sprite_region.vert", "sprite_outline.frag"},
        {"fullscreen.vert", "scene_backdrop.frag"},
        {"fullscreen.vert", "voxel_backdrop.frag"},
        {"voxel_view.vert", "voxel_view.frag"},
        {"shadow_blob.vert", "shadow_blob.frag"},
        {"overlay_line.vert", "overlay_line.frag"},
        {"overlay_triangle.vert", "overlay_triangle.frag"},
        {"cluster.vert", "cluster.frag"},
        {"cluster_view.vert", "cluster_view.frag"},
        {"cluster_view.vert", "cluster_depth.frag"},
        {"snapshot.vert", "snapshot.frag"},
        {"bench_seed.vert", "bench_seed.frag"}};
    std::vector<std::string> used;
    for (const auto& [vertex, fragment] : programs) {
        for (const std::vector<std::string>& defines : {std::vector<std::string>{},
                                                        {"LATTICE_WIDE"},
                                                        {"PER_PIXEL_DEPTH"},
                                                        {"FACE_SHADE"},
                                                        {"MARKED"},
                                                        {"LATTICE_WIDE", "FACE_SHADE"},
                                                        {"PROXY_BOX", "SPRITE_IDS"},
                                                        {"DEPTH_LIMIT", "FACE_SHADE"},
                                                        {"LATTICE_WIDE", "PER_PIXEL_DEPTH"}}) {
            const auto program = gl::compileProgram(vertex, fragment, defines);
            EXPECT_TRUE(program) << program.error().message;
        }
        used.push_back(vertex);
        used.push_back(fragment);
    }
    for (const char* compute : {"cluster_cut.comp", "ray_batch.comp", "sprite_cast.comp"}) {
        for (const std::vector<std::string>& defines :
             {std::vector<std::string>{},
              {"LATTICE_WIDE", "FACE_SHADE"},
              {"SPRITE_IDS"},
              {"LATTICE_WIDE", "FACE_SHADE", "SPRITE_IDS"}}) {
            const auto program = gl::compileCompute(compute, defines);
            EXPECT_TRUE(program) << program.error().message;
        }
        used.emplace_back(compute);
    }
    // No stage was left out.
    for (const auto& [name, text] : embeddedShaders()) {
        if (name.ends_with(".glsl")) continue;
        EXPECT_NE(std::ranges::find(used, name), used.end()) << name;
    }
}

TEST_F(GlBasics, AnUnknownShaderIsAnError) {
    const auto program = gl::compileProgram("fullscreen.vert", "no_such.frag");
    ASSERT_FALSE(program);
    EXPECT_NE(program.error().message.find("no_such.frag"), std::string::npos);
}

TEST(ShaderLibrary, IncludesAreExpandedOnceAndLinesAreKept) {
    const gl::ShaderSource source =
        must(gl::assembleShader("sprite_single.frag", {"LATTICE_WIDE", "LIMIT 4"}));
    EXPECT_TRUE(
        source.text.starts_with("#version 450 core\n#define LATTICE_WIDE\n#define LIMIT 4\n"
                                "#line 1 0\n"));
    EXPECT_EQ(source.text.find("#include"), std::string::npos);
    EXPECT_EQ(source.files[0], "sprite_single.frag");
    EXPECT_EQ(std::ranges::count(source.files, "shared/lattice.glsl"), 1);
    EXPECT_EQ(std::ranges::count(source.files, "shared/octree.glsl"), 1);
    // After an include the numbers go on where the file left off.
    const std::string_view original = embeddedShaders().at("sprite_single.frag");
    const std::size_t main = original.find("void main()");
    const auto line =
        1 + std::count(original.begin(), original.begin() + static_cast<long>(main), '\n');
    const std::size_t mainAt = source.text.rfind("void main()");
    const std::size_t directive = source.text.rfind("#line ", mainAt);
    const auto after = std::count(source.text.begin() + static_cast<long>(directive),
                                  source.text.begin() + static_cast<long>(mainAt), '\n');
    EXPECT_EQ(std::stol(source.text.substr(directive + 6)) + after - 1, line);
}

TEST(ShaderLibrary, DriversLogsNameTheFile) {
    const std::vector<std::string> files{"a.frag", "shared/b.glsl"};
    EXPECT_EQ(gl::namedLog("1:12(3): error: no", files), "shared/b.glsl:12(3): error: no");
    EXPECT_EQ(gl::namedLog("0(7) : error C0000", files), "a.frag:7 : error C0000");
    EXPECT_EQ(gl::namedLog("ERROR: 1:5: what\nmore", files), "shared/b.glsl:5: what\nmore");
    EXPECT_EQ(gl::namedLog("9:1: unknown file", files), "9:1: unknown file");
}

TEST_F(GlBasics, FramesClearAndReadBackTopRowFirst) {
    Frame frame({5, 3});
    frame.begin({1, 2, 3, 4});
    const Image image = frame.readColour();
    ASSERT_EQ(image.width, 5);
    ASSERT_EQ(image.height, 3);
    for (const Rgba8 pixel : image.pixels) EXPECT_EQ(pixel, Rgba8(1, 2, 3, 4));
    for (const float depth : frame.readDepth()) EXPECT_EQ(depth, 0.0f);
    // The bottom row of GL is the last.
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 5, 1);
    const float red[] = {1.0f, 0.0f, 0.0f, 1.0f};
    const float near[] = {0.75f};
    frame.bind();
    glClearBufferfv(GL_COLOR, 0, red);
    glClearBufferfv(GL_DEPTH, 0, near);
    glDisable(GL_SCISSOR_TEST);
    EXPECT_EQ(frame.readColour().at(2, 2), Rgba8(255, 0, 0, 255));
    EXPECT_EQ(frame.readColour().at(2, 0), Rgba8(1, 2, 3, 4));
    EXPECT_EQ(frame.readDepth()[12], 0.75f);
    const std::uint32_t texture = frame.colourTexture();
    frame.resize({5, 3});
    EXPECT_EQ(frame.colourTexture(), texture);
    frame.resize({0, -4});
    EXPECT_EQ(frame.sizePx(), glm::ivec2(1, 1));
}

}  // namespace
}  // namespace voxprite
