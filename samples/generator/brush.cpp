#include "samples/generator/brush.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace voxprite::samples {

namespace {

struct RampColours {
    const char* name;
    std::array<std::uint32_t, kShades> rgb;  // dark to light
};

constexpr std::array<RampColours, static_cast<std::size_t>(Ramp::count)> kRamps{{
    {"stone", {0x3b3a46, 0x54545f, 0x6f6f78, 0x8b8b90, 0xa9a8a8, 0xc9c6c0}},
    {"steel", {0x2c3547, 0x45536b, 0x657a92, 0x8ba3b5, 0xb4cad4, 0xe2eff2}},
    {"skin", {0x6e3b36, 0x9a5746, 0xc47a5a, 0xe09f78, 0xf2c19a, 0xfbdcbd}},
    {"hair", {0x2a1a1f, 0x432827, 0x603a2d, 0x825134, 0xa76f40, 0xcb9455}},
    {"wood", {0x3a2224, 0x583530, 0x7a4e3b, 0x9c6b48, 0xbd8c5c, 0xdcb07a}},
    {"bark", {0x2b211f, 0x42322b, 0x5b4637, 0x755d46, 0x907758, 0xac9471}},
    {"leaf", {0x16332e, 0x1f4d36, 0x2f6c3b, 0x4b8b3f, 0x74aa45, 0xa8cb57}},
    {"grass", {0x1f4a38, 0x2f653c, 0x478243, 0x679f4b, 0x8cba58, 0xb6d370}},
    {"roof", {0x4a1f2c, 0x6e2d33, 0x963f38, 0xb95840, 0xd67a50, 0xeda26c}},
    {"plaster", {0x7a6a66, 0xa08d80, 0xc1ae98, 0xdccbb0, 0xeee1c6, 0xfbf4df}},
    {"red", {0x4b1530, 0x701f36, 0x9b2c3a, 0xc2433e, 0xdd6a4c, 0xf09a6b}},
    {"blue", {0x1d1f4b, 0x27346f, 0x325293, 0x4276b4, 0x5f9fd0, 0x92c7e3}},
    {"gold", {0x5b331f, 0x8a5423, 0xb87b2b, 0xdca43a, 0xf3cb58, 0xfdeb95}},
    {"glass", {0x24405a, 0x356880, 0x4f93a3, 0x78bcc0, 0xaadfd9, 0xdff7ef}},
    {"soil", {0x2d1f24, 0x45302d, 0x5f4537, 0x7a5d45, 0x957858, 0xb09570}},
    {"blossom", {0x5a2350, 0x8a3568, 0xb94f7c, 0xdd7791, 0xf2a6ac, 0xfdd5d0}},
    {"ink", {0x0f0e17, 0x1c1b28, 0x2b2a38, 0x3c3b49, 0x51505d, 0x6a6974}},
}};

}  // namespace

std::uint8_t shade(Ramp ramp, int step) {
    return static_cast<std::uint8_t>(1 + static_cast<int>(ramp) * kShades +
                                     std::clamp(step, 0, kShades - 1));
}

Palette samplePalette() {
    Palette palette;
    for (std::size_t r = 0; r < kRamps.size(); ++r) {
        for (int s = 0; s < kShades; ++s) {
            const std::uint32_t rgb = kRamps[r].rgb[static_cast<std::size_t>(s)];
            const std::size_t index = shade(static_cast<Ramp>(r), s);
            palette.colours[index] = Rgba8(rgb >> 16, (rgb >> 8) & 0xffu, rgb & 0xffu, 255);
            palette.names[index] = std::string(kRamps[r].name) + ' ' + std::to_string(s + 1);
        }
    }
    // What is left is a plain grey scale, so that an artist finds no holes.
    const std::size_t used = 1 + kRamps.size() * kShades;
    for (std::size_t i = used; i < 256; ++i) {
        const auto grey = static_cast<std::uint8_t>(255 * (i - used) / (255 - used));
        palette.colours[i] = Rgba8(grey, grey, grey, 255);
    }
    return palette;
}

double grain(glm::ivec3 v, std::uint32_t seed) {
    std::uint32_t h = seed * 0x9e3779b9u;
    for (int axis = 0; axis < 3; ++axis) {
        h ^= static_cast<std::uint32_t>(v[axis]) + 0x85ebca6bu + (h << 6) + (h >> 2);
        h *= 0xc2b2ae35u;
        h ^= h >> 15;
    }
    return static_cast<double>(h >> 8) / 16777216.0;
}

Paint grained(Ramp ramp, int step, double amount, std::uint32_t seed) {
    return [=](glm::ivec3 v) {
        const double g = grain(v, seed);
        const int shift = g < amount * 0.5 ? -1 : g > 1.0 - amount * 0.5 ? 1 : 0;
        return shade(ramp, step + shift);
    };
}

Paint plain(Ramp ramp, int step) {
    return [=](glm::ivec3) { return shade(ramp, step); };
}

void Brush::put(glm::ivec3 v, std::uint8_t colour) {
    if (colour != 0) grid_->set(v, colour);
}

void Brush::dot(glm::ivec3 v, std::uint8_t colour) {
    grid_->set(v, colour);
}

void Brush::box(glm::ivec3 a, glm::ivec3 b, const Paint& paint) {
    for (int z = a.z; z <= b.z; ++z)
        for (int y = a.y; y <= b.y; ++y)
            for (int x = a.x; x <= b.x; ++x) put({x, y, z}, paint({x, y, z}));
}

void Brush::box(glm::ivec3 a, glm::ivec3 b, std::uint8_t colour) {
    box(a, b, [colour](glm::ivec3) { return colour; });
}

void Brush::erase(glm::ivec3 a, glm::ivec3 b) {
    grid_->fill({a, b + 1}, 0);
}

void Brush::ellipsoid(glm::dvec3 centre, glm::dvec3 radii, const Paint& paint) {
    const glm::ivec3 low(glm::floor(centre - radii));
    const glm::ivec3 high(glm::ceil(centre + radii));
    box(low, high, [&](glm::ivec3 v) -> std::uint8_t {
        const glm::dvec3 d = (glm::dvec3(v) + 0.5 - centre) / radii;
        return d.x * d.x + d.y * d.y + d.z * d.z <= 1.0 ? paint(v) : std::uint8_t{0};
    });
}

void Brush::cone(glm::dvec2 centre, int z0, int z1, double r0, double r1, const Paint& paint) {
    for (int z = z0; z <= z1; ++z) {
        const double t = z1 == z0 ? 0.0 : static_cast<double>(z - z0) / (z1 - z0);
        const double r = r0 + (r1 - r0) * t;
        const int reach = static_cast<int>(std::ceil(r)) + 1;
        const glm::ivec2 mid(glm::floor(centre));
        for (int y = mid.y - reach; y <= mid.y + reach; ++y)
            for (int x = mid.x - reach; x <= mid.x + reach; ++x) {
                const double dx = x + 0.5 - centre.x;
                const double dy = y + 0.5 - centre.y;
                if (dx * dx + dy * dy <= r * r) put({x, y, z}, paint({x, y, z}));
            }
    }
}

void Brush::limb(glm::dvec3 a, glm::dvec3 b, double radiusA, double radiusB, const Paint& paint) {
    const double reach = std::max(radiusA, radiusB);
    const glm::dvec3 along = b - a;
    const double length2 = along.x * along.x + along.y * along.y + along.z * along.z;
    box(glm::ivec3(glm::floor(glm::min(a, b) - reach)),
        glm::ivec3(glm::ceil(glm::max(a, b) + reach)), [&](glm::ivec3 v) -> std::uint8_t {
            const glm::dvec3 d = glm::dvec3(v) + 0.5 - a;
            const double t =
                length2 > 0.0
                    ? std::clamp((d.x * along.x + d.y * along.y + d.z * along.z) / length2, 0.0,
                                 1.0)
                    : 0.0;
            const glm::dvec3 off = d - along * t;
            const double r = radiusA + (radiusB - radiusA) * t;
            return off.x * off.x + off.y * off.y + off.z * off.z <= r * r ? paint(v)
                                                                          : std::uint8_t{0};
        });
}

void Brush::repaint(glm::ivec3 a, glm::ivec3 b, const Paint& paint) {
    box(a, b, [&](glm::ivec3 v) -> std::uint8_t {
        return grid_->get(v) != 0 ? paint(v) : std::uint8_t{0};
    });
}

Document documentOf(std::string name, VoxelGrid grid) {
    Document document;
    document.palette = samplePalette();
    document.entity.name = name;
    document.models.emplace_back();
    document.models.back().voxels = std::move(grid);
    SceneNode object;
    object.name = std::move(name);
    object.parent = 0;
    object.models = {ModelKey{0, 0}};
    document.nodes.push_back(std::move(object));
    document.nodes[0].children = {1};
    return document;
}

}  // namespace voxprite::samples
