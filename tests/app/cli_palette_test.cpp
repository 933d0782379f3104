// Palette variants and shading on the command line.
#include <algorithm>
#include <set>
#include <tuple>

#include "core/io/formats.h"
#include "core/io/png.h"
#include "tests/app/cli_program.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;

class CliPalette : public CommandLine {
  protected:
    void SetUp() override {
        document_ = documentOf(figure());
        Palette& palette = document_.palette;
        palette = Palette{};
        for (int i = 1; i < 256; ++i) {
            palette.colours[static_cast<std::size_t>(i)] =
                Rgba8(i / 36 * 36, i / 6 % 6 * 50, i % 6 * 50, 255);
        }
        palette.variants = {{"Red team", {}}, {"Winter", {}}};
        for (int i = 1; i < 256; ++i) {
            palette.variants[0].overrides[static_cast<std::uint8_t>(i)] = Rgba8(i, 0, 0, 255);
        }
        ASSERT_TRUE(saveDocument(model(), document_, GameProfile{}));
    }
    [[nodiscard]] std::string model() const { return file("figure.voxprite"); }

    [[nodiscard]] ProgramResult render(std::vector<std::string> options) const {
        std::vector<std::string> arguments{"render", model(),   "--json", "--yaw",
                                           "30",     "--pitch", "20"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return run(arguments);
    }
    // The colours of a sprite buffer but for the outline's black.
    [[nodiscard]] std::set<std::tuple<int, int, int>> coloursIn(const std::string& png) const {
        const auto image = readPngFile(png);
        EXPECT_TRUE(image);
        std::set<std::tuple<int, int, int>> colours;
        for (const Rgba8 pixel : image->pixels) {
            if (pixel.w != 0 && pixel != Rgba8(0, 0, 0, 255)) {
                colours.insert({pixel.x, pixel.y, pixel.z});
            }
        }
        return colours;
    }

    Document document_;
};

TEST_F(CliPalette, AVariantIsDrawnInItsColours) {
    const ProgramResult plain = render({"--buffer", file("a.png")});
    const ProgramResult red = render({"--buffer", file("b.png"), "--variant", "Red team"});
    ASSERT_EQ(red.status, 0) << red.err;
    EXPECT_EQ(plain.json()["buffer"]["ids_sha256"], red.json()["buffer"]["ids_sha256"]);
    EXPECT_NE(plain.json()["buffer"]["sha256"], red.json()["buffer"]["sha256"]);
    for (const auto& [r, g, b] : coloursIn(file("b.png"))) {
        EXPECT_GT(r, 0);
        EXPECT_EQ(g, 0);
        EXPECT_EQ(b, 0);
    }
    // A variant without colours of its own is the original.
    EXPECT_EQ(render({"--variant", "Winter"}).json()["buffer"]["sha256"],
              plain.json()["buffer"]["sha256"]);

    const ProgramResult none = render({"--variant", "Blue"});
    EXPECT_EQ(none.status, 1);
    EXPECT_NE(none.json()["error"]["message"].get<std::string>().find("Red team, Winter"),
              std::string::npos);
}

TEST_F(CliPalette, ShadingWithinThePaletteShowsOnlyItsColoursOnCpuAndGl) {
    std::set<std::tuple<int, int, int>> palette;
    for (std::size_t i = 1; i < 256; ++i) {
        const Rgba8 c = document_.palette.colours[i];
        palette.insert({c.x, c.y, c.z});
    }
    const ProgramResult cpu = render({"--shading", "palette", "--buffer", file("p.png")});
    ASSERT_EQ(cpu.status, 0) << cpu.err;
    for (const auto& colour : coloursIn(file("p.png"))) EXPECT_TRUE(palette.contains(colour));
    const std::string multiplied = render({"--shading", "multiply"}).json()["buffer"]["sha256"];
    EXPECT_NE(cpu.json()["buffer"]["sha256"], multiplied);
    EXPECT_EQ(render({}).json()["buffer"]["sha256"], multiplied);
    for (const char* mode : {"sprite", "single_pass"}) {
        const ProgramResult gl =
            render({"--shading", "palette", "--backend", "gl", "--mode", mode});
        ASSERT_EQ(gl.status, 0) << gl.err;
        EXPECT_EQ(gl.json()["buffer"]["sha256"], cpu.json()["buffer"]["sha256"]) << mode;
    }
    EXPECT_EQ(render({"--shading", "soft"}).status, 2);
}

TEST_F(CliPalette, InspectListsVariantsAndConvertSaysWhatIsLost) {
    const Json inspected = run({"inspect", model(), "--json"}).json();
    EXPECT_EQ(inspected["palette"]["variants"],
              Json::parse(R"([{"name": "Red team", "colours": 255},
                              {"name": "Winter", "colours": 0}])"));
    EXPECT_NE(run({"inspect", model()}).out.find("Red team"), std::string::npos);

    const Json lost = run({"convert", model(), "-o", file("a.vox"), "--json"}).json();
    ASSERT_EQ(lost["warnings"].size(), 1u);
    EXPECT_NE(lost["warnings"][0].get<std::string>().find("Red team, Winter"), std::string::npos);
    const Json kept = run({"convert", model(), "-o", file("b.voxprite"), "--json"}).json();
    EXPECT_TRUE(kept["warnings"].empty());
    EXPECT_EQ(loadDocument(file("b.voxprite"))->document.palette, document_.palette);

    // One variant by itself loses nothing, and its colours are the file's.
    for (const char* command : {"export", "convert"}) {
        const std::string output = file(std::string(command) + ".svo");
        const Json json =
            run({command, model(), "--variant", "Red team", "-o", output, "--json"}).json();
        EXPECT_TRUE(json["warnings"].empty());
        EXPECT_EQ(loadDocument(output)->document.palette.colours[77], Rgba8(77, 0, 0, 255));
    }
    const Json exported = run({"export", model(), "-o", file("c.svo"), "--json"}).json();
    EXPECT_EQ(exported["warnings"].size(), 1u);
    EXPECT_EQ(exported["verified"], true);
}

TEST_F(CliPalette, ColoursComeOutAndGoIn) {
    const Json listed = run({"palette", model(), "--json"}).json();
    std::uint64_t voxels = 0;
    for (const Json& used : listed["used"]) {
        const auto index = used["index"].get<std::size_t>();
        const Rgba8 c = document_.palette.colours[index];
        EXPECT_EQ(used["rgb"], Json({c.x, c.y, c.z}));
        voxels += used["voxels"].get<std::uint64_t>();
    }
    EXPECT_EQ(voxels, document_.models[0].voxels.solidCount());

    // Out as each kind of file, in again: the same palette.
    for (const char* name : {"c.gpl", "c.pal", "c.png"}) {
        ASSERT_EQ(run({"palette", model(), "-o", file(name)}).status, 0);
        ASSERT_EQ(
            run({"palette", model(), "--import", file(name), "-o", file("in.voxprite")}).status, 0);
        EXPECT_EQ(loadDocument(file("in.voxprite"))->document.palette, document_.palette) << name;
    }
    // A variant's colours into a variant of another name.
    ASSERT_EQ(run({"palette", model(), "--variant", "Red team", "-o", file("red.png")}).status, 0);
    ASSERT_EQ(run({"palette", model(), "--variant", "Blood", "--import", file("red.png"), "-o",
                   file("more.voxprite")})
                  .status,
              0);
    const Palette more = loadDocument(file("more.voxprite"))->document.palette;
    ASSERT_EQ(more.variants.size(), 3u);
    EXPECT_EQ(more.variants[2].name, "Blood");
    EXPECT_EQ(more.withVariant(2).colours, document_.palette.withVariant(0).colours);

    ASSERT_EQ(run({"palette", model(), "--remove-unused", "-o", file("few.voxprite")}).status, 0);
    const Palette few = loadDocument(file("few.voxprite"))->document.palette;
    for (std::size_t i = 1; i < 256; ++i) {
        const bool used = std::ranges::any_of(listed["used"],
                                              [&](const Json& each) { return each["index"] == i; });
        EXPECT_EQ(few.colours[i], used ? document_.palette.colours[i] : Rgba8(0));
    }

    // Formats without variants get the colours of the one that is named, and say what they lack.
    const ProgramResult red =
        run({"palette", model(), "--variant", "Red team", "-o", file("red.svo"), "--json"});
    ASSERT_EQ(red.status, 0) << red.err;
    EXPECT_EQ(loadDocument(file("red.svo"))->document.palette.colours[77], Rgba8(77, 0, 0, 255));
    EXPECT_TRUE(red.json()["warnings"].empty());
    const ProgramResult base = run({"palette", model(), "-o", file("base.svo")});
    EXPECT_NE(base.err.find("Red team, Winter"), std::string::npos) << base.err;
    EXPECT_EQ(run({"palette", model(), "-o", file("base.svo"), "--json"}).json()["warnings"].size(),
              1u);

    std::ofstream(file("bad.gpl")) << "GIMP Palette\nred\n";
    const ProgramResult bad =
        run({"palette", model(), "--import", file("bad.gpl"), "-o", file("x.voxprite"), "--json"});
    EXPECT_EQ(bad.status, 1);
    EXPECT_EQ(bad.json()["error"]["line"], 2);
    EXPECT_FALSE(std::filesystem::exists(file("x.voxprite")));
    const ProgramResult blue = run({"palette", model(), "--variant", "Blue", "--json"});
    EXPECT_EQ(blue.status, 1);
    EXPECT_NE(blue.out.find("Red team, Winter"), std::string::npos) << blue.out;
}

TEST_F(CliPalette, ChangesNeedAFileThatCanHoldThem) {
    ASSERT_EQ(run({"palette", model(), "-o", file("c.gpl")}).status, 0);
    for (const std::vector<std::string>& change :
         {std::vector<std::string>{"--import", file("c.gpl")},
          {"--remove-unused"},
          {"--suggest-ramps"}}) {
        std::vector<std::string> arguments{"palette", model()};
        arguments.insert(arguments.end(), change.begin(), change.end());
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.status, 2) << change[0];
        EXPECT_NE(result.err.find("-o OUT"), std::string::npos) << result.err;
    }
    for (const char* name : {"x.txt", "x.gltf", "x"}) {
        const ProgramResult result = run({"palette", model(), "-o", file(name)});
        EXPECT_EQ(result.status, 2) << name;
        EXPECT_NE(result.err.find(".gpl, .pal, .voxprite"), std::string::npos) << result.err;
        EXPECT_FALSE(std::filesystem::exists(file(name)));
    }
}

TEST_F(CliPalette, CountsWhatTheOutputHolds) {
    document_.palette.ramps = {{"greens", {10, 30}}};
    ASSERT_TRUE(saveDocument(model(), document_, GameProfile{}));
    const auto report = [&](const char* output) {
        return run({"palette", model(), "-o", file(output), "--json"}).json();
    };
    const Json all = report("all.voxprite");
    EXPECT_EQ(all["variants"], 2);
    EXPECT_EQ(all["ramps"], 1);
    for (const char* name : {"few.vox", "few.gpl"}) {
        const Json few = report(name);
        EXPECT_EQ(few["variants"], 0) << name;
        EXPECT_EQ(few["ramps"], 0) << name;
        EXPECT_EQ(few["used"], all["used"]) << name;
    }
}

}  // namespace
}  // namespace voxprite::test
