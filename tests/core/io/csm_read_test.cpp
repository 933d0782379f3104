// CSM text against voxels worked out by hand, and against a plain interpreter of random texts.
#include <gtest/gtest.h>

#include <memory>
#include <set>

#include "core/io/csm_reader.h"
#include "core/model/entity_voxels.h"
#include "core/svo/validate.h"
#include "tests/support/must.h"
#include "tests/support/random.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::must;
using test::VoxelMap;

ByteView bytesOf(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

Document documentFrom(const std::string& text) {
    return must(readCsm(bytesOf(text)));
}

VoxelMap voxelsOf(const std::string& text) {
    return test::mapOf(documentFrom(text).models.at(0).voxels);
}

int edgeOf(const std::string& text) {
    return must(octreeFromCsm(bytesOf(text))).size.x;
}

const VoxelMap kEight{{{0, 0, 0}, 1}, {{0, 0, 1}, 2}, {{0, 1, 0}, 3}, {{0, 1, 1}, 4},
                      {{1, 0, 0}, 5}, {{1, 0, 1}, 6}, {{1, 1, 0}, 7}, {{1, 1, 1}, 8}};

TEST(CsmRead, ABracketsOctantsHaveXInTheHighBit) {
    EXPECT_EQ(voxelsOf("> [1 2 3 4 5 6 7 8]"), kEight);
    // The same by paths.
    EXPECT_EQ(voxelsOf(">a 1 >b 2 >c 3 >d 4 >e 5 >f 6 >g 7 >h 8"), kEight);
}

TEST(CsmRead, ASolidFillsItsOctantDownToTheDeepestPath) {
    VoxelMap expected;
    for (int i = 0; i < 8; ++i) expected[{i >> 2, i >> 1 & 1, (i & 1) + 2}] = 9;
    expected[{3, 3, 2}] = 4;
    EXPECT_EQ(voxelsOf(">b 9 >hg 4"), expected);
    EXPECT_EQ(edgeOf(">b 9 >hg 4"), 4);
    EXPECT_EQ(voxelsOf("> 7"), (VoxelMap{{{0, 0, 0}, 7}}));
    EXPECT_EQ(edgeOf("> 7"), 1);
    EXPECT_EQ(edgeOf(">aaa 0"), 8);
    EXPECT_EQ(edgeOf(">a [0 0 0 [0 0 0 0 0 0 0 0] 0 0 0 0]"), 8);
}

TEST(CsmRead, WhatADocumentIs) {
    const Document document = documentFrom(">b 9 >hg 4");
    ASSERT_TRUE(validate(document));
    EXPECT_EQ(document.models.at(0).canvas, (IBox{glm::ivec3(0), glm::ivec3(4)}));
    EXPECT_EQ(instancesOf(document, 0).size(), 1u);
    EXPECT_EQ(document.palette, Palette::standard());
    Palette mine;
    mine.colours[9] = Rgba8(1, 2, 3, 255);
    EXPECT_EQ(must(readCsm(bytesOf(">b 9"), mine)).palette, mine);
}

TEST(CsmRead, SpaceAndComments) {
    EXPECT_EQ(voxelsOf(">[1 2 3 4 5 6 7 8]"), kEight);
    EXPECT_EQ(voxelsOf(">a1>b2>c3>d4>e5>f6>g7>h8"), kEight);
    EXPECT_EQ(voxelsOf("# eight > [ | <\n\t>\r\n[1 2 3 4# a half\n5 6\n\n7 8 ]  # done"), kEight);
    EXPECT_EQ(voxelsOf("\xEF\xBB\xBF>a1 > b 2 >c 3 >d 4 >e 005 >f 6 >g 7 >h 8\n"), kEight);
    EXPECT_EQ(voxelsOf("> a 0 > [[1 2 3 4 5 6 7 8]0 0 0 0 0 0 0]"), kEight);
}

TEST(CsmRead, LaterStatementsRefineAndReplace) {
    EXPECT_EQ(voxelsOf(">a 1 >a 2"), (VoxelMap{{{0, 0, 0}, 2}}));
    // Below, above, and the root.
    VoxelMap refined = kEight;
    refined[{0, 1, 1}] = 77;
    EXPECT_EQ(voxelsOf("> [1 2 3 4 5 6 7 8] >d 77"), refined);
    EXPECT_EQ(voxelsOf(">d 77 > [1 2 3 4 5 6 7 8]"), kEight);
    // A solid is taken apart where something finer comes into it.
    VoxelMap holed;
    for (int x = 0; x < 2; ++x)
        for (int y = 0; y < 2; ++y)
            for (int z = 0; z < 2; ++z) holed[{x, y, z}] = 5;
    holed.erase({1, 0, 0});
    EXPECT_EQ(voxelsOf(">a 5 >ae 0"), holed);
    // What was replaced still tells the resolution.
    EXPECT_EQ(edgeOf(">aaaa 1 >a 2"), 16);
    EXPECT_EQ(voxelsOf(">aaaa 1 >a 2").size(), 512u);
}

TEST(CsmRead, TheLastEpochThatAssignedAnythingIsTheModel) {
    EXPECT_EQ(voxelsOf(">a 1 | >b 2"), (VoxelMap{{{0, 0, 1}, 2}}));
    EXPECT_EQ(voxelsOf(">a 1 || # nothing\n |"), (VoxelMap{{{0, 0, 0}, 1}}));
    EXPECT_EQ(voxelsOf("|||>a 1"), (VoxelMap{{{0, 0, 0}, 1}}));
    EXPECT_EQ(voxelsOf(">a 1 | | >b <a"), (VoxelMap{{{0, 0, 1}, 1}}));
    // Its own resolution alone counts.
    EXPECT_EQ(edgeOf(">aaaaa 1 | >b 2"), 2);
    EXPECT_TRUE(voxelsOf("").empty());
    EXPECT_TRUE(voxelsOf("# nothing\n").empty());
    EXPECT_TRUE(voxelsOf(">a 0").empty());
    EXPECT_TRUE(voxelsOf(">a 1 | >b 0").empty());
}

TEST(CsmRead, ReferencesNameWhatTheEpochBeforeAssigned) {
    EXPECT_EQ(voxelsOf("> [1 2 3 4 5 6 7 8] | > <"), kEight);
    EXPECT_EQ(voxelsOf(">c [1 2 3 4 5 6 7 8] | > <c"), kEight);
    // As it stands at the end of that epoch, refined and replaced.
    VoxelMap refined = kEight;
    refined[{1, 1, 1}] = 70;
    EXPECT_EQ(voxelsOf(">c [1 2 3 4 5 6 7 8] >ch 70 | > <c"), refined);
    EXPECT_EQ(voxelsOf(">ca 9 >c 8 | > <ca"), (VoxelMap{{{0, 0, 0}, 8}}));
    // In brackets, several times, and from epoch to epoch.
    EXPECT_EQ(voxelsOf(">a 4 >b 6 | > [<a <b 0 <a 0 0 0 0]"),
              (VoxelMap{{{0, 0, 0}, 4}, {{0, 0, 1}, 6}, {{0, 1, 1}, 4}}));
    EXPECT_EQ(voxelsOf(">a 4 | >b <a | >h <b"), (VoxelMap{{{1, 1, 1}, 4}}));
    // What a statement does to a copy leaves the other copies alone.
    EXPECT_EQ(voxelsOf("> [1 2 3 4 5 6 7 8] | >a < >b < >aa 50 | > <b"), kEight);
    // The depth of what is referred to counts as if it stood there.
    EXPECT_EQ(edgeOf(">a [1 2 3 4 5 6 7 8] | >hh <a"), 8);
}

TEST(CsmRead, MirrorsAllTheWayDown) {
    EXPECT_EQ(voxelsOf("> /x [1 2 3 4 5 6 7 8]"), voxelsOf("> [5 6 7 8 1 2 3 4]"));
    EXPECT_EQ(voxelsOf("> /y [1 2 3 4 5 6 7 8]"), voxelsOf("> [3 4 1 2 7 8 5 6]"));
    EXPECT_EQ(voxelsOf("> /z [1 2 3 4 5 6 7 8]"), voxelsOf("> [2 1 4 3 6 5 8 7]"));
    EXPECT_EQ(voxelsOf("> /zxy [1 2 3 4 5 6 7 8]"), voxelsOf("> [8 7 6 5 4 3 2 1]"));
    EXPECT_EQ(voxelsOf("> / XY [1 2 3 4 5 6 7 8]"), voxelsOf("> /x/y [1 2 3 4 5 6 7 8]"));
    // Voxel (x, y, z) of 4 an edge goes to (3 - x, y, z).
    VoxelMap mirrored;
    for (const auto& [at, value] : voxelsOf(">b [1 2 3 4 5 6 7 8] >gf 9")) {
        mirrored[{3 - std::get<0>(at), std::get<1>(at), std::get<2>(at)}] = value;
    }
    EXPECT_EQ(voxelsOf("> [0 [1 2 3 4 5 6 7 8] 0 0 0 0 [0 0 0 0 0 9 0 0] 0] | > /x <"), mirrored);
    EXPECT_EQ(voxelsOf("> /xyz 5"), (VoxelMap{{{0, 0, 0}, 5}}));
}

TEST(CsmRead, ExchangesAxes) {
    // What lay at (x, y, z) lies at (y, x, z).
    EXPECT_EQ(voxelsOf("> ^xy [1 2 3 4 5 6 7 8]"), voxelsOf("> [1 2 5 6 3 4 7 8]"));
    EXPECT_EQ(voxelsOf("> ^yx [1 2 3 4 5 6 7 8]"), voxelsOf("> [1 2 5 6 3 4 7 8]"));
    EXPECT_EQ(voxelsOf("> ^yz [1 2 3 4 5 6 7 8]"), voxelsOf("> [1 3 2 4 5 7 6 8]"));
    EXPECT_EQ(voxelsOf("> ^xz [1 2 3 4 5 6 7 8]"), voxelsOf("> [1 5 3 7 2 6 4 8]"));
    // What lay along x lies along y: b (z) goes to e (x), e (x) to c (y), c (y) to b (z).
    EXPECT_EQ(voxelsOf("> ^xyz [1 2 3 0 5 0 0 0]"), voxelsOf("> [1 3 5 0 2 0 0 0]"));
    EXPECT_EQ(voxelsOf("> ^zyx [1 2 3 0 5 0 0 0]"), voxelsOf("> [1 5 2 0 3 0 0 0]"));
    // One axis: its halves change places, each as it is.
    EXPECT_EQ(voxelsOf("> ^x [[1 2 3 4 5 6 7 8] 0 0 0 9 0 0 0]"),
              voxelsOf("> [9 0 0 0 [1 2 3 4 5 6 7 8] 0 0 0]"));
    EXPECT_EQ(voxelsOf("> ^z [[1 2 3 4 5 6 7 8] 0 0 0 0 0 0 0]"),
              voxelsOf("> [0 [1 2 3 4 5 6 7 8] 0 0 0 0 0 0]"));
}

TEST(CsmRead, OfSeveralTheInnermostComesFirst) {
    // Mirrored along x, then x and y exchanged: a mirror along y of the exchanged one.
    EXPECT_EQ(voxelsOf("> ^xy /x [1 2 3 4 5 6 7 8]"), voxelsOf("> /y ^xy [1 2 3 4 5 6 7 8]"));
    EXPECT_NE(voxelsOf("> ^xy /x [1 2 3 4 5 6 7 8]"), voxelsOf("> /x ^xy [1 2 3 4 5 6 7 8]"));
    EXPECT_EQ(voxelsOf("> [1 2 3 4 5 6 7 8] | > ^yz ^xz /z <"),
              voxelsOf("> /z [1 2 3 4 5 6 7 8] | > ^xz < | > ^yz <"));
}

TEST(CsmRead, SixteenLevels) {
    const std::string far = ">hhhhhhhhhhhhhhhh 3";
    EXPECT_EQ(edgeOf(far), 65536);
    EXPECT_EQ(voxelsOf(far), (VoxelMap{{{65535, 65535, 65535}, 3}}));
    EXPECT_EQ(voxelsOf(">gaaaaaaaaaaaaaa [0 0 0 0 0 0 0 6]"), (VoxelMap{{{32769, 32769, 1}, 6}}));
}

// --- a plain interpreter, to compare random texts with -------------------------------------------

// Children in the order of the letters.
struct Tree {
    int value = 0;
    std::vector<Tree> children;  // eight, or none
};

int levelsOf(const Tree& tree) {
    int levels = 0;
    for (const Tree& child : tree.children) levels = std::max(levels, 1 + levelsOf(child));
    return levels;
}

// Each child moved to where `to` takes its letter's number, and turned itself if `deep`.
template <class To>
Tree moved(const Tree& tree, const To& to, bool deep) {
    Tree result{tree.value, std::vector<Tree>(tree.children.size())};
    for (unsigned i = 0; i < tree.children.size(); ++i) {
        result.children[to(i)] = deep ? moved(tree.children[i], to, true) : tree.children[i];
    }
    return result;
}

void put(Tree& tree, const std::string& path, const Tree& part) {
    if (path.empty()) {
        tree = part;
        return;
    }
    if (tree.children.empty()) tree.children.assign(8, Tree{tree.value, {}});
    put(tree.children[static_cast<std::size_t>(path[0] - 'a')], path.substr(1), part);
}

Tree partAt(const Tree& tree, const std::string& path) {
    if (path.empty() || tree.children.empty()) return path.empty() ? tree : Tree{tree.value, {}};
    return partAt(tree.children[static_cast<std::size_t>(path[0] - 'a')], path.substr(1));
}

void paint(const Tree& tree, glm::ivec3 corner, int edge, VoxelMap& voxels) {
    if (tree.children.empty()) {
        if (tree.value == 0) return;
        for (int x = 0; x < edge; ++x)
            for (int y = 0; y < edge; ++y)
                for (int z = 0; z < edge; ++z) {
                    voxels[{corner.x + x, corner.y + y, corner.z + z}] =
                        static_cast<std::uint8_t>(tree.value);
                }
        return;
    }
    for (int i = 0; i < 8; ++i) {
        paint(tree.children[static_cast<std::size_t>(i)],
              corner + glm::ivec3(i >> 2, i >> 1 & 1, i & 1) * (edge / 2), edge / 2, voxels);
    }
}

// Writes a text and finds out what it means on the way.
class RandomText {
  public:
    explicit RandomText(std::uint64_t seed) : random_(seed) {}

    std::string text;
    VoxelMap voxels;
    int edge = 1;

    void write(int maxLevels) {
        maxLevels_ = maxLevels;
        for (int epoch = random_.between(1, 4); epoch > 0; --epoch) {
            for (int i = random_.between(0, 5); i > 0; --i) statement();
            if (!paths_.empty()) {
                before_ = std::move(now_);
                pathsBefore_ = std::move(paths_);
                edge = 1 << levels_;
                now_ = {};
                paths_.clear();
                levels_ = 0;
            }
            if (epoch > 1) text += " |" + space();
        }
        paint(before_, glm::ivec3(0), edge, voxels);
    }

  private:
    std::string space() {
        static const char* const kSpaces[] = {"", " ", "\n", "\t ", " # >a | [\n", "\r\n"};
        return kSpaces[random_.between(0, 5)];
    }

    void statement() {
        std::string path;
        for (int i = random_.between(0, maxLevels_); i > 0; --i) {
            path += static_cast<char>('a' + random_.between(0, 7));
        }
        text += ">" + path + " ";
        const Tree cube = writeCube(static_cast<int>(path.size()));
        text += space();
        put(now_, path, cube);
        levels_ = std::max(levels_, static_cast<int>(path.size()) + levelsOf(cube));
        paths_.insert(path);
    }

    Tree writeCube(int depth) {
        const int kind = random_.between(0, 9);
        if (kind < 2) return writeTurned(depth);
        if (kind < 5 && depth < maxLevels_) {
            Tree tree{0, {}};
            text += "[" + space();
            for (int i = 0; i < 8; ++i) {
                tree.children.push_back(writeCube(depth + 1));
                text += " " + space();
            }
            text += "]";
            return tree;
        }
        if (kind < 7 && !pathsBefore_.empty()) {
            auto path = pathsBefore_.begin();
            std::advance(path, random_.between(0, static_cast<int>(pathsBefore_.size()) - 1));
            const Tree tree = partAt(before_, *path);
            if (depth + levelsOf(tree) <= maxLevels_) {
                text += "<" + *path;
                return tree;
            }
        }
        const int value = random_.chance(0.4) ? 0 : random_.between(1, 255);
        text += std::to_string(value);
        return {value, {}};
    }

    Tree writeTurned(int depth) {
        static const char* const kTurns[] = {"/x",  "/y",  "/z",   "/xz",  "/yxz", "^xy",
                                             "^zy", "^xz", "^xyz", "^zyx", "^y",   "^x"};
        const std::string turn = kTurns[random_.between(0, 11)];
        text += turn + space();
        const Tree tree = writeCube(depth);
        const auto bitOf = [](char axis) { return axis == 'x' ? 4u : axis == 'y' ? 2u : 1u; };
        const std::string axes = turn.substr(1);
        if (turn[0] == '/' || axes.size() == 1) {
            unsigned mask = 0;
            for (const char axis : axes) mask |= bitOf(axis);
            return moved(
                tree, [mask](unsigned i) { return i ^ mask; }, turn[0] == '/');
        }
        return moved(
            tree,
            [&](unsigned i) {
                unsigned to = 0;
                for (unsigned bit = 1; bit < 8; bit <<= 1) {
                    std::size_t at = axes.size();
                    for (std::size_t k = 0; k < axes.size(); ++k)
                        if (bitOf(axes[k]) == bit) at = k;
                    const unsigned target =
                        at == axes.size() ? bit : bitOf(axes[(at + 1) % axes.size()]);
                    if ((i & bit) != 0) to |= target;
                }
                return to;
            },
            true);
    }

    test::Random random_;
    int maxLevels_ = 3;
    Tree now_, before_;
    std::set<std::string> paths_, pathsBefore_;
    int levels_ = 0;
};

TEST(CsmRead, RandomTextsMeanWhatAPlainInterpreterSays) {
    int solid = 0;
    for (std::uint64_t seed = 0; seed < 600; ++seed) {
        RandomText random(seed);
        random.write(1 + static_cast<int>(seed % 4));
        const Result<Octree> octree = octreeFromCsm(bytesOf(random.text));
        ASSERT_TRUE(octree) << octree.error().describe() << "\n" << random.text;
        EXPECT_TRUE(validateCanonical(*octree)) << random.text;
        EXPECT_EQ(octree->size, glm::ivec3(random.edge)) << random.text;
        ASSERT_EQ(voxelsOf(random.text), random.voxels) << seed << "\n" << random.text;
        solid += random.voxels.empty() ? 0 : 1;
    }
    EXPECT_GT(solid, 400);
}

}  // namespace
}  // namespace voxprite
