// Places, sizes and cameras of the world: results stay finite, and the grid stays in place.
#include <algorithm>
#include <cmath>

#include "app/cli/conformance/finite.h"
#include "app/cli/conformance/gpu_probe.h"
#include "app/cli/conformance/outline_lost.h"
#include "app/cli/conformance/stability.h"
#include "app/cli/conformance/subjects.h"

namespace voxprite::conformance {
namespace {

std::string textOf(double number) {
    return std::to_string(number);
}

// Counts views as cases: each is seen, finite and its corners map onto themselves. An eye inside
// the proxy box, and a buffer beyond the limit, are answers too.
class ViewCounter {
  public:
    ViewCounter(Sweep& sweep, GpuProbe& probe) : sweep_(sweep), probe_(probe) {}
    std::optional<SpriteView> count(const std::string& name, const Subject& subject,
                                    const PlacedEntity& entity, const Camera& camera,
                                    const GameProfile& profile);
    [[nodiscard]] Figure roundTripFigure() const {
        return {"round_trip", "corners of the sprite off themselves, to the screen and back; worst",
                worstRoundTrip_, 1e-3, "vpx"};
    }

  private:
    Sweep& sweep_;
    GpuProbe& probe_;
    double worstRoundTrip_ = 0.0;
};

std::optional<SpriteView> ViewCounter::count(const std::string& name, const Subject& subject,
                                             const PlacedEntity& entity, const Camera& camera,
                                             const GameProfile& profile) {
    const auto result = viewSprite(entity, camera, profile);
    if (!result) {
        const bool limit =
            result.error().message.find(std::to_string(kMaxBufferPixels)) != std::string::npos;
        sweep_.refused += limit ? 1 : 0;
        sweep_.count(limit, name + ": " + result.error().message);
        return std::nullopt;
    }
    if (!result->view) {
        sweep_.refused += 1;
        sweep_.count(result->unseen == Unseen::cameraInside, name + ": not seen");
        return std::nullopt;
    }
    sweep_.count(finite(*result->view, camera), name);
    const double off = roundTripPx(*result->view, camera);
    worstRoundTrip_ = off <= worstRoundTrip_ ? worstRoundTrip_ : off;
    probe_.compareWindow(subject, result->view->lattice);
    probe_.draw(subject, entity, camera, profile);
    return result->view;
}

Camera cameraAt(double distance, double nearMetres) {
    Camera camera = orbit(33, 21, distance);
    camera.nearMetres = nearMetres;
    return camera;
}

}  // namespace

Sweep sweepScales(GpuProbe& probe) {
    Sweep sweep{"scales", "VoxelSize 1e-6 ... 1e6 m, scale 1e-3 ... 1e3, sigma 1/4, 4 and 16"};
    ViewCounter counter(sweep, probe);
    Subject subject = figure();
    for (int power = -6; power <= 6; ++power)
        for (const double scale : {1e-3, 0.01, 0.37, 1.0, 2.0, 30.0, 1e3})
            for (const double sigma : {0.25, 4.0, 16.0}) {
                GameProfile profile = plainProfile();
                profile.voxelSizeMetres = std::pow(10.0, power);
                profile.sigma = sigma;
                subject.entity.scale = scale;
                const PlacedEntity entity = subject.centredAt(glm::dvec3(0.0), profile);
                const double distance = entity.radiusMetres() * 4.0 + profile.voxelSizeMetres * 8.0;
                counter.count("1e" + std::to_string(power) + " m, scale " + textOf(scale), subject,
                              entity, cameraAt(distance, distance * 1e-3), profile);
            }
    sweep.figures = {counter.roundTripFigure()};
    return sweep;
}

Sweep sweepPositions(GpuProbe& probe) {
    Sweep sweep{"positions", "entity and camera 0 ... 1e9 m from the world's origin, three views"};
    const GameProfile profile = plainProfile();
    const Subject subject = figure();
    ViewCounter counter(sweep, probe);
    double jitterAt1e7 = 0.0;
    double jitterAt1e9 = 0.0;
    for (const double yaw : {0.0, 33.0, 160.0}) {
        const Camera home = orbit(yaw, 21, 12);
        const SpriteView still = seen(subject.centredAt(glm::dvec3(0.0), profile), home, profile);
        const glm::dmat3 atHome = pixelFromScreen(still, home);
        for (const double metres : {0.0, 1.0, 1e3, 1e5, 1e6, 1e7, 1e8, 1e9})
            for (const glm::dvec3 way :
                 {glm::dvec3(1, 0, 0), glm::dvec3(0.6, 0.0, -0.8), glm::dvec3(-0.48, 0.6, 0.64)})
                for (const double nudge : {0.0, 0.0123, 0.377}) {
                    const glm::dvec3 place = way * (metres + nudge);
                    Camera camera = home;
                    camera.eyeMetres += place;
                    const auto view =
                        counter.count(textOf(metres) + " m", subject,
                                      subject.centredAt(place, profile), camera, profile);
                    if (!view) continue;
                    const glm::dmat3 there = pixelFromScreen(*view, camera);
                    double jitter = 0.0;
                    for (const glm::dvec2 px : {glm::dvec2(256, 256), {150, 120}, {390, 400}}) {
                        const glm::dvec3 a = atHome * glm::dvec3(px, 1.0);
                        const glm::dvec3 b = there * glm::dvec3(px, 1.0);
                        jitter = std::max(jitter, glm::length(glm::dvec2(a.x, a.y) / a.z -
                                                              glm::dvec2(b.x, b.y) / b.z));
                    }
                    if (metres <= 1e7) jitterAt1e7 = std::max(jitterAt1e7, jitter);
                    jitterAt1e9 = std::max(jitterAt1e9, jitter);
                }
    }
    sweep.figures = {{"jitter_1e7", "the grid off its place near the origin, to 1e7 m", jitterAt1e7,
                      1e-3, "vpx"},
                     {"jitter_1e9", "the same to 1e9 m", jitterAt1e9, 1e-1, "vpx"},
                     counter.roundTripFigure()};
    return sweep;
}

Sweep sweepCameras(GpuProbe& probe) {
    Sweep sweep{"cameras",
                "just outside the box ... 1e7 radii away, field of view 1 ... 170 degrees and "
                "orthographic, with and without minification"};
    const Subject subject = figure();
    ViewCounter counter(sweep, probe);
    for (const bool minification : {false, true})
        for (const ViewRule rule : {ViewRule::towardEntity, ViewRule::cameraForward})
            for (const double radii : {1.02, 1.1, 1.5, 3.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6, 1e7})
                for (const double fov : {1.0, 10.0, 45.0, 90.0, 150.0, 170.0, 0.0}) {
                    GameProfile profile = plainProfile();
                    profile.minification = minification;
                    profile.view = rule;
                    const PlacedEntity entity = subject.centredAt(glm::dvec3(0.0), profile);
                    Camera camera = cameraAt(entity.radiusMetres() * radii + 0.05, 0.01);
                    camera.orthographic = fov == 0.0;
                    if (!camera.orthographic) camera.verticalFovDegrees = fov;
                    counter.count(textOf(radii) + " radii, " + textOf(fov) + " degrees", subject,
                                  entity, camera, profile);
                }
    sweep.figures = {counter.roundTripFigure()};
    return sweep;
}

Sweep sweepProxy(GpuProbe& probe) {
    Sweep sweep{
        "proxy",
        "outlines from 1.3 to 6 radii away, field of view 20 ... 120 degrees, off the axis"};
    const GameProfile profile = plainProfile();
    LitPalette lit;
    lit.outline.colour = kInk;
    double lost = 0.0;
    double outlines = 0.0;
    ViewCounter counter(sweep, probe);
    for (const Subject& subject : {letters(), solidBox({10, 20, 6})})
        for (const OrbitAngles angles : {OrbitAngles{0, 0, 0}, {45, 35, 0}, {70, -20, 0}})
            for (const double radii : {1.3, 2.5, 6.0})
                for (const double fov : {20.0, 45.0, 120.0}) {
                    Camera camera = orbit(angles.yawDegrees, angles.pitchDegrees, 1.0, 400);
                    camera.verticalFovDegrees = fov;
                    PlacedEntity entity = subject.centredAt(glm::dvec3(0.0), profile);
                    camera.eyeMetres = -camera.forward * (radii * entity.radiusMetres() + 0.03);
                    entity.anchorMetres += camera.right * 0.1 - camera.up * 0.05;
                    const auto view = counter.count(subject.name, subject, entity, camera, profile);
                    if (!view || view->screenPxPerPx < 1.5) continue;
                    const SpriteBuffer buffer =
                        castSprite(subject.octree.view(), view->lattice, lit);
                    lost += outlineLost(*view, buffer, camera);
                    outlines += static_cast<double>(buffer.outlineCount());
                }
    sweep.figures = {
        {"outline_lost", "outline pixels lost", lost, 0.0, "pixels"},
        {"outline", "outline pixels", outlines, std::numeric_limits<double>::infinity(), "pixels"},
        counter.roundTripFigure()};
    return sweep;
}

Sweep sweepAnchors(GpuProbe& probe) {
    Sweep sweep{"anchors",
                "anchors 0 ... 1e9 voxels outside the model, both registrations; the view along "
                "the world's up"};
    ViewCounter counter(sweep, probe);
    double moved = 0.0;
    Subject subject = figure();
    for (const Registration registration : {Registration::modelCentre, Registration::anchor})
        for (const double voxels : {0.0, 1.0, 100.0, 1e4, 1e6, 1e9})
            for (const glm::dvec3 way : {glm::dvec3(1, 0, 0), {0, 0, -1}, {0.6, -0.8, 0.0}})
                for (const double pitch : {0.0, 21.0, 90.0, -90.0}) {
                    GameProfile profile = plainProfile();
                    profile.registration = registration;
                    subject.entity.anchorVoxels = glm::dvec3(16, 8, 0) + way * voxels;
                    const PlacedEntity entity = subject.centredAt(glm::dvec3(0.0), profile);
                    const auto view = counter.count(textOf(voxels) + " voxels", subject, entity,
                                                    orbit(0, pitch, 12), profile);
                    if (view && voxels <= 1e6)
                        moved = std::max(moved, glm::length(view->centreFromEyeMetres -
                                                            orbit(0, pitch, 12).forward * 12.0) /
                                                    view->metresPerPx);
                }
    sweep.figures = {
        {"centre", "the sprite's centre off its place, to 1e6 voxels", moved, 1e-3, "vpx"},
        counter.roundTripFigure()};
    return sweep;
}

}  // namespace voxprite::conformance
