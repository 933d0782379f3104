// The conformance pages, one a seed, name what there is: files, tests, the specification's
// uniforms.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/support/file_content.h"

namespace voxprite::test {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = VOXPRITE_SOURCE_DIR;

// All files below a folder with one of the endings, joined.
std::string everythingBelow(const fs::path& folder, const std::set<std::string>& endings,
                            const std::string& without = "no such name") {
    std::string all;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (endings.count(entry.path().extension().string()) == 0) continue;
        if (name.find(without) == std::string::npos) all += contentOf(entry.path());
    }
    return all;
}

std::set<std::string> matchesIn(const std::string& text, const std::regex& pattern) {
    std::set<std::string> found;
    for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it)
        found.insert((*it)[1].str());
    return found;
}

// A seed's page, and how many rows it has at least: what the seed asks for, counted.
struct Page {
    const char* name;
    std::size_t leastRows;
};
constexpr Page kPages[] = {{"CONFORMANCE.md", 34},
                           {"CONFORMANCE_RAYCAST.md", 44},
                           {"CONFORMANCE_SNAPSHOTS.md", 20},
                           {"CONFORMANCE_CLUSTERS.md", 20}};

std::string textOf(const Page& page) {
    return contentOf(kSource / "tests" / page.name);
}

const std::regex kTestName("`([A-Z]\\w+\\.(?:[A-Z]\\w+|\\*))`");

// The rows of all tables, without their heads.
std::vector<std::string> rowsOf(const std::string& page) {
    std::vector<std::string> rows;
    std::istringstream lines(page);
    std::string line;
    bool below = false;  // of a table's head
    while (std::getline(lines, line)) {
        if (line.empty() || line[0] != '|') {
            below = false;
        } else if (line.starts_with("|---")) {
            below = true;
        } else if (below) {
            rows.push_back(line);
        }
    }
    return rows;
}

// "Suite.Test" and "Suite.*" of every test there is.
std::set<std::string> declaredTests() {
    const std::string sources = everythingBelow(kSource / "tests", {".cpp"});
    const std::regex declaration("TEST(?:_F|_P)?\\((\\w+),\\s*(\\w+)\\)");
    std::set<std::string> declared;
    for (std::size_t at = sources.find("\nTEST"); at != std::string::npos;
         at = sources.find("\nTEST", at + 1)) {
        std::smatch match;
        const std::string head = sources.substr(at + 1, 160);
        if (!std::regex_search(head, match, declaration, std::regex_constants::match_continuous))
            continue;
        declared.insert(match[1].str() + "." + match[2].str());
        declared.insert(match[1].str() + ".*");
    }
    return declared;
}

TEST(ConformancePage, ThereIsOneForEverySeed) {
    std::set<std::string> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(kSource / "tests")) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with("CONFORMANCE")) found.insert(name);
    }
    std::set<std::string> known;
    for (const Page& page : kPages) known.insert(page.name);
    EXPECT_EQ(found, known);
}

TEST(ConformancePage, NamesFilesThatExist) {
    for (const Page& page : kPages) {
        const std::set<std::string> files = matchesIn(
            textOf(page), std::regex("`([a-z]+/[\\w/]+\\.(?:cpp|h|glsl|frag|vert|comp|md))`"));
        EXPECT_GT(files.size(), 3u) << page.name;
        for (const std::string& file : files)
            EXPECT_TRUE(fs::exists(kSource / file)) << page.name << ": " << file;
    }
}

TEST(ConformancePage, NamesTestsThatExist) {
    const std::set<std::string> declared = declaredTests();
    EXPECT_GT(declared.size(), 1000u);
    for (const Page& page : kPages) {
        const std::set<std::string> names = matchesIn(textOf(page), kTestName);
        EXPECT_GT(names.size(), 15u) << page.name;
        for (const std::string& name : names)
            EXPECT_TRUE(declared.contains(name)) << page.name << ": " << name;
    }
}

TEST(ConformancePage, EveryRowNamesATest) {
    for (const Page& page : kPages) {
        const std::vector<std::string> rows = rowsOf(textOf(page));
        EXPECT_GE(rows.size(), page.leastRows) << page.name;
        for (const std::string& row : rows) {
            EXPECT_TRUE(std::regex_search(row, kTestName) ||
                        row.find("nothing to show") != std::string::npos)
                << page.name << ": " << row;
        }
    }
}

TEST(ConformancePage, EveryDecisionHasARow) {
    const std::string page = contentOf(kSource / "tests/CONFORMANCE.md");
    const std::size_t table = page.find("| Row | Decision | Tests |");
    ASSERT_NE(table, std::string::npos);
    for (int row = 1; row <= 19; ++row)
        EXPECT_NE(page.find("\n| " + std::to_string(row) + " | ", table), std::string::npos) << row;
}

// Section 10 of the specification: its uniforms by their names, as members of blocks or samplers.
TEST(ConformancePage, TheUniformsKeepTheirNames) {
    const std::string shaders =
        everythingBelow(kSource / "shaders", {".glsl", ".frag", ".vert"}, "bench_seed");
    for (const char* declaration :
         {"usampler2D svo_texture", "sampler2D palette_texture", "uvec3 svo_model_size",
          "uint svo_max_depth", "uint node_offset", "uint payload_offset", "float voxel_size",
          "float sigma", "vec3 anchor_to_center", "vec3 ray_dir_local", "vec3 camera_up_local",
          "float camera_distance", "float billboard_depth", "vec3 light_dir"})
        EXPECT_TRUE(std::regex_search(shaders, std::regex(std::string(declaration) + "\\b")))
            << declaration;
}

}  // namespace
}  // namespace voxprite::test
