// `voxprite render`: the same sprite from every backend and mode, and what its options do.
#include <array>
#include <fstream>
#include <set>

#include "core/base/hash.h"
#include "core/io/formats.h"
#include "core/io/png.h"
#include "core/io/profile_json.h"
#include "core/sprite/composite.h"
#include "tests/app/cli_program.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;

class CliRender : public CommandLine {
  protected:
    void SetUp() override {
        ASSERT_TRUE(saveDocument(model(), documentOf(figure()), GameProfile{}));
    }
    [[nodiscard]] std::string model() const { return file("figure.vox"); }

    Json render(const std::vector<std::string>& options) const {
        std::vector<std::string> arguments{"render", model(), "--json"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        return result.json();
    }
    [[nodiscard]] Image png(const std::string& name) const {
        const auto image = readPngFile(file(name));
        EXPECT_TRUE(image) << image.error().describe();
        return image ? *image : Image{};
    }
};

TEST_F(CliRender, JsonHasTheKeysOfTheContract) {
    const Json json = render({"-o", file("o.png"), "--buffer", file("b.png")});
    EXPECT_EQ(json["backend"], "cpu");
    EXPECT_EQ(json["mode"], "sprite");
    EXPECT_EQ(json["sigma_in_force"], 4.0);
    EXPECT_EQ(json["image"]["size"], Json({512, 512}));
    EXPECT_TRUE(json["ms"].is_object());
    const Image picture = png("o.png");
    EXPECT_EQ(picture.width, 512);
    EXPECT_EQ(picture.height, 512);

    // The hash, the counts and the picture of the buffer are those of one and the same thing.
    const Image buffer = png("b.png");
    EXPECT_EQ(json["buffer"]["size"], Json({buffer.width, buffer.height}));
    EXPECT_EQ(json["buffer"]["sha256"], sha256Hex(asBytes(buffer.pixels)));
    std::uint64_t covered = 0;
    std::uint64_t outline = 0;
    for (int y = 0; y < buffer.height; ++y) {
        for (int x = 0; x < buffer.width; ++x) {
            const Rgba8 c = buffer.at(x, y);
            EXPECT_TRUE(c.w == 255 || c == Rgba8(0));
            if (c.w == 255) ++covered;
            if (c == Rgba8(0, 0, 0, 255)) ++outline;
        }
    }
    EXPECT_EQ(json["buffer"]["opaque"].get<std::uint64_t>() +
                  json["buffer"]["outline"].get<std::uint64_t>(),
              covered);
    EXPECT_EQ(json["buffer"]["outline"], outline);
    EXPECT_EQ(json["buffer"]["ids_sha256"].get<std::string>().size(), 64u);
    const Json& lattice = json["lattice"];
    for (const char* bits : {"position", "direction", "step"}) {
        EXPECT_TRUE(lattice["bits"][bits].is_number_integer());
    }
    for (const char* vector : {"C", "D", "U", "V"}) EXPECT_EQ(lattice[vector].size(), 3u);
    EXPECT_EQ(lattice["first"].size(), 2u);
    EXPECT_EQ(lattice["size"], json["buffer"]["size"]);
}

TEST_F(CliRender, JsonHasTheLightThatARuntimeNeeds) {
    GameProfile profile;
    profile.outline.colour = {12, 34, 56, 255};
    ASSERT_TRUE(writeProfileFile(file("p.json"), profile));
    const Json json = render({"--profile", file("p.json"), "--yaw", "33", "--pitch", "12"});
    glm::ivec3 direction;
    for (int axis = 0; axis < 3; ++axis) direction[axis] = json["lattice"]["D"][axis];
    const std::array<std::uint8_t, 3> light8 =
        faceLight(direction, voxelFromWorld(profile.light.towardLight), profile.light.ambient);
    EXPECT_EQ(json["lit"], Json({{"light8", light8},
                                 {"shading", "multiply"},
                                 {"face_rays", false},
                                 {"outline", {12, 34, 56}}}));
    EXPECT_EQ(render({"--shading", "palette"})["lit"]["shading"], "palette");
    EXPECT_EQ(render({"--occlusion", "0.5"})["lit"]["face_rays"], true);
    profile.outline.enabled = false;
    ASSERT_TRUE(writeProfileFile(file("p.json"), profile));
    EXPECT_EQ(render({"--profile", file("p.json")})["lit"]["outline"], nullptr);
}

TEST_F(CliRender, TheWholeModelIsInThePicture) {
    for (const char* size : {"256x256", "300x100", "90x220"}) {
        for (const std::vector<std::string>& camera : {std::vector<std::string>{"--fov", "60"},
                                                       {"--ortho"},
                                                       {"--yaw", "45", "--pitch", "35"}}) {
            std::vector<std::string> options{"-o", file("o.png"), "--size", size};
            options.insert(options.end(), camera.begin(), camera.end());
            static_cast<void>(render(options));
            const Image image = png("o.png");
            std::uint64_t inside = 0;
            std::uint64_t atBorder = 0;
            for (int y = 0; y < image.height; ++y) {
                for (int x = 0; x < image.width; ++x) {
                    if (image.at(x, y).w == 0) continue;
                    ++inside;
                    if (x == 0 || y == 0 || x + 1 == image.width || y + 1 == image.height) {
                        ++atBorder;
                    }
                }
            }
            EXPECT_GT(inside, 100u) << size;
            EXPECT_EQ(atBorder, 0u) << size;
        }
    }
}

TEST_F(CliRender, EveryBackendAndModeCastsTheSameBuffer) {
    const std::vector<std::vector<std::string>> views{
        {},
        {"--yaw", "90"},
        {"--pitch", "90", "--yaw", "30"},
        {"--yaw", "45", "--pitch", "35.264"},
        {"--yaw", "-20", "--pitch", "10", "--roll", "5", "--sigma", "7.5"},
        {"--yaw", "200", "--pitch", "-40", "--sigma", "1", "--rotate", "10,20,30", "--scale", "2"},
        {"--yaw", "35", "--pitch", "25", "--occlusion", "0.7", "--shadow", "0.8"},
        {"--yaw", "-60", "--rotate", "77,5,-9", "--sigma", "1.5", "--shadow", "1"}};
    for (const auto& view : views) {
        Json buffers[3];
        const std::vector<std::string> ways[3] = {{"--backend", "cpu"},
                                                  {"--backend", "gl"},
                                                  {"--backend", "gl", "--mode", "single_pass"}};
        for (int k = 0; k < 3; ++k) {
            std::vector<std::string> options = ways[k];
            options.insert(options.end(), view.begin(), view.end());
            buffers[k] = render(options)["buffer"];
        }
        EXPECT_EQ(buffers[0], buffers[1]);
        EXPECT_EQ(buffers[0], buffers[2]);
        EXPECT_GT(buffers[0]["opaque"].get<int>(), 0);
    }
    EXPECT_EQ(render({"--mode", "single_pass"})["buffer"], render({})["buffer"]);
}

TEST_F(CliRender, OcclusionAndShadowChangeColoursAlone) {
    const std::vector<std::string> view{"--yaw", "35", "--pitch", "25"};
    const auto shaded = [&](std::vector<std::string> options) {
        options.insert(options.end(), view.begin(), view.end());
        return render(options)["buffer"];
    };
    const Json plain = shaded({});
    EXPECT_EQ(shaded({"--occlusion", "0", "--shadow", "0"}), plain);
    std::set<std::string> pictures{plain["sha256"].get<std::string>()};
    for (const std::vector<std::string>& options : {std::vector<std::string>{"--occlusion", "0.5"},
                                                    {"--shadow", "0.5"},
                                                    {"--occlusion", "0.5", "--shadow", "0.5"},
                                                    {"--occlusion", "0.9", "--shadow", "0.5"}}) {
        const Json buffer = shaded(options);
        EXPECT_EQ(buffer["ids_sha256"], plain["ids_sha256"]);
        EXPECT_TRUE(pictures.insert(buffer["sha256"].get<std::string>()).second);
    }
    // The profile says the same, and the option wins.
    std::ofstream(file("p.json"))
        << R"({"voxprite_profile": 1, "minification": false, "light": {"shadow": 0.5}})";
    EXPECT_EQ(shaded({"--profile", file("p.json")}), shaded({"--shadow", "0.5"}));
    EXPECT_EQ(shaded({"--profile", file("p.json"), "--shadow", "0"}), plain);
    for (const char* option : {"--occlusion", "--shadow"}) {
        EXPECT_EQ(run({"render", model(), "-o", file("o.png"), option, "1.5"}).status, 2);
    }
}

// In perspective the faces have the same light as in the sprite.
TEST_F(CliRender, ShadedVoxelsAgreeBetweenBackends) {
    for (const std::string backend : {"cpu", "gl"}) {
        render({"--mode", "voxels", "--yaw", "30", "--pitch", "20", "--size", "128x128",
                "--occlusion", "0.8", "--shadow", "0.9", "--backend", backend, "-o",
                file(backend + ".png")});
    }
    render({"--mode", "voxels", "--yaw", "30", "--pitch", "20", "--size", "128x128", "-o",
            file("plain.png")});
    const auto differing = [&](const std::string& other) {
        return run({"compare", file("cpu.png"), file(other), "--json"}).json()["mismatch_rate"];
    };
    EXPECT_LT(differing("gl.png").get<double>(), 0.002);
    EXPECT_GT(differing("plain.png").get<double>(), 0.02);
}

TEST_F(CliRender, VoxelsAgreeBetweenBackends) {
    const std::vector<std::string> view{"--mode",  "voxels", "--yaw",  "30",
                                        "--pitch", "20",     "--size", "128x128"};
    for (const char* backend : {"cpu", "gl"}) {
        std::vector<std::string> options = view;
        for (const std::string& option : {std::string("--backend"), std::string(backend),
                                          std::string("-o"), file(std::string(backend) + ".png")}) {
            options.push_back(option);
        }
        EXPECT_FALSE(render(options).contains("buffer"));
    }
    const Json difference = run({"compare", file("cpu.png"), file("gl.png"), "--json"}).json();
    // Perspective rays are in floating point on the GPU: a few pixels at edges may differ.
    EXPECT_LT(difference["mismatch_rate"].get<double>(), 0.002);
    EXPECT_GT(difference["iou"].get<double>(), 0.99);
}

TEST_F(CliRender, VoxelsStandOnTheGround) {
    for (const char* backend : {"cpu", "gl"}) {
        render({"--mode", "voxels", "--ground", "--pitch", "20", "--size", "96x96", "--backend",
                backend, "-o", file(std::string(backend) + ".png")});
        const Image picture = png(std::string(backend) + ".png");
        EXPECT_EQ(picture.at(2, 93), Ground{}.colour) << backend;
        EXPECT_NE(picture.at(48, 48), Ground{}.colour) << backend;
    }
    const Json difference = run({"compare", file("cpu.png"), file("gl.png"), "--json"}).json();
    EXPECT_LT(difference["mismatch_rate"].get<double>(), 0.002);
}

TEST_F(CliRender, LatticeFilesCastExactlyTheGivenView) {
    const ProgramResult first = run({"render", model(), "--json", "--yaw", "33", "--pitch", "12"});
    ASSERT_EQ(first.status, 0) << first.err;
    std::ofstream(file("whole.json")) << first.out;
    std::ofstream(file("lattice.json")) << first.json()["lattice"].dump();
    for (const char* name : {"whole.json", "lattice.json"}) {
        const Json again = render({"--lattice", file(name), "-o", file("o.png")});
        EXPECT_EQ(again["buffer"], first.json()["buffer"]) << name;
        EXPECT_EQ(again["lattice"], first.json()["lattice"]) << name;
        EXPECT_NEAR(again["sigma_in_force"].get<double>(), 4.0, 1e-3) << name;
        EXPECT_EQ(again["image"]["size"], again["buffer"]["size"]);
        EXPECT_EQ(sha256Hex(asBytes(png("o.png").pixels)), again["buffer"]["sha256"]);
    }
    Json wrong = first.json()["lattice"];
    wrong["D"] = {0, 0, 0};
    std::ofstream(file("wrong.json")) << wrong.dump();
    const ProgramResult refused =
        run({"render", model(), "--json", "--lattice", file("wrong.json")});
    EXPECT_EQ(refused.status, 1);
    EXPECT_EQ(refused.json()["error"]["file"], file("wrong.json"));
}

TEST_F(CliRender, AnchorAndPositionMoveNothingButThePlace) {
    // The camera looks at the centre: where the entity stands does not change its sprite.
    const Json buffer = render({})["buffer"];
    EXPECT_EQ(render({"--position", "100,-5,3"})["buffer"], buffer);
    EXPECT_EQ(render({"--anchor", "0,0,0"})["buffer"], buffer);
    EXPECT_EQ(render({"--anchor", "-3,7.5,90", "--position", "1e5,0,0"})["buffer"], buffer);
}

TEST_F(CliRender, TurningTheEntityIsTurningTheCameraTheOtherWay) {
    // The eye carried toward +X by 90 degrees sees what the entity turned clockwise shows.
    const Json turned = render({"--rotate", "-90,0,0"})["lattice"];
    EXPECT_EQ(turned["D"], render({"--yaw", "90"})["lattice"]["D"]);
    EXPECT_EQ(turned["U"], render({"--yaw", "90"})["lattice"]["U"]);
}

TEST_F(CliRender, ProfileFilesAndOptionsAreInForce) {
    GameProfile profile;
    profile.sigma = 2.0;
    profile.minification = false;
    profile.outline.enabled = false;
    ASSERT_TRUE(writeProfileFile(file("game.json"), profile));
    const Json withProfile = render({"--profile", file("game.json")});
    EXPECT_EQ(withProfile["sigma_in_force"], 2.0);
    EXPECT_EQ(withProfile["buffer"]["outline"], 0);
    EXPECT_EQ(render({"--profile", file("game.json"), "--sigma", "3"})["sigma_in_force"], 3.0);
    profile.mode = SpriteMode::singlePass;
    ASSERT_TRUE(writeProfileFile(file("single.json"), profile));
    EXPECT_EQ(withProfile["mode"], "sprite");
    EXPECT_EQ(render({"--profile", file("single.json")})["mode"], "single_pass");
    EXPECT_EQ(render({"--profile", file("single.json"), "--mode", "sprite"})["mode"], "sprite");
    // A virtual pixel far smaller than a screen pixel: sigma is halved only when asked.
    EXPECT_EQ(render({"--size", "64x64", "--sigma", "16"})["sigma_in_force"], 16.0);
    EXPECT_LT(render({"--size", "64x64", "--sigma", "16", "--minification"})["sigma_in_force"],
              16.0);
    EXPECT_EQ(
        render({"--size", "64x64", "--sigma", "16", "--minification", "off"})["sigma_in_force"],
        16.0);
    // Snapping to 45 degrees is the view of 45 degrees.
    EXPECT_EQ(render({"--yaw", "40", "--view-step", "45"})["lattice"]["D"],
              render({"--yaw", "45"})["lattice"]["D"]);
}

TEST_F(CliRender, BackgroundAndGroundAreBehindTheSprite) {
    static_cast<void>(render({"-o", file("o.png"), "--background", "#10203040"}));
    EXPECT_EQ(png("o.png").at(0, 0), Rgba8(0x10, 0x20, 0x30, 0x40));
    static_cast<void>(render({"-o", file("g.png"), "--pitch", "30", "--ground"}));
    const Image withGround = png("g.png");
    EXPECT_EQ(withGround.at(0, 511).w, 255);
    static_cast<void>(render({"-o", file("n.png"), "--pitch", "30"}));
    const Image without = png("n.png");
    // With the depth rule ground_safe the ground hides nothing of the sprite.
    int hidden = 0;
    for (std::size_t k = 0; k < without.pixels.size(); ++k) {
        if (without.pixels[k].w == 255 && without.pixels[k] != withGround.pixels[k]) ++hidden;
    }
    EXPECT_EQ(hidden, 0);
    // A ground above the model hides it from a camera below... and from above it is all there is.
    static_cast<void>(render({"-o", file("h.png"), "--pitch", "30", "--ground", "2"}));
    const Image above = png("h.png");
    EXPECT_EQ(above.at(256, 400), above.at(0, 511));
}

TEST_F(CliRender, AnEmptyModelIsNotSeen) {
    ASSERT_TRUE(saveDocument(file("empty.voxprite"), Document::withEmptyModel(), GameProfile{}));
    const ProgramResult result =
        run({"render", file("empty.voxprite"), "--json", "-o", file("o.png")});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(result.json()["unseen"], "empty_model");
    EXPECT_EQ(result.json()["buffer"]["size"], Json({0, 0}));
    EXPECT_EQ(result.json()["buffer"]["opaque"], 0);
    const ProgramResult inside = run({"render", model(), "--json", "--distance", "0.2"});
    ASSERT_EQ(inside.status, 0) << inside.err;
    EXPECT_EQ(inside.json()["unseen"], "camera_inside");
}

TEST_F(CliRender, NoPictureIsWrittenWithoutItsBuffer) {
    const std::string picture = file("a.png");
    for (const std::vector<std::string>& options :
         {std::vector<std::string>{"--buffer", file("b.png"), "--distance", "0.2"},
          {"--buffer", file("missing/b.png")}}) {
        std::vector<std::string> arguments{"render", model(), "-o", picture};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.status, 1);
        EXPECT_NE(result.err.find(options[1]), std::string::npos) << result.err;
        EXPECT_FALSE(std::filesystem::exists(picture)) << result.err;
    }
}

// The driver's limit, or that of a picture's file.
TEST_F(CliRender, APictureLargerThanCanBeIsNotWritten) {
    for (const char* mode : {"sprite", "voxels", "clusters", "billboard"}) {
        const ProgramResult result = run({"render", model(), "-o", file("wide.png"), "--backend",
                                          "gl", "--mode", mode, "--size", "20000x16"});
        EXPECT_EQ(result.status, 1) << mode;
        EXPECT_NE(result.err.find("16384"), std::string::npos) << result.err;
        EXPECT_FALSE(std::filesystem::exists(file("wide.png"))) << mode;
    }
}

TEST_F(CliRender, APictureTooLargeForTheMemoryIsRefused) {
    const ProgramResult result =
        run({"-c", R"(ulimit -v 3000000; exec "$0" "$@")", VOXPRITE_PROGRAM, "render", model(),
             "-o", file("huge.png"), "--backend", "cpu", "--size", "32768x32768"},
            "", "/bin/sh");
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.err, "voxprite render: there is not enough memory\n");
}

TEST_F(CliRender, FramesShareBounds) {
    ASSERT_TRUE(saveDocument(file("walk.voxprite"),
                             animationOf({solidBox({2, 2, 2}), solidBox({9, 4, 6})}),
                             GameProfile{}));
    const auto lattice = [&](const char* frame) {
        return run({"render", file("walk.voxprite"), "--json", "--frame", frame}).json();
    };
    EXPECT_EQ(lattice("0")["lattice"], lattice("1")["lattice"]);
    EXPECT_NE(lattice("0")["buffer"]["sha256"], lattice("1")["buffer"]["sha256"]);
    // One source model alone has its own bounds.
    const Json alone = run({"render", file("walk.voxprite"), "--json", "--model", "0"}).json();
    EXPECT_NE(alone["lattice"], lattice("0")["lattice"]);
}

}  // namespace
}  // namespace voxprite::test
