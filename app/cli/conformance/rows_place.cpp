// Rows 1, 2, 3, 5, 6 and 14: where and how large the sprite stands.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "app/cli/conformance/conformance.h"
#include "app/cli/conformance/literal.h"
#include "app/cli/conformance/subjects.h"
#include "core/trace/ideal_caster.h"

namespace voxprite::conformance {
namespace {

// Virtual pixel coordinates (not floored), from the model's centre, under a screen position.
glm::dvec2 oursFromCentre(const SpriteView& view, const Camera& camera, glm::dvec2 screenPx) {
    const glm::dvec3 p = pixelFromScreen(view, camera) * glm::dvec3(screenPx, 1.0);
    return glm::dvec2(p.x, p.y) / p.z - view.pixelFromCentre;
}

// The middle of the screen pixels for which `shows` holds, in metres on the plane at `depth`.
template <class Shows>
glm::dvec2 middleOnPlane(const Camera& camera, double depthMetres, const Shows& shows) {
    glm::dvec2 sum(0.0);
    double count = 0.0;
    for (int y = 0; y < camera.viewportPx.y; ++y)
        for (int x = 0; x < camera.viewportPx.x; ++x) {
            const glm::dvec2 screenPx = glm::dvec2(x, y) + 0.5;
            if (!shows(screenPx)) continue;
            sum += screenPx;
            ++count;
        }
    return sum / std::max(count, 1.0) * camera.metresPerScreenPx(depthMetres);
}

// Row 1: the same fragments, once mapped as section 5.1 says and cast as section 6.3 says.
Comparison compareRegistration() {
    const Subject subject = solidBox({32, 16, 64});
    const GameProfile profile = plainProfile();
    const Camera camera = orbit(0, 0, 24, 256);
    const PlacedEntity entity = subject.centredAt(glm::dvec3(0.0), profile);
    const SpriteView view = seen(entity, camera, profile);
    const SpriteBuffer buffer = cast(subject.octree, view.lattice);
    const glm::dmat3 axes = literalVoxelAxes(camera);
    const double distance = euclideanDistance(camera, entity.anchorMetres);
    const auto literalShows = [&](glm::dvec2 screenPx) {
        const glm::dvec2 uv =
            glm::round(literalAnchorOffset(camera, entity.anchorMetres, distance, 0.1, screenPx) *
                       profile.sigma) /
            profile.sigma;
        const glm::dvec3 start = entity.centreVoxels() + axes[0] * uv.x + axes[1] * uv.y;
        return castCells(subject.octree.view(), {start.x, start.y, start.z},
                         {axes[2].x, axes[2].y, axes[2].z})
                   .material != 0;
    };
    const auto oursShows = [&](glm::dvec2 screenPx) {
        const auto pixel = pixelUnder(view, camera, screenPx);
        if (!pixel) return false;
        const glm::ivec2 at = *pixel - buffer.first;
        if (at.x < 0 || at.y < 0 || at.x >= buffer.size.x || at.y >= buffer.size.y) return false;
        const int row = buffer.size.y - 1 - at.y;
        return buffer.ids[static_cast<std::size_t>(row * buffer.size.x + at.x)] >= kIdFirstVoxel;
    };
    const double depth = view.planeDepthMetres;
    const glm::dvec2 centre =
        camera.project(entity.centreMetres()).screenPx * camera.metresPerScreenPx(depth);
    return {1,
            "registration",
            "the sprite's middle from where the model's centre truly projects",
            glm::length(middleOnPlane(camera, depth, literalShows) - centre),
            glm::length(middleOnPlane(camera, depth, oursShows) - centre),
            view.metresPerPx,
            "m",
            "32x16x64 box of 0.1 m voxels, bottom-centre anchor, seen from the front"};
}

// Row 2: where the sprite plane comes to lie.
Comparison compareAnchorToCentre() {
    const GameProfile profile = plainProfile();
    const PlacedEntity entity = placeEntity(Entity{}, {glm::ivec3(0), glm::ivec3(128)}, profile);
    const Camera camera = orbit(0, 0, 60);
    const glm::dvec3 truth = entity.worldFromVoxel(glm::dvec3(64.0));
    const glm::dvec3 literal =
        entity.worldFromVoxel(entity.anchor + literalAnchorToCentre(entity.modelSize));
    const glm::dvec3 ours = camera.eyeMetres + seen(entity, camera, profile).centreFromEyeMetres;
    return {2,
            "anchor_to_center",
            "the sprite plane's centre from the model's",
            glm::length(literal - truth),
            glm::length(ours - truth),
            1e-9,
            "m",
            "128 cubed of 0.1 m voxels, bottom-centre anchor"};
}

// Row 3: how much too small a sprite appears off the axis.
void compareDistance(Comparisons& all) {
    GameProfile profile = plainProfile();
    profile.view = ViewRule::cameraForward;
    const Subject subject = cube32();
    Camera camera = orbit(0, 0, 12);
    camera.verticalFovDegrees = 100.0;
    for (const int degrees : {30, 45}) {
        const double across = 12.0 * std::tan(degrees * std::numbers::pi / 180.0);
        const PlacedEntity entity = subject.centredAt(camera.right * across, profile);
        const SpriteView view = seen(entity, camera, profile);
        const glm::dvec2 at = camera.project(entity.centreMetres()).screenPx;
        const glm::dvec2 aside = at + glm::dvec2(10.0, 0.0);
        // What 10 screen pixels span, in virtual pixels; the model spans more the smaller this is.
        const double truth = 10.0 * camera.metresPerScreenPx(12.0) / view.metresPerPx;
        const double distance = euclideanDistance(camera, entity.centreMetres());
        const auto literalAt = [&](glm::dvec2 px) {
            return literalAnchorOffset(camera, entity.centreMetres(), distance, 0.1, px).x *
                   profile.sigma;
        };
        const double literal = literalAt(aside) - literalAt(at);
        const double ours =
            oursFromCentre(view, camera, aside).x - oursFromCentre(view, camera, at).x;
        all.push_back({3, "camera_distance_" + std::to_string(degrees),
                       "too small by, " + std::to_string(degrees) + " degrees off the axis",
                       100.0 * (1.0 - truth / literal), 100.0 * std::abs(1.0 - truth / ours), 1e-6,
                       "%", "cube, camera_forward, 12 m before the camera's plane"});
    }
}

// Row 5: a proxy box that is turned.
Comparison compareRotation() {
    Subject subject = letters();
    subject.entity.yawDegrees = 60.0;
    const GameProfile profile = plainProfile();
    const Camera camera = orbit(20, 25, 4);
    const SpriteView view = seen(subject.centredAt(glm::dvec3(0.0), profile), camera, profile);
    const glm::dmat3 axes = literalVoxelAxes(camera);
    const OrthoView literal{axes[0], axes[1], axes[2], view.ortho.sigmaInForce};
    const LatticeCaster caster(subject.octree.view(), view.lattice);
    double shown = 0.0;
    double wrong = 0.0;
    double oursWrong = 0.0;
    for (int j = 0; j < view.lattice.size.y; ++j)
        for (int i = 0; i < view.lattice.size.x; ++i) {
            const glm::ivec2 pixel = view.lattice.first + glm::ivec2(i, j);
            const LatticeHit truth = castIdeal(subject.octree.view(), view.ortho, pixel);
            const LatticeHit read = castIdeal(subject.octree.view(), literal, pixel);
            const LatticeHit own = caster.cast(pixel);
            const auto differ = [&](const LatticeHit& hit) {
                return hit.material != truth.material || hit.voxel != truth.voxel;
            };
            shown += truth.material != 0 || read.material != 0 ? 1.0 : 0.0;
            wrong += differ(read) ? 1.0 : 0.0;
            oursWrong += differ(own) ? 1.0 : 0.0;
        }
    return {5,
            "entity_rotation",
            "pixels that show another voxel than they should",
            100.0 * wrong / shown,
            100.0 * oursWrong / shown,
            1.0,
            "%",
            "letters, the proxy box turned by 60 degrees"};
}

// Row 6: an entity of scale 2.
Comparison compareScale() {
    Subject subject = cube32();
    subject.entity.scale = 2.0;
    const GameProfile profile = plainProfile();
    const Camera camera = orbit(0, 0, 24);
    const PlacedEntity entity = subject.centredAt(glm::dvec3(0.0), profile);
    const SpriteView view = seen(entity, camera, profile);
    const auto widthMetres = [&](const LatticeView& lattice) {
        return (lattice.size.x - 2) * view.metresPerPx;  // the bounds have the outline's two more
    };
    const double truth = 32 * entity.metresPerVoxel();
    const double literal =
        widthMetres(quantised(orthoView({}, profile.sigma), subject.octree.size));
    return {6,
            "entity_scale",
            "the sprite's width off the scaled model's",
            100.0 * std::abs(1.0 - literal / truth),
            100.0 * std::abs(1.0 - widthMetres(view.lattice) / truth),
            1e-9,
            "%",
            "cube at scale 2, seen from the front: u = metres / VoxelSize knows no scale"};
}

// Row 14: an orthographic camera, and an anchor behind the eye.
void compareOddCameras(Comparisons& all) {
    const GameProfile profile = plainProfile();
    const Subject subject = cube32();
    Camera camera = orbit(0, 0, 12);
    camera.orthographic = true;
    camera.orthographicHeightMetres = 8.0;
    const PlacedEntity entity = subject.centredAt(glm::dvec3(0.0), profile);
    const glm::dvec2 at = glm::dvec2(camera.viewportPx) * 0.5;
    const glm::dvec2 aside = at + glm::dvec2(10.0, 0.0);
    const SpriteView view = seen(entity, camera, profile);
    const double truth = 10.0 * camera.metresPerScreenPx(12.0) / view.metresPerPx;
    const auto literalAt = [&](glm::dvec2 px) {
        return literalAnchorOffset(camera, entity.centreMetres(), 12.0, 0.1, px).x * profile.sigma;
    };
    const double ours = oursFromCentre(view, camera, aside).x - oursFromCentre(view, camera, at).x;
    all.push_back({14, "orthographic", "too small by, with an orthographic camera",
                   100.0 * (1.0 - truth / (literalAt(aside) - literalAt(at))),
                   100.0 * std::abs(1.0 - truth / ours), 1e-6, "%",
                   "cube, 12 m away: section 5.1 multiplies by camera_distance"});

    // The anchor lies 2 m behind the eye, the model 4 m before it and a little aside.
    const Camera eye = orbit(0, 0, 12);
    const glm::dvec3 anchor = eye.eyeMetres - eye.forward * 2.0 + eye.right;
    const glm::dvec3 centre = eye.eyeMetres + eye.forward * 4.0 + eye.right;
    Subject far = cube32();
    const glm::dvec3 offset = voxelFromWorld(anchor - centre) / 0.1;
    far.entity.anchorVoxels = glm::dvec3(16.0) + offset;
    const PlacedEntity placed = far.centredAt(centre, profile);
    const SpriteView behind = seen(placed, eye, profile);
    const glm::dvec2 truePx = eye.project(centre).screenPx;
    // Row 1 decided as we do: what the anchor formula shows at the centre, less the anchor's own
    // offset in the sprite plane.
    const double distance = euclideanDistance(eye, anchor);
    const glm::dvec2 literal =
        literalAnchorOffset(eye, placed.anchorMetres, distance, 0.1, truePx) * profile.sigma;
    const glm::dvec2 anchorInPlane =
        glm::dvec2(glm::dot(centre - anchor, eye.right), glm::dot(centre - anchor, eye.up)) /
        behind.metresPerPx;
    all.push_back({14, "anchor_behind_eye", "the sprite's place, with the anchor behind the eye",
                   glm::length(literal - anchorInPlane),
                   glm::length(oursFromCentre(behind, eye, truePx)), 1e-6, "vpx",
                   "cube 4 m ahead and 1 m aside, its anchor 2 m behind the eye"});
}

}  // namespace

void comparePlace(Comparisons& all) {
    all.push_back(compareRegistration());
    all.push_back(compareAnchorToCentre());
    compareDistance(all);
    all.push_back(compareRotation());
    all.push_back(compareScale());
    compareOddCameras(all);
}

}  // namespace voxprite::conformance
