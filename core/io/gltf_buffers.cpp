#include "core/io/gltf_buffers.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "core/base/file.h"
#include "core/io/gltf_numbers.h"

namespace voxprite {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67;   // "glTF"
constexpr std::uint32_t kJson = 0x4E4F534A;    // "JSON"
constexpr std::uint32_t kBinary = 0x004E4942;  // "BIN"

int bytesOf(int type) {
    switch (type) {
        case gltf::kByte:
        case gltf::kUByte:
            return 1;
        case gltf::kShort:
        case gltf::kUShort:
            return 2;
        case gltf::kUInt:
        case gltf::kFloat:
            return 4;
        default:
            return 0;
    }
}

int componentsOf(const std::string& type) {
    if (type == "SCALAR") return 1;
    if (type == "VEC2") return 2;
    if (type == "VEC3") return 3;
    if (type == "VEC4") return 4;
    if (type == "MAT4") return 16;
    return 0;
}

template <class T>
T loaded(const std::uint8_t* from) {
    T value;
    std::memcpy(&value, from, sizeof(T));
    return value;
}

template <class T>
double integerAt(const std::uint8_t* from, bool normalized) {
    const auto value = static_cast<double>(loaded<T>(from));
    if (!normalized) return value;
    return std::max(-1.0, value / static_cast<double>(std::numeric_limits<T>::max()));
}

std::size_t elementIn(const std::vector<JsonValue>& list, const JsonValue& reference,
                      const char* what) {
    if (list.empty()) reference.fail(std::string("the file has no ") + what);
    return static_cast<std::size_t>(reference.integer(0, static_cast<int>(list.size()) - 1));
}

std::optional<Bytes> base64(std::string_view text) {
    Bytes bytes;
    bytes.reserve(text.size() / 4 * 3);
    while (!text.empty() && text.back() == '=') text.remove_suffix(1);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const int value = c >= 'A' && c <= 'Z'   ? c - 'A'
                          : c >= 'a' && c <= 'z' ? c - 'a' + 26
                          : c >= '0' && c <= '9' ? c - '0' + 52
                          : c == '+' || c == '-' ? 62
                          : c == '/' || c == '_' ? 63
                                                 : -1;
        if (value < 0) return std::nullopt;
        bits = bits << 6 | static_cast<std::uint32_t>(value);
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes.push_back(static_cast<std::uint8_t>(bits >> count));
    }
    return bytes;
}

std::optional<int> hexDigit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return std::nullopt;
}

// RFC 3986: "%20" is a space.
std::string withoutPercents(std::string_view uri) {
    std::string text;
    for (std::size_t k = 0; k < uri.size(); ++k) {
        if (uri[k] == '%' && k + 2 < uri.size()) {
            const auto high = hexDigit(uri[k + 1]), low = hexDigit(uri[k + 2]);
            if (high && low) {
                text += static_cast<char>(*high * 16 + *low);
                k += 2;
                continue;
            }
        }
        text += uri[k];
    }
    return text;
}

}  // namespace

Result<GltfContainer> gltfContainer(ByteView file) {
    if (file.empty()) return failAtByte(0, "the file is empty");
    ByteReader reader(file);
    const auto text = [](ByteView bytes) {
        return std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    };
    if (file.size() < 4 || loaded<std::uint32_t>(file.data()) != kMagic) {
        return GltfContainer{.json = text(file), .binary = std::nullopt};
    }
    static_cast<void>(reader.u32("the magic number"));
    const auto version = reader.u32("the version");
    if (!version) return Failure(version.error());
    if (*version != 2) {
        return failAtByte(4, "glTF " + std::to_string(*version) + " is not read; version 2 is");
    }
    const auto length = reader.u32("the length");
    if (!length) return Failure(length.error());
    if (*length > file.size()) {
        return failAtByte(8, "the file should have " + std::to_string(*length) + " bytes and has " +
                                 std::to_string(file.size()));
    }
    GltfContainer container;
    bool first = true;
    while (reader.offset() + 8 <= *length) {
        const std::uint64_t at = reader.offset();
        const auto size = reader.u32("a chunk's length");
        const auto type = reader.u32("a chunk's type");
        if (!size) return Failure(size.error());
        if (!type) return Failure(type.error());
        if (first && *type != kJson) return failAtByte(at + 4, "the first chunk is not JSON");
        const auto bytes = reader.take(*size, "a chunk");
        if (!bytes) return Failure(bytes.error());
        if (first) container.json = text(*bytes);
        if (!first && *type == kBinary && !container.binary) container.binary = *bytes;
        first = false;
    }
    if (first) return failAtByte(reader.offset(), "the file holds no JSON");
    return container;
}

Result<Bytes> bytesOfUri(const std::string& uri, const ModelFolder& folder) {
    if (!uri.starts_with("data:")) return folder.read(withoutPercents(uri));
    const std::size_t comma = uri.find(',');
    const std::string_view head = std::string_view(uri).substr(0, comma);
    if (comma == std::string::npos || !head.ends_with(";base64")) {
        return fail("a data URI is not in base64");
    }
    std::optional<Bytes> bytes = base64(std::string_view(uri).substr(comma + 1));
    if (!bytes) return fail("a data URI holds what is not base64");
    return std::move(*bytes);
}

std::vector<std::filesystem::path> gltfRefersTo(const std::filesystem::path& path) {
    const Result<Bytes> file = readFile(path);
    if (!file) return {};
    const Result<GltfContainer> container = gltfContainer(*file);
    if (!container) return {};
    const Result<nlohmann::ordered_json> json = parseJson(container->json);
    if (!json) return {};
    std::vector<std::filesystem::path> files;
    for (const char* list : {"buffers", "images"}) {
        const auto found = json->find(list);
        if (found == json->end()) continue;
        for (const nlohmann::ordered_json& each : *found) {
            const auto uri = each.find("uri");
            if (uri == each.end() || !uri->is_string()) continue;
            const std::string text = uri->get<std::string>();
            if (text.starts_with("data:")) continue;
            const std::optional<std::filesystem::path> named = pathInFolder(withoutPercents(text));
            if (named) files.push_back(*named);
        }
    }
    return files;
}

double GltfAccessor::number(std::size_t element, int component) const {
    const std::uint8_t* at =
        data_ + element * stride_ + static_cast<std::size_t>(component * bytesOf(type_));
    switch (type_) {
        case gltf::kByte:
            return integerAt<std::int8_t>(at, normalized_);
        case gltf::kUByte:
            return integerAt<std::uint8_t>(at, normalized_);
        case gltf::kShort:
            return integerAt<std::int16_t>(at, normalized_);
        case gltf::kUShort:
            return integerAt<std::uint16_t>(at, normalized_);
        case gltf::kUInt:
            return integerAt<std::uint32_t>(at, normalized_);
        default:
            return static_cast<double>(loaded<float>(at));
    }
}

bool GltfAccessor::holdsIndices() const {
    return components_ == 1 &&
           (type_ == gltf::kUByte || type_ == gltf::kUShort || type_ == gltf::kUInt);
}

std::uint32_t GltfAccessor::index(std::size_t element) const {
    const std::uint8_t* at = data_ + element * stride_;
    if (type_ == gltf::kUByte) return *at;
    if (type_ == gltf::kUShort) return loaded<std::uint16_t>(at);
    return loaded<std::uint32_t>(at);
}

GltfBuffers::GltfBuffers(JsonObject& root, std::optional<ByteView> binary,
                         const ModelFolder& folder)
    : binary_(binary), folder_(folder) {
    const auto listOf = [&](const char* key) {
        const std::optional<JsonValue> found = root.find(key);
        return found ? found->list() : std::vector<JsonValue>{};
    };
    bufferJson_ = listOf("buffers");
    viewJson_ = listOf("bufferViews");
    accessorJson_ = listOf("accessors");
    buffers_.resize(bufferJson_.size());
}

ByteView GltfBuffers::buffer(const JsonValue& reference) {
    const std::size_t index = elementIn(bufferJson_, reference, "buffers");
    Buffer& buffer = buffers_[index];
    if (buffer.loaded) return buffer.bytes;
    JsonObject json(bufferJson_[index]);
    const std::uint64_t length = json.need("byteLength").unsigned64();
    if (const auto uri = json.find("uri")) {
        Result<Bytes> bytes = bytesOfUri(uri->text(), folder_);
        if (!bytes) uri->fail(bytes.error().message);
        loadedBytes_ += bytes->size();
        if (loadedBytes_ > kMaxFileBytes) uri->fail("the buffers are larger than 4 GiB together");
        buffer.owned = std::move(*bytes);
        buffer.bytes = buffer.owned;
    } else if (index == 0 && binary_) {
        buffer.bytes = *binary_;
    } else {
        bufferJson_[index].fail("has no bytes: no URI, and the file no chunk for it");
    }
    if (length > buffer.bytes.size()) {
        bufferJson_[index].fail("should have " + std::to_string(length) + " bytes and has " +
                                std::to_string(buffer.bytes.size()));
    }
    buffer.bytes = buffer.bytes.first(static_cast<std::size_t>(length));
    buffer.loaded = true;
    return buffer.bytes;
}

ByteView GltfBuffers::view(const JsonValue& reference) {
    const JsonValue& place = viewJson_[elementIn(viewJson_, reference, "buffer views")];
    JsonObject json(place);
    const ByteView bytes = buffer(json.need("buffer"));
    const auto offsetJson = json.find("byteOffset");
    const std::uint64_t offset = offsetJson ? offsetJson->unsigned64() : 0;
    const std::uint64_t length = json.need("byteLength").unsigned64();
    if (offset > bytes.size() || length > bytes.size() - offset) {
        place.fail("reaches beyond its buffer");
    }
    return bytes.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(length));
}

GltfAccessor GltfBuffers::accessor(const JsonValue& reference) {
    const JsonValue& place = accessorJson_[elementIn(accessorJson_, reference, "accessors")];
    JsonObject json(place);
    if (json.find("sparse")) place.fail("sparse accessors are not read");
    GltfAccessor accessor;
    accessor.type_ = json.need("componentType").integer();
    accessor.components_ = componentsOf(json.need("type").text());
    const int width = bytesOf(accessor.type_);
    if (width == 0) place.fail("its component type is not known");
    if (accessor.components_ == 0) place.fail("its type is none that meshes use");
    json.read("normalized", accessor.normalized_);
    const std::uint64_t count = json.need("count").unsigned64();
    accessor.count_ = static_cast<std::size_t>(count);
    const auto element = static_cast<std::uint64_t>(width * accessor.components_);
    const auto viewReference = json.find("bufferView");
    if (!viewReference) {
        // All zeros: one element stands for every one.
        static constexpr std::array<std::uint8_t, 16 * sizeof(float)> kZeros{};
        accessor.data_ = kZeros.data();
        return accessor;
    }
    const ByteView bytes = view(*viewReference);
    std::uint64_t stride = element;
    JsonObject viewJson(viewJson_[static_cast<std::size_t>(viewReference->integer())]);
    if (const auto given = viewJson.find("byteStride")) {
        stride = static_cast<std::uint64_t>(given->integer(4, 252));
        if (stride < element) given->fail("is less than what one element takes");
    }
    const auto offsetJson = json.find("byteOffset");
    const std::uint64_t offset = offsetJson ? offsetJson->unsigned64() : 0;
    const bool fits = count == 0 || (offset <= bytes.size() && element <= bytes.size() - offset &&
                                     count - 1 <= (bytes.size() - offset - element) / stride);
    if (!fits) place.fail("reaches beyond its buffer view");
    accessor.data_ = bytes.data() + (count == 0 ? 0 : offset);
    accessor.stride_ = static_cast<std::size_t>(stride);
    return accessor;
}

}  // namespace voxprite
