// Chooses clusters and draws them: a compute pass writes the commands of a multi-draw-indirect,
// nothing comes back from the GPU. The processor's work is that of the instances, however many
// clusters they have.
//
// What a cluster looks like is the caller's: a program whose vertex stage is cluster.vert's
// (shaders/shared/cluster_vertex.glsl).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/lod/cluster_cut.h"
#include "core/sprite/camera.h"
#include "core/sprite/placed_entity.h"
#include "render/gl/handles.h"
#include "render/gl/program.h"
#include "render/gpu_clusters.h"

namespace voxprite {

// How far the colours that tell levels take the place of a model's own.
inline constexpr float kLevelTint = 0.8f;

// How a camera sees clusters of an entity, for core/lod/cluster_cut.h: positions in metres, the
// world's axes, the camera at `cameraPosition`.
[[nodiscard]] ClusterView clusterView(const PlacedEntity& placed, glm::ivec3 treeFromVoxel,
                                      const Camera& camera, double budgetPx);

class ClusterPass {
  public:
    struct Instance {
        const GpuClusters* clusters = nullptr;
        PlacedEntity placed;
        std::array<std::uint16_t, kFaces> faceRows{};  // of the palette, by face
    };
    struct Look {
        double budgetPx = 1.0;
        float levelTint = 0.0f;      // 0 ... 1
        bool leaveOutUnseen = true;  // what lies beside the picture is not drawn
    };

    [[nodiscard]] static Result<ClusterPass> create();

    // Chooses for all instances, which are drawn mesh by mesh in their order.
    void choose(std::span<const Instance> instances, const Camera& camera, const Look& look);
    // Draws what was chosen with the program, framebuffer and state that are set.
    void draw();
    // Multi-draws of the last draw(): one a mesh.
    [[nodiscard]] int drawCalls() const { return static_cast<int>(batches_.size()); }

    // The commands as they stand, five words each, in the order of instances and pages within their
    // batches. Waits for the GPU: for tests.
    [[nodiscard]] std::vector<std::array<std::uint32_t, 5>> readCommands() const;

  private:
    // Instances of one mesh.
    struct Batch {
        const GpuClusters* clusters = nullptr;
        std::uint32_t firstInstance = 0;
        std::uint32_t instances = 0;
        std::uint32_t firstCommand = 0;
        [[nodiscard]] std::uint32_t commands() const { return instances * clusters->pageCount(); }
    };

    void chooseBatch(const Batch& batch, bool leaveOutUnseen);

    gl::Program cut_;
    gl::UniformBuffer cutBlock_, drawBlock_;
    gl::StorageBuffer cuts_;
    gl::Buffer commands_, shown_;
    std::size_t commandRoom_ = 0;
    gl::VertexArray vertices_;
    std::vector<Batch> batches_;
    float widenedPx_ = 0.0f;
};

}  // namespace voxprite
