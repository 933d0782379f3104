#include "render/cluster_pass.h"

#include <glad/gl.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/gpu_blocks.h"

namespace voxprite {

namespace {

constexpr std::uint32_t kGroup = 64;              // local_size_x of cluster_cut.comp
constexpr std::uint32_t kMostInstances = 65'535;  // of one dispatch, as every driver allows
constexpr std::size_t kCommandBytes = 20;

// Attributes and the buffers that they come from, see cluster_vertex.glsl.
constexpr GLuint kVertexSource = 0, kInstanceSource = 1;
constexpr GLuint kPackedVertex = 0, kClipFromEyeCell = 1, kEyeCell = 5, kFaceRows = 6;

struct CutBlock {
    std::uint32_t first_instance = 0;
    std::uint32_t page_count = 0;
    std::uint32_t first_command = 0;
    std::uint32_t culled = 1;
};
static_assert(sizeof(CutBlock) == 16);

struct DrawBlock {
    glm::vec2 half_frame_px{0.0f};
    float widened_px = 0.0f;
    float level_tint = 0.0f;
};
static_assert(sizeof(DrawBlock) == 16);

struct CutRecord {
    ClusterCutParams params;
    std::array<glm::vec4, 5> planes{};
};
static_assert(sizeof(CutRecord) == 176);

// What the vertex stage is given of an instance.
struct ShownRecord {
    glm::mat4 clip_from_eye_cell{1.0f};
    glm::ivec3 eye_cell{0};
    std::int32_t padding = 0;
    std::array<std::uint16_t, kFaces> face_rows{};
    std::uint32_t padding_too = 0;
};
static_assert(sizeof(ShownRecord) == 96);

// The camera is the origin, with the world's axes.
glm::dmat4 eyeFromTree(const PlacedEntity& placed, glm::ivec3 treeFromVoxel, const Camera& camera) {
    const glm::dmat3 axes = placed.worldFromVoxelAxes * placed.metresPerVoxel();
    const glm::dvec3 origin = (placed.anchorMetres - camera.eyeMetres) -
                              axes * (placed.anchor + glm::dvec3(treeFromVoxel));
    glm::dmat4 matrix(axes);
    matrix[3] = glm::dvec4(origin, 1.0);
    return matrix;
}

// The sides of the picture and its near plane (depth is reversed), in tree space.
std::array<glm::vec4, 5> picturePlanes(const glm::dmat4& clipFromTree) {
    const glm::dmat4 rows = glm::transpose(clipFromTree);
    std::array<glm::vec4, 5> planes{};
    const std::array<glm::dvec4, 5> all{rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1],
                                        rows[3] - rows[1], rows[3] - rows[2]};
    for (std::size_t k = 0; k < all.size(); ++k) {
        planes[k] = glm::vec4(all[k] / glm::length(glm::dvec3(all[k])));
    }
    return planes;
}

// The corner of a cell near the eye, or near the model where the eye is far away.
glm::ivec3 eyeCell(const glm::dmat4& eyeFromTree) {
    const glm::dvec3 eye = -glm::inverse(glm::dmat3(eyeFromTree)) * glm::dvec3(eyeFromTree[3]);
    glm::ivec3 cell(0);
    for (int axis = 0; axis < 3; ++axis) {
        // Of an eye that is no number the corner is the tree's.
        if (eye[axis] > 0.0) cell[axis] = static_cast<int>(std::min(eye[axis], 65536.0));
    }
    return cell;
}

}  // namespace

ClusterView clusterView(const PlacedEntity& placed, glm::ivec3 treeFromVoxel, const Camera& camera,
                        double budgetPx) {
    ClusterView view;
    view.worldFromTree = eyeFromTree(placed, treeFromVoxel, camera);
    if (camera.orthographic) {
        view.orthographicHalfHeight = 0.5 * camera.orthographicHeightMetres;
    } else {
        view.tanHalfFovY = 0.5 * camera.viewportPx.y * camera.metresPerScreenPx(1.0);
    }
    view.viewportHeightPx = camera.viewportPx.y;
    view.pixelBudget = budgetPx;
    view.nearDistance = camera.nearMetres;
    return view;
}

Result<ClusterPass> ClusterPass::create() {
    Result<gl::Program> cut = gl::compileCompute("cluster_cut.comp");
    if (!cut) return Failure(cut.error());
    ClusterPass pass;
    pass.cut_ = std::move(*cut);
    pass.commands_ = gl::createBuffer();
    pass.shown_ = gl::createBuffer();
    pass.vertices_ = gl::createVertexArray();
    const GLuint id = pass.vertices_.id();
    const auto words = [&](GLuint attribute, GLint count, GLenum type, std::size_t offset,
                           GLuint source) {
        glEnableVertexArrayAttrib(id, attribute);
        glVertexArrayAttribIFormat(id, attribute, count, type, static_cast<GLuint>(offset));
        glVertexArrayAttribBinding(id, attribute, source);
    };
    words(kPackedVertex, 2, GL_UNSIGNED_INT, 0, kVertexSource);
    for (GLuint column = 0; column < 4; ++column) {
        glEnableVertexArrayAttrib(id, kClipFromEyeCell + column);
        glVertexArrayAttribFormat(id, kClipFromEyeCell + column, 4, GL_FLOAT, GL_FALSE,
                                  column * sizeof(glm::vec4));
        glVertexArrayAttribBinding(id, kClipFromEyeCell + column, kInstanceSource);
    }
    words(kEyeCell, 3, GL_INT, offsetof(ShownRecord, eye_cell), kInstanceSource);
    words(kFaceRows, 3, GL_UNSIGNED_INT, offsetof(ShownRecord, face_rows), kInstanceSource);
    glVertexArrayBindingDivisor(id, kInstanceSource, 1);

    // A corner is rounded to within half a step on each axis, and so are those of the edge that it
    // lies on: together sqrt(2) steps at most, half of which each quad covers; and some more.
    GLint subpixelBits = 4;
    glGetIntegerv(GL_SUBPIXEL_BITS, &subpixelBits);
    pass.widenedPx_ = static_cast<float>(std::ldexp(1.25, -subpixelBits));
    return pass;
}

void ClusterPass::choose(std::span<const Instance> instances, const Camera& camera,
                         const Look& look) {
    std::vector<const Instance*> ordered;
    for (const Instance& instance : instances) {
        if (instance.clusters->indexCount() > 0) ordered.push_back(&instance);
    }
    std::ranges::stable_sort(
        ordered, {}, [](const Instance* instance) { return instance->clusters->revision(); });

    std::vector<CutRecord> cuts;
    std::vector<ShownRecord> shown;
    batches_.clear();
    std::size_t commands = 0;
    const glm::dmat4 clipFromEye = camera.clipFromCameraRelative();
    for (const Instance* instance : ordered) {
        const GpuClusters& clusters = *instance->clusters;
        if (batches_.empty() || batches_.back().clusters->revision() != clusters.revision() ||
            batches_.back().instances == kMostInstances) {
            batches_.push_back({&clusters, static_cast<std::uint32_t>(cuts.size()), 0,
                                static_cast<std::uint32_t>(commands)});
        }
        ++batches_.back().instances;
        commands += clusters.pageCount();

        const ClusterView view =
            clusterView(instance->placed, clusters.treeFromVoxel(), camera, look.budgetPx);
        const glm::dmat4 clipFromTree = clipFromEye * view.worldFromTree;
        cuts.push_back({clusterCutParams(view, clusters.reach(), clusters.pageCount()),
                        picturePlanes(clipFromTree)});
        ShownRecord& record = shown.emplace_back();
        record.eye_cell = eyeCell(view.worldFromTree);
        glm::dmat4 clipFromEyeCell = clipFromTree;
        clipFromEyeCell[3] = clipFromTree * glm::dvec4(glm::dvec3(record.eye_cell), 1.0);
        record.clip_from_eye_cell = glm::mat4(clipFromEyeCell);
        record.face_rows = instance->faceRows;
    }
    if (batches_.empty()) return;

    if (commands > commandRoom_) {
        commandRoom_ = commands + commands / 2;
        glNamedBufferData(commands_.id(), static_cast<GLsizeiptr>(commandRoom_ * kCommandBytes),
                          nullptr, GL_STREAM_COPY);
    }
    const std::span<const ShownRecord> all(shown);
    glNamedBufferData(shown_.id(), static_cast<GLsizeiptr>(all.size_bytes()), all.data(),
                      GL_STREAM_DRAW);
    drawBlock_.set(BlockBinding::clusterDraw,
                   DrawBlock{0.5f * glm::vec2(camera.viewportPx), widenedPx_, look.levelTint});
    cuts_.set(BufferBinding::clusterCuts, std::span<const CutRecord>(cuts));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(BufferBinding::clusterCommands),
                     commands_.id());
    gl::useProgram(cut_);
    for (const Batch& batch : batches_) chooseBatch(batch, look.leaveOutUnseen);
    glMemoryBarrier(GL_COMMAND_BARRIER_BIT);
}

void ClusterPass::chooseBatch(const Batch& batch, bool leaveOutUnseen) {
    const std::uint32_t pages = batch.clusters->pageCount();
    cutBlock_.set(BlockBinding::clusterCut, CutBlock{batch.firstInstance, pages, batch.firstCommand,
                                                     leaveOutUnseen ? 1u : 0u});
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(BufferBinding::clusterPages),
                     batch.clusters->pages());
    glDispatchCompute((pages + kGroup - 1) / kGroup, batch.instances, 1);
}

void ClusterPass::draw() {
    const GLuint id = vertices_.id();
    glBindVertexArray(id);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, commands_.id());
    glVertexArrayVertexBuffer(id, kInstanceSource, shown_.id(), 0, sizeof(ShownRecord));
    for (const Batch& batch : batches_) {
        glVertexArrayVertexBuffer(id, kVertexSource, batch.clusters->vertices(), 0,
                                  sizeof(ClusterVertex));
        glVertexArrayElementBuffer(id, batch.clusters->indices());
        glMultiDrawElementsIndirect(
            GL_TRIANGLES, GL_UNSIGNED_INT,
            reinterpret_cast<const void*>(batch.firstCommand * kCommandBytes),
            static_cast<GLsizei>(batch.commands()), kCommandBytes);
    }
}

std::vector<std::array<std::uint32_t, 5>> ClusterPass::readCommands() const {
    std::size_t count = 0;
    for (const Batch& batch : batches_) count += batch.commands();
    std::vector<std::array<std::uint32_t, 5>> commands(count);
    glGetNamedBufferSubData(commands_.id(), 0, static_cast<GLsizeiptr>(count * kCommandBytes),
                            commands.data());
    return commands;
}

}  // namespace voxprite
