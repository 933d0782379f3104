// Damaged files end in an error that names the place, or in a valid document; never in a crash, a
// hang or a hunger for memory.

#include <gtest/gtest.h>

#include "core/io/vox.h"
#include "core/model/entity_voxels.h"
#include "tests/support/random.h"
#include "tests/support/vox_builder.h"

namespace voxprite {
namespace {

using test::put32;
using test::VoxBuilder;

// A small file with every kind of chunk.
Bytes everyChunk() {
    Bytes map;
    for (int k = 1; k <= 256; ++k) map.push_back(static_cast<std::uint8_t>(k));
    Bytes names;
    put32(names, 2);
    test::putText(names, "skin");
    test::putText(names, "hair");
    Bytes colourNames;
    put32(colourNames, 1);
    colourNames.push_back(3);
    test::putText(colourNames, "tin");
    Bytes material;
    put32(material, 3);
    test::putProperties(material, {{"_type", "_metal"}});
    Bytes oldMaterial;
    for (const std::int64_t field : {4, 1, 0x3F800000, 1, 0x3F000000}) put32(oldMaterial, field);
    Bytes camera;
    put32(camera, 0);
    test::putProperties(camera, {{"_mode", "pers"}});
    Bytes setting;
    test::putProperties(setting, {{"_type", "_env"}});
    VoxBuilder builder;
    builder.chunk("META", {0, 0, 0, 0})
        .chunk("PACK", {2, 0, 0, 0})
        .model({2, 1, 3}, {{0, 0, 0, 1}, {1, 0, 2, 9}})
        .model({1, 1, 1}, {})
        .transform(0, 1)
        .group(1, {2, 4}, {{"_g", "1"}})
        .transform(2, 3, {{"_name", "n"}, {"_hidden", "1"}, {"_loop", "1"}},
                   {{{"_f", "0"}, {"_r", "41"}, {"_t", "1 -2 3"}}, {{"_f", "7"}}}, 0)
        .shape(3, {{0, {{"_f", "0"}}}, {1, {{"_f", "4"}}}}, {{"_loop", "1"}})
        .transform(4, 3, {}, {{}}, 1)
        .layer(0, {{"_name", "l"}})
        .layer(1, {{"_hidden", "1"}})
        .chunk("RGBA", Bytes(64, 0x7F))
        .chunk("IMAP", map)
        .chunk("NOTE", names)
        .chunk("vpCN", colourNames)
        .chunk("MATL", material)
        .chunk("MATT", oldMaterial)
        .chunk("rCAM", camera)
        .chunk("rOBJ", setting);
    return builder.bytes();
}

void expectErrorOrDocument(const Bytes& bytes) {
    const Result<VoxImport> import = readVox(bytes);
    if (!import) {
        EXPECT_FALSE(import.error().message.empty());
        if (import.error().offset) {
            EXPECT_LE(*import.error().offset, bytes.size());
        }
        return;
    }
    const Status valid = validate(import->document);
    EXPECT_TRUE(valid) << valid.error().describe();
    EXPECT_LE(import->document.nodes.size(), 16u);
    EXPECT_LE(import->warnings.size(), 100u);
}

TEST(VoxDamage, TheWholeFileIsRead) {
    const Result<VoxImport> import = readVox(everyChunk());
    ASSERT_TRUE(import) << import.error().describe();
    EXPECT_EQ(import->document.nodes.size(), 3u);
    EXPECT_EQ(import->warnings.size(), 1u);  // META
    const Result<Bytes> written = writeVox(import->document);
    ASSERT_TRUE(written) << written.error().describe();
    EXPECT_TRUE(readVox(*written)->document == import->document);
}

TEST(VoxDamage, EveryTruncationIsRefused) {
    const Bytes whole = everyChunk();
    for (std::size_t length = 0; length < whole.size(); ++length) {
        const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
        const Result<VoxImport> import = readVox(cut);
        ASSERT_FALSE(import) << length;
        ASSERT_TRUE(import.error().offset) << length;
        EXPECT_LE(*import.error().offset, length);
    }
}

// The same with lengths of MAIN that fit, so that chunks are cut off and not just the file.
TEST(VoxDamage, EveryTruncationWithinMainEndsInAnErrorOrADocument) {
    const Bytes whole = everyChunk();
    for (std::size_t length = 20; length < whole.size(); ++length) {
        Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
        for (std::size_t i = 0; i < 4; ++i) {
            cut[16 + i] = static_cast<std::uint8_t>((length - 20) >> (8 * i));
        }
        expectErrorOrDocument(cut);
    }
}

TEST(VoxDamage, EveryFlippedByteEndsInAnErrorOrADocument) {
    const Bytes whole = everyChunk();
    for (std::size_t at = 0; at < whole.size(); ++at) {
        for (const int mask : {0x01, 0x80, 0xFF}) {
            Bytes flipped = whole;
            flipped[at] = static_cast<std::uint8_t>(flipped[at] ^ mask);
            expectErrorOrDocument(flipped);
        }
    }
}

TEST(VoxDamage, RandomNumbersInRandomPlacesEndInAnErrorOrADocument) {
    const Bytes whole = everyChunk();
    test::Random random(5);
    constexpr std::int64_t kOdd[] = {0, 1, -1, 255, 256, 257, 0x7FFFFFFF, -0x7FFFFFFF - 1, 1 << 24};
    for (int round = 0; round < 5000; ++round) {
        Bytes changed = whole;
        for (int change = random.between(1, 4); change > 0; --change) {
            Bytes number;
            put32(number, kOdd[random.between(0, 8)]);
            const int at = random.between(8, static_cast<int>(whole.size()) - 4);
            std::copy(number.begin(), number.end(), changed.begin() + at);
        }
        expectErrorOrDocument(changed);
    }
}

}  // namespace
}  // namespace voxprite
