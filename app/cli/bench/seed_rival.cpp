#include "app/cli/bench/seed_rival.h"

#include <glad/gl.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/sprite/lit_palette.h"
#include "render/gl/draw_state.h"

namespace voxprite::bench {
namespace {

constexpr std::uint32_t kWidth = 4096;  // kWidthBits of shaders/bench_seed.frag
enum class Binding : std::uint32_t { seed = 0 };
constexpr GLuint kCountBinding = 1;

// SeedBlock of shaders/shared/bench_seed.glsl.
struct SeedBlock {
    glm::mat4 clip_from_box{1.0f};
    glm::vec3 box_half{0.0f};
    float voxel_size = 0.1f;
    glm::vec3 ray_dir_local{0.0f};
    float sigma = 4.0f;
    glm::vec3 camera_up_local{0.0f};
    float camera_distance = 1.0f;
    glm::vec3 anchor_to_center{0.0f};
    float billboard_depth = 0.0f;
    glm::uvec3 svo_model_size{0};
    std::uint32_t svo_max_depth = 1;
    glm::vec2 center_ndc{0.0f};
    glm::vec2 proj_scale{1.0f};
    glm::vec2 viewport_size{1.0f};
    std::uint32_t node_offset = 0;
    std::uint32_t payload_offset = 0;
};
static_assert(sizeof(SeedBlock) == 176);

gl::Texture textureOf(GLenum format, glm::ivec2 size) {
    gl::Texture texture = gl::createTexture2d();
    glTextureStorage2D(texture.id(), 1, format, size.x, size.y);
    glTextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(texture.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

// Nodes, then payloads as low and high words, a row of kWidth after the other.
std::vector<std::uint32_t> wordsOf(const Octree& octree) {
    std::vector<std::uint32_t> words(octree.nodes);
    for (const std::uint64_t payload : octree.payloads) {
        words.push_back(static_cast<std::uint32_t>(payload));
        words.push_back(static_cast<std::uint32_t>(payload >> 32));
    }
    words.resize((words.size() + kWidth - 1) / kWidth * kWidth);
    return words;
}

bool onScreen(const Camera::Projected& centre, double radiusPx, glm::ivec2 viewportPx) {
    return centre.screenPx.x + radiusPx >= 0.0 && centre.screenPx.y + radiusPx >= 0.0 &&
           centre.screenPx.x - radiusPx <= viewportPx.x &&
           centre.screenPx.y - radiusPx <= viewportPx.y;
}

}  // namespace

Result<SeedRenderer> SeedRenderer::create(std::span<const Octree> models, const Palette& palette) {
    SeedRenderer renderer;
    Result<gl::Program> program = gl::compileProgram("bench_seed.vert", "bench_seed.frag");
    if (!program) return Failure(program.error());
    Result<gl::Program> counting =
        gl::compileProgram("bench_seed.vert", "bench_seed.frag", {"COUNT_RAYS"});
    if (!counting) return Failure(counting.error());
    renderer.program_ = std::move(*program);
    renderer.counting_ = std::move(*counting);
    renderer.nothing_ = gl::createVertexArray();
    renderer.count_ = gl::createBuffer();
    glNamedBufferData(renderer.count_.id(), 4, nullptr, GL_DYNAMIC_READ);

    for (const Octree& octree : models) {
        const std::vector<std::uint32_t> words = wordsOf(octree);
        const glm::ivec2 size(kWidth, static_cast<int>(words.size() / kWidth));
        Model model{textureOf(GL_R32UI, size), octree.size,
                    static_cast<std::uint32_t>(octree.maxDepth),
                    static_cast<std::uint32_t>(octree.nodes.size())};
        glTextureSubImage2D(model.svo.id(), 0, 0, 0, size.x, size.y, GL_RED_INTEGER,
                            GL_UNSIGNED_INT, words.data());
        renderer.models_.push_back(std::move(model));
    }
    const LitPalette lit = litPalette(palette, {255, 255, 255}, Outline{});
    std::vector<Rgba8> rows;
    for (std::uint8_t axis = 0; axis < 3; ++axis)
        for (int index = 0; index < 256; ++index)
            rows.push_back(lit.shade(static_cast<std::uint8_t>(index), axis));
    renderer.palette_ = textureOf(GL_RGBA8, {256, 3});
    glTextureSubImage2D(renderer.palette_.id(), 0, 0, 0, 256, 3, GL_RGBA, GL_UNSIGNED_BYTE,
                        rows.data());
    return renderer;
}

int SeedRenderer::drawAll(Frame& frame, std::span<const CrowdMember> scene, const Camera& camera,
                          const GameProfile& profile) {
    frame.begin(Rgba8(0));
    gl::apply(
        {.depthTest = gl::DepthTest::nearer, .depthWrite = true, .cull = gl::Cull::frontFaces});
    glBindVertexArray(nothing_.id());
    glBindTextureUnit(1, palette_.id());
    const glm::dmat4 clipFromEye = camera.clipFromCameraRelative();
    const glm::dvec2 viewport(camera.viewportPx);
    const glm::dvec2 halfAtOneMetre = 0.5 * viewport * camera.metresPerScreenPx(1.0);
    int drawn = 0;
    for (const CrowdMember& member : scene) {
        const PlacedEntity& entity = member.placed;
        const Model& model = models_[static_cast<std::size_t>(member.model)];
        const glm::dvec3 centre = entity.centreMetres() - camera.eyeMetres;
        const Camera::Projected seen = camera.projectFromEye(centre);
        const double radius = entity.radiusMetres() + profile.voxelSizeMetres;
        if (seen.depthMetres <= radius) continue;
        const double radiusPx = radius / camera.metresPerScreenPx(seen.depthMetres - radius);
        if (!onScreen(seen, radiusPx, camera.viewportPx)) continue;

        const glm::dmat3& axes = entity.worldFromVoxelAxes;
        const glm::dmat4 eyeFromBox{glm::dvec4(axes[0], 0.0), glm::dvec4(axes[1], 0.0),
                                    glm::dvec4(axes[2], 0.0), glm::dvec4(centre, 1.0)};
        SeedBlock block;
        block.clip_from_box = glm::mat4(clipFromEye * eyeFromBox);
        block.box_half = glm::vec3(proxyHalfMetres(entity, profile.sigma));
        block.voxel_size = static_cast<float>(entity.voxelSizeMetres);
        block.ray_dir_local = glm::vec3(glm::transpose(axes) * camera.forward);
        block.sigma = static_cast<float>(profile.sigma);
        block.camera_up_local = glm::vec3(glm::transpose(axes) * camera.up);
        block.camera_distance = static_cast<float>(seen.depthMetres);
        block.anchor_to_center = glm::vec3(entity.centreVoxels());
        block.billboard_depth = camera.reversedDepth(seen.depthMetres);
        block.svo_model_size = glm::uvec3(model.size);
        block.svo_max_depth = model.maxDepth;
        block.center_ndc = glm::vec2((seen.screenPx / viewport * 2.0 - 1.0) * glm::dvec2(1, -1));
        block.proj_scale = glm::vec2(halfAtOneMetre);
        block.viewport_size = glm::vec2(viewport);
        block.payload_offset = model.payloadOffset;
        block_.set(Binding::seed, block);
        glBindTextureUnit(0, model.svo.id());
        glDrawArrays(GL_TRIANGLES, 0, 36);
        ++drawn;
    }
    return drawn;
}

SeedRenderer::Drawn SeedRenderer::draw(Frame& frame, std::span<const CrowdMember> scene,
                                       const Camera& camera, const GameProfile& profile) {
    gl::useProgram(program_);
    return {drawAll(frame, scene, camera, profile), 0};
}

SeedRenderer::Drawn SeedRenderer::countRays(Frame& frame, std::span<const CrowdMember> scene,
                                            const Camera& camera, const GameProfile& profile) {
    const GLuint zero = 0;
    glNamedBufferSubData(count_.id(), 0, 4, &zero);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kCountBinding, count_.id());
    gl::useProgram(counting_);
    const int drawn = drawAll(frame, scene, camera, profile);
    GLuint rays = 0;
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(count_.id(), 0, 4, &rays);
    return {drawn, rays};
}

}  // namespace voxprite::bench
