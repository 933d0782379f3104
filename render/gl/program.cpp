#include "render/gl/program.h"

#include <glad/gl.h>

#include "render/gl/shader_library.h"

namespace voxprite::gl {

namespace {

// Deletes the shader objects whatever happens; a linked program keeps what it needs.
class Shader {
  public:
    explicit Shader(GLenum stage) : id_(glCreateShader(stage)) {}
    ~Shader() { glDeleteShader(id_); }
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;
    [[nodiscard]] GLuint id() const { return id_; }

    [[nodiscard]] Status compile(const std::string& name, const std::vector<std::string>& defines) {
        const Result<ShaderSource> source = assembleShader(name, defines);
        if (!source) return tl::unexpected(source.error());
        const char* text = source->text.c_str();
        glShaderSource(id_, 1, &text, nullptr);
        glCompileShader(id_);
        GLint compiled = 0;
        glGetShaderiv(id_, GL_COMPILE_STATUS, &compiled);
        if (compiled != 0) return {};
        GLint length = 0;
        glGetShaderiv(id_, GL_INFO_LOG_LENGTH, &length);
        std::string log(static_cast<std::size_t>(length), '\0');
        glGetShaderInfoLog(id_, length, &length, log.data());
        log.resize(static_cast<std::size_t>(length));
        return fail("the shader " + name + " does not compile: " + namedLog(log, source->files));
    }

  private:
    GLuint id_;
};

Status link(const Program& program, const std::string& what) {
    glLinkProgram(program.id());
    GLint linked = 0;
    glGetProgramiv(program.id(), GL_LINK_STATUS, &linked);
    if (linked != 0) return {};
    GLint length = 0;
    glGetProgramiv(program.id(), GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    glGetProgramInfoLog(program.id(), length, &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    return fail(what + " cannot be linked: " + log);
}

void uploadAndBind(Buffer& buffer, GLenum target, GLuint binding, const void* data,
                   std::size_t bytes) {
    if (!buffer) buffer = createBuffer();
    // Orphans the old contents, so that a draw still in flight keeps what it was given.
    glNamedBufferData(buffer.id(), static_cast<GLsizeiptr>(bytes), data, GL_STREAM_DRAW);
    glBindBufferBase(target, binding, buffer.id());
}

}  // namespace

Result<Program> compileProgram(const std::string& vertex, const std::string& fragment,
                               const std::vector<std::string>& defines) {
    Shader vertexShader(GL_VERTEX_SHADER);
    Shader fragmentShader(GL_FRAGMENT_SHADER);
    if (const Status done = vertexShader.compile(vertex, defines); !done) {
        return tl::unexpected(done.error());
    }
    if (const Status done = fragmentShader.compile(fragment, defines); !done) {
        return tl::unexpected(done.error());
    }
    Program program{glCreateProgram()};
    glAttachShader(program.id(), vertexShader.id());
    glAttachShader(program.id(), fragmentShader.id());
    if (const Status linked = link(program, "the shaders " + vertex + " and " + fragment);
        !linked) {
        return tl::unexpected(linked.error());
    }
    glDetachShader(program.id(), vertexShader.id());
    glDetachShader(program.id(), fragmentShader.id());
    return program;
}

Result<Program> compileCompute(const std::string& name, const std::vector<std::string>& defines) {
    Shader shader(GL_COMPUTE_SHADER);
    if (const Status done = shader.compile(name, defines); !done) {
        return tl::unexpected(done.error());
    }
    Program program{glCreateProgram()};
    glAttachShader(program.id(), shader.id());
    if (const Status linked = link(program, "the shader " + name); !linked) {
        return tl::unexpected(linked.error());
    }
    glDetachShader(program.id(), shader.id());
    return program;
}

void useProgram(const Program& program) {
    glUseProgram(program.id());
}

void UniformBuffer::upload(std::uint32_t binding, const void* data, std::size_t bytes) {
    uploadAndBind(buffer_, GL_UNIFORM_BUFFER, binding, data, bytes);
}

void StorageBuffer::upload(std::uint32_t binding, const void* data, std::size_t bytes) {
    uploadAndBind(buffer_, GL_SHADER_STORAGE_BUFFER, binding, data, bytes);
}

void StorageBuffer::bindTo(std::uint32_t binding) const {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer_.id());
}

}  // namespace voxprite::gl
