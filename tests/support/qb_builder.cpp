#include "tests/support/qb_builder.h"

#include "tests/support/vox_builder.h"

namespace voxprite::test {

QbBuilder& QbBuilder::matrix(const std::string& name, std::array<std::uint32_t, 3> size,
                             std::array<std::int32_t, 3> position,
                             const std::vector<std::uint32_t>& numbers) {
    matrices_.push_back(static_cast<std::uint8_t>(name.size()));
    matrices_.insert(matrices_.end(), name.begin(), name.end());
    for (const std::uint32_t edge : size) put32(matrices_, edge);
    for (const std::int32_t coordinate : position) put32(matrices_, coordinate);
    for (const std::uint32_t number : numbers) put32(matrices_, number);
    ++count_;
    return *this;
}

Bytes QbBuilder::bytes(std::uint32_t matrices) const {
    Bytes file;
    for (const std::uint32_t number : {options_.version, options_.blueFirst, options_.rightHanded,
                                       options_.runs, options_.mask, matrices}) {
        put32(file, number);
    }
    file.insert(file.end(), matrices_.begin(), matrices_.end());
    return file;
}

Bytes QbBuilder::bytes() const {
    return bytes(count_);
}

}  // namespace voxprite::test
