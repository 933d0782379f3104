// Puts .qb files together number by number, right or wrong, without any code of the reader or
// writer.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/bytes.h"

namespace voxprite::test {

struct QbOptions {
    std::uint32_t version = 0x0101;
    std::uint32_t blueFirst = 0;
    std::uint32_t rightHanded = 0;
    std::uint32_t runs = 0;
    std::uint32_t mask = 0;
};

class QbBuilder {
  public:
    explicit QbBuilder(QbOptions options = {}) : options_(options) {}

    // `numbers` are what follows the position: colours, runs and ends of slices as they stand.
    QbBuilder& matrix(const std::string& name, std::array<std::uint32_t, 3> size,
                      std::array<std::int32_t, 3> position,
                      const std::vector<std::uint32_t>& numbers);
    [[nodiscard]] Bytes bytes() const;
    // With another count in the header.
    [[nodiscard]] Bytes bytes(std::uint32_t matrices) const;

  private:
    QbOptions options_;
    Bytes matrices_;
    std::uint32_t count_ = 0;
};

// A colour as red-first files have it.
[[nodiscard]] constexpr std::uint32_t rgba(std::uint32_t r, std::uint32_t g, std::uint32_t b,
                                           std::uint32_t a = 255) {
    return r | g << 8 | b << 16 | a << 24;
}

}  // namespace voxprite::test
