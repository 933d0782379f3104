#include "tests/support/corpus.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace voxprite::test {

namespace {

std::filesystem::path corpusFolder() {
    const char* folder = std::getenv("VOXPRITE_CORPUS");
    return folder == nullptr ? "" : folder;
}

}  // namespace

std::vector<std::filesystem::path> corpusFiles() {
    const std::filesystem::path folder = corpusFolder();
    std::vector<std::filesystem::path> files;
    if (folder.empty()) return files;
    std::error_code error;
    for (auto entry = std::filesystem::recursive_directory_iterator(folder, error);
         !error && entry != std::filesystem::recursive_directory_iterator();
         entry.increment(error)) {
        if (entry->is_regular_file() && entry->path().extension() == ".vox") {
            files.push_back(entry->path());
        }
    }
    // A wrong folder must not pass as an empty corpus.
    EXPECT_FALSE(error) << folder << ": " << error.message();
    EXPECT_FALSE(files.empty()) << "VOXPRITE_CORPUS names a folder without .vox files: " << folder;
    std::sort(files.begin(), files.end());
    return files;
}

bool corpusNotice() {
    if (!corpusFolder().empty()) return false;
    std::puts("corpus part not run: VOXPRITE_CORPUS is not set");
    return true;
}

}  // namespace voxprite::test
