#include "core/io/project_file.h"

#include <gtest/gtest.h>

#include <random>

#include "core/io/json_text.h"
#include "core/io/voxel_payload.h"
#include "core/io/zip_archive.h"

namespace voxprite {
namespace {

// Something in every field of a document.
Document fullDocument() {
    Document document;
    document.palette.colours[7] = Rgba8(1, 2, 3, 4);
    document.palette.names[7] = "Kn\xC3\xB6pfe";
    document.palette.names[255] = std::string("not \xFF UTF-8 \xC3 \x00 \xF4\x8F\xBF\xBF", 19);
    document.palette.materials[9] = {{"_type", "_glass"}, {"_rough", "0.1"}, {"", ""}};
    std::swap(document.palette.displayOrder[3], document.palette.displayOrder[200]);
    document.palette.ramps = {{"skin", {9, 3, 200}}, {"", {1, 255}}};
    document.palette.variants = {
        {"Winter \xE2\x9D\x84", {{7, Rgba8(9, 8, 7, 255)}, {255, Rgba8(1, 2, 3, 4)}}}, {"B", {}}};

    std::mt19937 random(11);
    document.models.resize(4);
    const auto coordinate = [&](int range) {
        return static_cast<int>(random() % static_cast<unsigned>(2 * range)) - range;
    };
    for (int k = 0; k < 3000; ++k) {
        document.models[0].voxels.set({coordinate(20), coordinate(20), coordinate(20)},
                                      static_cast<std::uint8_t>(random()));
    }
    document.models[0].canvas = {{-20, -20, -20}, {20, 20, 20}};
    document.models[1].voxels.fill({{-70, -64, 3}, {90, 64, 72}}, 42);
    document.models[1].voxels.set({0, 0, 10}, 0);
    document.models[2].voxels.set(glm::ivec3(kMaxCoordinate), 1);
    document.models[2].voxels.set(glm::ivec3(-kMaxCoordinate), 255);

    SceneNode root;
    root.name = "root";
    root.children = {2, 1};
    SceneNode group;
    group.name = "group";
    group.parent = 0;
    group.children = {3};
    group.hidden = true;
    group.layer = 1;
    SceneNode object;
    object.name = "object";
    object.parent = 0;
    object.locked = true;
    object.models = {{0, 0}, {3, 1}, {4, 3}};
    object.loopModels = true;
    object.attributes = {{"_name", "object"}, {"zz", "a\nb"}};
    SceneNode mirrored;
    mirrored.parent = 1;
    mirrored.models = {{0, 1}};
    mirrored.placements = {{0, {{{1, 2, 0}, {-1, 1, -1}}, {5, -6, 7}}},
                           {9, {{{2, 0, 1}, {1, -1, 1}}, {-1000, 0, 1000}}}};
    mirrored.loopPlacements = true;
    mirrored.glides = true;
    document.nodes = {root, group, object, mirrored};

    document.layers = {{"back", false, {}}, {"front", true, {{"_color", "255 0 0"}}}};
    document.cameras = {{3, {{"_mode", "pers"}}}, {-1, {}}};
    document.renderSettings = {{0, {{"_type", "_inf"}}}};
    document.clips = {{"walk", 0, 4, 12.5, true}, {"idle", 2, 2, 1.0 / 3.0, false}};
    document.clips[0].durationsMilliseconds = {1, 1'000'000, 30, 40, 50};
    document.sockets = {{"hand", {{0, {0.1 + 0.2, -1e7, 1.0 / 3.0}}, {9, {4, 5, 6}}}},
                        {"", {{3, glm::dvec3(0.0)}}}};
    document.entity = {"hero",    glm::dvec3(1.5, -0.1, 1e-9), 90.0, -12.3, 360.0,
                       0.1 + 0.2, {1e6, -2.0, 1.0 / 3.0}};
    document.authored = {0.07, 2.5};
    return document;
}

Bytes written(const Document& document) {
    Result<Bytes> bytes = writeProject(document);
    EXPECT_TRUE(bytes) << bytes.error().describe();
    return bytes ? *bytes : Bytes{};
}

Bytes bytesOfText(const std::string& text) {
    return {text.begin(), text.end()};
}

// The archive again with `name` replaced by `bytes`.
Bytes withEntry(const Bytes& archive, const std::string& name, const Bytes& bytes) {
    const auto reader = ZipReader::open(archive);
    EXPECT_TRUE(reader);
    std::vector<ZipEntry> entries;
    for (const char* entry : {"project.json", "models/0.voxels"}) {
        auto content = reader->read(entry, 1 << 30);
        EXPECT_TRUE(content) << content.error().describe();
        entries.push_back({entry, entry == name ? bytes : *content});
    }
    return writeZip(entries).value();
}

std::string projectJson(const Bytes& archive) {
    const Bytes bytes = ZipReader::open(archive)->read("project.json", 1 << 30).value();
    return {bytes.begin(), bytes.end()};
}

void expectError(const Bytes& bytes, const std::string& part) {
    const auto document = readProject(bytes);
    ASSERT_FALSE(document);
    EXPECT_NE(document.error().describe().find(part), std::string::npos)
        << document.error().describe();
}

TEST(ProjectFile, ReadsBackEqual) {
    for (const Document& document : {fullDocument(), Document::withEmptyModel(), Document{}}) {
        const auto read = readProject(written(document));
        ASSERT_TRUE(read) << read.error().describe();
        EXPECT_EQ(read->palette, document.palette);
        EXPECT_EQ(read->models, document.models);
        EXPECT_EQ(read->nodes, document.nodes);
        EXPECT_EQ(read->layers, document.layers);
        EXPECT_EQ(read->cameras, document.cameras);
        EXPECT_EQ(read->renderSettings, document.renderSettings);
        EXPECT_EQ(read->clips, document.clips);
        EXPECT_EQ(read->entity, document.entity);
        EXPECT_EQ(read->authored, document.authored);
        EXPECT_EQ(*read, document);
    }
}

TEST(ProjectFile, BytesDependOnTheDocumentAlone) {
    const Document document = fullDocument();
    const Bytes first = written(document);
    EXPECT_EQ(first, written(document));
    EXPECT_EQ(first, written(readProject(first).value()));
}

TEST(ProjectFile, RecordsTheValuesAtTheTimeOfSaving) {
    const auto bytes = writeProject(Document::withEmptyModel(), {0.5, 3.0});
    ASSERT_TRUE(bytes);
    EXPECT_EQ(readProject(*bytes)->authored, (AuthoredValues{0.5, 3.0}));
}

TEST(ProjectFile, RefusesToWriteAnInvalidDocument) {
    Document document = Document::withEmptyModel();
    document.nodes[1].parent = 17;
    EXPECT_FALSE(writeProject(document));
}

// What could not be opened again must not replace what can.
TEST(ProjectFile, RefusesToWriteMoreThanItReads) {
    Document document = Document::withEmptyModel();
    document.nodes[1].name.assign(kMaxProjectJsonBytes, 'n');
    const Result<Bytes> written = writeProject(document);
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().message.find("64 MiB can be read back"), std::string::npos);
}

TEST(ProjectFile, WrongJsonIsNamedByLineOrField) {
    const Bytes good = written(Document::withEmptyModel());
    const std::string json = projectJson(good);
    const auto replaced = [&](const std::string& from, const std::string& to) {
        std::string changed = json;
        const std::size_t at = changed.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        changed.replace(at, from.size(), to);
        return withEntry(good, "project.json", bytesOfText(changed));
    };
    EXPECT_TRUE(readProject(replaced("\"locked\"", "\"locked\"")));
    expectError(replaced("\"scale\": 1.0", "\"scale\": 1.0.0"), "project.json");
    const auto syntax = readProject(replaced("\"scale\": 1.0", "\"scale\": x"));
    EXPECT_GT(syntax.error().line.value_or(0), 2);
    EXPECT_GT(syntax.error().column.value_or(0), 1);
    expectError(replaced("\"scale\": 1.0", "\"scale\": -1.0"), "scale");
    expectError(replaced("\"scale\": 1.0", "\"scale\": \"big\""), "entity.scale: must be a number");
    expectError(replaced("\"scale\"", "\"skale\""), "unknown field \"skale\"");
    expectError(replaced("\"voxprite_project\": 1", "\"voxprite_project\": 2"), "newer version");
    expectError(replaced("\"model\": 0", "\"model\": 1"), "project.json");
    expectError(replaced("\"model\": 0", "\"model\": 0.5"),
                "nodes[1].models[0].model: must be a whole number");
    expectError(replaced("\"parent\": 0", "\"parent\": 1"), "project.json");
    expectError(replaced("\"solidVoxels\": 0", "\"solidVoxels\": 5"), "number of voxels");
    expectError(replaced("\"crc32\": ", "\"crc32\": 1"), "checksum");
    expectError(replaced("models/0.voxels", "models/1.voxels"), "no such entry");
    expectError(replaced("#00000000", "black"), "palette.colours[0]: must be a colour");
}

TEST(ProjectFile, EveryTruncationIsAnError) {
    const Bytes bytes = written(fullDocument());
    for (std::size_t length = 0; length < bytes.size();
         length += 1 + (length > 256 && length + 2048 < bytes.size() ? 61 : 0)) {
        EXPECT_FALSE(readProject(ByteView(bytes).first(length))) << length;
    }
}

TEST(ProjectFile, EveryCutAndFlippedByteOfASmallOneEndsInAnErrorOrADocument) {
    Document document = Document::withEmptyModel();
    document.models[0].voxels.set({1, 2, 3}, 4);
    const Bytes whole = written(document);
    ASSERT_TRUE(readProject(whole));
    for (std::size_t length = 0; length < whole.size(); ++length) {
        EXPECT_FALSE(readProject(ByteView(whole).first(length))) << length;
    }
    for (std::size_t at = 0; at < whole.size(); ++at) {
        Bytes flipped = whole;
        flipped[at] ^= static_cast<std::uint8_t>(at % 2 == 0 ? 0xFF : 0x01);
        const auto read = readProject(flipped);
        EXPECT_TRUE(!read || *read == document) << at;
    }
}

TEST(ProjectFile, ChangedBytesNeverChangeTheDocumentInSilence) {
    const Document document = fullDocument();
    const Bytes bytes = written(document);
    std::mt19937 random(5);
    int refused = 0;
    for (int k = 0; k < 400; ++k) {
        Bytes changed = bytes;
        // Half of them in the directory at the end, where the structure is.
        const std::size_t range =
            k % 2 == 0 ? bytes.size() : std::min<std::size_t>(600, bytes.size());
        changed[bytes.size() - 1 - random() % range] ^=
            static_cast<std::uint8_t>(1u << random() % 8);
        const auto read = readProject(changed);
        if (!read) {
            ++refused;
            EXPECT_FALSE(read.error().message.empty());
        } else {
            EXPECT_EQ(*read, document);
        }
    }
    EXPECT_GT(refused, 200);
}

TEST(ProjectFile, ChangedJsonIsRefusedOrValid) {
    Document document = fullDocument();
    for (Model& model : document.models) model.voxels.clear();
    const Bytes good = written(document);
    const std::string json = projectJson(good);
    const auto archive = ZipReader::open(good);
    std::vector<ZipEntry> entries{{"project.json", {}}};
    for (int k = 0; k < 4; ++k) {
        const std::string name = "models/" + std::to_string(k) + ".voxels";
        entries.push_back({name, archive->read(name, 1 << 30).value()});
    }
    std::mt19937 random(9);
    constexpr std::string_view interesting = "0123456789-.eE\"[]{},:tfn \xFF";
    int accepted = 0;
    for (int k = 0; k < 300; ++k) {
        std::string changed = json;
        for (int edit = 0; edit < 1 + k % 3; ++edit) {
            changed[random() % changed.size()] = interesting[random() % interesting.size()];
        }
        entries[0].bytes = bytesOfText(changed);
        const auto read = readProject(writeZip(entries).value());
        if (read) {
            ++accepted;
            EXPECT_TRUE(validate(*read));
        } else {
            // The text itself is wrong, or it names an entry that is not there.
            const std::string why = read.error().describe();
            EXPECT_TRUE(why.find("project.json") != std::string::npos ||
                        why.find("no such entry") != std::string::npos)
                << why;
        }
    }
    EXPECT_GT(accepted, 0);
    EXPECT_LT(accepted, 300);
}

TEST(ProjectFile, OtherFilesAreRefused) {
    expectError({}, "ZIP");
    expectError(bytesOfText("VOX 200 is something else altogether"), "ZIP");
    expectError(writeZip({{"readme.txt", bytesOfText("hello")}}).value(), "project.json");
}

Result<VoxelGrid> payloadOf(ByteView bytes) {
    GridBudget budget(bytes.size());
    return readVoxelPayload(bytes, budget);
}

TEST(VoxelPayload, RefusesWhatItCannotHold) {
    VoxelGrid grid;
    grid.set({1, 2, 3}, 9);
    const Bytes good = writeVoxelPayload(grid).value();
    ASSERT_EQ(good.size(), 8u + 14u + 512u);
    EXPECT_EQ(payloadOf(good).value(), grid);
    for (std::size_t length = 0; length < good.size(); ++length) {
        EXPECT_FALSE(payloadOf(ByteView(good).first(length))) << length;
    }
    const auto changed = [&](std::size_t at, std::uint8_t value) {
        Bytes bytes = good;
        bytes[at] = value;
        return payloadOf(bytes);
    };
    for (std::size_t at = 0; at < good.size(); ++at) {
        for (const int mask : {0x01, 0x80, 0xFF}) {
            const auto read = changed(at, static_cast<std::uint8_t>(good[at] ^ mask));
            EXPECT_TRUE(!read || writeVoxelPayload(*read)) << at;
        }
    }
    EXPECT_FALSE(changed(0, 'W'));    // mark
    EXPECT_FALSE(changed(7, 0xFF));   // number of blocks
    EXPECT_FALSE(changed(8, 1));      // x off the grid of blocks
    EXPECT_FALSE(changed(11, 0x7F));  // x beyond the limits
    EXPECT_FALSE(changed(20, 4));     // a dense block of 16 voxels
    EXPECT_FALSE(changed(20, 31));    // a huge one
    EXPECT_FALSE(changed(21, 1));     // uniform, but values follow
    Bytes longer = good;
    longer.push_back(0);
    EXPECT_FALSE(payloadOf(longer));
}

// A block of one value takes 14 bytes of the file, and the node above it 9,000 of memory.
TEST(VoxelPayload, BlocksOfOneValueArePaidFor) {
    GridBudget budget(0);
    while (budget.has(40)) (void)budget.takeOne();
    const auto withCubes = [](int count) {
        VoxelGrid grid;
        for (int k = 0; k < count; ++k) grid.fill({{512 * k, 0, 0}, {512 * k + 8, 8, 8}}, 1);
        return writeVoxelPayload(grid).value();
    };
    GridBudget forTwo = budget;
    EXPECT_TRUE(readVoxelPayload(withCubes(2), forTwo));
    const Result<VoxelGrid> three = readVoxelPayload(withCubes(3), budget);
    ASSERT_FALSE(three);
    EXPECT_EQ(three.error().message, GridBudget::refusal());
}

TEST(VoxelPayload, UniformBlocksHaveOneFormHoweverTheyWereMade) {
    VoxelGrid filled;
    filled.fill({{0, 0, 0}, {8, 8, 8}}, 3);
    VoxelGrid painted;
    for (int x = 0; x < 8; ++x) {
        for (int y = 0; y < 8; ++y) {
            for (int z = 0; z < 8; ++z) painted.set({x, y, z}, 3);
        }
    }
    painted.set({100, 0, 0}, 1);
    painted.set({100, 0, 0}, 0);
    EXPECT_EQ(writeVoxelPayload(filled).value(), writeVoxelPayload(painted).value());
    EXPECT_EQ(writeVoxelPayload(filled)->size(), 22u);
}

TEST(ZipReader, SizesAreCheckedBeforeInflating) {
    const Bytes zeros(1 << 20);
    const Bytes archive = writeZip({{"a", zeros}, {"b", bytesOfText("plain")}}).value();
    EXPECT_LT(archive.size(), 4096u);
    const auto reader = ZipReader::open(archive);
    ASSERT_TRUE(reader);
    EXPECT_EQ(reader->read("a", 1 << 20).value(), zeros);
    EXPECT_EQ(reader->read("b", 5).value(), bytesOfText("plain"));
    const auto tooLarge = reader->read("a", (1 << 20) - 1);
    ASSERT_FALSE(tooLarge);
    EXPECT_NE(tooLarge.error().message.find("the limit is"), std::string::npos);
    EXPECT_FALSE(reader->read("c", 100));
}

TEST(JsonText, EveryByteStringGoesThroughUtf8) {
    std::mt19937 random(3);
    for (int k = 0; k < 2000; ++k) {
        std::string bytes(random() % 9, '\0');
        // Mostly lead and continuation bytes, so that almost-valid sequences are common.
        for (char& c : bytes) {
            const auto choice = random();
            c = static_cast<char>(choice % 3 == 0   ? choice >> 8
                                  : choice % 3 == 1 ? 0xF4
                                                    : 0x8F + (choice >> 8) % 48);
        }
        const std::string text = jsonTextFromBytes(bytes);
        EXPECT_EQ(bytesFromJsonText(text), bytes);
        EXPECT_NO_THROW(static_cast<void>(nlohmann::json(text).dump()));
    }
    EXPECT_EQ(jsonTextFromBytes("Gr\xC3\xBC\xC3\x9F"
                                "e \xF0\x9F\x8E\xB2"),
              "Gr\xC3\xBC\xC3\x9F"
              "e \xF0\x9F\x8E\xB2");
}

}  // namespace
}  // namespace voxprite
