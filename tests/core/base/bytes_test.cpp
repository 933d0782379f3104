#include "core/base/bytes.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace voxprite {
namespace {

Bytes oneOfEach() {
    ByteWriter writer;
    writer.u8(0xAB);
    writer.u16(0x1234);
    writer.u32(0xDEAD'BEEF);
    writer.u64(0x0123'4567'89AB'CDEF);
    writer.i32(-2);
    writer.f64(-0.1);
    writer.string32(std::string_view("a\0b", 3));
    return writer.release();
}

TEST(Bytes, WritesLittleEndian) {
    ByteWriter writer;
    writer.u16(0x1234);
    writer.u32(0xDEAD'BEEF);
    writer.i32(-2);
    EXPECT_EQ(writer.bytes(), (Bytes{0x34, 0x12, 0xEF, 0xBE, 0xAD, 0xDE, 0xFE, 0xFF, 0xFF, 0xFF}));
    ByteWriter number;
    number.f64(1.0);
    EXPECT_EQ(number.bytes(), (Bytes{0, 0, 0, 0, 0, 0, 0xF0, 0x3F}));
}

TEST(Bytes, ReadsBackWhatWasWritten) {
    const Bytes bytes = oneOfEach();
    ByteReader reader(bytes);
    EXPECT_EQ(reader.u8("a").value(), 0xAB);
    EXPECT_EQ(reader.u16("b").value(), 0x1234);
    EXPECT_EQ(reader.u32("c").value(), 0xDEAD'BEEF);
    EXPECT_EQ(reader.u64("d").value(), 0x0123'4567'89AB'CDEFu);
    EXPECT_EQ(reader.i32("e").value(), -2);
    EXPECT_EQ(reader.f64("f").value(), -0.1);
    EXPECT_EQ(reader.string32("g").value(), std::string("a\0b", 3));
    EXPECT_TRUE(reader.atEnd());
}

TEST(Bytes, KeepsEveryBitOfADouble) {
    const double values[] = {-0.0, std::numeric_limits<double>::denorm_min(),
                             std::numeric_limits<double>::infinity(), std::nan("7")};
    for (const double value : values) {
        ByteWriter writer;
        writer.f64(value);
        const double back = ByteReader(writer.bytes()).f64("x").value();
        EXPECT_EQ(std::bit_cast<std::uint64_t>(back), std::bit_cast<std::uint64_t>(value));
    }
}

// Reads the fields of oneOfEach() until one fails.
Result<ByteView> readAllFields(ByteReader& reader) {
    if (auto r = reader.u8("a"); !r) return Failure(r.error());
    if (auto r = reader.u16("b"); !r) return Failure(r.error());
    if (auto r = reader.u32("c"); !r) return Failure(r.error());
    if (auto r = reader.u64("d"); !r) return Failure(r.error());
    if (auto r = reader.i32("e"); !r) return Failure(r.error());
    if (auto r = reader.f64("f"); !r) return Failure(r.error());
    if (auto r = reader.string32("g"); !r) return Failure(r.error());
    return ByteView();
}

TEST(Bytes, RefusesEveryTruncation) {
    const Bytes whole = oneOfEach();
    for (std::size_t length = 0; length < whole.size(); ++length) {
        // A buffer of exactly this length, so that a sanitizer sees any step beyond it.
        const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
        ByteReader reader(cut, 1000);
        const auto read = readAllFields(reader);
        ASSERT_FALSE(read) << length;
        EXPECT_EQ(read.error().message.rfind("the file ends inside ", 0), 0u);
        EXPECT_EQ(read.error().offset.has_value(), true);
    }
}

TEST(Bytes, AFailedReadStaysWhereItWas) {
    const Bytes bytes{5, 0, 0, 0, 'x'};
    ByteReader reader(bytes, 40);
    const auto name = reader.string32("the name");
    ASSERT_FALSE(name);
    EXPECT_EQ(name.error().describe(), "byte 44: the file ends inside the name");
    EXPECT_EQ(reader.offset(), 40u);
    EXPECT_EQ(reader.u32("the length").value(), 5u);
    EXPECT_FALSE(reader.take(std::numeric_limits<std::uint64_t>::max(), "everything"));
    EXPECT_EQ(reader.remaining(), 1u);
}

TEST(Bytes, ASubReaderKnowsItsPlaceInTheFile) {
    const Bytes bytes{1, 2, 3, 4, 5, 6};
    ByteReader reader(bytes);
    ASSERT_TRUE(reader.u16("head"));
    Result<ByteReader> part = reader.sub(3, "part");
    ASSERT_TRUE(part);
    EXPECT_EQ(part->offset(), 2u);
    EXPECT_EQ(part->remaining(), 3u);
    EXPECT_EQ(part->u8("x").value(), 3);
    EXPECT_EQ(part->u32("y").error().offset, 3u);
    EXPECT_EQ(reader.offset(), 5u);
    EXPECT_FALSE(reader.sub(2, "too much"));
}

TEST(Bytes, AlignsAndPatches) {
    ByteWriter writer;
    writer.alignTo(16);
    EXPECT_EQ(writer.size(), 0u);
    writer.u32(0);
    writer.raw(std::string_view("ab"));
    writer.alignTo(8);
    EXPECT_EQ(writer.size(), 8u);
    writer.alignTo(8);
    EXPECT_EQ(writer.size(), 8u);
    writer.patchU32(0, 0x0403'0201);
    EXPECT_EQ(writer.bytes(), (Bytes{1, 2, 3, 4, 'a', 'b', 0, 0}));
}

}  // namespace
}  // namespace voxprite
