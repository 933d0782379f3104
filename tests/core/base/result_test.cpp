#include "core/base/result.h"

#include <gtest/gtest.h>

namespace voxprite {
namespace {

std::string describe(const Failure& failure) {
    return failure.value().describe();
}

TEST(Result, DescribesWhereAndWhy) {
    EXPECT_EQ(describe(fail("too large")), "too large");
    EXPECT_EQ(describe(failAtByte(120, "cut short")), "byte 120: cut short");
    EXPECT_EQ(describe(failAtLine(3, 14, "a comma")), "line 3, column 14: a comma");
    EXPECT_EQ(describe(failInFile("hut.vox", "is empty")), "hut.vox: is empty");
}

TEST(Result, NamesTheFileOnceOnly) {
    const Result<int> bare = failAtByte(0, "no magic number");
    EXPECT_EQ(inFile(bare, "a.vox").error().describe(), "a.vox: byte 0: no magic number");
    EXPECT_EQ(inFile(inFile(bare, "inner.vox"), "outer.vox").error().file, "inner.vox");
    EXPECT_EQ(inFile(Result<int>(7), "a.vox").value(), 7);
}

TEST(Result, DescribesOnOneLineWhateverTheTextHolds) {
    const std::string text = describe(failInFile("a\nb.vox", "chunk \"\r\n\t\x7F\" x"));
    EXPECT_EQ(text, "a b.vox: chunk \"    \" x");
}

}  // namespace
}  // namespace voxprite
