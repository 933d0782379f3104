// The conformance page names what there is: files, tests, and the specification's uniforms.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace voxprite::test {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = VOXPRITE_SOURCE_DIR;

std::string contentOf(const fs::path& path) {
    std::ostringstream content;
    content << std::ifstream(path, std::ios::binary).rdbuf();
    return content.str();
}

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

TEST(ConformancePage, NamesFilesThatExist) {
    const std::string page = contentOf(kSource / "tests/CONFORMANCE.md");
    const std::set<std::string> files =
        matchesIn(page, std::regex("`([a-z]+/[\\w/]+\\.(?:cpp|h|glsl|frag|vert|md))`"));
    EXPECT_GT(files.size(), 15u);
    for (const std::string& file : files) EXPECT_TRUE(fs::exists(kSource / file)) << file;
}

TEST(ConformancePage, NamesTestsThatExist) {
    const std::string page = contentOf(kSource / "tests/CONFORMANCE.md");
    const std::string tests = everythingBelow(kSource / "tests", {".cpp"});
    const std::set<std::string> names =
        matchesIn(page, std::regex("`([A-Z]\\w+\\.(?:[A-Z]\\w+|\\*))`"));
    EXPECT_GT(names.size(), 40u);
    for (const std::string& name : names) {
        const std::size_t dot = name.find('.');
        const std::string test = name.substr(dot + 1);
        const std::regex declared("TEST(_F|_P)?\\(" + name.substr(0, dot) + ",\\s*" +
                                  (test == "*" ? "\\w+" : test) + "\\)");
        EXPECT_TRUE(std::regex_search(tests, declared)) << name;
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
