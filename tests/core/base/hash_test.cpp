#include "core/base/hash.h"

#include <gtest/gtest.h>

#include <string_view>

namespace voxprite {
namespace {

Bytes bytesOf(std::string_view text) {
    return {text.begin(), text.end()};
}

// Known answers of FIPS 180-4.
TEST(Hash, Sha256KnownAnswers) {
    EXPECT_EQ(sha256Hex({}), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256Hex(bytesOf("abc")),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256Hex(Bytes(1'000'000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

// The check value of the polynomial's catalogue entry (CRC-32/ISO-HDLC).
TEST(Hash, Crc32KnownAnswers) {
    EXPECT_EQ(crc32({}), 0u);
    EXPECT_EQ(crc32(bytesOf("123456789")), 0xCBF4'3926u);
}

TEST(Hash, AsBytesSeesTheWholeVector) {
    const std::vector<std::uint32_t> words{0x0403'0201, 0x0807'0605};
    const ByteView view = asBytes(words);
    EXPECT_EQ(Bytes(view.begin(), view.end()), (Bytes{1, 2, 3, 4, 5, 6, 7, 8}));
}

}  // namespace
}  // namespace voxprite
