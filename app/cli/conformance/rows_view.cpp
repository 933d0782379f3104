// Rows 4 and 13: from which way the sprite is seen.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "app/cli/conformance/conformance.h"
#include "app/cli/conformance/subjects.h"

namespace voxprite::conformance {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

double angleDegrees(glm::dvec3 a, glm::dvec3 b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * kDegrees;
}

GameProfile profileWith(ViewRule rule) {
    GameProfile profile = plainProfile();
    profile.view = rule;
    return profile;
}

// The camera turned about its own eye.
Camera turnedCamera(Camera camera, double yawDegrees) {
    const SinCos turn = sinCosDegrees(yawDegrees);
    const auto about = [&](glm::dvec3 v) {
        return glm::dvec3(v.x * turn.cos + v.z * turn.sin, v.y, v.z * turn.cos - v.x * turn.sin);
    };
    camera.right = about(camera.right);
    camera.up = about(camera.up);
    camera.forward = about(camera.forward);
    return camera;
}

double changedPercent(const SpriteBuffer& a, const SpriteBuffer& b) {
    const glm::ivec2 first = glm::min(a.first, b.first);
    const glm::ivec2 end = glm::max(a.first + a.size, b.first + b.size);
    const auto idAt = [](const SpriteBuffer& buffer, glm::ivec2 pixel) {
        const glm::ivec2 at = pixel - buffer.first;
        if (at.x < 0 || at.y < 0 || at.x >= buffer.size.x || at.y >= buffer.size.y) return kIdEmpty;
        const int row = buffer.size.y - 1 - at.y;
        return buffer.ids[static_cast<std::size_t>(row * buffer.size.x + at.x)];
    };
    double changed = 0.0;
    for (int y = first.y; y < end.y; ++y)
        for (int x = first.x; x < end.x; ++x)
            changed += idAt(a, {x, y}) != idAt(b, {x, y}) ? 1.0 : 0.0;
    return 100.0 * changed / static_cast<double>(a.opaqueCount());
}

Comparison compareSightLine() {
    Camera camera = orbit(0, 0, 10);
    camera.viewportPx = {1280, 720};
    camera.verticalFovDegrees = 58.0;
    const glm::dvec3 toCorner = camera.rayThrough({40.0, 40.0}).direction;
    const glm::dvec3 centre = camera.eyeMetres + toCorner * 20.0;
    const auto off = [&](ViewRule rule) {
        const GameProfile profile = profileWith(rule);
        return angleDegrees(seen(figure().centredAt(centre, profile), camera, profile).forward,
                            toCorner);
    };
    return {4,
            "view_in_the_corner",
            "the view shown, off the line of sight",
            off(ViewRule::cameraForward),
            off(ViewRule::towardEntity),
            1e-9,
            "degrees",
            "figure in the corner of a 16:9 picture, 58 degrees high"};
}

Comparison compareCameraTurn() {
    const Subject subject = figure();
    const auto worst = [&](ViewRule rule) {
        const GameProfile profile = profileWith(rule);
        const PlacedEntity entity = subject.centredAt({0.4, 0.3, -0.2}, profile);
        double changed = 0.0;
        for (const double yaw : {10.0, 30.0, 75.0}) {
            const Camera before = orbit(yaw, 20, 12);
            const Camera after = turnedCamera(before, 0.1);
            changed = std::max(
                changed,
                changedPercent(cast(subject.octree, seen(entity, before, profile).lattice),
                               cast(subject.octree, seen(entity, after, profile).lattice)));
        }
        return changed;
    };
    return {4,
            "camera_turn",
            "pixels that change when the camera turns by 0.1 degrees",
            worst(ViewRule::cameraForward),
            worst(ViewRule::towardEntity),
            0.0,
            "%",
            "figure, sigma 4, the worst of three views"};
}

// Row 13: the eye trembles right above the entity.
Comparison comparePole() {
    const GameProfile profile = profileWith(ViewRule::towardEntity);
    const PlacedEntity entity = figure().centredAt(glm::dvec3(0.0), profile);
    const auto worstJump = [&](ViewHistory* history) {
        Sequence random(13);
        Camera camera = orbit(0, 90, 12);
        const glm::dvec3 eye = camera.eyeMetres;
        camera.eyeMetres = eye + glm::dvec3(0.0, 0.0, 0.5);
        glm::dvec3 before = seen(entity, camera, profile, history).up;
        double worst = 0.0;
        for (int n = 0; n < 200; ++n) {
            camera.eyeMetres =
                eye + glm::dvec3(random.between(-0.01, 0.01), 0.0, random.between(-0.01, 0.01));
            const glm::dvec3 up = seen(entity, camera, profile, history).up;
            worst = std::max(worst, angleDegrees(up, before));
            before = up;
        }
        return worst;
    };
    ViewHistory history;
    return {13,
            "pole",
            "the picture's roll from one frame to the next",
            worstJump(nullptr),
            worstJump(&history),
            5.0,
            "degrees",
            "the eye 12 m above a figure, trembling by 1 cm, 200 frames; worst"};
}

}  // namespace

void compareView(Comparisons& all) {
    all.push_back(compareSightLine());
    all.push_back(compareCameraTurn());
    all.push_back(comparePole());
}

}  // namespace voxprite::conformance
