// Files that are written beside the one that was asked for never replace what is somebody else's.
#include <fstream>

#include "core/base/file.h"
#include "core/io/formats.h"
#include "tests/app/cli_program.h"
#include "tests/support/must.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

class CliNeighbours : public CommandLine {
  protected:
    std::string model() const {
        EXPECT_TRUE(saveDocument(file("hut.voxprite"), documentOf(figure()), GameProfile{}));
        return file("hut.voxprite");
    }
    void write(const std::string& name, const std::string& content) const {
        std::ofstream(file(name), std::ios::binary) << content;
    }
    [[nodiscard]] bool exists(const std::string& name) const {
        return std::filesystem::exists(file(name));
    }
};

TEST_F(CliNeighbours, OfAMeshAreKeptUnlessItRefersToThem) {
    const std::string input = model();
    const std::vector<std::string> convert{"convert", input, "-o", file("hut.obj")};
    for (const char* name : {"hut.png", "hut.mtl"}) {
        write(name, "mine");
        const ProgramResult refused = run(convert);
        EXPECT_EQ(refused.status, 1);
        EXPECT_NE(refused.err.find(name), std::string::npos) << refused.err;
        EXPECT_NE(refused.err.find("nothing was written"), std::string::npos) << refused.err;
        EXPECT_EQ(contentOf(file(name)), "mine");
        EXPECT_FALSE(exists("hut.obj"));
        // A mesh that refers to others does not own it, either.
        write("hut.obj", "mtllib other.mtl\nv 0 0 0\n");
        EXPECT_EQ(run(convert).status, 1);
        EXPECT_EQ(contentOf(file(name)), "mine");
        std::filesystem::remove(file("hut.obj"));
        std::filesystem::remove(file(name));
    }
    write("hut.png", "mine");
    std::vector<std::string> forced = convert;
    forced.push_back("--force");
    ASSERT_EQ(run(forced).status, 0);
    EXPECT_NE(contentOf(file("hut.png")), "mine");

    // What was exported before is exported again, in other colours, too.
    Document painted = documentOf(figure());
    painted.palette.colours[1] = {1, 200, 3, 255};
    ASSERT_TRUE(saveDocument(input, painted, GameProfile{}));
    const std::string before = contentOf(file("hut.png"));
    ASSERT_EQ(run(convert).status, 0);
    EXPECT_NE(contentOf(file("hut.png")), before);
}

TEST_F(CliNeighbours, TheSameFilesAgainAreNoLoss) {
    const std::string input = model();
    ASSERT_EQ(run({"convert", input, "-o", file("a.obj")}).status, 0);
    std::filesystem::remove(file("a.obj"));
    EXPECT_EQ(run({"convert", input, "-o", file("a.obj")}).status, 0);
}

TEST_F(CliNeighbours, OfAStackOfPicturesAreKept) {
    const std::string input = model();
    write("hut_001.png", "mine");
    EXPECT_EQ(run({"convert", input, "-o", file("hut_000.png")}).status, 1);
    EXPECT_EQ(contentOf(file("hut_001.png")), "mine");
    EXPECT_EQ(run({"convert", input, "-o", file("hut_000.png"), "--force"}).status, 0);
    EXPECT_EQ(run({"convert", input, "-o", file("hut_000.png")}).status, 0) << "once more";
    const std::vector<std::filesystem::path> replaced =
        replacedBySaving(file("hut_000.png"), documentOf(figure()));
    EXPECT_EQ(replaced.back(), std::filesystem::path(file("hut_000.png")));
    std::size_t pictures = 0;
    for (const auto& entry : std::filesystem::directory_iterator(file(""))) {
        pictures += entry.path().extension() == ".png";
    }
    EXPECT_EQ(replaced.size(), pictures);
}

TEST_F(CliNeighbours, OfASpriteSheetAreKeptUnlessItsTextRefersToThem) {
    const std::string input = model();
    const std::vector<std::string> sheet{"sheet",        input, "-o",       file("hut.png"),
                                         "--directions", "1",   "--normals"};
    for (const char* name : {"hut.json", "hut.normals.png"}) {
        write(name, "mine");
        const ProgramResult refused = run(sheet);
        EXPECT_EQ(refused.status, 1);
        EXPECT_NE(refused.err.find(name), std::string::npos) << refused.err;
        EXPECT_NE(refused.err.find("nothing was written"), std::string::npos) << refused.err;
        EXPECT_EQ(contentOf(file(name)), "mine");
        EXPECT_FALSE(exists("hut.png"));
        std::filesystem::remove(file(name));
    }
    // The picture itself was asked for.
    write("hut.png", "mine");
    ASSERT_EQ(run(sheet).status, 0);
    EXPECT_NE(contentOf(file("hut.png")), "mine");
    // What was made before is made again in other colours, but nothing that it did not have.
    Document painted = documentOf(figure());
    painted.palette.colours[1] = {1, 200, 3, 255};
    ASSERT_TRUE(saveDocument(input, painted, GameProfile{}));
    EXPECT_EQ(run(sheet).status, 0);
    write("hut.depths.png", "mine");
    std::vector<std::string> more = sheet;
    more.push_back("--depths");
    EXPECT_EQ(run(more).status, 1);
    EXPECT_EQ(contentOf(file("hut.depths.png")), "mine");
    more.push_back("--force");
    EXPECT_EQ(run(more).status, 0);
    EXPECT_NE(contentOf(file("hut.depths.png")), "mine");
    more.pop_back();
    EXPECT_EQ(run(more).status, 0) << "once more";
}

TEST_F(CliNeighbours, ATurntableIsAskedForByItsName) {
    write("turn.gif", "mine");
    EXPECT_EQ(run({"sheet", model(), "-o", file("hut.png"), "--directions", "2", "--turntable",
                   file("turn.gif")})
                  .status,
              0);
    EXPECT_NE(contentOf(file("turn.gif")), "mine");
}

}  // namespace
}  // namespace voxprite::test
