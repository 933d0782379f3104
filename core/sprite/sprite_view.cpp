#include "core/sprite/sprite_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>

#include "core/base/finite.h"
#include "core/sprite/lattice_memo.h"
#include "core/sprite/sprite_depth.h"
#include "core/sprite/view_axes.h"
#include "core/sprite/view_set.h"

namespace voxprite {

namespace {

constexpr double kLeastSpritePx = 2.0;  // along the model's longest edge
// Once halved, sigma is doubled again only when a virtual pixel would then be this wide.
constexpr double kDoublingScreenPx = 1.25;
// A finer step than this snaps nothing (and would not fit an int).
constexpr double kLeastViewStep = 1e-6;

// The profile's sigma, brought by powers of two to where sigma * scale is in range.
double sigmaInRange(double sigma, double scale) {
    while (sigma * scale > kMostSigma) sigma *= 0.5;
    while (sigma * scale < kLeastSigma) sigma *= 2.0;
    return sigma;
}

// How often sigma is halved so that a virtual pixel, `screenPx` wide before, covers a screen pixel.
int halvingsFor(double screenPx, double pxPerVoxel, int longestEdge,
                const std::optional<int>& before) {
    const auto needed = [&](double wantedScreenPx) {
        int halvings = 0;
        double width = screenPx;
        double density = 0.5 * pxPerVoxel;
        while (width < wantedScreenPx && density >= kLeastSigma &&
               density * longestEdge >= kLeastSpritePx) {
            ++halvings;
            width *= 2.0;
            density *= 0.5;
        }
        return halvings;
    };
    const int least = needed(1.0);
    return before ? std::clamp(*before, least, needed(kDoublingScreenPx)) : least;
}

bool insideProxy(const PlacedEntity& entity, glm::dvec3 centreFromEye, double sigmaInForce) {
    const glm::dvec3 eye = glm::transpose(entity.worldFromVoxelAxes) * centreFromEye;
    const glm::dvec3 half = proxyHalfMetres(entity, sigmaInForce);
    return std::abs(eye.x) <= half.x && std::abs(eye.y) <= half.y && std::abs(eye.z) <= half.z;
}

// Registration at the anchor: by how much the sprite moves in its plane, so that the anchor's place
// in the (parallel) sprite comes to lie where the eye sees the anchor.
glm::dvec2 anchorShiftPx(const SpriteView& view, const PlacedEntity& entity, const Camera& camera) {
    const glm::dvec3 anchorFromEye = entity.anchorMetres - camera.eyeMetres;
    const double anchorDepth = glm::dot(anchorFromEye, camera.forward);
    if (anchorDepth <= camera.nearMetres) return glm::dvec2(0.0);
    // Where the eye ray to the anchor meets the sprite plane, from the centre.
    const glm::dvec3 along = camera.orthographic ? camera.forward : anchorFromEye;
    const double speed = glm::dot(along, view.forward);
    if (speed <= 1e-9 * glm::length(along)) return glm::dvec2(0.0);
    const glm::dvec3 anchorFromCentre = anchorFromEye - view.centreFromEyeMetres;
    const glm::dvec3 seen =
        anchorFromCentre - along * (glm::dot(anchorFromCentre, view.forward) / speed);
    const glm::dvec3 drawn = (entity.anchor - entity.centreVoxels()) * view.ortho.sigmaInForce;
    return {glm::dot(seen, view.right) / view.metresPerPx - glm::dot(drawn, view.ortho.right),
            glm::dot(seen, view.up) / view.metresPerPx - glm::dot(drawn, view.ortho.up)};
}

// Samples lie at (k + offset) virtual pixels from the lattice corner nearest the centre, each in
// the middle of its pixel.
glm::dvec2 pixelFromCentreOf(const OrthoView& ortho, const PlacedEntity& entity) {
    const glm::dvec3 cornerFromCentre =
        (glm::dvec3(entity.modelSize / 2) - entity.centreVoxels()) * ortho.sigmaInForce;
    const glm::dvec2 corner{glm::dot(cornerFromCentre, ortho.right),
                            glm::dot(cornerFromCentre, ortho.up)};
    return 0.5 - sampleOffsetPx(ortho.sigmaInForce) - corner;
}

// The nearest view of the set instead of `seen`, and the plane turned to match it.
void snapToSet(const ViewSet& views, glm::ivec3 size, SpriteView& view, glm::dmat3& plane,
               glm::dmat3& seen, ViewHistory* history) {
    const std::optional<int> before = history != nullptr ? history->viewOfSet : std::nullopt;
    const int nearest = *views.nearest(-seen[2], before);  // the axes are finite
    if (history != nullptr) history->viewOfSet = nearest;
    const glm::dmat3 shown = views.axes(nearest);
    view.viewOfSet = nearest;
    view.degreesOff = glm::degrees(angleBetween(shown[2], seen[2]));
    if (views.roll == SnapshotRoll::matched) plane = rolledToMatch(plane, seen, shown, size);
    seen = shown;
}

Result<SpriteView> makeView(const PlacedEntity& entity, const Camera& camera,
                            const GameProfile& profile, glm::dvec3 centreFromEye,
                            double sigmaInForce, const ViewSet* views, ViewHistory* history,
                            LatticeMemo* lattices) {
    SpriteView view;
    view.sigmaInForce = sigmaInForce;
    view.metresPerPx = entity.voxelSizeMetres / sigmaInForce;
    view.centreFromEyeMetres = centreFromEye;
    view.planeDepthMetres = glm::dot(centreFromEye, camera.forward);
    view.screenPxPerPx = view.metresPerPx / camera.metresPerScreenPx(view.planeDepthMetres);
    view.proxy = profile.proxy;
    view.boxAxes = entity.worldFromVoxelAxes;
    view.boxHalfMetres = proxyHalfMetres(entity, sigmaInForce);

    glm::dmat3 plane = planeAxes(entity, camera, profile.view, centreFromEye, history);
    const glm::dmat3 voxelFromWorldAxes = glm::transpose(entity.worldFromVoxelAxes);
    glm::dmat3 seen = voxelFromWorldAxes * plane;
    if (views != nullptr)
        snapToSet(*views, entity.modelSize, view, plane, seen, history);
    else if (profile.viewStepDegrees >= kLeastViewStep)
        seen = snapAxes(seen, profile.viewStepDegrees, history);
    view.right = plane[0];
    view.up = plane[1];
    view.forward = plane[2];
    view.ortho = {seen[0], seen[1], seen[2], sigmaInForce * entity.scale};
    auto lattice = lattices != nullptr ? lattices->quantise(view.ortho, entity.modelSize)
                                       : quantiseView(view.ortho, entity.modelSize);
    if (!lattice) return Failure(lattice.error());
    view.lattice = *lattice;
    view.light8 = faceLights(view.lattice.D, voxelFromWorldAxes, profile.light);

    if (profile.registration == Registration::anchor)
        view.registrationShiftPx = anchorShiftPx(view, entity, camera);
    view.pixelFromCentre = pixelFromCentreOf(view.ortho, entity) - view.registrationShiftPx;
    // As drawn: the snapped picture's axes lie along those of the plane.
    const glm::dvec3 forwardInPlane = camera.forward * plane;
    view.depthPerVoxelMetres = seen * forwardInPlane * entity.metresPerVoxel();
    view.centreVoxels = entity.centreVoxels();
    view.depthMetres = spriteDepth(view, entity, camera, profile.depth);
    return view;
}

Result<SpriteViewResult> viewFrom(const PlacedEntity& entity, const Camera& camera,
                                  const GameProfile& profile, const ViewSet* views,
                                  ViewHistory* history, LatticeMemo* lattices) {
    if (auto ok = validate(camera); !ok) return Failure(ok.error());
    if (auto ok = validate(profile); !ok) return Failure(ok.error());
    if (auto ok = validate(entity); !ok) return Failure(ok.error());
    const auto unseen = [](Unseen why) { return SpriteViewResult{std::nullopt, why}; };
    const glm::ivec3 size = entity.modelSize;
    if (size.x == 0 || size.y == 0 || size.z == 0) return unseen(Unseen::emptyModel);

    // Summed so that the large parts cancel first.
    const glm::dvec3 centreFromEye =
        (entity.anchorMetres - camera.eyeMetres) +
        entity.worldFromVoxelAxes *
            ((entity.centreVoxels() - entity.anchor) * entity.metresPerVoxel());
    const double distance = glm::length(centreFromEye);
    if (!finite(centreFromEye) || !std::isfinite(distance))
        return fail("the entity is too far from the camera");

    double sigma = sigmaInRange(profile.sigma, entity.scale);
    const double planeDepth = glm::dot(centreFromEye, camera.forward);
    const bool behind = planeDepth <= camera.nearMetres;
    if (!behind && profile.minification) {
        // By distance where the view goes by the eye's place alone: turning the camera then changes
        // nothing. Off the axis a virtual pixel is only wider than this.
        const double depth = profile.view == ViewRule::towardEntity ? distance : planeDepth;
        const double screenPx = entity.voxelSizeMetres / sigma / camera.metresPerScreenPx(depth);
        const int halvings =
            halvingsFor(screenPx, sigma * entity.scale, std::max({size.x, size.y, size.z}),
                        history != nullptr ? history->halvings : std::nullopt);
        if (history != nullptr) history->halvings = halvings;
        sigma = std::ldexp(sigma, -halvings);
    }
    if (insideProxy(entity, centreFromEye, sigma)) return unseen(Unseen::cameraInside);
    if (behind) return unseen(Unseen::behindCamera);
    if (views != nullptr && entity.radiusMetres() < camera.metresPerScreenPx(planeDepth))
        return unseen(Unseen::subPixel);

    const auto seenAt = [&](double sigmaInForce) {
        return makeView(entity, camera, profile, centreFromEye, sigmaInForce, views, history,
                        lattices);
    };
    Result<SpriteView> view = seenAt(sigma);
    // A large model close by: a coarser sprite instead of none.
    while (!view && profile.minification && sigma * entity.scale * 0.5 >= kLeastSigma) {
        sigma *= 0.5;
        Result<SpriteView> coarser = seenAt(sigma);
        if (coarser) view = std::move(coarser);
    }
    if (!view) return Failure(view.error());
    return SpriteViewResult{*view, std::nullopt};
}

}  // namespace

Result<SpriteViewResult> viewSprite(const PlacedEntity& entity, const Camera& camera,
                                    const GameProfile& profile, ViewHistory* history,
                                    LatticeMemo* lattices) {
    return viewFrom(entity, camera, profile, nullptr, history, lattices);
}

Result<SpriteViewResult> viewSnapshot(const PlacedEntity& entity, const Camera& camera,
                                      const GameProfile& profile, const ViewSet& views,
                                      ViewHistory* history, LatticeMemo* lattices) {
    return viewFrom(entity, camera, profile, &views, history, lattices);
}

glm::dmat3 pixelFromScreen(const SpriteView& view, const Camera& camera) {
    // The eye ray's start and direction are affine in the screen position; columns are x, y, 1.
    const double metresPerPx = camera.metresPerScreenPx(1.0);
    const glm::dvec2 middle = glm::dvec2(camera.viewportPx) * 0.5;
    const glm::dmat3 across(camera.right * metresPerPx, -camera.up * metresPerPx,
                            (camera.up * middle.y - camera.right * middle.x) * metresPerPx);
    const glm::dvec3 centre = view.centreFromEyeMetres;
    const glm::dvec3 right = view.right / view.metresPerPx;
    const glm::dvec3 up = view.up / view.metresPerPx;
    glm::dvec3 x, y, z;  // rows
    if (camera.orthographic) {
        // start + t * forward, met with the plane; the start lies in the eye's plane.
        const double speed = glm::dot(camera.forward, view.forward);
        const glm::dvec3 t = -(view.forward * across) / speed;
        const glm::dvec3 tCentre{0, 0, glm::dot(centre, view.forward) / speed};
        x = right * across + (t + tCentre) * glm::dot(camera.forward, right);
        y = up * across + (t + tCentre) * glm::dot(camera.forward, up);
        x.z += view.pixelFromCentre.x - glm::dot(centre, right);
        y.z += view.pixelFromCentre.y - glm::dot(centre, up);
        z = {0, 0, speed};
        x *= speed;
        y *= speed;
    } else {
        // u = (centre.n / d.n) * d.right + pixelFromCentre - centre.right, times d.n.
        glm::dmat3 direction = across;
        direction[2] += camera.forward;
        const double distance = glm::dot(centre, view.forward);
        z = view.forward * direction;
        x = right * direction * distance + z * (view.pixelFromCentre.x - glm::dot(centre, right));
        y = up * direction * distance + z * (view.pixelFromCentre.y - glm::dot(centre, up));
    }
    return glm::transpose(glm::dmat3(x, y, z));
}

std::optional<glm::ivec2> pixelUnder(const SpriteView& view, const Camera& camera,
                                     glm::dvec2 screenPx) {
    const glm::dvec3 p = pixelFromScreen(view, camera) * glm::dvec3(screenPx, 1.0);
    if (!(p.z > 0.0)) return std::nullopt;
    const glm::dvec2 pixel{std::floor(p.x / p.z), std::floor(p.y / p.z)};
    constexpr double kMost = 1 << 30;
    // Written so that NaN fails.
    if (!(std::abs(pixel.x) <= kMost && std::abs(pixel.y) <= kMost)) return std::nullopt;
    return glm::ivec2(pixel);
}

std::array<glm::dvec3, 4> quadFromEye(const SpriteView& view, glm::ivec2 first, glm::ivec2 size) {
    std::array<glm::dvec3, 4> corners;
    for (int corner = 0; corner < 4; ++corner) {
        const glm::ivec2 pixel = first + size * glm::ivec2(corner & 1, corner >> 1);
        const glm::dvec2 metres = (glm::dvec2(pixel) - view.pixelFromCentre) * view.metresPerPx;
        corners[static_cast<std::size_t>(corner)] =
            view.centreFromEyeMetres + view.right * metres.x + view.up * metres.y;
    }
    return corners;
}

LatticeView visibleLattice(const SpriteView& view, const Camera& camera) {
    const glm::dmat3 mapping = pixelFromScreen(view, camera);
    const auto corner = [&](int k) {
        const glm::ivec2 side{k == 1 || k == 2 ? 1 : 0, k >= 2 ? 1 : 0};
        return mapping * glm::dvec3(camera.viewportPx * side, 1.0);
    };
    glm::dvec2 least(std::numeric_limits<double>::infinity());
    glm::dvec2 most = -least;
    const auto include = [&](glm::dvec3 p) {
        least = glm::min(least, glm::dvec2(p.x, p.y) / p.z);
        most = glm::max(most, glm::dvec2(p.x, p.y) / p.z);
    };
    // The screen's outline, clipped where eye rays begin to run away from the plane.
    constexpr double kHorizon = 1e-12;
    for (int k = 0; k < 4; ++k) {
        const glm::dvec3 a = corner(k);
        const glm::dvec3 b = corner((k + 1) % 4);
        if (a.z >= kHorizon) include(a);
        if ((a.z >= kHorizon) != (b.z >= kHorizon))
            include(a + (b - a) * ((kHorizon - a.z) / (b.z - a.z)));
    }
    LatticeView visible = view.lattice;
    const glm::dvec2 first(view.lattice.first);
    const glm::dvec2 end(view.lattice.first + view.lattice.size);
    const glm::dvec2 from = glm::clamp(glm::floor(least) - 1.0, first, end);
    const glm::dvec2 to = glm::clamp(glm::floor(most) + 2.0, from, end);
    visible.first = glm::ivec2(from);
    visible.size = glm::ivec2(to - from);
    if (visible.size.x == 0 || visible.size.y == 0) visible.size = glm::ivec2(0);
    return visible;
}

bool meetsProxyBox(const SpriteView& view, const Camera::Ray& rayFromEye) {
    const glm::dmat3 boxFromWorld = glm::transpose(view.boxAxes);
    const glm::dvec3 start = boxFromWorld * (rayFromEye.origin - view.centreFromEyeMetres);
    const glm::dvec3 direction = boxFromWorld * rayFromEye.direction;
    double enter = 0.0;
    double leave = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double half = view.boxHalfMetres[axis];
        if (direction[axis] == 0.0) {
            if (std::abs(start[axis]) > half) return false;
            continue;
        }
        const double a = (-half - start[axis]) / direction[axis];
        const double b = (half - start[axis]) / direction[axis];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave;
}

}  // namespace voxprite
