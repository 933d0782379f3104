// The picture over time: what trembles must not flicker, and who comes back sees the same again.
#include <cmath>
#include <glm/geometric.hpp>

#include "app/cli/conformance/stability.h"
#include "app/cli/conformance/subjects.h"
#include "core/sprite/view_axes.h"

namespace voxprite::conformance {
namespace {

constexpr int kFrames = 500;
constexpr double kDistance = 12.0;

// Moved by about `radians` as seen from the model, and turned by as much.
Camera trembled(const Camera& camera, double radians, Sequence& random) {
    const auto some = [&] { return random.between(-radians, radians); };
    Camera moved = camera;
    moved.eyeMetres += (camera.right * some() + camera.up * some()) * kDistance;
    moved.forward = glm::normalize(camera.forward + camera.right * some() + camera.up * some());
    moved.right = glm::normalize(glm::cross(moved.forward, camera.up + camera.right * some()));
    moved.up = glm::cross(moved.right, moved.forward);
    return moved;
}

struct Viewer {
    const Subject& subject;
    GameProfile profile;
    ViewHistory history{};

    // All that the pixels are made of.
    struct Picture {
        LatticeView lattice;
        FaceLights lights;
        bool operator==(const Picture&) const = default;
    };
    Picture look(const Camera& camera) {
        const SpriteView view =
            seen(subject.centredAt(glm::dvec3(0.0), profile), camera, profile, &history);
        return {view.lattice, view.light8};
    }
};

}  // namespace

Sweep sweepStillness() {
    const double step = kUsualViewStepDegrees;
    Sweep sweep{
        "stillness",
        "cameras that tremble by 1e-7 ... 1e-3 rad for 500 frames, on steps, between them "
        "and straight above, both views, with occlusion and shadows; and ways from A to B and "
        "back"};
    const Subject subject = letters();
    Sequence random(31);
    double snappedChanges = 0.0;
    double changes = 0.0;
    double notTheSame = 0.0;
    for (const ViewRule rule : {ViewRule::towardEntity, ViewRule::cameraForward}) {
        GameProfile profile = plainProfile();
        profile.view = rule;
        profile.light.occlusion = profile.light.shadow = 0.5;
        for (const double viewStep : {0.0, step}) {
            profile.viewStepDegrees = viewStep;
            for (const OrbitAngles angles : {OrbitAngles{0, 0, 0},
                                             {0.5 * step, 0.5 * step, 0},
                                             {180, 5.5 * step, 0},
                                             {61.7, 80, 0},
                                             {33, 90, 0},
                                             {10, -90, 0}})
                for (const double radians : {1e-7, 1e-5, 1e-3}) {
                    Viewer viewer{subject, profile};
                    const Camera camera = orbit(angles.yawDegrees, angles.pitchDegrees, kDistance);
                    Viewer::Picture shown = viewer.look(camera);
                    double& count = viewStep > 0.0 ? snappedChanges : changes;
                    for (int frame = 0; frame < kFrames; ++frame) {
                        const Viewer::Picture next = viewer.look(trembled(camera, radians, random));
                        count += next == shown ? 0.0 : 1.0;
                        shown = next;
                    }
                    sweep.count(true, "");
                }
        }
        for (int n = 0; n < 200; ++n) {
            // Within 0.35 steps of a snapped view: outside the band of hysteresis.
            const auto near = [&](double most) {
                return step *
                       (std::round(random.between(-most, most)) + random.between(-0.35, 0.35));
            };
            const Camera a = orbit(near(20.0), near(9.0), kDistance);
            Viewer viewer{subject, profile};
            const Viewer::Picture before = viewer.look(a);
            for (int k = 0; k < 6; ++k)
                static_cast<void>(viewer.look(
                    orbit(random.between(-180, 180), random.between(-88, 88), kDistance)));
            notTheSame += viewer.look(a) == before ? 0.0 : 1.0;
            sweep.count(true, "");
        }
    }
    sweep.figures = {
        {"flicker", "changes of the picture while the camera trembles, at the usual view step",
         snappedChanges, 0.0, "frames"},
        {"flicker_exact", "the same without a view step", changes,
         std::numeric_limits<double>::infinity(), "frames"},
        {"return", "ways from A to B and back that end at another picture", notTheSame, 0.0,
         "ways"}};
    return sweep;
}

}  // namespace voxprite::conformance
