// Move-only owners of GL objects. Each deletes what it holds; a default one holds nothing.
#pragma once

#include <cstdint>
#include <utility>

namespace voxprite::gl {

template <void (*Delete)(std::uint32_t)>
class Handle {
  public:
    Handle() = default;
    explicit Handle(std::uint32_t id) : id_(id) {}
    ~Handle() { reset(); }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        if (this != &other) {
            reset();
            id_ = std::exchange(other.id_, 0);
        }
        return *this;
    }
    [[nodiscard]] std::uint32_t id() const { return id_; }
    explicit operator bool() const { return id_ != 0; }
    void reset() {
        if (id_ != 0) Delete(std::exchange(id_, 0));
    }

  private:
    std::uint32_t id_ = 0;
};

void deleteTexture(std::uint32_t id);
void deleteBuffer(std::uint32_t id);
void deleteFramebuffer(std::uint32_t id);
void deleteVertexArray(std::uint32_t id);
void deleteProgram(std::uint32_t id);
void deleteQuery(std::uint32_t id);

using Texture = Handle<deleteTexture>;
using Buffer = Handle<deleteBuffer>;
using Framebuffer = Handle<deleteFramebuffer>;
using VertexArray = Handle<deleteVertexArray>;
using Program = Handle<deleteProgram>;
using Query = Handle<deleteQuery>;

[[nodiscard]] Texture createTexture2d();
[[nodiscard]] Texture createTexture2dArray();
// The texels of an immutable 2D texture of one level, as another format of the same size.
[[nodiscard]] Texture createTextureView(const Texture& texture, std::uint32_t format);
[[nodiscard]] Buffer createBuffer();
[[nodiscard]] Framebuffer createFramebuffer();
[[nodiscard]] VertexArray createVertexArray();
[[nodiscard]] Query createTimeQuery();

}  // namespace voxprite::gl
