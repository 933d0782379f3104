// voxprite convert --out-dir: many files, as make and job arrays call it.
#include "core/io/formats.h"
#include "tests/app/cli_program.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using Json = nlohmann::json;

class CliBatch : public test::CommandLine {
  protected:
    CliBatch() {
        std::filesystem::create_directory(file("in"));
        EXPECT_TRUE(saveDocument(file("in/figure.vox"), test::documentOf(test::figure()), {}));
        EXPECT_TRUE(saveDocument(file("in/busy.voxprite"), test::busyDocument(), {}));
        std::ofstream(file("in/broken.qb")) << "no";
    }
    [[nodiscard]] std::vector<Json> lines(const std::string& name) const {
        std::vector<Json> lines;
        std::istringstream text(test::contentOf(file(name)));
        for (std::string line; std::getline(text, line);) lines.push_back(Json::parse(line));
        return lines;
    }
};

TEST_F(CliBatch, OneBadFileFailsAloneAndTheLogSaysWhich) {
    const auto convert = [&](const std::string& out, const std::string& jobs) {
        return run({"convert", "--jobs", jobs, "--out-dir", file(out), "--to", "qb", "--log",
                    file(out + ".log"), file("in/figure.vox"), file("in/broken.qb"),
                    file("in/busy.voxprite")});
    };
    // What would overwrite nothing is told before anything is done.
    const test::ProgramResult result = convert("out", "1");
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.out.find("2 files converted to .qb"), std::string::npos) << result.out;
    EXPECT_NE(result.err.find("1 of 3 files failed"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("[2/3] failed: "), std::string::npos) << result.err;
    // Losses stand before the line that says the file is written.
    const std::size_t loss = result.err.find("busy.voxprite: .qb has no clips: 2 left out");
    ASSERT_NE(loss, std::string::npos) << result.err;
    EXPECT_LT(loss, result.err.find("[3/3] "));
    const std::vector<Json> log = lines("out.log");
    ASSERT_EQ(log.size(), 3u);
    EXPECT_EQ(log[0]["status"], "converted");
    EXPECT_EQ(log[0]["from"], "vox");
    EXPECT_EQ(log[1]["status"], "failed");
    EXPECT_NE(log[1]["error"].get<std::string>().find("broken.qb: byte 0"), std::string::npos);
    EXPECT_FALSE(log[2]["losses"].empty());
    EXPECT_TRUE(loadDocument(file("out/busy.qb")));
    EXPECT_FALSE(std::filesystem::exists(file("out/broken.qb")));

    EXPECT_EQ(convert("again", "4").status, 1);
    for (const char* name : {"figure.qb", "busy.qb"}) {
        EXPECT_EQ(test::contentOf(file(std::string("again/") + name)),
                  test::contentOf(file(std::string("out/") + name)));
    }
}

TEST_F(CliBatch, NamesThatCollideAreRefusedBeforeAnyWork) {
    std::filesystem::create_directory(file("other"));
    std::filesystem::copy_file(file("in/figure.vox"), file("other/figure.vox"));
    const test::ProgramResult result =
        run({"convert", "--out-dir", file("out"), file("in/figure.vox"), file("other/figure.vox")});
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.err.find("nothing was converted"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(file("out")));
    EXPECT_EQ(
        run({"convert", "--out-dir", file("in"), "--to", "vox", file("in/figure.vox")}).status, 1);
}

TEST_F(CliBatch, UsageIsChecked) {
    EXPECT_EQ(run({"convert", file("in/figure.vox")}).status, 2);
    EXPECT_EQ(run({"convert", "a.vox", "b.vox", "-o", "c.vox"}).status, 2);
    EXPECT_EQ(run({"convert", "a.vox", "-o", "c.vox", "--out-dir", "d"}).status, 2);
    EXPECT_EQ(run({"convert", "a.vox", "-o", "c.vox", "--jobs", "2"}).status, 2);
    EXPECT_EQ(run({"convert", "a.vox", "--out-dir", file("d"), "--to", "fbx"}).status, 2);
    EXPECT_EQ(run({"convert", "a.vox", "--out-dir", file("d"), "--jobs", "-1"}).status, 2);
    EXPECT_EQ(run({"convert", "a.vox", "--out-dir", ""}).status, 2);
    EXPECT_FALSE(std::filesystem::exists(file("d")));
}

TEST_F(CliBatch, TheLogReplacesNeitherInputsNorOutputs) {
    const std::string input = file("in/figure.vox");
    const std::string before = test::contentOf(input);
    for (const std::string& log : {input, file("out/figure.qb"), std::string()}) {
        const test::ProgramResult result =
            run({"convert", "--out-dir", file("out"), "--to", "qb", "--log", log, input});
        EXPECT_EQ(result.status, 2) << log;
        EXPECT_NE(result.err.find("--log"), std::string::npos) << result.err;
    }
    EXPECT_EQ(test::contentOf(input), before);
    EXPECT_FALSE(std::filesystem::exists(file("out")));
    const test::ProgramResult missing = run(
        {"convert", "--out-dir", file("out"), "--to", "qb", "--log", file("missing/log"), input});
    EXPECT_NE(missing.err.find("No such file"), std::string::npos) << missing.err;
}

TEST_F(CliBatch, WithoutStandardErrorFilesAreWhole) {
    ASSERT_EQ(run({"convert", "--jobs", "1", "--out-dir", file("out"), "--to", "qb", "--log",
                   file("log"), file("in/figure.vox"), file("in/busy.voxprite")},
                  "2>&-")
                  .status,
              0);
    EXPECT_EQ(lines("log").size(), 2u);  // each an object, and nothing else
}

TEST_F(CliBatch, OneFileSaysItsLossesFirstAndStrictRefusesThem) {
    const std::string busy = file("in/busy.voxprite");
    const test::ProgramResult plain = run({"convert", busy, "-o", file("b.vox")});
    EXPECT_EQ(plain.status, 0);
    EXPECT_NE(plain.err.find(".vox has no clips: 2 left out"), std::string::npos) << plain.err;
    const test::ProgramResult strict = run({"convert", "--strict", busy, "-o", file("c.vox")});
    EXPECT_EQ(strict.status, 1);
    EXPECT_FALSE(std::filesystem::exists(file("c.vox")));
    EXPECT_EQ(run({"convert", "--strict", busy, "-o", file("c.voxprite")}).status, 0);
}

}  // namespace
}  // namespace voxprite
