// `voxprite sheet`, and what an engine reads of it.
#include <cmath>
#include <filesystem>

#include "core/io/formats.h"
#include "core/io/png.h"
#include "tests/app/cli_program.h"
#include "tests/support/must.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;

class CliSheet : public CommandLine {
  protected:
    std::string saved(const Document& document) {
        const std::string path = file("model.voxprite");
        EXPECT_TRUE(saveDocument(path, document, GameProfile{}));
        return path;
    }
    Json sheet(const std::vector<std::string>& options) {
        std::vector<std::string> arguments{"sheet", file("model.voxprite"), "-o", file("out.png"),
                                           "--json"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        return result.json();
    }
    [[nodiscard]] Json text() const { return Json::parse(contentOf(file("out.json"))); }
};

Document walk() {
    Document document = animationOf({figure(), asymmetric(), figure(), asymmetric()});
    document.clips.push_back({"idle", 0, 1, 4.0, true, {}});
    document.clips.push_back({"step", 2, 3, 8.0, false, {70, 90}});
    document.sockets.push_back({"hand", {{0, {12.0, 3.0, 18.0}}}});
    return document;
}

TEST_F(CliSheet, ItsSpritesAreThoseThatRenderCasts) {
    const std::string model = saved(walk());
    sheet({"--directions", "6", "--pitch", "30,60", "--sigma", "2", "--frames", "0,3"});
    const Json json = text();
    const Image image = must(readPngFile(file("out.png")));
    ASSERT_EQ(json["frames"].size(), 24u);
    for (const std::size_t k : {0u, 3u, 13u, 23u}) {
        const Json& frame = json["frames"][k];
        const Json& own = frame["voxprite"];
        const auto number = [](const Json& value) { return value.dump(); };
        const ProgramResult cast =
            run({"render", model, "--ortho", "--sigma", "2", "--yaw", number(own["yaw"]), "--pitch",
                 number(own["pitch"]), "--frame", number(own["frame"]), "--buffer",
                 file("buffer.png")});
        ASSERT_EQ(cast.status, 0) << cast.err;
        const Image buffer = must(readPngFile(file("buffer.png")));
        // The buffer has an empty border; the sheet's sprite is the rest.
        std::uint64_t opaque = 0;
        for (const Rgba8 pixel : buffer.pixels) opaque += pixel.w != 0 ? 1 : 0;
        int left = buffer.width, top = buffer.height;
        for (int y = 0; y < buffer.height; ++y)
            for (int x = 0; x < buffer.width; ++x)
                if (buffer.at(x, y).w != 0) {
                    left = std::min(left, x);
                    top = std::min(top, y);
                }
        const Json& place = frame["frame"];
        for (int y = 0; y < place["h"].get<int>(); ++y)
            for (int x = 0; x < place["w"].get<int>(); ++x) {
                const Rgba8 pixel = image.at(place["x"].get<int>() + x, place["y"].get<int>() + y);
                ASSERT_EQ(pixel, buffer.at(left + x, top + y)) << k;
                opaque -= pixel.w != 0 ? 1 : 0;
            }
        EXPECT_EQ(opaque, 0u);
    }
}

TEST_F(CliSheet, TellsClipsPivotAndSocketsInAsepritesLayout) {
    saved(walk());
    const Json report = sheet({"--directions", "2"});
    const Json json = text();
    EXPECT_EQ(report["sprites"], 8);
    EXPECT_EQ(json["meta"]["image"], "out.png");
    EXPECT_EQ(json["meta"]["size"]["w"], report["size"][0]);
    const Json& tags = json["meta"]["frameTags"];
    ASSERT_EQ(tags.size(), 4u);
    EXPECT_EQ(tags[0]["name"], "idle_yaw0");
    EXPECT_EQ(tags[1]["name"], "step_yaw0");
    EXPECT_EQ(tags[3]["name"], "step_yaw180");
    EXPECT_EQ(tags[3]["from"], 6);
    EXPECT_EQ(tags[3]["to"], 7);
    EXPECT_FALSE(tags[0].contains("repeat"));
    EXPECT_EQ(tags[1]["repeat"], "1");
    EXPECT_EQ(json["meta"]["voxprite"]["clips"][1]["durations"], (std::vector<int>{70, 90}));
    const std::vector<int> durations{250, 250, 70, 90};
    for (std::size_t k = 0; k < 8; ++k) {
        const Json& frame = json["frames"][k];
        EXPECT_EQ(frame["duration"], durations[k % 4]);
        EXPECT_EQ(frame["rotated"], false);
        EXPECT_EQ(frame["sourceSize"]["w"], report["cell"][0]);
        EXPECT_EQ(frame["spriteSourceSize"]["w"], frame["frame"]["w"]);
        EXPECT_EQ(frame["voxprite"]["sockets"]["hand"]["px"].size(), 2u);
        const Json& pivot = json["meta"]["slices"][0]["keys"][0]["pivot"];
        EXPECT_EQ(std::floor(frame["voxprite"]["anchor"][0].get<double>() + 0.25), pivot["x"]);
        EXPECT_EQ(std::floor(frame["voxprite"]["anchor"][1].get<double>() + 0.25), pivot["y"]);
    }
    EXPECT_EQ(json["frames"][6]["filename"], "6");
    EXPECT_EQ(json["frames"][6]["voxprite"]["name"], "out/yaw180/2");
}

TEST_F(CliSheet, TagsHaveNamesThatEnginesTake) {
    Document document = walk();
    document.clips[0].name = document.clips[1].name = "walk/[north]";
    saved(document);
    sheet({"--directions", "1", "--pitch", "30,60"});
    const Json json = text();
    std::vector<std::string> names;
    for (const Json& tag : json["meta"]["frameTags"]) names.push_back(tag["name"]);
    EXPECT_EQ(names, (std::vector<std::string>{
                         "walk__north]_yaw0_pitch30", "walk__north] 2_yaw0_pitch30",
                         "walk__north]_yaw0_pitch60", "walk__north] 2_yaw0_pitch60"}));
}

TEST_F(CliSheet, WritesEveryPictureThatWasAskedFor) {
    Document document = walk();
    document.palette.variants.push_back({"night", {{1, Rgba8(5, 5, 40, 255)}}});
    saved(document);
    const Json report = sheet({"--directions", "2", "--normals", "--depths", "--indices",
                               "--turntable", file("turn.png"), "--magnify", "2"});
    for (const char* name : {"out.png", "out.variant-night.png", "out.normals.png",
                             "out.depths.png", "out.indices.png"}) {
        const Image image = must(readPngFile(file(name)));
        EXPECT_EQ(image.width, report["size"][0]) << name;
        EXPECT_EQ(image.height, report["size"][1]) << name;
    }
    EXPECT_EQ(must(readPngFile(file("turn.png"))).width, 2 * report["cell"][0].get<int>());
    EXPECT_EQ(text()["meta"]["voxprite"]["images"]["variant-night"], "out.variant-night.png");
    // The same input gives the same bytes.
    const std::string before = contentOf(file("out.png")) + contentOf(file("out.json"));
    sheet({"--directions", "2", "--normals", "--depths", "--indices"});
    EXPECT_EQ(contentOf(file("out.png")) + contentOf(file("out.json")), before);
}

TEST_F(CliSheet, RefusesWrongUsageWithoutWritingAnything) {
    const std::string model = saved(walk());
    const std::string out = file("none.png");
    for (const std::vector<std::string>& wrong : {std::vector<std::string>{"--frames", "2-1"},
                                                  {"--frames", "a"},
                                                  {"--pitch", "1,,2"},
                                                  {"--directions", "0"},
                                                  {"--padding", "65"},
                                                  {"--pitch", "30,91"},
                                                  {"--turntable", file("turn.jpg")},
                                                  {"--sigma", "1000"}}) {
        std::vector<std::string> arguments{"sheet", model, "-o", out};
        arguments.insert(arguments.end(), wrong.begin(), wrong.end());
        EXPECT_EQ(run(arguments).status, 2) << wrong[0] << wrong[1];
    }
    for (const std::vector<std::string>& failing : {std::vector<std::string>{"--frames", "4"},
                                                    {"--variants", "noon"},
                                                    {"--largest-edge", "32"}}) {
        std::vector<std::string> arguments{"sheet", model, "-o", out};
        arguments.insert(arguments.end(), failing.begin(), failing.end());
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.status, 1) << failing[0];
        EXPECT_EQ(result.errorLines(), 1);
    }
    EXPECT_EQ(run({"sheet", model, "-o", file("sheet.gif")}).status, 2);
    EXPECT_FALSE(std::filesystem::exists(out));
    EXPECT_FALSE(std::filesystem::exists(file("turn.jpg")));
    EXPECT_EQ(run({"sheet", model, "-o", file("LOUD.PNG"), "--directions", "1"}).status, 0);
}

}  // namespace
}  // namespace voxprite::test
