// An array that grows at its end, of numbers that are written before they are read: room for many
// is asked for once, filled through a pointer, and then counted.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>

namespace voxprite {

template <class T>
class GrowingArray {
    static_assert(std::is_trivially_copyable_v<T>);

  public:
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] const T* begin() const { return values_.get(); }
    [[nodiscard]] const T* end() const { return values_.get() + size_; }
    [[nodiscard]] const T& operator[](std::size_t index) const { return values_[index]; }

    // Where the next `count` elements go, nothing in them yet; valid until the next call.
    [[nodiscard]] T* room(std::size_t count) {
        if (capacity_ - size_ < count) grow(std::max(size_ + count, 2 * capacity_));
        return values_.get() + size_;
    }
    // The first `count` of the room have been filled.
    void add(std::size_t count) { size_ += count; }
    void push_back(T value) {
        *room(1) = value;
        add(1);
    }
    void shrink(std::size_t size) { size_ = size; }

  private:
    void grow(std::size_t capacity) {
        auto values = std::make_unique_for_overwrite<T[]>(capacity);
        std::copy(begin(), end(), values.get());
        values_ = std::move(values);
        capacity_ = capacity;
    }

    std::unique_ptr<T[]> values_;
    std::size_t size_ = 0;
    std::size_t capacity_ = 0;
};

}  // namespace voxprite
