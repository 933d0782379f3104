// Several entities in one .svo: what the format promises besides the files of the conformance set
// (tests/runtime).
#include <gmock/gmock.h>

#include <fstream>
#include <set>

#include "core/base/file.h"
#include "core/io/svo_file.h"
#include "core/io/svo_set.h"
#include "core/model/document.h"
#include "core/model/entity_voxels.h"
#include "core/svo/bake.h"
#include "tests/core/io/svo_sections.h"
#include "tests/support/must.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::must;

std::vector<SvoFile> smallSet() {
    Document box = test::documentOf(test::solidBox({2, 1, 3}));
    box.palette.colours[1] = {9, 8, 7, 255};
    SvoFile first = must(bakeForExport(box, {}));
    first.name = "box";
    first.anchor = {1.0, 0.5, 0.0};
    SvoFile second = must(bakeForExport(test::documentOf(test::solidBox({1, 1, 1})), {}));
    second.name = "dot";
    second.sigma = 2.0;
    second.sockets = {{"top", {{0.5, 0.5, 1.0}}}};
    return {first, second};
}

TEST(SvoSet, OneEntityIsTheFileThatItWas) {
    const SvoFile one = smallSet()[0];
    EXPECT_EQ(must(writeSvoSet({&one, 1})), must(writeSvo(one)));
    EXPECT_EQ(must(readSvoSet(must(writeSvo(one)))), std::vector{one});
    EXPECT_FALSE(writeSvoSet({}).has_value());
}

TEST(SvoSet, OldReadersAreToldThatTheyMustKnow) {
    const Bytes bytes = must(writeSvoSet(smallSet()));
    for (const test::SvoSection& section : test::sectionsOf(bytes)) {
        EXPECT_EQ(section.flags & 1u, section.tag == "SOCK" || section.tag == "SPOS" ? 0u : 1u);
    }
    EXPECT_EQ(test::valueAt<std::uint16_t>(bytes, 8), 1);
    EXPECT_EQ(test::valueAt<std::uint16_t>(bytes, 10), 2);
}

TEST(SvoSet, EveryTruncationAndFlippedByteIsRefusedOrAnotherValidSet) {
    const Bytes bytes = must(writeSvoSet(smallSet()));
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        ASSERT_FALSE(readSvoSet(ByteView(bytes).first(length)).has_value()) << length;
    }
    int refused = 0;
    for (std::size_t at = 8; at < bytes.size(); ++at) {
        Bytes damaged = bytes;
        damaged[at] ^= at % 2 == 0 ? 0xFF : 0x01;
        test::reseal(damaged);
        const Result<std::vector<SvoFile>> set = readSvoSet(damaged);
        if (!set) {
            ++refused;
            ASSERT_TRUE(set.error().offset.has_value()) << set.error().message;
            continue;
        }
        ASSERT_EQ(must(readSvoSet(must(writeSvoSet(*set)))), *set) << at;
    }
    EXPECT_GT(refused, 400);
}

TEST(SvoSet, HoldsAtMost4096Entities) {
    const std::vector<SvoFile> set(4097, smallSet()[1]);
    EXPECT_THAT(writeSvoSet(set).error().message, testing::HasSubstr("4,096"));
    const Bytes most = must(writeSvoSet(std::span(set).first(4096)));
    EXPECT_EQ(must(readSvoSet(most)).size(), 4096u);
    // A count that the file does not bear out costs no memory.
    std::vector<test::SvoSection> sections = test::sectionsOf(must(writeSvoSet(smallSet())));
    test::sectionNamed(sections, "ENTY").bytes.resize(std::size_t{32} << 20);
    EXPECT_FALSE(readSvoSet(test::fileOf(sections)).has_value());
}

TEST(SvoSet, MembersAreVerifiedNamedAndTold) {
    const Document busy = test::busyDocument();
    const Document box = test::documentOf(test::solidBox({2, 1, 3}));
    const GameProfile profile;
    const std::vector<SetMember> members{{box, profile, std::nullopt, "thing"},
                                         {busy, profile, std::nullopt, "thing"},
                                         {busy, profile, 0, "thing"}};
    const std::vector<SvoFile> set = must(readSvoSet(must(exportSvoSet(members))));
    ASSERT_EQ(set.size(), 3u);
    EXPECT_TRUE(verifyExport(set[0], box));
    EXPECT_TRUE(verifyExport(set[1], busy));
    EXPECT_FALSE(verifyExport(set[0], busy));
    EXPECT_TRUE(verifyModelExport(set[2], busy, 0));
    EXPECT_EQ(set[0].name, "thing");
    EXPECT_EQ(set[0].models[0].name, "thing");
    EXPECT_EQ(set[2].models[0].name, set[2].name);
    std::set<std::string> names;
    for (const SvoFile& entity : set) names.insert(entity.name);
    EXPECT_EQ(names.size(), set.size());

    const std::vector<SetMember> wrong{{box, profile, 7, "lost"}};
    EXPECT_THAT(exportSvoSet(wrong).error().message, testing::HasSubstr("\"lost\""));
}

TEST(SvoSet, IsToldFromOtherFilesBeforeItIsOpened) {
    const test::TemporaryFolder folder;
    const std::vector<SvoFile> set = smallSet();
    const Bytes bytes = must(writeSvoSet(set));
    ASSERT_TRUE(writeFileAtomically(folder / "set.SVO", bytes));
    EXPECT_EQ(entitiesAt(folder / "set.SVO"), 2u);
    EXPECT_EQ(must(severalEntities(folder / "set.SVO")), set);
    ASSERT_TRUE(writeFileAtomically(folder / "one.svo", must(writeSvo(set[0]))));
    EXPECT_EQ(entitiesAt(folder / "one.svo"), 1u);
    ASSERT_TRUE(writeFileAtomically(folder / "set.vox", bytes));
    for (const char* name : {"one.svo", "set.vox", "none.svo", ""}) {
        EXPECT_TRUE(must(severalEntities(folder / name)).empty()) << name;
    }
    EXPECT_EQ(entitiesAt(folder / "set.vox"), 0u);
    EXPECT_EQ(entitiesAt(folder / "none.svo"), 0u);
    // A damaged set is one still, and its damage is told.
    Bytes damaged = bytes;
    damaged[damaged.size() - 1] ^= 1;
    ASSERT_TRUE(writeFileAtomically(folder / "set.svo", damaged));
    EXPECT_EQ(entitiesAt(folder / "set.svo"), 2u);
    EXPECT_THAT(severalEntities(folder / "set.svo").error().describe(),
                testing::HasSubstr("set.svo"));
    // However short it is.
    const std::string text(bytes.begin(), bytes.end());
    for (std::size_t length = 0; length < 512; ++length) {
        std::ofstream(folder / "cut.svo", std::ios::binary) << text.substr(0, length);
        EXPECT_LE(entitiesAt(folder / "cut.svo"), 2u);
    }
}

TEST(SvoSet, FiguresTellEntitiesApart) {
    const std::vector<SvoFile> set = smallSet();
    EXPECT_EQ(figuresOf(set[0]).size, glm::ivec3(2, 1, 3));
    EXPECT_EQ(figuresOf(set[0]).voxels, 6u);
    EXPECT_EQ(figuresOf(set[0]).frames, 1u);
    const Document busy = test::busyDocument();
    const SvoFile entity = must(bakeForExport(busy, {}));
    const EntityFigures figures = figuresOf(entity);
    EXPECT_EQ(figures.frames, static_cast<std::size_t>(frameCount(documentFromSvo(entity))));
    EXPECT_EQ(figures.size, entityBounds(busy).size());
    ASSERT_FALSE(entity.clips.empty());
    EXPECT_EQ(figures.firstModel, entity.clips[0].models[0]);
    EXPECT_EQ(figures.voxels, flatten(documentFromSvo(entity), 0).solidCount());
}

}  // namespace
}  // namespace voxprite
