// Compiled shader programs, and the typed blocks of uniforms that they read.
//
// Every uniform lives in a std140 block that a C++ struct mirrors; textures have fixed units
// (layout(binding)). So nothing is looked up by name.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "render/gl/handles.h"

namespace voxprite::gl {

// Compiles and links shaders/<vertex> and shaders/<fragment>. An error names the shader file and
// the line.
[[nodiscard]] Result<Program> compileProgram(const std::string& vertex, const std::string& fragment,
                                             const std::vector<std::string>& defines = {});

// A program of one compute shader.
[[nodiscard]] Result<Program> compileCompute(const std::string& name,
                                             const std::vector<std::string>& defines = {});

void useProgram(const Program& program);

// A uniform block on the GPU that mirrors `Block` (std140, sizes checked beside each struct).
class UniformBuffer {
  public:
    UniformBuffer() = default;
    // Allocates on first use; call with a current context.
    template <class Binding, class Block>
    void set(Binding binding, const Block& block) {
        static_assert(sizeof(Block) % 16 == 0, "std140 blocks are multiples of 16 bytes");
        upload(static_cast<std::uint32_t>(binding), &block, sizeof(Block));
    }

  private:
    void upload(std::uint32_t binding, const void* data, std::size_t bytes);
    Buffer buffer_;
};

// An array of structs on the GPU that mirrors `Item` (std430, sizes checked beside each struct).
class StorageBuffer {
  public:
    template <class Binding, class Item>
    void set(Binding binding, std::span<const Item> items) {
        static_assert(sizeof(Item) % 16 == 0, "structs that hold vec4 are multiples of 16 bytes");
        upload(static_cast<std::uint32_t>(binding), items.data(), items.size_bytes());
    }
    // What was set last, again.
    template <class Binding>
    void bind(Binding binding) const {
        bindTo(static_cast<std::uint32_t>(binding));
    }

  private:
    void upload(std::uint32_t binding, const void* data, std::size_t bytes);
    void bindTo(std::uint32_t binding) const;
    Buffer buffer_;
};

}  // namespace voxprite::gl
