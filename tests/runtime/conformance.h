// The conformance set of samples/runtime/conformance, as its index.json lists it.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/file.h"
#include "tests/support/must.h"

namespace voxprite::test {

inline std::filesystem::path conformanceFolder() {
    return std::filesystem::path(VOXPRITE_SOURCE_DIR) / "samples/runtime/conformance";
}

struct ConformanceFile {
    nlohmann::json entry;
    Bytes bytes;
    [[nodiscard]] std::string name() const { return entry["file"]; }
    [[nodiscard]] bool valid() const { return entry["valid"]; }
};

inline std::vector<ConformanceFile> conformanceSet() {
    std::vector<ConformanceFile> files;
    const auto index =
        nlohmann::json::parse(must(readTextFile(conformanceFolder() / "index.json")));
    for (const nlohmann::json& entry : index) {
        const std::string name = entry["file"];
        files.push_back({entry, must(readFile(conformanceFolder() / name))});
    }
    EXPECT_GT(files.size(), 80u);
    return files;
}

}  // namespace voxprite::test
