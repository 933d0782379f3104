#include "render/overlay.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "render/gl/draw_state.h"
#include "render/gl/lazy_program.h"
#include "render/gpu_blocks.h"

namespace voxprite {

namespace {

// Toward the eye, so that what lies on a surface is seen whole.
constexpr float kBias = 4e-4f;
constexpr float kFaintOpacity = 0.25f;

struct OverlayBlock {
    glm::vec2 overlay_viewport_px{0.0f};
    float overlay_opacity = 1.0f;
    float overlay_bias = 0.0f;
};
static_assert(sizeof(OverlayBlock) == 16);

// One instance of overlay_line.vert.
struct LineInstance {
    glm::vec4 clip_a, clip_b, colour;
    float width_px;
};
static_assert(sizeof(LineInstance) == 52);

// One vertex of overlay_triangle.vert.
struct TriangleVertex {
    glm::vec4 clip_position, colour;
};
static_assert(sizeof(TriangleVertex) == 32);

// Cuts a segment of clip space at the near plane (reversed: depth z / w at most 1), since a line is
// widened on the screen, where points behind the eye have no place.
std::optional<std::pair<glm::dvec4, glm::dvec4>> clippedAtNear(glm::dvec4 a, glm::dvec4 b) {
    const double insideA = a.w - a.z;
    const double insideB = b.w - b.z;
    if (insideA < 0.0 && insideB < 0.0) return std::nullopt;
    if (insideA < 0.0) a += (b - a) * (insideA / (insideA - insideB));
    if (insideB < 0.0) b += (a - b) * (insideB / (insideB - insideA));
    if (a.w <= 0.0 || b.w <= 0.0) return std::nullopt;
    return std::pair{a, b};
}

void addAttribute(const gl::VertexArray& array, GLuint location, GLint components, GLuint offset) {
    glEnableVertexArrayAttrib(array.id(), location);
    glVertexArrayAttribFormat(array.id(), location, components, GL_FLOAT, GL_FALSE, offset);
    glVertexArrayAttribBinding(array.id(), location, 0);
}

// Vertices of one kind, replaced whole for every draw.
struct VertexStream {
    gl::VertexArray array = gl::createVertexArray();
    gl::Buffer buffer = gl::createBuffer();

    template <class Vertex>
    void set(const std::vector<Vertex>& vertices) {
        glNamedBufferData(buffer.id(), static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)),
                          vertices.data(), GL_STREAM_DRAW);
        glVertexArrayVertexBuffer(array.id(), 0, buffer.id(), 0, sizeof(Vertex));
        glBindVertexArray(array.id());
    }
};

}  // namespace

void OverlayShapes::addBox(std::span<const glm::dvec3, 8> cornersInOctantOrder, Rgba8 colour,
                           float widthPx) {
    for (std::size_t octant = 0; octant < 8; ++octant) {
        for (const std::size_t bit : {std::size_t{1}, std::size_t{2}, std::size_t{4}}) {
            if ((octant & bit) != 0) continue;
            lines.push_back({cornersInOctantOrder[octant], cornersInOctantOrder[octant | bit],
                             colour, widthPx});
        }
    }
}

struct Overlay::Impl {
    gl::LazyProgram lineProgram{"overlay_line.vert", "overlay_line.frag"};
    gl::LazyProgram triangleProgram{"overlay_triangle.vert", "overlay_triangle.frag"};
    VertexStream lines;
    VertexStream triangles;
    gl::UniformBuffer block;

    Impl() {
        addAttribute(lines.array, 0, 4, offsetof(LineInstance, clip_a));
        addAttribute(lines.array, 1, 4, offsetof(LineInstance, clip_b));
        addAttribute(lines.array, 2, 4, offsetof(LineInstance, colour));
        addAttribute(lines.array, 3, 1, offsetof(LineInstance, width_px));
        glVertexArrayBindingDivisor(lines.array.id(), 0, 1);
        addAttribute(triangles.array, 0, 4, offsetof(TriangleVertex, clip_position));
        addAttribute(triangles.array, 1, 4, offsetof(TriangleVertex, colour));
    }

    void drawTriangles(const OverlayShapes& shapes, const Camera& camera) {
        const glm::dmat4 clip = camera.clipFromCameraRelative();
        std::vector<TriangleVertex> vertices;
        vertices.reserve(3 * shapes.triangles.size());
        for (const OverlayTriangle& triangle : shapes.triangles) {
            for (const glm::dvec3 corner : {triangle.a, triangle.b, triangle.c}) {
                vertices.push_back({glm::vec4(clip * glm::dvec4(corner - camera.eyeMetres, 1.0)),
                                    toVec4(triangle.colour)});
            }
        }
        if (vertices.empty()) return;
        triangles.set(vertices);
        triangleProgram.useOrSay();
        glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
    }

    void drawLines(const OverlayShapes& shapes, const Camera& camera) {
        const glm::dmat4 clip = camera.clipFromCameraRelative();
        std::vector<LineInstance> instances;
        instances.reserve(shapes.lines.size());
        for (const OverlayLine& line : shapes.lines) {
            const auto ends = clippedAtNear(clip * glm::dvec4(line.a - camera.eyeMetres, 1.0),
                                            clip * glm::dvec4(line.b - camera.eyeMetres, 1.0));
            if (!ends) continue;
            instances.push_back({glm::vec4(ends->first), glm::vec4(ends->second),
                                 toVec4(line.colour), line.widthPx});
        }
        if (instances.empty()) return;
        lines.set(instances);
        lineProgram.useOrSay();
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(instances.size()));
    }

    void pass(const OverlayShapes& shapes, const Camera& camera, gl::DepthTest test,
              float opacity) {
        gl::apply({.depthTest = test, .blend = true});
        block.set(BlockBinding::overlay, OverlayBlock{glm::vec2(camera.viewportPx), opacity,
                                                      test == gl::DepthTest::off ? 0.0f : kBias});
        drawTriangles(shapes, camera);
        drawLines(shapes, camera);
    }
};

void Overlay::draw(Frame& frame, const OverlayShapes& shapes, const Camera& camera,
                   OverlayDepth depth) {
    frame.bind();
    if (depth == OverlayDepth::always) {
        impl_->pass(shapes, camera, gl::DepthTest::off, 1.0f);
        return;
    }
    if (depth == OverlayDepth::faintBehind) {
        impl_->pass(shapes, camera, gl::DepthTest::behind, kFaintOpacity);
    }
    impl_->pass(shapes, camera, gl::DepthTest::nearerOrEqual, 1.0f);
}

Overlay::Overlay() : impl_(std::make_unique<Impl>()) {}
Overlay::~Overlay() = default;
Overlay::Overlay(Overlay&&) noexcept = default;
Overlay& Overlay::operator=(Overlay&&) noexcept = default;

}  // namespace voxprite
