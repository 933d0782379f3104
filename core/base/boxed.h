// A value kept on the heap that still copies and compares as a value: for large members of small
// types.
#pragma once

#include <memory>
#include <utility>

namespace voxprite {

template <class T>
class Boxed {
  public:
    Boxed() : value_(std::make_unique<T>()) {}
    // Implicit, so that a T can stand where a Boxed<T> is wanted.
    Boxed(T value) : value_(std::make_unique<T>(std::move(value))) {}
    ~Boxed() = default;
    Boxed(const Boxed& other) : value_(std::make_unique<T>(*other)) {}
    Boxed(Boxed&&) noexcept = default;  // what was moved from may only be assigned or destroyed
    Boxed& operator=(const Boxed& other) {
        if (this != &other) value_ = std::make_unique<T>(*other);
        return *this;
    }
    Boxed& operator=(Boxed&&) noexcept = default;

    [[nodiscard]] T& operator*() { return *value_; }
    [[nodiscard]] const T& operator*() const { return *value_; }
    [[nodiscard]] T* operator->() { return value_.get(); }
    [[nodiscard]] const T* operator->() const { return value_.get(); }
    bool operator==(const Boxed& other) const { return *value_ == *other.value_; }

  private:
    std::unique_ptr<T> value_;
};

}  // namespace voxprite
