// Several entities in one .svo: what the format promises besides the files of the conformance set
// (tests/runtime).
#include <gmock/gmock.h>

#include <set>

#include "core/io/svo_file.h"
#include "core/io/svo_set.h"
#include "core/model/document.h"
#include "core/svo/bake.h"
#include "tests/core/io/svo_sections.h"
#include "tests/support/must.h"
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

}  // namespace
}  // namespace voxprite
