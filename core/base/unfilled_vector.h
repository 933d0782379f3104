// A std::vector whose constructor and resize() leave new elements unset instead of writing zeros:
// for arrays that are filled afterwards, by several threads or while their memory is in the cache.
// Reading an element before it is written is undefined.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace voxprite {

template <class T>
struct UnfilledAllocator : std::allocator<T> {
    static_assert(std::is_trivially_copyable_v<T>);

    template <class U>
    struct rebind {
        using other = UnfilledAllocator<U>;
    };

    UnfilledAllocator() = default;
    template <class U>
    explicit(false) UnfilledAllocator(const UnfilledAllocator<U>& /*other*/) noexcept {}

    template <class U>
    void construct(U* at) noexcept {
        ::new (static_cast<void*>(at)) U;
    }
    template <class U, class... Arguments>
    void construct(U* at, Arguments&&... arguments) {
        std::construct_at(at, std::forward<Arguments>(arguments)...);
    }
};

template <class T>
using UnfilledVector = std::vector<T, UnfilledAllocator<T>>;

}  // namespace voxprite
