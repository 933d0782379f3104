// Real .vox files from outside the repository: every *.vox below the folder that the environment
// variable VOXPRITE_CORPUS names. Without it the tests run on their own fixtures alone.
#pragma once

#include <filesystem>
#include <vector>

namespace voxprite::test {

// Sorted by path; empty when VOXPRITE_CORPUS is not set.
[[nodiscard]] std::vector<std::filesystem::path> corpusFiles();

// Says plainly on stdout that the corpus part of a test does not run. Returns whether it said so:
//     if (corpusNotice()) return;
bool corpusNotice();

}  // namespace voxprite::test
