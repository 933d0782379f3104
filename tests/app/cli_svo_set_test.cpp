// Several entities in one .svo, from the command line.
#include <fstream>

#include "core/base/file.h"
#include "core/io/formats.h"
#include "core/io/svo_file.h"
#include "core/io/svo_set.h"
#include "tests/app/cli_program.h"
#include "tests/support/must.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

using Json = nlohmann::json;

class CliSvoSet : public CommandLine {
  protected:
    std::string saved(const std::string& name, const Document& document) const {
        EXPECT_TRUE(saveDocument(file(name), document, GameProfile{}));
        return file(name);
    }
    // Two of one name, and one of many frames.
    std::string exportedSet() const {
        Document figures = documentOf(figure());
        figures.entity.name = "guard";
        Document box = documentOf(solidBox({3, 4, 5}));
        box.palette.colours[1] = {200, 10, 30, 255};
        box.entity.anchorVoxels = glm::dvec3(1.0, 2.0, 0.5);
        const ProgramResult result =
            run({"export", saved("a.voxprite", figures), saved("busy.voxprite", busyDocument()),
                 saved("guard.voxprite", box), "-o", file("set.svo")});
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_NE(result.out.find("3 entities"), std::string::npos) << result.out;
        return file("set.svo");
    }
};

TEST_F(CliSvoSet, EachInputIsAnEntityWithWhatItHas) {
    const std::vector<SvoFile> set = must(readSvoSet(must(readFile(exportedSet()))));
    ASSERT_EQ(set.size(), 3u);
    EXPECT_EQ(set[0].name, "guard");
    EXPECT_EQ(set[2].name, "guard 2");
    EXPECT_EQ(set[2].palette[1], Rgba8(200, 10, 30, 255));
    EXPECT_NE(set[0].palette[1], set[2].palette[1]);
    EXPECT_EQ(set[2].anchor, glm::dvec3(1.0, 2.0, 0.5));
    EXPECT_TRUE(verifyExport(set[1], busyDocument()));
}

TEST_F(CliSvoSet, WhereOneIsMeantItMustBeChosen) {
    const std::string set = exportedSet();
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"render", set, "--json"},
          {"convert", set, "-o", file("out.vox"), "--json"},
          {"export", set, "-o", file("out.svo"), "--json"},
          {"sheet", set, "-o", file("out.png"), "--json"},
          {"trade", set, "-o", file("report"), "--quick", "--axes", "mode", "--backend", "cpu",
           "--json"}}) {
        const ProgramResult refused = run(command);
        EXPECT_EQ(refused.status, 1);
        const std::string message = refused.json()["error"]["message"];
        EXPECT_NE(message.find("3 entities (0 guard"), std::string::npos) << message;
        std::vector<std::string> chosen = command;
        chosen.insert(chosen.end(), {"--entity", "2"});
        EXPECT_EQ(run(chosen).status, 0) << command[0];
        chosen.back() = "3";
        EXPECT_EQ(run(chosen).status, 1) << command[0];
    }
    const ProgramResult turned = run({"trade", "--temporal", set, "--entity", "3"});
    EXPECT_NE(turned.err.find("there is no entity 3"), std::string::npos) << turned.err;
    // What comes out of the set alone is what went in.
    const SvoFile one = must(readSvo(must(readFile(file("out.svo")))));
    EXPECT_EQ(one, must(readSvo(must(readFile(set)), 2)));
    const Json told = run({"inspect", set, "--json"}).json();
    ASSERT_EQ(told["entities"].size(), 3u);
    EXPECT_EQ(told["entities"][2]["name"], "guard 2");
    EXPECT_EQ(told["models"].back()["entity"], 2);
    EXPECT_EQ(told["models"].back()["size"], Json::array({3, 4, 5}));
    EXPECT_EQ(run({"inspect", set, "--entity", "2", "--json"}).json()["models"].size(), 1u);
}

TEST_F(CliSvoSet, OnlySetsHaveEntitiesToChoose) {
    const std::string model = saved("one.vox", documentOf(figure()));
    const ProgramResult negative = run({"inspect", model, "--entity", "-1"});
    EXPECT_EQ(negative.status, 2);
    EXPECT_NE(negative.err.find("-1"), std::string::npos) << negative.err;
    const ProgramResult none = run({"inspect", model, "--entity", "0"});
    EXPECT_EQ(none.status, 1);
    EXPECT_NE(none.err.find("one.vox: there is no entity 0"), std::string::npos) << none.err;
}

// What would be left is one entity, or none.
TEST_F(CliSvoSet, ASetIsNotReplacedByAPart) {
    const std::string set = exportedSet();
    const std::string before = contentOf(set);
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"export", set, "--entity", "0", "-o", set},
          {"convert", set, "--entity", "0", "-o", set},
          {"palette", set, "--entity", "0", "-o", set}}) {
        EXPECT_EQ(run(command).status, 2) << command[0];
        EXPECT_EQ(contentOf(set), before) << command[0];
    }
}

TEST_F(CliSvoSet, EachModelOfAFileCanBeAnEntity) {
    const Document document = busyDocument();
    const std::string input = saved("busy.voxprite", document);
    const ProgramResult result = run({"export", input, "--each", "-o", file("each.svo"), "--json"});
    ASSERT_EQ(result.status, 0) << result.err;
    const std::vector<SvoFile> set = must(readSvoSet(must(readFile(file("each.svo")))));
    const std::vector<SetMember> members = modelsOneByOne(document, GameProfile{}, "busy");
    ASSERT_EQ(set.size(), members.size());
    ASSERT_GT(set.size(), 1u);
    for (std::size_t i = 0; i < set.size(); ++i) {
        EXPECT_TRUE(verifyModelExport(set[i], document, *members[i].model)) << i;
        EXPECT_FALSE(set[i].name.empty());
        // The octree is that of the model exported by itself.
        const std::string number = std::to_string(i);
        ASSERT_EQ(run({"export", input, "--model", number, "-o", file("one.svo")}).status, 0);
        const SvoFile one = must(readSvo(must(readFile(file("one.svo")))));
        EXPECT_EQ(one.models[0].octree.nodes, set[i].models[0].octree.nodes);
        EXPECT_EQ(one.models[0].octree.payloads, set[i].models[0].octree.payloads);
        EXPECT_EQ(one.palette, set[i].palette);
        EXPECT_EQ(one.anchor, set[i].anchor);
    }
    EXPECT_EQ(run({"export", input, "--each", "--model", "0", "-o", file("x.svo")}).status, 2);
}

TEST_F(CliSvoSet, OneBadInputLeavesWhatWasThere) {
    const std::string good = saved("good.voxprite", busyDocument());
    std::ofstream(file("bad.vox")) << "no such thing";
    std::ofstream(file("set.svo")) << "old";
    const ProgramResult result = run({"export", good, file("bad.vox"), "-o", file("set.svo")});
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.err.find("bad.vox"), std::string::npos) << result.err;
    EXPECT_EQ(contentOf(file("set.svo")), "old");
}

}  // namespace
}  // namespace voxprite::test
