// The runtimes of samples/ make voxprite's sprites, by hash, from the same lattice views: the
// viewer in C on Mesa, the page on Chromium's own software driver.
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <map>

#include "core/base/file.h"
#include "core/sprite/lit_palette.h"
#include "core/trace/lattice.h"
#include "samples/runtime/voxprite_lattice.h"
#include "tests/render/views.h"
#include "tests/runtime/conformance.h"
#include "tests/runtime/exported_samples.h"
#include "tests/runtime/sprite_jobs.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace voxprite {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::JobSet;
using test::SpriteJob;

constexpr std::chrono::seconds kLong(1500);  // on a busy machine

std::string lineOf(const SpriteJob& job) {
    return job.size + " " + job.colours + " " + job.ids;
}

TEST(Viewer, SpritesAreVoxpritesByHash) {
    const test::TemporaryFolder folder;
    test::VirtualDisplay display;
    ASSERT_NO_FATAL_FAILURE(display.start({1280, 800}, folder.path()));
    std::size_t compared = 0, wide = 0;
    for (const JobSet& set : test::spriteJobs()) {
        SCOPED_TRACE(set.name);
        ASSERT_TRUE(writeFileAtomically(folder / "model.svo", set.svo));
        std::map<std::array<std::uint32_t, 2>, std::vector<const SpriteJob*>> byModel;
        for (const SpriteJob& job : set.jobs) byModel[{job.entity, job.model}].push_back(&job);
        for (const auto& [shown, jobs] : byModel) {
            const std::string entity = std::to_string(shown[0]), model = std::to_string(shown[1]);
            std::string views, expected;
            for (const SpriteJob* job : jobs) {
                views += job->shot.dump(compared % 2 == 0 ? -1 : 2) + "\n";
                expected += lineOf(*job) + "\n";
                wide += job->narrow ? 0 : 1;
                ++compared;
            }
            ASSERT_TRUE(writeFileAtomically(folder / "views.json", views));
            const fs::path said = folder / (set.name + entity + "-" + model);
            test::Process viewer(
                {RUNTIME_VIEWER, (folder / "model.svo").string(), "--entity", entity, "--model",
                 model, "--lattice", (folder / "views.json").string()},
                {"DISPLAY=" + display.name(), "LIBGL_ALWAYS_SOFTWARE=1"}, said);
            EXPECT_EQ(viewer.wait(kLong), 0);
            ASSERT_EQ(test::contentOf(said), expected);
        }
    }
    EXPECT_GT(compared, 350u);
    EXPECT_GT(wide, 5u);
}

TEST(Viewer, DrawsItsWindowAndRefusesWhatItCannotRead) {
    const test::TemporaryFolder folder;
    test::VirtualDisplay display;
    ASSERT_NO_FATAL_FAILURE(display.start({1280, 800}, folder.path()));
    const auto run = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), RUNTIME_VIEWER);
        fs::remove(folder / "said");
        test::Process viewer(arguments, {"DISPLAY=" + display.name(), "LIBGL_ALWAYS_SOFTWARE=1"},
                             folder / "said");
        return viewer.wait(kLong);
    };
    const std::string model = (test::conformanceFolder() / "mixture.svo").string();
    ASSERT_EQ(run({model, "--screenshot", (folder / "window.ppm").string()}), 0);
    const std::string picture = test::contentOf(folder / "window.ppm");
    ASSERT_EQ(picture.substr(0, 16), "P6 1280 800 255\n");
    ASSERT_EQ(picture.size(), 16u + 1280u * 800u * 3u);
    // Sky, ground, outline and five materials, each in up to three lights.
    std::map<std::string, int> colours;
    for (std::size_t at = 16; at < picture.size(); at += 3) ++colours[picture.substr(at, 3)];
    EXPECT_GT(colours[std::string(3, '\0')], 500) << "the outline";
    EXPECT_GT(colours.size(), 100u);

    const std::string broken = (test::conformanceFolder() / "cycle.svo").string();
    EXPECT_EQ(run({broken, "--screenshot", (folder / "none.ppm").string()}), 1);
    EXPECT_NE(test::contentOf(folder / "said").find("out of breadth-first order"),
              std::string::npos);
    std::ofstream(folder / "views.json") << R"({"lattice": {"bits": {"position": 99}}})";
    EXPECT_EQ(run({model, "--lattice", (folder / "views.json").string()}), 1);
    EXPECT_NE(test::contentOf(folder / "said").find("bits"), std::string::npos);
}

// The header of samples/runtime quantises views to the very integers that voxprite casts.
TEST(LatticeHeader, ViewsAndLightAreVoxprites) {
    const glm::dvec3 light{0.35, -0.55, 0.8};
    for (const glm::ivec3 size : {glm::ivec3(25, 20, 38), glm::ivec3(128), glm::ivec3(1, 2, 3),
                                  glm::ivec3(300, 200, 7), glm::ivec3(2000, 1, 9)}) {
        for (const OrbitAngles& angles : test::allKindsOfViews(30, 3)) {
            for (const double sigma : {1.0 / 64.0, 1.0 / 32.0, 0.25, 1.0, 2.5, 4.0, 7.5}) {
                const glm::dmat3 basis = orbitBasis(angles);
                const OrthoView ortho{voxelFromWorld(basis[0]), voxelFromWorld(basis[1]),
                                      voxelFromWorld(basis[2]), sigma};
                const auto expected = quantiseView(ortho, size);
                lattice_view view;
                const glm::uvec3 voxels(size);
                const int fits = lattice_from_axes(&view, &ortho.right.x, &ortho.up.x,
                                                   &ortho.forward.x, sigma, &voxels.x);
                ASSERT_EQ(fits == 1, expected.has_value());
                if (!expected) continue;
                const auto vector = [](const int v[3]) { return glm::ivec3(v[0], v[1], v[2]); };
                const LatticeView actual{view.position_bits,
                                         view.direction_bits,
                                         vector(view.C),
                                         vector(view.D),
                                         vector(view.U),
                                         vector(view.V),
                                         {view.first[0], view.first[1]},
                                         {view.size[0], view.size[1]}};
                ASSERT_EQ(actual, *expected)
                    << angles.yawDegrees << ", " << angles.pitchDegrees << ", sigma " << sigma;
                ASSERT_EQ(lattice_is_narrow(&view, &voxels.x) == 1, fitsNarrow(*expected, size));
                std::array<std::uint8_t, 3> light8{};
                lattice_face_light(view.D, &light.x, 0.55, light8.data());
                ASSERT_EQ(light8, faceLight(expected->D, light, 0.55));
            }
        }
    }
}

TEST(LatticeHeader, RefusesTextsThatAreNoViews) {
    const json shot = test::oneShot();
    const std::string good = shot.dump();
    const auto refused = [](const std::string& text) {
        lattice_shot read;
        const char* at = text.c_str();
        return lattice_from_json(&read, &at) != nullptr;
    };
    EXPECT_FALSE(refused(good));
    EXPECT_FALSE(refused(shot["lattice"].dump())) << "without light";
    for (std::size_t length = 0; length < good.size(); ++length) {
        EXPECT_TRUE(refused(good.substr(0, length))) << length;
    }
    const auto changed = [&](const char* pointer, const json& value) {
        json other = shot;
        other[json::json_pointer(pointer)] = value;
        return refused(other.dump());
    };
    EXPECT_TRUE(changed("/lattice/bits/position", 14));
    EXPECT_TRUE(changed("/lattice/bits/step", 11));
    EXPECT_TRUE(changed("/lattice/D/1", 8193));
    EXPECT_TRUE(changed("/lattice/U/0", 1 << 29));
    EXPECT_TRUE(changed("/lattice/C", "here"));
    EXPECT_TRUE(changed("/lattice/V", json::array({1, 2})));
    EXPECT_TRUE(changed("/lattice/V/2", 1.5));
    EXPECT_TRUE(changed("/lattice/size", json::array({5000, 5000})));
    EXPECT_TRUE(changed("/lattice/size/0", -1));
    EXPECT_TRUE(changed("/lit/light8/2", 256));
    EXPECT_TRUE(changed("/lit/light8/2", -1));
    EXPECT_TRUE(changed("/lit/shading", "palette"));
    EXPECT_TRUE(changed("/lit/face_rays", true));
    EXPECT_TRUE(refused(std::string(100, '[')));
    EXPECT_TRUE(refused("{\"lattice\": {\"bits\": \"\\"));
}

std::string base64(const Bytes& bytes) {
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        const std::size_t rest = std::min<std::size_t>(3, bytes.size() - at);
        std::uint32_t word = 0;
        for (std::size_t i = 0; i < 3; ++i) word = word << 8 | (i < rest ? bytes[at + i] : 0u);
        for (std::size_t i = 0; i < 4; ++i) {
            text += i <= rest ? digits[word >> (18 - 6 * i) & 63] : '=';
        }
    }
    return text;
}

const fs::path kWeb = fs::path(VOXPRITE_SOURCE_DIR) / "samples/web";

// The page with what drives it at its end, as if it lay beside its scripts.
std::string drivenPage(const fs::path& jobs) {
    std::string page = test::must(readTextFile(kWeb / "index.html"));
    const auto insert = [&](const char* before, const std::string& text) {
        const std::size_t at = page.find(before);
        ASSERT_NE(at, std::string::npos) << before;
        page.insert(at, text);
    };
    const fs::path driver = fs::path(VOXPRITE_SOURCE_DIR) / "tests/runtime/web_driver.js";
    insert("<meta charset", "<base href=\"file://" + kWeb.string() + "/\">");
    insert("</body>", "<script src=\"file://" + jobs.string() +
                          "\"></script><script src=\"file://" + driver.string() + "\"></script>");
    return page;
}

// Views by their axes, and the integers that core makes of them.
json quantisedViews() {
    const auto list = [](const auto& v) { return json::array({v.x, v.y, v.z}); };
    json views = json::array();
    const glm::ivec3 size(25, 20, 38);
    for (const OrbitAngles& angles : test::allKindsOfViews(4, 3)) {
        for (const double sigma : {1.0 / 64.0, 1.0 / 32.0, 0.25, 1.0, 7.5}) {
            const glm::dmat3 basis = orbitBasis(angles);
            const OrthoView ortho{voxelFromWorld(basis[0]), voxelFromWorld(basis[1]),
                                  voxelFromWorld(basis[2]), sigma};
            const LatticeView view = test::must(quantiseView(ortho, size));
            views.push_back({{"basis",
                              {{"right", list(ortho.right)},
                               {"up", list(ortho.up)},
                               {"forward", list(ortho.forward)}}},
                             {"sigma", sigma},
                             {"size", list(size)},
                             {"lattice",
                              {{"bits", {{"position", view.positionBits}}},
                               {"C", list(view.C)},
                               {"D", list(view.D)},
                               {"U", list(view.U)},
                               {"V", list(view.V)},
                               {"first", {view.first.x, view.first.y}},
                               {"size", {view.size.x, view.size.y}}}}});
        }
    }
    return views;
}

// One start of Chromium for all of it.
TEST(WebPage, SpritesAreVoxpritesByHashAndFilesAreReadOrRefused) {
    const test::TemporaryFolder folder;
    const std::vector<JobSet> sets = test::spriteJobs();
    const std::vector<test::ConformanceFile> conformance = test::conformanceSet();
    json jobs{{"sets", json::array()}, {"conformance", json::array()}};
    for (const JobSet& set : sets) {
        json shots = json::array();
        for (const SpriteJob& job : set.jobs)
            shots.push_back({{"entity", job.entity}, {"model", job.model}, {"shot", job.shot}});
        jobs["sets"].push_back({{"svo", base64(set.svo)}, {"jobs", std::move(shots)}});
    }
    jobs["shaders"] =
        test::must(readTextFile(fs::path(VOXPRITE_SOURCE_DIR) / "samples/runtime/sprite.glsl"));
    for (const test::ConformanceFile& one : conformance) {
        jobs["conformance"].push_back({{"svo", base64(one.bytes)}, {"entry", one.entry}});
    }
    jobs["views"] = quantisedViews();
    std::ofstream(folder / "jobs.js") << "const jobs = " << jobs.dump() << ";\n";
    std::ofstream(folder / "page.html") << drivenPage(folder / "jobs.js");

    test::Process chromium(
        {"sh", "-c",
         "exec chromium --headless --no-sandbox --use-gl=angle --use-angle=swiftshader "
         "--enable-unsafe-swiftshader --disable-background-networking --disable-quic "
         "--no-first-run --disable-component-update --disable-sync --disable-gpu-sandbox "
         "--window-size=1280,800 --user-data-dir='" +
             (folder / "profile").string() + "' --dump-dom 'file://" +
             (folder / "page.html").string() + "' >'" + (folder / "dom.html").string() + "'"},
        {}, folder / "chromium.log");
    const int status = chromium.wait(kLong);
    const std::string log = test::contentOf(folder / "chromium.log");
    ASSERT_EQ(status, 0) << "Is Chromium installed? " << log;
    const std::string dom = test::contentOf(folder / "dom.html");
    const std::size_t first = dom.find("RESULT["), last = dom.rfind("]RESULT");
    ASSERT_NE(last, std::string::npos) << dom.substr(0, 2000) << log;
    const json result = json::parse(dom.substr(first + 7, last - first - 7));
    ASSERT_EQ(result.value("error", ""), "");

    std::size_t byProcessor = 0;
    for (std::size_t s = 0; s < sets.size(); ++s) {
        ASSERT_EQ(result["sets"][s].size(), sets[s].jobs.size());
        for (std::size_t i = 0; i < sets[s].jobs.size(); ++i) {
            const SpriteJob& job = sets[s].jobs[i];
            const json& mine = result["sets"][s][i];
            ASSERT_EQ(mine["hashes"], lineOf(job)) << sets[s].name << ", " << job.shot;
            EXPECT_EQ(mine["by"], job.narrow ? "gpu" : "cpu");
            if (mine.contains("processor")) {
                EXPECT_EQ(mine["processor"], lineOf(job));
                EXPECT_EQ(mine["read"], lineOf(job));
                ++byProcessor;
            }
        }
    }
    EXPECT_GT(byProcessor, 5u);
    EXPECT_EQ(result["conformance"], json::array()) << "files that were not read, or not refused";
    EXPECT_EQ(result["conformed"], conformance.size());
    EXPECT_EQ(result["page"], json::array()) << "what the page did wrong";
    EXPECT_EQ(result["page_checks"], 15);
    EXPECT_EQ(result["views"], json::array());
}

TEST(WebPage, TheSampleInItIsTheExportedOne) {
    const std::string script = test::must(readTextFile(kWeb / "sample.js"));
    for (const test::ExportedSample& sample : test::exportedSamples()) {
        if (sample.name != "walk.voxprite") continue;
        EXPECT_NE(script.find('"' + base64(sample.bytes) + '"'), std::string::npos)
            << "./dev samples makes it again";
    }
}

}  // namespace
}  // namespace voxprite
