// The cut as seed 003 words it, in single precision: what ours is held against. It measures the
// distance to a sphere's centre and takes every value as it comes.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <limits>
#include <span>
#include <vector>

#include "core/lod/cluster_page.h"

namespace voxprite::test {

struct LiteralView {
    glm::mat4 worldFromTree{1.0f};
    glm::vec3 camera{0.0f};
    float tanHalfFovY = 0.5f;
    float viewportHeight = 1080.0f;
    float pixelBudget = 1.0f;
};

inline float literalScale(const glm::mat4& m) {
    return std::fmax(std::fmax(glm::length(glm::vec3(m[0])), glm::length(glm::vec3(m[1]))),
                     glm::length(glm::vec3(m[2])));
}

inline float literalProjected(float error, glm::vec3 centre, const LiteralView& view) {
    const glm::vec3 world(view.worldFromTree * glm::vec4(centre, 1.0f));
    const float distance = glm::length(world - view.camera);
    if (distance <= 1e-6f || view.tanHalfFovY <= 1e-6f)
        return std::numeric_limits<float>::infinity();
    return error * literalScale(view.worldFromTree) * (view.viewportHeight * 0.5f) /
           (distance * view.tanHalfFovY);
}

inline std::vector<std::uint32_t> literalCut(std::span<const ClusterPage> pages,
                                             const LiteralView& view) {
    std::vector<std::uint32_t> cut;
    for (std::uint32_t i = 0; i < pages.size(); ++i) {
        const ClusterPage& page = pages[i];
        if (literalProjected(page.lodError, page.lodBoundsCentre, view) <= view.pixelBudget &&
            view.pixelBudget < literalProjected(page.parentError, page.parentBoundsCentre, view))
            cut.push_back(i);
    }
    return cut;
}

}  // namespace voxprite::test
