#include "render/ray_batch.h"

#include <glad/gl.h>

#include <algorithm>

#include "core/base/check.h"

namespace voxprite {

namespace {

constexpr std::size_t kRaysAGroup = 64;         // local_size_x of ray_batch.comp
constexpr std::size_t kRayGroupsAcross = 1024;  // the rest are rows

struct BatchRay {
    glm::ivec3 origin{0};
    std::int32_t leaf_level = 0;
    glm::ivec3 direction{0};
    std::int32_t kind = 0;
};
static_assert(sizeof(BatchRay) == 32);

struct BatchHit {
    glm::ivec3 voxel{0};
    std::uint32_t material_and_axis = 0;
};
static_assert(sizeof(BatchHit) == 16);

BatchRay batchRay(const QuantisedRay& ray) {
    const std::int32_t kind = !ray.meetsBox ? 0 : ray.inside ? 2 : 1;
    return {ray.origin, ray.leafLevel, ray.direction, kind};
}

}  // namespace

Result<RayBatch> RayBatch::create() {
    Result<gl::Program> program = gl::compileCompute("ray_batch.comp");
    if (!program) return Failure(program.error());
    RayBatch batch;
    batch.program_ = std::move(*program);
    return batch;
}

void RayBatch::upload(std::span<const QuantisedRay> rays) {
    VOXPRITE_CHECK(rays.size() <= kMaxRays);
    count_ = rays.size();
    std::vector<BatchRay> batch(count_);
    std::ranges::transform(rays, batch.begin(), batchRay);
    rays_ = gl::createBuffer();
    hits_ = gl::createBuffer();
    // A buffer of no bytes is none.
    const std::size_t room = std::max<std::size_t>(count_, 1);
    glNamedBufferStorage(rays_.id(), static_cast<GLsizeiptr>(room * sizeof(BatchRay)),
                         count_ == 0 ? nullptr : batch.data(), 0);
    glNamedBufferStorage(hits_.id(), static_cast<GLsizeiptr>(room * sizeof(BatchHit)), nullptr, 0);
}

void RayBatch::cast(const GpuOctree& octree) {
    if (count_ == 0 || octree.texture() == 0) return;
    octreeBlock_.set(BlockBinding::octree, octree.block());
    glBindTextureUnit(static_cast<GLuint>(TextureUnit::svo), octree.texture());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(BufferBinding::rays),
                     rays_.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(BufferBinding::rayHits),
                     hits_.id());
    gl::useProgram(program_);
    const std::size_t groups = (count_ + kRaysAGroup - 1) / kRaysAGroup;
    const std::size_t across = std::min(groups, kRayGroupsAcross);
    glDispatchCompute(static_cast<GLuint>(across),
                      static_cast<GLuint>((groups + across - 1) / across), 1);
}

std::vector<LatticeHit> RayBatch::readHits() const {
    std::vector<BatchHit> batch(count_);
    std::vector<LatticeHit> hits(count_);
    if (count_ == 0) return hits;
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(hits_.id(), 0, static_cast<GLsizeiptr>(count_ * sizeof(BatchHit)),
                            batch.data());
    std::ranges::transform(batch, hits.begin(), [](const BatchHit& hit) {
        return LatticeHit{static_cast<std::uint8_t>(hit.material_and_axis & 0xFFu),
                          static_cast<std::uint8_t>(hit.material_and_axis >> 8u), hit.voxel};
    });
    return hits;
}

}  // namespace voxprite
