// Against OpenVDB itself, which writes what is read here and reads what is written.
#include "core/io/vdb.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/LevelSetSphere.h>

#include <sstream>

#include "core/io/formats.h"
#include "core/model/entity_voxels.h"
#include "tests/support/must.h"
#include "tests/support/random.h"
#include "tests/support/voxels.h"

namespace voxprite {
namespace {

using test::must;
using testing::Contains;
using testing::HasSubstr;

Bytes fileOf(const openvdb::GridCPtrVec& grids, std::uint32_t packing, const char* palette = "") {
    openvdb::initialize();
    std::ostringstream stream(std::ios::binary);
    openvdb::MetaMap metadata;
    metadata.insertMeta("creator", openvdb::StringMetadata(std::string("a test") + palette));
    openvdb::io::Stream out(stream);
    out.setCompression(packing);
    out.write(grids, metadata);
    const std::string text = stream.str();
    return {text.begin(), text.end()};
}

constexpr std::uint32_t kPackings[] = {
    openvdb::io::COMPRESS_NONE, openvdb::io::COMPRESS_ZIP, openvdb::io::COMPRESS_ACTIVE_MASK,
    openvdb::io::COMPRESS_ZIP | openvdb::io::COMPRESS_ACTIVE_MASK,
    openvdb::io::COMPRESS_BLOSC | openvdb::io::COMPRESS_ACTIVE_MASK};

template <class GridType>
typename GridType::Ptr named(const char* name, typename GridType::ValueType background = {}) {
    typename GridType::Ptr grid = GridType::create(background);
    grid->setName(name);
    return grid;
}

test::VoxelMap seen(const Document& document) {
    return test::mapOf(flatten(document, 0));
}

TEST(Vdb, IndexGridsAreObjectsHoweverTheyArePacked) {
    for (const std::uint32_t packing : kPackings) {
        const auto letter = named<openvdb::Int32Grid>("letter");
        test::VoxelMap expected;
        auto accessor = letter->getAccessor();
        test::asymmetric().forEachSolid([&](glm::ivec3 v, std::uint8_t value) {
            accessor.setValueOn({v.x - 100, v.y, v.z + 5000}, value);
            expected[{v.x - 100, v.y, v.z + 5000}] = value;
        });
        accessor.setValueOff({0, 0, 0}, 9);  // not active: no voxel
        const auto small = named<openvdb::Int64Grid>("small");
        small->tree().setValueOn({7, 8, 9}, 200);
        expected[{7, 8, 9}] = 200;
        const VdbImport import = must(readVdb(fileOf({letter, small}, packing)));
        EXPECT_TRUE(import.warnings.empty());
        EXPECT_EQ(seen(import.document), expected) << packing;
        ASSERT_EQ(import.document.nodes.size(), 3u);
        EXPECT_EQ(import.document.nodes[1].name, "letter");
    }
}

TEST(Vdb, OtherNumbersAreCounted) {
    const auto grid = named<openvdb::Int32Grid>("ids");
    grid->tree().setValueOn({0, 0, 0}, 1000);
    grid->tree().setValueOn({1, 0, 0}, -5);
    grid->tree().setValueOn({2, 0, 0}, 300);
    const VdbImport import = must(readVdb(fileOf({grid}, 0)));
    EXPECT_THAT(import.warnings, Contains(HasSubstr("numbered anew")));
    EXPECT_EQ(seen(import.document),
              (test::VoxelMap{{{0, 0, 0}, 3}, {{1, 0, 0}, 1}, {{2, 0, 0}, 2}}));
}

TEST(Vdb, MasksAreShapes) {
    for (const std::uint32_t packing : kPackings) {
        const auto flags = named<openvdb::BoolGrid>("flags");
        flags->tree().setValueOn({1, 2, 3}, true);
        flags->tree().setValueOn({1, 2, 4}, false);
        const auto mask = named<openvdb::MaskGrid>("mask");
        mask->tree().setValueOn({-9, 0, 0});
        EXPECT_EQ(seen(must(readVdb(fileOf({flags, mask}, packing))).document),
                  (test::VoxelMap{{{1, 2, 3}, 1}, {{-9, 0, 0}, 1}}));
    }
}

TEST(Vdb, DensityAboveAThreshold) {
    for (const bool half : {false, true}) {
        for (const std::uint32_t packing : kPackings) {
            const auto density = named<openvdb::FloatGrid>("density");
            density->setSaveFloatAsHalf(half);
            density->tree().setValueOn({0, 0, 0}, 0.25f);
            density->tree().setValueOn({1, 0, 0}, 0.75f);
            const auto heat = named<openvdb::FloatGrid>("heat");
            heat->tree().setValueOn({5, 5, 5}, 9.0f);
            const Bytes file = fileOf({heat, density}, packing);
            const VdbImport import = must(readVdb(file));
            EXPECT_EQ(seen(import.document), (test::VoxelMap{{{1, 0, 0}, 1}}));
            EXPECT_THAT(import.warnings, Contains(HasSubstr("above 0.5 is inside")));
            EXPECT_THAT(import.warnings, Contains(HasSubstr("passed over: \"heat\"")));
            EXPECT_EQ(seen(must(readVdb(file, {.grid = "", .threshold = 0.1})).document).size(),
                      2u);
            EXPECT_EQ(seen(must(readVdb(file, {.grid = "heat"})).document),
                      (test::VoxelMap{{{5, 5, 5}, 1}}));
            EXPECT_FALSE(readVdb(file, {.grid = "none"}));
        }
    }
}

TEST(Vdb, LevelSetsAreFilledToTheirMiddle) {
    openvdb::initialize();
    const auto ball = openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(
        20.0f, openvdb::Vec3f(3, 4, 5), 1.0f);
    ball->setName("ball");
    const VdbImport import = must(
        readVdb(fileOf({ball}, openvdb::io::COMPRESS_ACTIVE_MASK | openvdb::io::COMPRESS_BLOSC)));
    EXPECT_THAT(import.warnings, Contains(HasSubstr("level set")));
    std::uint64_t expected = 0;
    for (int x = -20; x <= 20; ++x) {
        for (int y = -20; y <= 20; ++y) {
            for (int z = -20; z <= 20; ++z) expected += x * x + y * y + z * z < 400 ? 1 : 0;
        }
    }
    EXPECT_EQ(import.document.models[0].voxels.solidCount(), expected);
}

TEST(Vdb, ColoursBesideAShape) {
    const auto density = named<openvdb::FloatGrid>("density");
    density->fill({{0, 0, 0}, {15, 7, 7}}, 1.0f);
    const auto colours = named<openvdb::Vec3SGrid>("Cd");
    colours->fill({{0, 0, 0}, {7, 7, 7}}, openvdb::Vec3s(1.0f, 0.0f, 0.0f));
    colours->tree().setValueOn({8, 0, 0}, openvdb::Vec3s(0.0f, 0.2f, 1.0f));
    for (const std::uint32_t packing : kPackings) {
        const Document document = must(readVdb(fileOf({density, colours}, packing))).document;
        const auto colourAt = [&](glm::ivec3 v) {
            return document.palette.colours[EntitySampler(document, 0).at(v)];
        };
        EXPECT_EQ(colourAt({3, 3, 3}), Rgba8(255, 0, 0, 255));
        EXPECT_EQ(colourAt({8, 0, 0}), Rgba8(0, 51, 255, 255));
        EXPECT_EQ(colourAt({9, 0, 0}), Rgba8(0, 0, 0, 255));
        EXPECT_EQ(document.models[0].voxels.solidCount(), 1024u);
    }
}

TEST(Vdb, HugeCubesStayCubes) {
    const auto grid = named<openvdb::Int32Grid>("block");
    grid->sparseFill({{0, 0, 0}, {4095, 4095, 4095}}, 7, true);
    const Document document = must(readVdb(fileOf({grid}, 0))).document;
    EXPECT_EQ(document.models[0].voxels.solidCount(), std::uint64_t{1} << 36);
    EXPECT_LT(document.models[0].voxels.bytes(), std::size_t{64} << 20);
}

// Cubes of one colour are not gone through voxel by voxel.
TEST(Vdb, HugeCubesHaveColours) {
    const auto colours = named<openvdb::Vec3SGrid>("Cd");
    colours->sparseFill({{0, 0, 0}, {4095, 4095, 4095}}, openvdb::Vec3s(1.0f, 0.0f, 0.0f), true);
    const auto density = named<openvdb::FloatGrid>("density");
    density->sparseFill({{0, 0, 0}, {4095, 4095, 4095}}, 1.0f, true);
    for (const auto& file : {fileOf({colours}, 0), fileOf({density, colours}, 0)}) {
        const Document document = must(readVdb(file)).document;
        EXPECT_EQ(document.models[0].voxels.solidCount(), std::uint64_t{1} << 36);
        EXPECT_EQ(document.palette.colours[EntitySampler(document, 0).at({9, 9, 9})],
                  Rgba8(255, 0, 0, 255));
    }
    const auto spot = named<openvdb::Vec3SGrid>("Cd");
    spot->tree().setValueOn({5, 5, 5}, openvdb::Vec3s(1.0f, 0.0f, 0.0f));
    const Document document = must(readVdb(fileOf({density, spot}, 0))).document;
    const auto colourAt = [&](glm::ivec3 v) {
        return document.palette.colours[EntitySampler(document, 0).at(v)];
    };
    EXPECT_EQ(document.models[0].voxels.solidCount(), std::uint64_t{1} << 36);
    EXPECT_EQ(colourAt({5, 5, 5}), Rgba8(255, 0, 0, 255));
    EXPECT_EQ(colourAt({5, 5, 6}), Rgba8(0, 0, 0, 255));
    EXPECT_EQ(colourAt({4000, 9, 9}), Rgba8(0, 0, 0, 255));
}

// A voxel beside them moves the middle off their corners.
TEST(Vdb, HugeCubesStayCubesWhateverLiesBesideThem) {
    const auto grid = named<openvdb::Int32Grid>("blocks");
    for (const int at : {0, 8192, 16384}) {
        grid->sparseFill({{at, 0, 0}, {at + 4095, 4095, 4095}}, 7, true);
    }
    grid->tree().setValueOn({-1, -1, -1}, 7);
    const Document document = must(readVdb(fileOf({grid}, 0))).document;
    EXPECT_LT(document.models[0].voxels.bytes(), std::size_t{64} << 20);
    EXPECT_EQ(document.models[0].voxels.solidCount(), (std::uint64_t{3} << 36) + 1);
    EXPECT_EQ(EntitySampler(document, 0).at({-1, -1, -1}), 7);
    EXPECT_EQ(EntitySampler(document, 0).at({-1, 0, 0}), 0);
}

TEST(Vdb, WhatIsWrittenOpenVdbReads) {
    const Document busy = test::busyDocument();
    const Bytes bytes = must(writeVdb(busy, busy.authored));
    std::istringstream stream(std::string(bytes.begin(), bytes.end()), std::ios::binary);
    openvdb::io::Stream in(stream, false);
    const auto grids = in.getGrids();
    test::VoxelMap found;
    std::size_t k = 0;
    for (const Instance& instance : instancesOf(busy, 0)) {
        const auto grid = openvdb::gridPtrCast<openvdb::Int32Grid>(grids->at(k++));
        EXPECT_EQ(grid->getName(), busy.nodes[static_cast<std::size_t>(instance.node)].name);
        EXPECT_DOUBLE_EQ(grid->voxelSize().x(), busy.authored.voxelSizeMetres);
        for (auto it = grid->cbeginValueOn(); it; ++it) {
            const openvdb::Coord c = it.getCoord();
            found[{c.x(), c.y(), c.z()}] = static_cast<std::uint8_t>(it.getValue());
        }
    }
    EXPECT_EQ(k, grids->size());
    EXPECT_EQ(found, seen(busy));
    EXPECT_EQ(must(writeVdb(busy, busy.authored)), bytes);
}

TEST(Vdb, ReadsBackEqual) {
    Document document = must(readVdb(must(writeVdb(test::busyDocument(), {0.25, 7.5})))).document;
    EXPECT_EQ(seen(document), seen(test::busyDocument()));
    EXPECT_EQ(document.palette, test::busyDocument().palette);
    EXPECT_EQ(document.entity, test::busyDocument().entity);
    EXPECT_EQ(document.authored, (AuthoredValues{0.25, 7.5}));
    EXPECT_EQ(must(readVdb(must(writeVdb(document, document.authored)))).document, document);
}

// Nodes of 4 an edge: a file of a few hundred bytes, so that every byte can be gone through.
template <class Value>
using Small = openvdb::Grid<typename openvdb::tree::Tree4<Value, 2, 2, 2>::Type>;

Bytes wholeFile(std::uint32_t packing) {
    const auto density = named<Small<float>>("density");
    density->tree().setValueOn({0, 0, 0}, 0.75f);
    density->tree().setValueOn({300, 0, 0}, 0.25f);
    const auto colours = named<Small<openvdb::Vec3s>>("Cd");
    colours->tree().setValueOn({0, 0, 0}, openvdb::Vec3s(1.0f, 0.5f, 0.0f));
    return fileOf({density, colours}, packing);
}

TEST(VdbDamage, EveryTruncationIsRefused) {
    for (const std::uint32_t packing : {kPackings[3], kPackings[4]}) {
        const Bytes whole = wholeFile(packing);
        ASSERT_TRUE(readVdb(whole));
        for (std::size_t length = 0; length < whole.size(); ++length) {
            EXPECT_FALSE(readVdb(ByteView(whole).first(length))) << length;
        }
    }
}

TEST(VdbDamage, EveryFlippedByteEndsInAnErrorOrADocument) {
    for (const std::uint32_t packing : {kPackings[3], kPackings[4]}) {
        const Bytes whole = wholeFile(packing);
        for (std::size_t at = 0; at < whole.size(); ++at) {
            for (const int mask : {0x01, 0x80, 0xFF}) {
                Bytes flipped = whole;
                flipped[at] = static_cast<std::uint8_t>(flipped[at] ^ mask);
                const auto read = readVdb(flipped);
                EXPECT_TRUE(!read || validate(read->document)) << at;
            }
        }
    }
}

}  // namespace
}  // namespace voxprite
