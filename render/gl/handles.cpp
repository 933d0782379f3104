#include "render/gl/handles.h"

#include <glad/gl.h>

namespace voxprite::gl {

void deleteTexture(std::uint32_t id) {
    glDeleteTextures(1, &id);
}
void deleteBuffer(std::uint32_t id) {
    glDeleteBuffers(1, &id);
}
void deleteFramebuffer(std::uint32_t id) {
    glDeleteFramebuffers(1, &id);
}
void deleteVertexArray(std::uint32_t id) {
    glDeleteVertexArrays(1, &id);
}
void deleteProgram(std::uint32_t id) {
    glDeleteProgram(id);
}
void deleteQuery(std::uint32_t id) {
    glDeleteQueries(1, &id);
}

namespace {
template <class Object, class Create>
Object created(Create create) {
    std::uint32_t id = 0;
    create(&id);
    return Object{id};
}
}  // namespace

Texture createTexture2d() {
    return created<Texture>([](auto* id) { glCreateTextures(GL_TEXTURE_2D, 1, id); });
}
Texture createTexture2dArray() {
    return created<Texture>([](auto* id) { glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, id); });
}
Texture createTextureView(const Texture& texture, std::uint32_t format) {
    std::uint32_t id = 0;
    glGenTextures(1, &id);
    glTextureView(id, GL_TEXTURE_2D, texture.id(), format, 0, 1, 0, 1);
    return Texture{id};
}
Buffer createBuffer() {
    return created<Buffer>([](auto* id) { glCreateBuffers(1, id); });
}
Framebuffer createFramebuffer() {
    return created<Framebuffer>([](auto* id) { glCreateFramebuffers(1, id); });
}
VertexArray createVertexArray() {
    return created<VertexArray>([](auto* id) { glCreateVertexArrays(1, id); });
}
Query createTimeQuery() {
    return created<Query>([](auto* id) { glCreateQueries(GL_TIME_ELAPSED, 1, id); });
}

}  // namespace voxprite::gl
