// Rows 10, 11 and 19: depth, and worlds that are large.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "app/cli/conformance/conformance.h"
#include "app/cli/conformance/literal.h"
#include "app/cli/conformance/subjects.h"
#include "core/sprite/composite.h"

namespace voxprite::conformance {
namespace {

// How much deeper than `depth` something must be to be told from it.
template <class Stored>
double resolutionAt(double depth, const Stored& stored) {
    double same = 0.0;
    double other = 100.0;
    for (int n = 0; n < 80; ++n) {
        const double middle = 0.5 * (same + other);
        (stored(depth + middle) == stored(depth) ? same : other) = middle;
    }
    return other;
}

// Row 10.
void compareDepthBuffers(Comparisons& all) {
    Camera camera;
    camera.nearMetres = 0.1;
    double literal = 0.0;
    double ours = 0.0;
    for (double depth = 1000.0; depth < 1010.0; depth += 0.37) {
        literal = std::max(literal, resolutionAt(depth, [&](double metres) {
                               return depth24(camera.nearMetres, 10'000.0, metres);
                           }));
        ours = std::max(
            ours, resolutionAt(depth, [&](double metres) { return camera.reversedDepth(metres); }));
    }
    all.push_back({10, "depth_resolution", "depths that cannot be told apart at 1 km", literal,
                   ours, 2e-4, "m", "near plane at 0.1 m: 24 bits against reversed 32-bit float"});

    // A vertex stage that hands over z = w * (z_c / w_c) with the corner's own w, or with w = 1;
    // what is drawn divides by it again.
    Sequence random(10);
    double literalOff = 0.0, oursOff = 0.0;
    const int tries = 10'000;
    const auto isOff = [](float depth, float cornerW) {
        const volatile float w = cornerW;
        const volatile float z = w * depth;
        return z / w != depth ? 1.0 : 0.0;
    };
    for (int n = 0; n < tries; ++n) {
        const auto depth = static_cast<float>(random.between(0.0, 1.0));
        literalOff += isOff(depth, static_cast<float>(random.between(0.1, 100.0)));
        oursOff += isOff(depth, 1.0f);
    }
    all.push_back({10, "one_depth", "corners whose depth is not the sprite's one value",
                   100.0 * literalOff / tries, 100.0 * oursOff / tries, 0.0, "%",
                   "w * (z / w) in fp32 at random w; with w = 1 it is the value itself"});
}

// Row 11: the sprite's corners on the screen, by fp32 matrices over world coordinates and by
// camera-relative fp32.
void compareLargeWorlds(Comparisons& all) {
    const GameProfile profile = plainProfile();
    const Subject subject = cube32();
    for (const double kilometres : {100.0, 1000.0}) {
        Sequence random(11);
        double literal = 0.0;
        double ours = 0.0;
        double count = 0.0;
        for (int n = 0; n < 500; ++n) {
            const glm::dvec3 place =
                glm::normalize(glm::dvec3(random.between(-1, 1), random.between(-0.2, 0.2),
                                          random.between(-1, 1))) *
                kilometres * 1e3;
            const OrbitAngles angles{random.between(0, 360), random.between(-40, 40), 0.0};
            const Camera camera = orbitCamera(angles, place, 12.0, 45.0, {1024, 1024});
            const SpriteView view = seen(subject.centredAt(place, profile), camera, profile);
            for (const glm::dvec3& corner :
                 quadFromEye(view, view.lattice.first, view.lattice.size)) {
                const glm::dvec2 truth = camera.projectFromEye(corner).screenPx;
                const glm::dvec2 world =
                    projectThroughFp32World(camera, place, corner - view.centreFromEyeMetres);
                const glm::vec4 clip =
                    glm::mat4(camera.clipFromCameraRelative()) * glm::vec4(glm::vec3(corner), 1.0f);
                const glm::dvec2 ndc = glm::dvec2(clip.x, -clip.y) / static_cast<double>(clip.w);
                const glm::dvec2 relative = (ndc * 0.5 + 0.5) * glm::dvec2(camera.viewportPx);
                const auto squaredVpx = [&](glm::dvec2 px) {
                    const glm::dvec2 off = (px - truth) / view.screenPxPerPx;
                    return glm::dot(off, off);
                };
                literal += squaredVpx(world);
                ours += squaredVpx(relative);
                ++count;
            }
        }
        const std::string key = std::to_string(static_cast<int>(kilometres)) + "_km";
        all.push_back({11, "world_" + key,
                       "rms error of a corner's place, " +
                           std::to_string(static_cast<int>(kilometres)) + " km from the origin",
                       std::sqrt(literal / count), std::sqrt(ours / count), 1e-3, "vpx",
                       "cube 12 m away, 500 places: fp32 matrices against camera-relative"});
    }
}

// Row 19: the share of the sprite's screen pixels that the ground under it hides.
double hiddenPercent(const Subject& subject, const Camera& camera, DepthRule rule) {
    constexpr Rgba8 red{255, 0, 0, 255};
    GameProfile profile = plainProfile();
    profile.depth = rule;
    const PlacedEntity entity = subject.centredAt(glm::dvec3(0.0), profile);
    const SpriteView view = seen(entity, camera, profile);
    LitPalette lit;
    lit.faces = LitPalette::allFaces(red);
    lit.outline.colour = red;
    const SpriteBuffer buffer = castSprite(subject.octree.view(), view.lattice, lit);
    const std::array<CompositeSprite, 1> sprites{CompositeSprite{&view, &buffer, nullptr}};
    Ground ground;
    ground.heightMetres = entity.anchorMetres.y - groundClearanceMetres(profile);
    const auto count = [&](const Image& image) {
        return static_cast<double>(std::count(image.pixels.begin(), image.pixels.end(), red));
    };
    const double all = count(composite(sprites, camera, Rgba8(0)));
    return 100.0 * (1.0 - count(composite(sprites, camera, Rgba8(0), ground)) / all);
}

void compareGround(Comparisons& all) {
    for (const Subject& subject : {cube32(), vehicle(), slab()}) {
        double literal = 0.0;
        double ours = 0.0;
        for (const double pitch : {15.0, 30.0})
            for (const double yaw : {0.0, 35.0}) {
                const Camera camera = orbit(yaw, pitch, 12, 256);
                literal = std::max(literal, hiddenPercent(subject, camera, DepthRule::centre));
                ours = std::max(ours, hiddenPercent(subject, camera, DepthRule::groundSafe));
            }
        all.push_back({19, "ground_" + subject.name,
                       "of a " + subject.name + ", pixels hidden by the ground it stands on",
                       literal, ours, 0.0, "%",
                       "sigma 4, 12 m away, pitch 15 and 30, one vpx of clearance; worst of four"});
    }
}

}  // namespace

void compareDepth(Comparisons& all) {
    compareDepthBuffers(all);
    compareLargeWorlds(all);
    compareGround(all);
}

}  // namespace voxprite::conformance
