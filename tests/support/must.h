#pragma once

#include <stdexcept>
#include <utility>

#include "core/base/result.h"

namespace voxprite::test {

// The value, or a failed test and an exception that ends it.
template <class T>
[[nodiscard]] T must(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().describe());
    return std::move(*result);
}

}  // namespace voxprite::test
