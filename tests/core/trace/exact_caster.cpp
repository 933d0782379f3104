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

}  // namespace

LatticeHit castExact(const DenseModel& model, const LatticeRay& ray) {
    const std::int64_t steps = std::int64_t{1} << ray.positionBits;
    std::vector<Crossing> crossings;
    glm::ivec3 cell{0};
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
    for (const Crossing& crossing : crossings) {
        cell[crossing.axis] = crossing.cellBehind;
        if (const std::uint8_t material = model.at(cell); material != 0)
            return {material, static_cast<std::uint8_t>(crossing.axis), cell};
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
