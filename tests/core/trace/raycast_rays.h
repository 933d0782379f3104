// Rays for the tests of the octree ray cast: common ones, and those that are hard.
#pragma once

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <random>
#include <string>

#include "core/trace/raycast.h"

namespace voxprite::test {

// So that failures print the ray.
inline std::string describe(const Ray& ray) {
    char text[256];
    const glm::dvec3 o = ray.origin;
    const glm::dvec3 d = ray.direction;
    std::snprintf(text, sizeof text, "origin %.17g %.17g %.17g direction %.17g %.17g %.17g", o.x,
                  o.y, o.z, d.x, d.y, d.z);
    return text;
}

class Rays {
  public:
    explicit Rays(unsigned seed) : random_(seed) {}

    // From around or inside a box of `size` voxels at a point in it; directions of any length.
    Ray common(glm::ivec3 modelSize, double reach) {
        const glm::dvec3 size(modelSize);
        const glm::dvec3 side =
            glm::normalize(glm::dvec3(normal_(random_), normal_(random_), normal_(random_)));
        const glm::dvec3 eye = size * 0.5 + side * (glm::length(size) * reach * unit_(random_));
        const glm::dvec3 target = size * glm::dvec3(unit_(random_), unit_(random_), unit_(random_));
        return {eye, (target - eye) * std::exp(4.0 * normal_(random_))};
    }

    // Through corners and edges, along faces, from corners, from faces, from inside; components
    // are 0 or powers of two and all coordinates eighths, so that quantising changes nothing.
    Ray special(glm::ivec3 size) {
        Ray ray;
        do {
            for (int a = 0; a < 3; ++a) {
                const int power = among(-1, 2);
                const double length = power < 0 ? 0.0 : std::exp2(-power);
                ray.direction[a] = among(0, 1) != 0 ? length : -length;
            }
        } while (ray.direction == glm::dvec3(0.0));
        const int grain = 1 << among(0, 3);  // whole voxels, halves, quarters, eighths
        for (int a = 0; a < 3; ++a)
            ray.origin[a] = among(-2 * grain, (size[a] + 2) * grain) / double(grain);
        if (among(0, 2) == 0) ray.origin -= ray.direction * double(4 * among(1, 64));
        return ray;
    }

    // Nearly along a face or an axis, by less and less, down to beyond what a double holds.
    Ray grazing(glm::ivec3 size) {
        Ray ray = special(size);
        for (int a = 0; a < 3; ++a) {
            if (ray.direction[a] == 0.0) ray.direction[a] = tiny();
            ray.origin[a] += among(0, 1) * tiny();
        }
        return ray;
    }

    int among(int least, int most) {
        return std::uniform_int_distribution<int>(least, most)(random_);
    }

  private:
    double tiny() {
        const double length = std::pow(10.0, -among(1, 320));
        return among(0, 1) != 0 ? length : -length;
    }

    std::mt19937 random_;
    std::normal_distribution<double> normal_;
    std::uniform_real_distribution<double> unit_{0.0, 1.0};
};

}  // namespace voxprite::test
