// The sections SOCK and SPOS, read here from the byte diagram alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/io/svo_file.h"
#include "core/model/entity_voxels.h"
#include "tests/core/io/svo_sections.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::SvoSection;
using testing::ElementsAre;
using testing::HasSubstr;

// Four frames, of which the clips show three: 1, 2 and 1 again. Its minimum corner is (-2, 0, 0).
Document walker() {
    VoxelGrid low;
    low.fill({{-2, 0, 0}, {2, 2, 2}}, 1);
    Document document =
        test::animationOf({low, test::solidBox({3, 3, 3}, 2), test::solidBox({1, 1, 9}, 3), low});
    document.clips = {Clip{"step", 1, 2, 8.0, true, {}}, Clip{"back", 1, 1, 2.0, false, {}}};
    document.sockets = {Socket{"hand", {{0, {0.5, 1.0, 1.5}}}},
                        Socket{"Mündung", {{0, {9, 9, 9}}, {2, {1.0, 2.0, 3.25}}}},
                        Socket{"", {{0, {-1e7 + 100, 0, 1e7}}}}};
    return document;
}

Bytes exported(const Document& document) {
    return writeSvo(bakeForExport(document, GameProfile{}).value()).value();
}

struct ReadSocket {
    std::string name;
    std::vector<glm::dvec3> positions;
};

std::vector<ReadSocket> socketsIn(const Bytes& bytes) {
    std::vector<SvoSection> sections = test::sectionsOf(bytes);
    const auto& records = test::sectionNamed(sections, "SOCK").bytes;
    const auto& places = test::sectionNamed(sections, "SPOS").bytes;
    const auto& texts = test::sectionNamed(sections, "STRS").bytes;
    std::vector<ReadSocket> sockets;
    for (std::size_t at = 0; at < records.size(); at += 16) {
        ReadSocket& socket = sockets.emplace_back();
        const auto text = texts.begin() + test::valueAt<std::uint32_t>(records, at);
        socket.name.assign(text, text + test::valueAt<std::uint32_t>(records, at + 4));
        const auto first = test::valueAt<std::uint32_t>(records, at + 8);
        const auto count = test::valueAt<std::uint32_t>(records, at + 12);
        for (std::size_t k = 24 * std::size_t{first}; k < 24 * (std::size_t{first} + count);
             k += 24) {
            socket.positions.emplace_back(test::valueAt<double>(places, k),
                                          test::valueAt<double>(places, k + 8),
                                          test::valueAt<double>(places, k + 16));
        }
    }
    return sockets;
}

TEST(SvoSockets, AreWrittenAsTheDiagramSays) {
    const Bytes bytes = exported(walker());
    const std::vector<ReadSocket> sockets = socketsIn(bytes);
    ASSERT_EQ(sockets.size(), 3u);
    EXPECT_EQ(sockets[0].name, "hand");
    EXPECT_THAT(sockets[0].positions, ElementsAre(glm::dvec3(2.5, 1.0, 1.5)));
    EXPECT_EQ(sockets[1].name, "Mündung");
    // Frames 1 and 2 of the one clip, frame 1 of the other.
    EXPECT_THAT(sockets[1].positions, ElementsAre(glm::dvec3(11, 9, 9), glm::dvec3(3.0, 2.0, 3.25),
                                                  glm::dvec3(11, 9, 9)));
    EXPECT_EQ(sockets[2].name, "");
    EXPECT_EQ(test::valueAt<std::uint16_t>(bytes, 10), 1);
    // A reader that does not know the sections may skip them.
    for (const SvoSection& section : test::sectionsOf(bytes)) {
        const bool known = section.tag != "SOCK" && section.tag != "SPOS";
        EXPECT_EQ(section.flags, known ? 1u : 0u);
    }
}

TEST(SvoSockets, AFileWithoutAnyHasNoSuchSections) {
    Document document = walker();
    document.sockets.clear();
    std::vector<SvoSection> sections = test::sectionsOf(exported(document));
    EXPECT_EQ(sections.size(), 9u);
    for (const SvoSection& section : sections) {
        EXPECT_NE(section.tag, "SOCK");
        EXPECT_NE(section.tag, "SPOS");
    }
    // Empty ones mean the same.
    const Result<SvoFile> plain = readSvo(test::fileOf(sections));
    ASSERT_TRUE(plain) << plain.error().message;
    sections.push_back({"SOCK", 0, {}});
    sections.push_back({"SPOS", 0, {}});
    const Result<SvoFile> file = readSvo(test::fileOf(sections));
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_EQ(*file, *plain);
}

TEST(SvoSockets, ReadBackTheyLieWhereTheyLay) {
    const Document before = walker();
    const Document document = documentFromSvo(readSvo(exported(before)).value());
    ASSERT_EQ(document.sockets.size(), 3u);
    const std::vector<int> shown{1, 2, 1};
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(document.sockets[k].name, before.sockets[k].name);
        for (int frame = 0; frame < 3; ++frame) {
            EXPECT_EQ(positionAt(document.sockets[k], frame),
                      positionAt(before.sockets[k], shown[static_cast<std::size_t>(frame)]));
        }
    }
    EXPECT_TRUE(validate(document));
    // From here on nothing changes any more.
    EXPECT_EQ(documentFromSvo(readSvo(exported(document)).value()).sockets, document.sockets);
}

TEST(SvoSockets, OfAStillModel) {
    Document document = test::documentOf(test::solidBox({2, 2, 2}));
    document.sockets = {Socket{"seat", {{0, {1, 1, 2}}}}};
    const Bytes bytes = exported(document);
    EXPECT_THAT(socketsIn(bytes)[0].positions, ElementsAre(glm::dvec3(1, 1, 2)));
    EXPECT_EQ(documentFromSvo(readSvo(bytes).value()).sockets, document.sockets);
}

TEST(SvoSockets, VerifyingSeesAnyOther) {
    const Document document = walker();
    const Bytes bytes = exported(document);
    ASSERT_TRUE(verifyExport(bytes, document));
    const auto differs = [&](auto change) {
        Document other = document;
        change(other.sockets);
        const Status same = verifyExport(bytes, other);
        return !same && same.error().message == "the export has other sockets";
    };
    EXPECT_TRUE(differs([](auto& sockets) { sockets[0].name = "Hand"; }));
    EXPECT_TRUE(differs([](auto& sockets) { sockets[0].positions[0].positionVoxels.z += 1e-9; }));
    EXPECT_TRUE(differs([](auto& sockets) { sockets[1].positions[1].positionVoxels.x = 0.0; }));
    EXPECT_TRUE(differs([](auto& sockets) { sockets[1].positions[1].frame = 1; }));
    EXPECT_TRUE(differs([](auto& sockets) { sockets.pop_back(); }));
    EXPECT_TRUE(differs([](auto& sockets) { sockets.push_back({}); }));
}

TEST(SvoSockets, EveryTruncatedSectionIsRefused) {
    const std::vector<SvoSection> whole = test::sectionsOf(exported(walker()));
    for (const char* tag : {"SOCK", "SPOS"}) {
        std::vector<SvoSection> sections = whole;
        std::vector<std::uint8_t>& bytes = test::sectionNamed(sections, tag).bytes;
        while (!bytes.empty()) {
            bytes.pop_back();
            const Result<SvoFile> file = readSvo(test::fileOf(sections));
            EXPECT_FALSE(file) << tag << " of " << bytes.size() << " bytes";
            if (!file) {
                EXPECT_TRUE(file.error().offset.has_value());
            }
        }
        sections = whole;
        std::erase_if(sections, [&](const SvoSection& section) { return section.tag == tag; });
        const Result<SvoFile> file = readSvo(test::fileOf(sections));
        ASSERT_FALSE(file);
        EXPECT_EQ(file.error().message, "of SOCK and SPOS there is only one");
    }
}

TEST(SvoSockets, DamageUnderRightChecksumsIsRefusedOrHarmless) {
    const std::vector<SvoSection> whole = test::sectionsOf(exported(walker()));
    int refused = 0;
    for (const char* tag : {"SOCK", "SPOS"}) {
        std::vector<SvoSection> sections = whole;
        std::vector<std::uint8_t>& bytes = test::sectionNamed(sections, tag).bytes;
        for (std::uint8_t& byte : bytes) {
            for (const std::uint8_t flip : std::array<std::uint8_t, 3>{1, 0x80, 0xFF}) {
                byte = static_cast<std::uint8_t>(byte ^ flip);
                const Result<SvoFile> file = readSvo(test::fileOf(sections));
                if (file) {
                    EXPECT_TRUE(writeSvo(*file));
                    EXPECT_TRUE(validate(documentFromSvo(*file)));
                } else {
                    ++refused;
                }
                byte = static_cast<std::uint8_t>(byte ^ flip);
            }
        }
    }
    EXPECT_GT(refused, 100);
}

TEST(SvoSockets, WhatCannotBeIsRefusedWithItsPlace) {
    const std::vector<SvoSection> whole = test::sectionsOf(exported(walker()));
    const auto reason = [&](const char* tag, std::size_t at, auto value) {
        std::vector<SvoSection> sections = whole;
        test::setValueAt(test::sectionNamed(sections, tag).bytes, at, value);
        const Result<SvoFile> file = readSvo(test::fileOf(sections));
        return file ? "taken" : file.error().message;
    };
    EXPECT_THAT(reason("SPOS", 0, std::nan("")), HasSubstr("socket \"hand\" lies beyond"));
    EXPECT_THAT(reason("SPOS", 8, 1e300), HasSubstr("socket \"hand\" lies beyond"));
    EXPECT_THAT(reason("SOCK", 8, std::uint32_t{1}), HasSubstr("not the next of SPOS"));
    EXPECT_THAT(reason("SOCK", 12, std::uint32_t{2}), HasSubstr("has 2 positions"));
    EXPECT_THAT(reason("SOCK", 12, std::uint32_t{0}), HasSubstr("has 0 positions"));
    EXPECT_THAT(reason("SOCK", 12, ~std::uint32_t{0}), HasSubstr("not the next of SPOS"));
    EXPECT_THAT(reason("SOCK", 0, ~std::uint32_t{0}), HasSubstr("within section STRS"));

    SvoFile file = bakeForExport(walker(), GameProfile{}).value();
    file.sockets[0].positions.resize(2);
    EXPECT_FALSE(writeSvo(file));
    file.sockets[0] = {"\xFF", {glm::dvec3(0)}};
    EXPECT_FALSE(writeSvo(file));
}

TEST(SvoClips, UnevenDurationsComeBackOneByOne) {
    Document document = walker();
    document.clips = {Clip{"odd", 0, 2, 8.0, true, {40, 300, 7}},
                      Clip{"even", 1, 2, 6.0, true, {}}};
    const Bytes bytes = exported(document);
    EXPECT_THAT(readSvo(bytes).value().clips[0].durationsMilliseconds, ElementsAre(40, 300, 7));
    const Document again = documentFromSvo(readSvo(bytes).value());
    EXPECT_THAT(again.clips[0].durationsMilliseconds, ElementsAre(40, 300, 7));
    EXPECT_TRUE(again.clips[1].durationsMilliseconds.empty());
    EXPECT_EQ(again.clips[1].framesPerSecond, 6.0);
}

}  // namespace
}  // namespace voxprite
