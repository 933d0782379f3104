#include "tests/support/vox_builder.h"

namespace voxprite::test {

namespace {

void putAll(Bytes& bytes, const Bytes& more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
}

void putChunk(Bytes& bytes, const std::string& id, const Bytes& content, const Bytes& children) {
    bytes.insert(bytes.end(), id.begin(), id.end());
    put32(bytes, static_cast<std::int64_t>(content.size()));
    put32(bytes, static_cast<std::int64_t>(children.size()));
    putAll(bytes, content);
    putAll(bytes, children);
}

}  // namespace

void put32(Bytes& bytes, std::int64_t value) {
    for (int shift = 0; shift < 32; shift += 8) {
        bytes.push_back(static_cast<std::uint8_t>((value >> shift) & 0xFF));
    }
}

void putText(Bytes& bytes, const std::string& text) {
    put32(bytes, static_cast<std::int64_t>(text.size()));
    bytes.insert(bytes.end(), text.begin(), text.end());
}

void putProperties(Bytes& bytes, const Properties& properties) {
    put32(bytes, static_cast<std::int64_t>(properties.size()));
    for (const auto& [key, value] : properties) {
        putText(bytes, key);
        putText(bytes, value);
    }
}

VoxBuilder& VoxBuilder::chunk(const std::string& id, const Bytes& content, const Bytes& children) {
    putChunk(chunks_, id, content, children);
    return *this;
}

VoxBuilder& VoxBuilder::model(glm::ivec3 size, const std::vector<Voxel>& voxels) {
    Bytes sizes;
    for (int axis = 0; axis < 3; ++axis) put32(sizes, size[axis]);
    Bytes content;
    put32(content, static_cast<std::int64_t>(voxels.size()));
    for (const Voxel& voxel : voxels) content.insert(content.end(), voxel.begin(), voxel.end());
    return chunk("SIZE", sizes).chunk("XYZI", content);
}

VoxBuilder& VoxBuilder::transform(int id, int child, const Properties& attributes,
                                  const std::vector<Properties>& frames, int layer) {
    Bytes content;
    put32(content, id);
    putProperties(content, attributes);
    put32(content, child);
    put32(content, -1);
    put32(content, layer);
    put32(content, static_cast<std::int64_t>(frames.size()));
    for (const Properties& frame : frames) putProperties(content, frame);
    return chunk("nTRN", content);
}

VoxBuilder& VoxBuilder::group(int id, const std::vector<int>& children,
                              const Properties& attributes) {
    Bytes content;
    put32(content, id);
    putProperties(content, attributes);
    put32(content, static_cast<std::int64_t>(children.size()));
    for (const int child : children) put32(content, child);
    return chunk("nGRP", content);
}

VoxBuilder& VoxBuilder::shape(int id, const std::vector<std::pair<int, Properties>>& models,
                              const Properties& attributes) {
    Bytes content;
    put32(content, id);
    putProperties(content, attributes);
    put32(content, static_cast<std::int64_t>(models.size()));
    for (const auto& [model, own] : models) {
        put32(content, model);
        putProperties(content, own);
    }
    return chunk("nSHP", content);
}

VoxBuilder& VoxBuilder::layer(int id, const Properties& attributes) {
    Bytes content;
    put32(content, id);
    putProperties(content, attributes);
    put32(content, -1);
    return chunk("LAYR", content);
}

Bytes VoxBuilder::bytes(int version) const {
    Bytes file{'V', 'O', 'X', ' '};
    put32(file, version);
    putChunk(file, "MAIN", {}, chunks_);
    return file;
}

VoxBuilder oneObject(glm::ivec3 size, const Properties& frame) {
    const glm::ivec3 middle = size / 2;
    VoxBuilder builder;
    builder
        .model(size, {{static_cast<std::uint8_t>(middle.x), static_cast<std::uint8_t>(middle.y),
                       static_cast<std::uint8_t>(middle.z), 7}})
        .transform(0, 1)
        .group(1, {2})
        .transform(2, 3, {}, {frame})
        .shape(3, {{0, {}}});
    return builder;
}

}  // namespace voxprite::test
