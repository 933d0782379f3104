// core's reader and the C reader of samples/runtime: over the conformance set, and over every
// exported sample.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <set>

#include "core/io/formats.h"
#include "core/io/svo_file.h"
#include "core/svo/bake.h"
#include "samples/runtime/voxprite_svo.h"
#include "tests/runtime/conformance.h"
#include "tests/runtime/exported_samples.h"

namespace voxprite {
namespace {

using nlohmann::json;
using test::must;

std::string textOf(svo_text text) {
    return text.length == 0 ? std::string() : std::string(text.bytes, text.length);
}

// What index.json tells of a valid file, from either reader.
json toldOf(const std::string& name, const double anchor[3], const std::uint8_t* palette,
            std::size_t models, std::size_t clips, std::size_t sockets) {
    json colours = json::array();
    for (int i = 0; i < 256; ++i) {
        const std::uint8_t* c = palette + std::ptrdiff_t{4} * i;
        if (c[0] != 0 || c[1] != 0 || c[2] != 0 || c[3] != 0) {
            colours.push_back({i, c[0], c[1], c[2], c[3]});
        }
    }
    return {{"name", name},       {"anchor", {anchor[0], anchor[1], anchor[2]}},
            {"models", models},   {"clips", clips},
            {"sockets", sockets}, {"colours", colours}};
}

json told(const std::vector<SvoFile>& set) {
    json models = json::array(), clips = json::array(), sockets = json::array();
    json entities = json::array();
    for (const SvoFile& file : set) {
        const std::size_t firstModel = models.size();
        entities.push_back(toldOf(file.name, &file.anchor.x, &file.palette[0].x, file.models.size(),
                                  file.clips.size(), file.sockets.size()));
        for (const SvoModel& model : file.models) {
            const Octree& o = model.octree;
            models.push_back({{"name", model.name},
                              {"size", {o.size.x, o.size.y, o.size.z}},
                              {"origin", {o.origin.x, o.origin.y, o.origin.z}},
                              {"max_depth", o.maxDepth},
                              {"nodes", o.nodes.size()},
                              {"payloads", o.payloads.size()}});
        }
        for (const SvoClip& clip : file.clips) {
            json frames = json::array();
            for (std::size_t i = 0; i < clip.models.size(); ++i) {
                frames.push_back({firstModel + clip.models[i], clip.durationsMilliseconds[i]});
            }
            clips.push_back({{"name", clip.name}, {"loops", clip.loop}, {"frames", frames}});
        }
        for (const SvoSocket& socket : file.sockets) {
            json positions = json::array();
            for (const glm::dvec3& p : socket.positions) positions.push_back({p.x, p.y, p.z});
            sockets.push_back({{"name", socket.name}, {"positions", positions}});
        }
    }
    return {{"models", models}, {"clips", clips}, {"sockets", sockets}, {"entities", entities}};
}

json told(const svo_file& file) {
    json models = json::array(), clips = json::array(), sockets = json::array();
    for (std::uint32_t i = 0; i < file.models; ++i) {
        const svo_model m = svo_get_model(&file, i);
        models.push_back({{"name", textOf(m.name)},
                          {"size", m.size},
                          {"origin", m.origin},
                          {"max_depth", m.max_depth},
                          {"nodes", m.node_count},
                          {"payloads", m.payload_count}});
    }
    for (std::uint32_t i = 0; i < file.clips; ++i) {
        const svo_clip clip = svo_get_clip(&file, i);
        json frames = json::array();
        for (std::uint32_t k = 0; k < clip.frame_count; ++k) {
            const svo_frame frame = svo_get_frame(&file, clip.first_frame + k);
            frames.push_back({frame.model, frame.milliseconds});
        }
        clips.push_back(
            {{"name", textOf(clip.name)}, {"loops", clip.loops == 1}, {"frames", frames}});
    }
    for (std::uint32_t i = 0; i < file.sockets; ++i) {
        const svo_socket socket = svo_get_socket(&file, i);
        json positions = json::array();
        for (std::uint32_t k = 0; k < socket.position_count; ++k) {
            double xyz[3];
            svo_get_position(&file, socket.first_position + k, xyz);
            positions.push_back(xyz);
        }
        sockets.push_back({{"name", textOf(socket.name)}, {"positions", positions}});
    }
    json entities = json::array();
    for (std::uint32_t i = 0; i < file.entities; ++i) {
        const svo_entity entity = svo_get_entity(&file, i);
        const svo_authored authored = svo_get_authored(&file, i);
        entities.push_back(toldOf(textOf(authored.name), authored.anchor, entity.palette,
                                  entity.model_count, entity.clip_count, entity.socket_count));
    }
    return {{"models", models}, {"clips", clips}, {"sockets", sockets}, {"entities", entities}};
}

void expectTold(const json& actual, const json& expected) {
    for (const char* list : {"models", "clips", "sockets"}) {
        EXPECT_EQ(actual.at(list), expected.at(list)) << expected.at("file");
    }
    if (expected.contains("entities")) {
        EXPECT_EQ(actual.at("entities"), expected.at("entities")) << expected.at("file");
    } else {
        EXPECT_EQ(actual.at("entities").size(), 1u) << expected.at("file");
    }
}

// Every cell of the model and one layer around it; of large ones the corners' surroundings.
void expectVoxels(const json& list, const std::vector<std::uint32_t>& size, const auto& voxelAt,
                  const std::string& what) {
    std::set<std::array<std::uint32_t, 3>> solid;
    for (const json& v : list) {
        const auto at = v.get<std::array<std::uint32_t, 4>>();
        solid.insert({at[0], at[1], at[2]});
        ASSERT_EQ(voxelAt(at[0], at[1], at[2]), static_cast<int>(at[3])) << what << " at " << v;
    }
    const auto coordinates = [](std::uint32_t length) {
        std::vector<std::uint32_t> all;
        for (std::uint32_t i = 0; i < std::min(length, 16u); ++i) all.push_back(i);
        for (std::uint32_t i = std::max(length, 17u) - 1; i < length + 1; ++i) all.push_back(i);
        if (length < 16) all.push_back(length);
        all.push_back(0xFFFF'FFFFu);
        return all;
    };
    for (const std::uint32_t z : coordinates(size[2])) {
        for (const std::uint32_t y : coordinates(size[1])) {
            for (const std::uint32_t x : coordinates(size[0])) {
                ASSERT_EQ(voxelAt(x, y, z) != 0, solid.contains({x, y, z}))
                    << what << " at " << x << ", " << y << ", " << z;
            }
        }
    }
}

TEST(Conformance, CoreReadsWhatIsValidAndRefusesTheRest) {
    for (const test::ConformanceFile& one : test::conformanceSet()) {
        const Result<std::vector<SvoFile>> file = readSvoSet(one.bytes);
        ASSERT_EQ(file.has_value(), one.valid()) << one.entry;
        if (!file) {
            EXPECT_FALSE(file.error().message.empty());
            EXPECT_TRUE(file.error().offset.has_value()) << one.name();
            continue;
        }
        json expected = one.entry;
        std::vector<SvoModel> models;
        for (const SvoFile& entity : *file) {
            models.insert(models.end(), entity.models.begin(), entity.models.end());
        }
        for (std::size_t i = 0; i < models.size(); ++i) {
            const Octree& octree = models[i].octree;
            const auto voxelAt = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
                return int{materialAt(octree.view(), glm::ivec3(glm::uvec3(x, y, z)))};
            };
            expectVoxels(expected["models"][i]["voxels"], expected["models"][i]["size"], voxelAt,
                         one.name());
            expected["models"][i].erase("voxels");
        }
        expectTold(told(*file), expected);
    }
}

TEST(Conformance, TheCReaderReadsWhatIsValidAndRefusesTheRest) {
    for (const test::ConformanceFile& one : test::conformanceSet()) {
        svo_file file;
        svo_error error{};
        const bool valid = svo_open(&file, one.bytes.data(), one.bytes.size(), &error) == 1;
        ASSERT_EQ(valid, one.valid()) << one.entry << (valid ? "" : error.reason);
        if (!valid) {
            EXPECT_GT(std::strlen(error.reason), 8u) << one.name();
            EXPECT_LE(error.offset, one.bytes.size()) << one.name();
            EXPECT_EQ(svo_open(&file, one.bytes.data(), one.bytes.size(), nullptr), 0);
            continue;
        }
        json expected = one.entry;
        for (std::uint32_t i = 0; i < file.models; ++i) {
            const svo_model model = svo_get_model(&file, i);
            const auto voxelAt = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
                return int{svo_voxel(&file, &model, x, y, z)};
            };
            expectVoxels(expected["models"][i]["voxels"], expected["models"][i]["size"], voxelAt,
                         one.name());
            expected["models"][i].erase("voxels");
        }
        expectTold(told(file), expected);
    }
}

TEST(CReader, ReadsExportedSamplesAsCoreDoes) {
    for (const test::ExportedSample& sample : test::exportedSamples()) {
        const SvoFile expected = must(readSvo(sample.bytes));
        svo_file file;
        svo_error error{};
        ASSERT_TRUE(svo_open(&file, sample.bytes.data(), sample.bytes.size(), &error))
            << sample.name << ": " << error.reason;
        EXPECT_EQ(told(file), told(std::vector{expected})) << sample.name;
        for (std::uint32_t i = 0; i < file.models; ++i) {
            const svo_model model = svo_get_model(&file, i);
            const Octree& octree = expected.models[i].octree;
            const std::uint8_t* nodes = file.nodes + std::size_t{4} * model.node_offset;
            const std::uint8_t* payloads = file.payloads + std::size_t{8} * model.payload_offset;
            EXPECT_EQ(std::memcmp(nodes, octree.nodes.data(), 4 * octree.nodes.size()), 0);
            EXPECT_EQ(std::memcmp(payloads, octree.payloads.data(), 8 * octree.payloads.size()), 0);
        }
        for (std::uint32_t i = 0; i < 256; ++i) {
            EXPECT_EQ(std::memcmp(file.palette + 4 * i, &expected.palette[i], 4), 0);
            EXPECT_EQ(textOf(svo_get_colour_name(&file, 0, i)), expected.colourNames[i]);
        }
        const svo_authored authored = svo_get_authored(&file, 0);
        EXPECT_EQ(textOf(authored.name), expected.name);
        EXPECT_EQ(authored.voxel_size_metres, expected.voxelSizeMetres);
        EXPECT_EQ(authored.sigma, expected.sigma);
        EXPECT_EQ(glm::dvec3(authored.anchor[0], authored.anchor[1], authored.anchor[2]),
                  expected.anchor);
        EXPECT_EQ(authored.outlined == 1, expected.outline.enabled);
        EXPECT_EQ(std::memcmp(authored.outline, &expected.outline.colour, 4), 0);
    }
}

// A file with all samples: each entity is what its own file is.
TEST(CReader, ReadsEverySampleOutOfOneFile) {
    std::vector<SvoFile> set;
    for (const test::ExportedSample& sample : test::exportedSamples()) {
        set.push_back(must(readSvo(sample.bytes)));
    }
    const Bytes bytes = must(writeSvoSet(set));
    EXPECT_EQ(must(readSvoSet(bytes)), set);
    EXPECT_EQ(must(writeSvoSet(must(readSvoSet(bytes)))), bytes);
    svo_file file;
    svo_error error{};
    ASSERT_TRUE(svo_open(&file, bytes.data(), bytes.size(), &error)) << error.reason;
    ASSERT_EQ(file.entities, set.size());
    EXPECT_EQ(told(file), told(set));
    for (std::uint32_t i = 0; i < file.entities; ++i) {
        const SvoFile& expected = set[i];
        const svo_entity entity = svo_get_entity(&file, i);
        EXPECT_EQ(std::memcmp(entity.palette, expected.palette.data(), 1024), 0);
        for (std::uint32_t c = 0; c < 256; ++c) {
            ASSERT_EQ(textOf(svo_get_colour_name(&file, i, c)), expected.colourNames[c]);
        }
        const svo_authored authored = svo_get_authored(&file, i);
        EXPECT_EQ(authored.sigma, expected.sigma);
        EXPECT_EQ(authored.voxel_size_metres, expected.voxelSizeMetres);
        for (std::uint32_t k = 0; k < entity.model_count; ++k) {
            const svo_model model = svo_get_model(&file, entity.first_model + k);
            const Octree& octree = expected.models[k].octree;
            EXPECT_EQ(std::memcmp(file.nodes + std::size_t{4} * model.node_offset,
                                  octree.nodes.data(), 4 * octree.nodes.size()),
                      0);
            EXPECT_EQ(std::memcmp(file.payloads + std::size_t{8} * model.payload_offset,
                                  octree.payloads.data(), 8 * octree.payloads.size()),
                      0);
        }
    }
    // Whoever asks for one entity is told of all.
    const Result<SvoFile> one = readSvo(bytes);
    ASSERT_FALSE(one.has_value());
    EXPECT_NE(one.error().message.find("7 entities"), std::string::npos) << one.error().message;
    EXPECT_EQ(must(readSvo(bytes, 2)), set[2]);
    EXPECT_FALSE(readSvo(bytes, 7).has_value());
}

// SVO.md shows a file in the form of `hexdump -C`, where a row that repeats the one before is left
// out behind a star.
Bytes dumpedIn(const std::string& page) {
    Bytes bytes;
    std::istringstream lines(page.substr(page.find("```hexdump\n") + 11));
    bool starred = false;
    for (std::string line; std::getline(lines, line) && line != "```";) {
        if (line == "*") {
            starred = true;
            continue;
        }
        std::istringstream words(line.substr(0, line.find('|')));
        std::size_t offset = 0;
        words >> std::hex >> offset;
        const std::ptrdiff_t row = 16;
        while (starred && bytes.size() < offset) {
            const Bytes last(bytes.end() - row, bytes.end());
            bytes.insert(bytes.end(), last.begin(), last.end());
        }
        starred = false;
        EXPECT_EQ(bytes.size(), offset) << line;
        for (unsigned value = 0; words >> std::hex >> value;) {
            bytes.push_back(static_cast<std::uint8_t>(value));
        }
    }
    return bytes;
}

TEST(SvoPage, TheDumpIsWhatTheWriterMakes) {
    const std::filesystem::path folder =
        std::filesystem::path(VOXPRITE_SOURCE_DIR) / "samples/runtime";
    const Bytes dumped = dumpedIn(must(readTextFile(folder / "SVO.md")));
    const Bytes example = must(readFile(folder / "conformance/example.svo"));
    EXPECT_EQ(dumped, example);
    EXPECT_EQ(must(writeSvo(must(readSvo(example)))), example);
}

}  // namespace
}  // namespace voxprite
