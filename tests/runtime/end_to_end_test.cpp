// What the program says of a sprite is what a runtime makes of the file that the program wrote:
// `voxprite render --json` of the source, of the exported file, and the viewer in C with
// `--lattice`, over the command lines that people use.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/base/file.h"
#include "core/io/formats.h"
#include "core/io/svo_file.h"
#include "tests/app/cli_program.h"
#include "tests/support/must.h"
#include "tests/support/process.h"

namespace voxprite::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const std::array<std::vector<std::string>, 3> kViews{{
    {"--yaw", "33", "--pitch", "21", "--sigma", "2"},
    {"--yaw", "-120", "--pitch", "-35", "--roll", "17", "--sigma", "1.5", "--occlusion", "0"},
    {"--yaw", "90", "--sigma", "0.5", "--view", "camera_forward"},
}};

class EndToEnd : public CommandLine {
  protected:
    static std::string sample(const std::string& name) {
        return (fs::path(VOXPRITE_SOURCE_DIR) / "samples" / name).string();
    }
    std::string rendered(const std::string& model, const std::vector<std::string>& view,
                         const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments{"render", model, "--json"};
        arguments.insert(arguments.end(), view.begin(), view.end());
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProgramResult result = run(arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        return result.out;
    }
    // As the viewer prints it.
    static std::string lineOf(const std::string& told) {
        const Json buffer = Json::parse(told).at("buffer");
        return std::to_string(buffer["size"][0].get<int>()) + "x" +
               std::to_string(buffer["size"][1].get<int>()) + " " +
               buffer["sha256"].get<std::string>() + " " + buffer["ids_sha256"].get<std::string>() +
               "\n";
    }
    std::string seen(const VirtualDisplay& display, const std::string& model,
                     const std::string& views, const std::vector<std::string>& more) const {
        EXPECT_TRUE(writeFileAtomically(file("views.json"), views));
        std::vector<std::string> arguments{RUNTIME_VIEWER, model, "--lattice", file("views.json")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        fs::remove(file("said"));
        Process viewer(arguments, {"DISPLAY=" + display.name(), "LIBGL_ALWAYS_SOFTWARE=1"},
                       file("said"));
        EXPECT_EQ(viewer.wait(std::chrono::seconds(600)), 0);
        return contentOf(file("said"));
    }
};

TEST_F(EndToEnd, TheViewerMakesWhatRenderSaysOfEachEntityOfOneFile) {
    // Unlike in size, palette and frames; all called knight.
    Document painted = must(loadDocument(sample("truck.vox"))).document;
    auto& colours = painted.palette.colours;
    std::rotate(colours.begin() + 1, colours.begin() + 40, colours.end());
    ASSERT_TRUE(saveDocument(file("knight.voxprite"), painted, GameProfile{}));
    const std::vector<std::string> sources{sample("knight.vox"), sample("walk.voxprite"),
                                           file("knight.voxprite")};
    std::vector<std::string> arguments{"export", "-o", file("set.svo"), "--json"};
    arguments.insert(arguments.end(), sources.begin(), sources.end());
    const ProgramResult exported = run(arguments);
    ASSERT_EQ(exported.status, 0) << exported.err;
    const Json told = exported.json();
    EXPECT_EQ(told["verified"], true);
    ASSERT_EQ(told["entities"].size(), sources.size());
    const std::vector<SvoFile> set = must(readSvoSet(must(readFile(file("set.svo")))));
    ASSERT_EQ(set.size(), sources.size());
    EXPECT_EQ(set[0].name, "knight");
    EXPECT_EQ(set[1].name, "knight 2") << "a game finds entities by name";
    EXPECT_EQ(set[2].name, "knight 3");
    EXPECT_NE(set[2].palette, set[0].palette);
    EXPECT_GT(set[1].clips.size(), 0u);

    VirtualDisplay display;
    ASSERT_NO_FATAL_FAILURE(display.start({1280, 800}, file("")));
    for (std::size_t entity = 0; entity < sources.size(); ++entity) {
        SCOPED_TRACE(sources[entity]);
        const std::vector<std::string> chosen{"--entity", std::to_string(entity)};
        // The same entity in a file of its own.
        ASSERT_EQ(run({"export", sources[entity], "-o", file("one.svo")}).status, 0);
        SvoFile one = must(readSvo(must(readFile(file("one.svo")))));
        one.name = set[entity].name;
        if (one.models.size() == 1) one.models[0].name = one.name;
        EXPECT_EQ(one, set[entity]);

        std::string views, expected;
        for (const std::vector<std::string>& view : kViews) {
            const std::string ofSource = rendered(sources[entity], view);
            views += ofSource;
            expected += lineOf(ofSource);
        }
        EXPECT_EQ(lineOf(rendered(file("set.svo"), kViews[entity], chosen)),
                  lineOf(rendered(sources[entity], kViews[entity])));
        EXPECT_EQ(seen(display, file("set.svo"), views, chosen), expected);
        EXPECT_EQ(seen(display, file("one.svo"), views, {}), expected);
    }
}

}  // namespace
}  // namespace voxprite::test
