#include "core/io/svo_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/svo/bake.h"
#include "core/svo/validate.h"
#include "tests/core/io/svo_sections.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::SvoSection;
using testing::HasSubstr;

// Two models of one size, one of another; two clips; texts in several scripts.
SvoFile sampleFile() {
    SvoFile file;
    VoxelGrid first;
    first.set({-3, 0, 2}, 1);
    first.set({1, 2, 4}, 200);
    const IBox bounds = first.bounds();
    VoxelGrid second;
    second.fill({{-3, 0, 2}, {1, 2, 4}}, 9);
    VoxelGrid other;
    other.set({100, 100, 100}, 3);
    file.models = {{"first", bake(first, bounds).value()},
                   {"zwölf", bake(second, bounds).value()},
                   {"", bake(other).value()}};
    file.clips = {{"walk", {0, 1, 0}, {125, 250, 1}, true}, {"見る", {2}, {1000000}, false}};
    for (int i = 1; i < 256; ++i) {
        file.palette[static_cast<std::size_t>(i)] =
            Rgba8(i, 255 - i, (7 * i) & 255, i % 3 == 0 ? 100 : 255);
    }
    file.colourNames[7] = "amber glass";
    file.colourNames[255] = "Ω";
    file.name = "sample";
    file.voxelSizeMetres = 0.25;
    file.sigma = 7.5;
    file.anchor = {1.5, -2.0, 1e6};
    file.outline = {false, {1, 2, 3, 255}};
    return file;
}

Bytes sampleBytes() {
    return writeSvo(sampleFile()).value();
}

void expectRefused(const Bytes& bytes, const char* reason,
                   std::optional<std::uint64_t> offset = std::nullopt) {
    const Result<SvoFile> file = readSvo(bytes);
    ASSERT_FALSE(file.has_value()) << reason;
    EXPECT_THAT(file.error().message, HasSubstr(reason));
    EXPECT_TRUE(file.error().offset.has_value()) << "names the place";
    if (offset) {
        EXPECT_EQ(file.error().offset, offset);
    }
}

// The sample with one value of a section changed, under valid checksums.
template <class T>
Bytes changed(const std::string& tag, std::size_t offset, T value) {
    std::vector<SvoSection> sections = test::sectionsOf(sampleBytes());
    test::setValueAt(test::sectionNamed(sections, tag).bytes, offset, value);
    return test::fileOf(sections);
}

TEST(SvoFile, ReadsBackEqual) {
    const SvoFile file = sampleFile();
    const Bytes bytes = writeSvo(file).value();
    EXPECT_EQ(readSvo(bytes).value(), file);
    EXPECT_EQ(writeSvo(file).value(), bytes) << "the same bytes every time";
}

TEST(SvoFile, MatchesTheByteDiagram) {
    VoxelGrid voxels;  // 3 x 1 x 1: root and two bricks
    for (int x = 0; x < 3; ++x) voxels.set({x - 7, 0, 0}, static_cast<std::uint8_t>(x + 1));
    SvoFile file;
    file.models = {{"ab", bake(voxels).value()}};
    file.palette[1] = {10, 20, 30, 255};
    file.name = "c";
    const Bytes bytes = writeSvo(file).value();

    const std::uint8_t magic[] = {0x89, 'S', 'V', 'O', '\r', '\n', 0x1A, '\n'};
    EXPECT_TRUE(std::equal(magic, magic + 8, bytes.begin()));
    EXPECT_EQ(test::valueAt<std::uint32_t>(bytes, 8), 1u);
    EXPECT_EQ(test::valueAt<std::uint32_t>(bytes, 12), 9u);
    EXPECT_EQ(test::valueAt<std::uint64_t>(bytes, 16), bytes.size());
    Bytes sealed = bytes;
    test::reseal(sealed);
    EXPECT_EQ(sealed, bytes);
    EXPECT_EQ(test::fileOf(test::sectionsOf(bytes)), bytes);
    for (std::size_t entry = 64; entry < 64 + 9 * 32; entry += 32) {
        EXPECT_EQ(test::valueAt<std::uint64_t>(bytes, entry + 8) % 64, 0u);
    }

    std::vector<SvoSection> sections = test::sectionsOf(bytes);
    const auto words = [&](const std::string& tag) {
        const Bytes& section = test::sectionNamed(sections, tag).bytes;
        std::vector<std::uint32_t> result;
        for (std::size_t at = 0; at < section.size(); at += 4) {
            result.push_back(test::valueAt<std::uint32_t>(section, at));
        }
        return result;
    };
    const auto minusSeven = static_cast<std::uint32_t>(-7);
    EXPECT_EQ(words("MODL"), (std::vector<std::uint32_t>{0, 0, 2, 3, 1, 1, 3, 2, minusSeven, 0, 0,
                                                         0, 2, 0, 0, 0}));
    EXPECT_EQ(words("NODE"), (std::vector<std::uint32_t>{0x8000'0103, 0x4000'0000, 0x4000'0001}));
    EXPECT_EQ(words("PAYL"), (std::vector<std::uint32_t>{0x0201, 0, 0x03, 0}));
    EXPECT_EQ(words("PALT")[1], 0xFF1E'140Au);
    EXPECT_EQ(words("PALT").size(), 256u);
    EXPECT_EQ(words("CNAM"), std::vector<std::uint32_t>(512, 0));
    EXPECT_TRUE(words("CLIP").empty());
    EXPECT_TRUE(words("FRAM").empty());
    EXPECT_EQ(words("AUTH").size(), 16u);
    EXPECT_EQ(words("AUTH")[10], 1u);            // outlined
    EXPECT_EQ(words("AUTH")[11], 0xFF00'0000u);  // in black
    EXPECT_EQ(words("AUTH")[12], 2u);            // "c" begins after "ab"
    EXPECT_EQ(words("AUTH")[13], 1u);
    const Bytes& authored = test::sectionNamed(sections, "AUTH").bytes;
    EXPECT_EQ(test::valueAt<double>(authored, 0), 0.1);
    EXPECT_EQ(test::valueAt<double>(authored, 8), 4.0);
    EXPECT_EQ(test::sectionNamed(sections, "STRS").bytes, (Bytes{'a', 'b', 'c'}));
}

TEST(SvoFile, EveryTruncationIsRefused) {
    const Bytes bytes = sampleBytes();
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        const Result<SvoFile> file = readSvo(ByteView(bytes).first(length));
        ASSERT_FALSE(file.has_value()) << length;
        ASSERT_TRUE(file.error().offset.has_value()) << length;
    }
    Bytes longer = bytes;
    longer.push_back(0);
    expectRefused(longer, "should have", 16);
}

TEST(SvoFile, EveryFlippedBitIsRefusedOrInThePadding) {
    const SvoFile file = sampleFile();
    Bytes bytes = sampleBytes();
    std::size_t sectionBytes = 0;
    for (const SvoSection& section : test::sectionsOf(bytes)) sectionBytes += section.bytes.size();
    std::size_t harmless = 0;
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        const int bit = static_cast<int>(at % 8);
        bytes[at] ^= static_cast<std::uint8_t>(1 << bit);
        const Result<SvoFile> damaged = readSvo(bytes);
        if (damaged) {
            EXPECT_EQ(*damaged, file) << "byte " << at;
            ++harmless;
        }
        bytes[at] ^= static_cast<std::uint8_t>(1 << bit);
    }
    EXPECT_EQ(harmless, bytes.size() - sectionBytes - 64 - 9 * 32);
}

TEST(SvoFile, DamageUnderValidChecksumsIsRefusedOrAnotherValidFile) {
    const Bytes bytes = sampleBytes();
    int refused = 0;
    for (std::size_t at = 8; at < bytes.size(); ++at) {
        for (const int flip : {0x01, 0x80, 0xFF}) {
            Bytes damaged = bytes;
            damaged[at] ^= static_cast<std::uint8_t>(flip);
            test::reseal(damaged);
            const Result<SvoFile> file = readSvo(damaged);
            if (!file) {
                ++refused;
                ASSERT_TRUE(file.error().offset.has_value()) << file.error().message;
                continue;
            }
            const Result<Bytes> again = writeSvo(*file);
            ASSERT_TRUE(again.has_value()) << again.error().message;
            ASSERT_EQ(readSvo(*again).value(), *file);
            if (at % 16 != 0) continue;
            const Status valid = validate(documentFromSvo(*file));
            ASSERT_TRUE(valid.has_value()) << valid.error().message;
        }
    }
    EXPECT_GT(refused, 1000);
}

TEST(SvoFile, UnknownSectionsAreSkipped) {
    std::vector<SvoSection> sections = test::sectionsOf(sampleBytes());
    sections.insert(sections.begin() + 2, SvoSection{"LODS", 0, Bytes(100, 7)});
    sections.push_back({"XTRA", 0xFFFF'FFFEu, {}});
    EXPECT_EQ(readSvo(test::fileOf(sections)).value(), sampleFile());

    sections.back().flags = 1;
    expectRefused(test::fileOf(sections), "XTRA is not known", 64 + 10 * 32);
    sections.pop_back();
    sections.push_back(sections.front());
    expectRefused(test::fileOf(sections), "MODL occurs twice", 64 + 10 * 32);
}

TEST(SvoFile, SectionsMayComeInAnyOrder) {
    std::vector<SvoSection> sections = test::sectionsOf(sampleBytes());
    std::reverse(sections.begin(), sections.end());
    EXPECT_EQ(readSvo(test::fileOf(sections)).value(), sampleFile());
    for (std::size_t i = 0; i < sections.size(); ++i) {
        std::vector<SvoSection> others = sections;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        expectRefused(test::fileOf(others), (sections[i].tag + " is missing").c_str());
    }
}

TEST(SvoFile, OnlyTheMajorVersionMatters) {
    Bytes bytes = sampleBytes();
    test::setValueAt(bytes, 10, std::uint16_t{7});
    test::reseal(bytes);
    EXPECT_EQ(readSvo(bytes).value(), sampleFile());
    test::setValueAt(bytes, 8, std::uint16_t{2});
    test::reseal(bytes);
    expectRefused(bytes, "version 2", 8);
    expectRefused({}, "not a .svo", 0);
    expectRefused(Bytes(1000, 'x'), "not a .svo", 0);
}

TEST(SvoFile, SectionTableStaysWithinTheFile) {
    const auto withEntry = [](std::size_t field, std::uint64_t value) {
        Bytes bytes = sampleBytes();
        test::setValueAt(bytes, 64 + 32 + field, value);  // of NODE
        test::reseal(bytes);
        return bytes;
    };
    const Bytes bytes = sampleBytes();
    expectRefused(withEntry(8, 0), "within the file", 96);
    expectRefused(withEntry(8, bytes.size() + 64 - bytes.size() % 64), "within the file", 96);
    expectRefused(withEntry(8, ~std::uint64_t{63}), "within the file", 96);
    expectRefused(withEntry(8, test::valueAt<std::uint64_t>(bytes, 96 + 8) + 4), "within the file",
                  96);
    expectRefused(withEntry(16, bytes.size()), "within the file", 96);
    expectRefused(withEntry(16, ~std::uint64_t{0}), "within the file", 96);
    expectRefused(withEntry(16, 3), "wrong length");

    Bytes many = bytes;
    test::setValueAt(many, 12, std::uint32_t{0xFFFF'FFFF});
    expectRefused(many, "longer than the file", 12);
}

TEST(SvoFile, ModelsAreChecked) {
    const auto nodeSection = test::valueAt<std::uint64_t>(sampleBytes(), 96 + 8);
    const auto modelSection = test::valueAt<std::uint64_t>(sampleBytes(), 64 + 8);
    expectRefused(changed("MODL", 0, 1u), "leaves a gap", modelSection);
    expectRefused(changed("MODL", 4, 1u), "leaves a gap", modelSection + 4);
    expectRefused(changed("MODL", 24, 0xFFFF'FFFFu), "ends beyond", modelSection);
    expectRefused(changed("MODL", 28, 0xFFFF'FFFFu), "ends beyond", modelSection + 4);
    expectRefused(changed("MODL", 8, 0u), "depth", modelSection);
    expectRefused(changed("MODL", 8, 0xFFFF'FFFFu), "depth", modelSection);
    expectRefused(changed("MODL", 12, 70000u), "65,536", modelSection);
    expectRefused(changed("MODL", 32, 0x7FFF'FFFFu), "2^24", modelSection);
    expectRefused(changed("NODE", 0, 0xFFFF'FFFFu), "beyond the end", nodeSection);
    expectRefused(changed("NODE", 4, 0x0000'1234u), "stray bits", nodeSection + 4);
    expectRefused(changed("PALT", 0, 1u), "transparent black");

    // Nodes and payloads without a model.
    for (const char* tag : {"NODE", "PAYL"}) {
        std::vector<SvoSection> sections = test::sectionsOf(sampleBytes());
        test::sectionNamed(sections, tag)
            .bytes.resize(test::sectionNamed(sections, tag).bytes.size() + 8);
        expectRefused(test::fileOf(sections), "belong to no model");
    }
}

TEST(SvoFile, TextsAreChecked) {
    expectRefused(changed("STRS", 0, std::uint8_t{0xFF}), "not UTF-8");
    expectRefused(changed("MODL", 44, 0xFFFF'FFF0u), "within section STRS");
    expectRefused(changed("MODL", 48, 0xFFFF'FFF0u), "within section STRS");
    // All texts in one place would make a small file large in memory.
    std::vector<SvoSection> sections = test::sectionsOf(sampleBytes());
    const auto all = static_cast<std::uint32_t>(test::sectionNamed(sections, "STRS").bytes.size());
    Bytes& names = test::sectionNamed(sections, "CNAM").bytes;
    for (std::size_t i = 0; i < 256; ++i) {
        test::setValueAt(names, 8 * i, 0u);
        test::setValueAt(names, 8 * i + 4, all);
    }
    expectRefused(test::fileOf(sections), "within section STRS");
}

TEST(SvoFile, ClipsAreChecked) {
    expectRefused(changed("CLIP", 8, 1u), "next ones of FRAM");
    expectRefused(changed("CLIP", 12, 5u), "next ones of FRAM");
    expectRefused(changed("CLIP", 12, 0xFFFF'FFFFu), "next ones of FRAM");
    expectRefused(changed("CLIP", 12, 0u), "no frames");
    expectRefused(changed("FRAM", 0, 3u), "shows model 3");
    expectRefused(changed("FRAM", 8, 2u), "different sizes");
    expectRefused(changed("FRAM", 4, 0u), "0 ms");
    expectRefused(changed("FRAM", 4, 1'000'001u), "ms");
    std::vector<SvoSection> sections = test::sectionsOf(sampleBytes());
    Bytes& frames = test::sectionNamed(sections, "FRAM").bytes;
    frames.resize(frames.size() + 8);
    expectRefused(test::fileOf(sections), "belong to no clip");
}

TEST(SvoFile, AuthoredValuesAreChecked) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {nan, 0.0, -0.1, 1e300}) {
        expectRefused(changed("AUTH", 0, bad), "voxelSizeMetres");
        expectRefused(changed("AUTH", 8, bad), "sigma");
    }
    for (const double bad : {nan, HUGE_VAL, 1e9}) {
        expectRefused(changed("AUTH", 16, bad), "anchor");
    }
    expectRefused(changed("AUTH", 47, std::uint8_t{128}), "alpha");
}

TEST(SvoFile, WriterRefusesWhatTheReaderWould) {
    const auto expectNotWritten = [](const SvoFile& file, const char* reason) {
        const Result<Bytes> bytes = writeSvo(file);
        ASSERT_FALSE(bytes.has_value()) << reason;
        EXPECT_THAT(bytes.error().message, HasSubstr(reason));
    };
    SvoFile file = sampleFile();
    file.models.clear();
    expectNotWritten(file, "shows model");
    file.clips.clear();
    expectNotWritten(file, "no model");
    file = sampleFile();
    file.models[0].octree.nodes.push_back(0);
    expectNotWritten(file, "no parent");
    file = sampleFile();
    file.name = "\xC3";
    expectNotWritten(file, "UTF-8");
    file = sampleFile();
    file.clips[0].durationsMilliseconds.pop_back();
    expectNotWritten(file, "one duration a frame");
    file = sampleFile();
    file.sigma = 0.0;
    expectNotWritten(file, "sigma");
    file = sampleFile();
    file.clips[0].models.resize(65535, 0);
    file.clips[0].durationsMilliseconds.resize(65535, 1);
    EXPECT_TRUE(writeSvo(file).has_value());
    file.clips[1].models.push_back(2);
    file.clips[1].durationsMilliseconds.push_back(1);
    expectNotWritten(file, "65,536");
    file = sampleFile();
    file.models = {{"vast", Octree{{5}, {}, 14, glm::ivec3(1 << 14), glm::ivec3(0)}}};
    file.clips.clear();
    expectNotWritten(file, "2^40");
}

}  // namespace
}  // namespace voxprite
