#include "core/base/file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

#include "tests/support/temporary_folder.h"

namespace voxprite {
namespace {

using test::TemporaryFolder;

std::size_t entriesIn(const std::filesystem::path& folder) {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder),
                                                  std::filesystem::directory_iterator()));
}

TEST(File, ReadsBackWhatWasWritten) {
    const TemporaryFolder folder;
    Bytes bytes(300'000);
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * 7);
    ASSERT_TRUE(writeFileAtomically(folder / "a.bin", bytes));
    EXPECT_EQ(readFile(folder / "a.bin").value(), bytes);
    ASSERT_TRUE(writeFileAtomically(folder / "empty", Bytes{}));
    EXPECT_TRUE(readFile(folder / "empty").value().empty());
    ASSERT_TRUE(writeFileAtomically(folder / "a.txt", std::string("one\ntwo\0three", 13)));
    EXPECT_EQ(readTextFile(folder / "a.txt").value(), std::string("one\ntwo\0three", 13));
    EXPECT_EQ(entriesIn(folder.path()), 3u);
}

TEST(File, ReplacesTheOldContent) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeFileAtomically(folder / "a", std::string("a long first version")));
    ASSERT_TRUE(writeFileAtomically(folder / "a", std::string("second")));
    EXPECT_EQ(readTextFile(folder / "a").value(), "second");
    EXPECT_EQ(entriesIn(folder.path()), 1u);
}

TEST(File, WhoHasItOpenKeepsTheOldVersionWhole) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeFileAtomically(folder / "a", std::string("first")));
    std::ifstream open(folder / "a");
    ASSERT_TRUE(writeFileAtomically(folder / "a", std::string("the second version")));
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(open), {}), "first");
}

TEST(File, KeepsPermissionsOfTheOldFile) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeFileAtomically(folder / "a", std::string("first")));
    ASSERT_EQ(::chmod((folder / "a").c_str(), 0640), 0);
    ASSERT_TRUE(writeFileAtomically(folder / "a", std::string("second")));
    struct stat status {};
    ASSERT_EQ(::stat((folder / "a").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777, 0640u);
}

TEST(File, WritesThroughALinkAndKeepsIt) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeFileAtomically(folder / "target", std::string("first")));
    std::filesystem::create_symlink("target", folder / "link");
    ASSERT_TRUE(writeFileAtomically(folder / "link", std::string("second")));
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
    EXPECT_EQ(readTextFile(folder / "target").value(), "second");
}

TEST(File, WritesThroughALinkToWhatIsNotThereYet) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "below");
    std::filesystem::create_symlink("below/second", folder / "first");
    std::filesystem::create_symlink("target", folder / "below" / "second");
    ASSERT_TRUE(writeFileAtomically(folder / "first", std::string("new")));
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "first"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "below" / "second"));
    EXPECT_EQ(readTextFile(folder / "below" / "target").value(), "new");
    EXPECT_EQ(entriesIn(folder / "below"), 2u);
}

// `voxprite ... -o /dev/stdout >> log`: others write to that file, too.
TEST(File, ADescriptorOfTheProcessIsWrittenToEvenIfItIsOfAFile) {
    const TemporaryFolder folder;
    const int log = ::open((folder / "log").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
    ASSERT_GE(log, 0);
    ASSERT_EQ(::write(log, "before,", 7), 7);
    std::filesystem::create_symlink("/dev/fd/" + std::to_string(log), folder / "link");
    ASSERT_TRUE(writeFileAtomically(folder / "link", std::string("between,")));
    ASSERT_EQ(::write(log, "after", 5), 5);
    ::close(log);
    EXPECT_EQ(readTextFile(folder / "log").value(), "before,between,after");
    EXPECT_EQ(entriesIn(folder.path()), 2u);
}

TEST(File, NamesMayBeAsLongAsTheFolderAllows) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder / std::string(255, 'n');
    ASSERT_TRUE(writeFileAtomically(path, std::string("kept")));
    EXPECT_EQ(readTextFile(path).value(), "kept");
}

TEST(File, WritesToAPipeWithoutReplacingIt) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    std::filesystem::create_symlink("pipe", folder / "link");
    const int reader = ::open((folder / "pipe").c_str(), O_RDONLY | O_NONBLOCK);
    ASSERT_GE(reader, 0);
    ASSERT_TRUE(writeFileAtomically(folder / "pipe", std::string("straight ")));
    ASSERT_TRUE(writeFileAtomically(folder / "link", std::string("linked")));
    std::string text(100, '\0');
    const ssize_t got = ::read(reader, text.data(), text.size());
    ::close(reader);
    ASSERT_GE(got, 0);
    EXPECT_EQ(text.substr(0, static_cast<std::size_t>(got)), "straight linked");
    EXPECT_TRUE(std::filesystem::is_fifo(folder / "pipe"));
    EXPECT_EQ(entriesIn(folder.path()), 2u);
}

TEST(File, AMissingFolderIsAnErrorThatNamesTheFile) {
    const TemporaryFolder folder;
    const Status written = writeFileAtomically(folder / "missing/a", std::string("x"));
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().describe(),
              (folder / "missing/a").string() + ": cannot be written: No such file or directory");
    EXPECT_EQ(entriesIn(folder.path()), 0u);
}

TEST(File, WhatCannotBeWrittenIsKnownBefore) {
    const TemporaryFolder folder;
    const std::filesystem::path missing = folder / "missing" / "a";
    const Status may = checkWritable(missing);
    ASSERT_FALSE(may);
    EXPECT_EQ(may.error().describe(),
              writeFileAtomically(missing, std::string("a")).error().describe());
    std::filesystem::create_symlink("missing/a", folder / "link");
    EXPECT_FALSE(checkWritable(folder / "link"));
    EXPECT_FALSE(checkWritable(folder.path()));
    EXPECT_TRUE(checkWritable(folder / "a"));
    EXPECT_TRUE(checkWritable("/dev/null"));
    EXPECT_EQ(entriesIn(folder.path()), 1u);
}

// Root may write to everything; so the test is somebody else for a moment.
TEST(File, AFileThatIsReadOnlyIsNotReplaced) {
    const TemporaryFolder folder;
    ASSERT_TRUE(writeFileAtomically(folder / "a", std::string("first")));
    const bool isRoot = ::geteuid() == 0;
    constexpr uid_t kNobody = 65534;
    ASSERT_EQ(::chmod(folder.path().c_str(), 0777), 0);
    ASSERT_EQ(::chmod((folder / "a").c_str(), 0444), 0);
    ASSERT_TRUE(!isRoot || ::seteuid(kNobody) == 0);
    const Status known = checkWritable(folder / "a");
    const Status refused = writeFileAtomically(folder / "a", std::string("second"));
    const Status beside = writeFileAtomically(folder / "b", std::string("new"));
    ASSERT_TRUE(!isRoot || ::seteuid(0) == 0);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("Permission denied"), std::string::npos);
    EXPECT_FALSE(known);
    EXPECT_TRUE(beside);
    EXPECT_EQ(readTextFile(folder / "a").value(), "first");
    EXPECT_EQ(entriesIn(folder.path()), 2u);
}

TEST(File, AFailedReplacementLeavesAllAsItWas) {
    const TemporaryFolder folder;
    // A folder that is not empty cannot be replaced by a file, not even by the administrator.
    std::filesystem::create_directory(folder / "a");
    ASSERT_TRUE(writeFileAtomically(folder / "a/inside", std::string("kept")));
    const Status written = writeFileAtomically(folder / "a", std::string("x"));
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().file, (folder / "a").string());
    EXPECT_EQ(readTextFile(folder / "a/inside").value(), "kept");
    EXPECT_EQ(entriesIn(folder.path()), 1u) << "a temporary file was left behind";
}

TEST(File, RefusesToReadWhatIsNoFile) {
    const TemporaryFolder folder;
    EXPECT_EQ(readFile(folder / "none").error().describe(),
              (folder / "none").string() + ": cannot be opened: No such file or directory");
    EXPECT_EQ(readFile(folder.path()).error().message, "is a folder, not a file");
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_EQ(readFile(folder / "pipe").error().message, "is not a regular file");
}

TEST(File, RefusesWhatIsTooLargeBeforeReadingIt) {
    const TemporaryFolder folder;
    std::ofstream(folder / "huge").put('x');
    std::filesystem::resize_file(folder / "huge", kMaxFileBytes + 1);  // sparse: takes no space
    const auto read = readFile(folder / "huge");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().message, "has 4294967297 bytes; at most 4294967296 can be read");
}

}  // namespace
}  // namespace voxprite
