#include "core/io/batch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "core/base/file.h"
#include "tests/support/must.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

namespace fs = std::filesystem;

using test::must;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(Batch, IsPlannedBeforeAnyWork) {
    const auto items = must(planBatch({"a/hut.vox", "a/b/tree.qb", "layers/"}, "out", Format::svo));
    ASSERT_EQ(items.size(), 3u);
    EXPECT_EQ(items[0].output, "out/hut.svo");
    EXPECT_EQ(items[1].output, "out/tree.svo");
    EXPECT_EQ(items[2].output, "out/layers.svo");
    EXPECT_TRUE(must(planBatch({}, "out", Format::svo)).empty());

    const auto same = planBatch({"a/hut.vox", "b/hut.qb"}, "out", Format::svo);
    ASSERT_FALSE(same);
    EXPECT_EQ(
        same.error().describe(),
        "b/hut.qb: would be written to out/hut.svo, as would a/hut.vox; nothing was converted");
    EXPECT_FALSE(planBatch({"a/hut.vox", "a/hut.vox"}, "out", Format::svo));
    // Layers of one stack, all of them, whichever came last.
    EXPECT_EQ(
        planBatch({"a/walk_000.vox", "a/walk_001.vox"}, "out", Format::png).error().describe(),
        "a/walk_001.vox: would be written to out/walk_*.png, as would a/walk_000.vox; nothing "
        "was converted");
    EXPECT_TRUE(planBatch({"a/walk_000.vox", "a/run_001.vox", "a/8.vox"}, "out", Format::png));
    EXPECT_TRUE(planBatch({"a/walk_000.vox", "a/walk_001.vox"}, "out", Format::svo));
    // Nor may what lies beside them: materials and pictures have names without blanks.
    EXPECT_THAT(planBatch({"a b.vox", "a_b.vox"}, "out", Format::obj).error().describe(),
                HasSubstr("a_b.vox: would be written to out/a_b.png, as would a b.vox"));
    EXPECT_TRUE(planBatch({"a b.vox", "a_b.vox"}, "out", Format::glb));
    // Neither itself nor another input may be overwritten, by whatever name.
    EXPECT_THAT(planBatch({"a/hut.vox"}, "a/../a", Format::vox).error().describe(),
                HasSubstr("is an input"));
    EXPECT_THAT(planBatch({"b/hut.qb", "a/hut.svo"}, "a", Format::svo).error().describe(),
                HasSubstr("nothing was converted"));
}

TEST(Batch, OverwritesNothingThatIsReadForAnInput) {
    const test::TemporaryFolder folder, layers;
    const fs::path mesh = folder / "m.obj";
    for (const fs::path& path : {mesh, layers / "hut_000.png"}) {
        ASSERT_TRUE(saveDocument(path, test::documentOf(test::figure()), GameProfile{}));
    }
    EXPECT_THAT(planBatch({mesh}, folder.path(), Format::png).error().describe(),
                HasSubstr("m.png: is read for " + mesh.string()));
    EXPECT_THAT(
        planBatch({"hut_001.vox", layers.path()}, layers.path(), Format::png).error().describe(),
        HasSubstr("hut_001.png: is read for " + layers.path().string()));
    EXPECT_TRUE(planBatch({mesh, layers.path()}, folder.path(), Format::vox));
}

class BatchOfFiles : public testing::Test {
  protected:
    BatchOfFiles() {
        const auto save = [&](const std::string& name, const Document& document) {
            inputs_.push_back(folder_ / name);
            EXPECT_TRUE(saveDocument(inputs_.back(), document, GameProfile{}));
        };
        save("figure.vox", test::documentOf(test::figure()));
        save("busy.voxprite", test::busyDocument());
        inputs_.push_back(folder_ / "broken.vox");
        std::ofstream(inputs_.back()) << "VOX ";
        save("walk.svo", test::animationOf({test::figure(), test::asymmetric()}));
        inputs_.push_back(folder_ / "missing.qb");
        inputs_.push_back(folder_ / "unknown.txt");
        save("shape.qb", test::documentOf(test::asymmetric()));
        save("flat.png", test::documentOf(test::shellSphere(9)));
        save("noise.csm", test::documentOf(test::randomVoxels(5, {9, 9, 9}, 0.5, 255)));
    }

    // Every file of the output by its name.
    std::map<std::string, Bytes> convert(Format to, int jobs, BatchReport report = {}) {
        const test::TemporaryFolder out;
        BatchOptions options;
        options.jobs = jobs;
        outcomes_ = runBatch(must(planBatch(inputs_, out.path(), to)), options, report);
        std::map<std::string, Bytes> files;
        for (const auto& entry : fs::directory_iterator(out.path())) {
            files[entry.path().filename().string()] = must(readFile(entry.path()));
        }
        return files;
    }

    test::TemporaryFolder folder_;
    std::vector<fs::path> inputs_;
    std::vector<BatchOutcome> outcomes_;
};

TEST_F(BatchOfFiles, OneThatFailsStopsAndSpoilsNoOther) {
    const auto files = convert(Format::vox, 3);
    std::vector<std::string> names;
    for (const auto& [name, bytes] : files) names.push_back(name);
    EXPECT_THAT(names, ElementsAre("busy.vox", "figure.vox", "flat.vox", "noise.vox", "shape.vox",
                                   "walk.vox"));
    ASSERT_EQ(outcomes_.size(), 9u);
    for (const std::size_t failed : {2u, 4u, 5u}) {
        ASSERT_TRUE(outcomes_[failed].error) << failed;
        EXPECT_EQ(outcomes_[failed].error->file, inputs_[failed].string());
        EXPECT_EQ(outcomes_[failed].bytes, 0u);
    }
    EXPECT_FALSE(outcomes_[1].error);
    EXPECT_EQ(outcomes_[1].from, Format::voxprite);
    EXPECT_EQ(outcomes_[1].bytes, files.at("busy.vox").size());
    EXPECT_FALSE(outcomes_[1].losses.empty());
}

TEST_F(BatchOfFiles, OneThatIsTooLargeForTheMemorySaysSo) {
    const test::TemporaryFolder out;
    BatchOptions options;
    options.prepare = [](Document&) -> Status { throw std::bad_alloc(); };
    outcomes_ = runBatch(must(planBatch({inputs_[0]}, out.path(), Format::qb)), options, {});
    ASSERT_TRUE(outcomes_[0].error);
    EXPECT_EQ(outcomes_[0].error->describe(), inputs_[0].string() + ": there is not enough memory");
}

TEST_F(BatchOfFiles, TheOutputIsAFunctionOfTheInputAlone) {
    for (const FormatInfo& info : formats()) {
        if (!info.writes()) continue;
        const auto once = convert(info.format, 1);
        EXPECT_GE(once.size(), 6u) << info.name;
        EXPECT_EQ(convert(info.format, 1), once) << info.name;
        EXPECT_EQ(convert(info.format, 4), once) << info.name;
    }
}

TEST_F(BatchOfFiles, WhatIsDoneIsToldInOrderAndLossesBeforeIt) {
    std::vector<std::size_t> done, losing;
    BatchReport report;
    report.done = [&](std::size_t index, const BatchOutcome&) { done.push_back(index); };
    report.losing = [&](std::size_t index, const std::vector<std::string>& losses) {
        EXPECT_TRUE(std::ranges::find(done, index) == done.end());
        EXPECT_FALSE(losses.empty());
        losing.push_back(index);
    };
    convert(Format::csm, 4, report);
    EXPECT_THAT(done, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8));
    EXPECT_EQ(losing.size(), 6u);
}

TEST_F(BatchOfFiles, StrictOnesWriteNothingThatLoses) {
    const test::TemporaryFolder out;
    BatchOptions options;
    options.strict = true;
    const auto outcomes = runBatch(must(planBatch(inputs_, out.path(), Format::vox)), options);
    EXPECT_FALSE(outcomes[0].error);
    ASSERT_TRUE(outcomes[1].error);
    EXPECT_THAT(outcomes[1].error->message, HasSubstr("would lose something: .vox has no clips"));
    EXPECT_FALSE(fs::exists(out / "busy.vox"));
    EXPECT_TRUE(fs::exists(out / "figure.vox"));
}

}  // namespace
}  // namespace voxprite
