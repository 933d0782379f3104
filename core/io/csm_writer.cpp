#include "core/io/csm_writer.h"

#include <algorithm>
#include <bit>

#include "core/io/csm_octant.h"
#include "core/model/entity_voxels.h"
#include "core/svo/bake.h"

namespace voxprite {
namespace {

class Writer {
  public:
    explicit Writer(const OctreeView& octree) : octree_(octree) {}

    std::string run() {
        // A model of one voxel has a tree of two an edge.
        const bool single = octree_.size == glm::ivec3(1) && octree_.maxDepth == 1;
        if (single) {
            state("", std::to_string(materialAtTree(octree_, glm::ivec3(0))));
        } else {
            cube(octree_.nodes[0]);
        }
        if (!single && deepest_ < octree_.maxDepth) {
            state(std::string(static_cast<std::size_t>(octree_.maxDepth), csm::letterOf(0)),
                  std::to_string(materialAtTree(octree_, glm::ivec3(0))));
        }
        return std::move(text_);
    }

  private:
    void state(const std::string& path, const std::string& cube) {
        text_ += '>' + path + ' ' + cube + '\n';
    }

    [[nodiscard]] std::uint32_t child(std::uint32_t word, unsigned octant) const {
        if (node::isBrick(word)) {
            return payloadMaterial(octree_.payloads[node::payloadIndex(word)], octant);
        }
        return node::hasChild(word, octant) ? octree_.nodes[node::childIndex(word, octant)] : 0;
    }

    // The node at path_.
    void cube(std::uint32_t word) {
        if (node::isEmpty(word)) return;
        const int depth = static_cast<int>(path_.size());
        if (node::isUniform(word)) {
            deepest_ = std::max(deepest_, depth);
            return state(path_, std::to_string(word));
        }
        std::string values;
        for (unsigned i = 0; i < 8; ++i) {
            const std::uint32_t part = child(word, csm::octantFromCsm(i));
            if (!node::isEmpty(part) && !node::isUniform(part)) return children(word);
            values += (i == 0 ? "" : " ") + std::to_string(part);
        }
        deepest_ = std::max(deepest_, depth + 1);
        state(path_, '[' + values + ']');
    }

    void children(std::uint32_t word) {
        for (unsigned i = 0; i < 8; ++i) {
            const unsigned octant = csm::octantFromCsm(i);
            path_.push_back(csm::letterOf(octant));
            cube(child(word, octant));
            path_.pop_back();
        }
    }

    const OctreeView& octree_;
    std::string text_;
    std::string path_;
    int deepest_ = 0;  // level that a statement has reached
};

// The canvas of the only object, if it is a cube that CSM can have.
IBox cubicCanvas(const Document& document) {
    const std::vector<Instance> instances = instancesOf(document, 0);
    if (instances.size() != 1) return {};
    const Model& model = document.models[static_cast<std::size_t>(instances[0].model)];
    const IBox canvas = instances[0].entityFromModel.applyToBox(model.canvas);
    const int edge = canvas.max.x;
    const bool fits = canvas.min == glm::ivec3(0) && canvas.max == glm::ivec3(edge) &&
                      std::has_single_bit(static_cast<unsigned>(edge)) &&
                      edge <= 1 << kMaxOctreeDepth;
    return fits ? canvas : IBox{};
}

// The cube that is written, in entity space.
IBox cubeFor(const Document& document, const IBox& bounds) {
    const IBox canvas = cubicCanvas(document);
    if (!canvas.empty() && canvas.united(bounds) == canvas) return canvas;
    if (bounds.empty()) return {glm::ivec3(0), glm::ivec3(1)};
    constexpr int kMaxEdge = 1 << kMaxOctreeDepth;
    glm::ivec3 corner = glm::min(bounds.min, glm::ivec3(0));
    const glm::ivec3 reach = bounds.max - corner;
    if (std::max({reach.x, reach.y, reach.z}) > kMaxEdge) corner = bounds.min;
    const glm::ivec3 size = bounds.max - corner;
    const int longest = std::max({size.x, size.y, size.z});
    return {corner, corner + static_cast<int>(std::bit_ceil(static_cast<unsigned>(longest)))};
}

}  // namespace

std::string csmText(const OctreeView& octree) {
    return Writer(octree).run();
}

Result<Bytes> writeCsm(const Document& document) {
    const VoxelGrid voxels = flatten(document, 0);
    const Result<Octree> octree = bake(voxels, cubeFor(document, voxels.bounds()));
    if (!octree) return Failure(octree.error());
    const std::string text = csmText(octree->view());
    return Bytes(text.begin(), text.end());
}

std::vector<std::string> csmLosses(const Document& document) {
    const glm::ivec3 corner = cubeFor(document, frameBounds(document, 0)).min;
    if (corner == glm::ivec3(0)) return {};
    return {".csm has no coordinates below 0: the model is moved by " + std::to_string(-corner.x) +
            ", " + std::to_string(-corner.y) + ", " + std::to_string(-corner.z)};
}

}  // namespace voxprite
