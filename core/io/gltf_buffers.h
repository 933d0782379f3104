// The bytes of a glTF file: its container, its buffers, and numbers in them. Private to core/io:
// fields that are wrong throw JsonFieldError (json_value.h).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/io/json_value.h"
#include "core/io/model_folder.h"

namespace voxprite {

// A .glb is a header and chunks; a .gltf is its JSON alone.
struct GltfContainer {
    std::string_view json;
    std::optional<ByteView> binary;
};
[[nodiscard]] Result<GltfContainer> gltfContainer(ByteView file);

// Numbers in a buffer: `count` elements of `components` each, all within the buffer. Of an accessor
// without a buffer view all are 0, and `count` is bounded by nothing.
class GltfAccessor {
  public:
    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] int components() const { return components_; }
    // Integers become 0 ... 1 or -1 ... 1 where the file says that they are normalised.
    [[nodiscard]] double number(std::size_t element, int component) const;
    // Of an accessor of unsigned integers.
    [[nodiscard]] std::uint32_t index(std::size_t element) const;
    [[nodiscard]] bool holdsIndices() const;

  private:
    friend class GltfBuffers;
    const std::uint8_t* data_ = nullptr;
    std::size_t count_ = 0;
    std::size_t stride_ = 0;
    int components_ = 1;
    int type_ = 0;  // componentType of the file
    bool normalized_ = false;
};

class GltfBuffers {
  public:
    // `root` is the file's JSON object; all must outlive this.
    GltfBuffers(JsonObject& root, std::optional<ByteView> binary, const ModelFolder& folder);

    // `reference` holds the index of an accessor.
    [[nodiscard]] GltfAccessor accessor(const JsonValue& reference);
    // `reference` holds the index of a buffer view.
    [[nodiscard]] ByteView view(const JsonValue& reference);

  private:
    struct Buffer {
        bool loaded = false;
        Bytes owned;
        ByteView bytes;
    };
    [[nodiscard]] ByteView buffer(const JsonValue& reference);

    std::optional<ByteView> binary_;
    const ModelFolder& folder_;
    std::vector<JsonValue> bufferJson_, viewJson_, accessorJson_;
    std::vector<Buffer> buffers_;
    std::uint64_t loadedBytes_ = 0;
};

// The bytes of a URI: "data:...;base64,..." or another file of the model's folder.
[[nodiscard]] Result<Bytes> bytesOfUri(const std::string& uri, const ModelFolder& folder);

// The other files that the URIs of its buffers and images name, relative to its folder. None where
// the file cannot be read.
[[nodiscard]] std::vector<std::filesystem::path> gltfRefersTo(const std::filesystem::path& path);

}  // namespace voxprite
