#include "tests/core/trace/exact_caster.h"

#include <algorithm>

namespace voxprite::test {
namespace {

// At time numerator / denominator, denominator > 0.
struct Crossing {
    std::int64_t numerator;
    std::int64_t denominator;
    int axis;
    int cellBehind;
};

// All of a line's crossings in their order, and its cell before the first.
std::vector<Crossing> crossingsOf(const DenseModel& model, const LatticeRay& ray,
                                  glm::ivec3& cell) {
    const std::int64_t steps = std::int64_t{1} << ray.positionBits;
    std::vector<Crossing> crossings;
    cell = glm::ivec3(0);
    for (int a = 0; a < 3; ++a) {
        const std::int64_t d = ray.direction[a];
        if (d == 0) {
            cell[a] = static_cast<int>(ray.origin[a] >> ray.positionBits);
            continue;
        }
        cell[a] = d > 0 ? -1 : model.size[a];
        for (int k = 0; k <= model.size[a]; ++k) {
            const std::int64_t n = k * steps - ray.origin[a];
            crossings.push_back({d > 0 ? n : -n, std::abs(d), a, d > 0 ? k : k - 1});
        }
    }
    std::sort(crossings.begin(), crossings.end(), [](const Crossing& p, const Crossing& q) {
        const std::int64_t left = p.numerator * q.denominator;
        const std::int64_t right = q.numerator * p.denominator;
        return left != right ? left < right : p.axis < q.axis;
    });
    return crossings;
}

}  // namespace

LatticeHit castExact(const DenseModel& model, const LatticeRay& ray) {
    glm::ivec3 cell;
    for (const Crossing& crossing : crossingsOf(model, ray, cell)) {
        cell[crossing.axis] = crossing.cellBehind;
        if (const std::uint8_t material = model.at(cell); material != 0)
            return {material, static_cast<std::uint8_t>(crossing.axis), cell};
    }
    return {};
}

bool startsInside(const DenseModel& model, const LatticeRay& ray) {
    bool inside = true;
    for (int a = 0; a < 3; ++a)
        inside = inside && ray.origin[a] >= 0 &&
                 ray.origin[a] < std::int64_t{model.size[a]} << ray.positionBits;
    return inside;
}

LatticeHit castExactRay(const DenseModel& model, const LatticeRay& ray, bool inside) {
    for (int a = 0; a < 3 && !inside; ++a) {
        const bool below = ray.origin[a] < 0;
        const bool above = ray.origin[a] >= std::int64_t{model.size[a]} << ray.positionBits;
        if ((below && ray.direction[a] <= 0) || (above && ray.direction[a] >= 0)) return {};
    }
    glm::ivec3 cell;
    const std::vector<Crossing> crossings = crossingsOf(model, ray, cell);
    const auto ahead = std::find_if(crossings.begin(), crossings.end(), [&](const Crossing& c) {
        return inside ? c.numerator > 0 : c.numerator >= 0;
    });
    for (auto c = crossings.begin(); c != ahead; ++c) cell[c->axis] = c->cellBehind;
    if (inside && model.at(cell) != 0) return {model.at(cell), 3, cell};
    for (auto c = ahead; c != crossings.end(); ++c) {
        cell[c->axis] = c->cellBehind;
        if (const std::uint8_t material = model.at(cell); material != 0)
            return {material, static_cast<std::uint8_t>(c->axis), cell};
    }
    return {};
}

bool sameHit(const LatticeHit& a, const LatticeHit& b) {
    return a.material == b.material &&
           (a.material == 0 || (a.faceAxis == b.faceAxis && a.voxel == b.voxel));
}

std::string describe(const LatticeHit& hit) {
    if (hit.material == 0) return "nothing";
    return "material " + std::to_string(hit.material) + " at " + std::to_string(hit.voxel.x) + "," +
           std::to_string(hit.voxel.y) + "," + std::to_string(hit.voxel.z) + " through axis " +
           std::to_string(hit.faceAxis);
}

std::string describe(const LatticeRay& ray) {
    return "origin " + std::to_string(ray.origin.x) + "," + std::to_string(ray.origin.y) + "," +
           std::to_string(ray.origin.z) + " direction " + std::to_string(ray.direction.x) + "," +
           std::to_string(ray.direction.y) + "," + std::to_string(ray.direction.z) + " P " +
           std::to_string(ray.positionBits);
}

}  // namespace voxprite::test
