// Numbers that are none, or hardly: in every input there is. Each case ends in an error or in a
// sprite whose every number is finite.
#include <array>
#include <functional>
#include <limits>

#include "app/cli/conformance/finite.h"
#include "app/cli/conformance/gpu_probe.h"
#include "app/cli/conformance/stability.h"
#include "app/cli/conformance/subjects.h"

namespace voxprite::conformance {
namespace {

using Limits = std::numeric_limits<double>;
constexpr std::array<double, 13> kOddNumbers{Limits::quiet_NaN(),
                                             Limits::infinity(),
                                             -Limits::infinity(),
                                             Limits::denorm_min(),
                                             -Limits::denorm_min(),
                                             Limits::min(),
                                             Limits::max(),
                                             -Limits::max(),
                                             1e-300,
                                             1e300,
                                             0.0,
                                             -0.0,
                                             -1.0};

// What a caller sets, and what is made of it.
struct Inputs {
    Entity record;
    OrbitAngles angles{30, 20, 0};
    double distanceMetres = 4.0;
    PlacedEntity entity;
    Camera camera;
    GameProfile profile;
};

struct Input {
    std::string name;
    std::function<double&(Inputs&)> at;
    bool early = false;  // set before entity and camera are made
};

void addVector(std::vector<Input>& all, const std::string& name,
               const std::function<glm::dvec3&(Inputs&)>& vector) {
    for (int axis = 0; axis < 3; ++axis)
        all.push_back({name + "." + "xyz"[axis],
                       [vector, axis](Inputs& in) -> double& { return vector(in)[axis]; }});
}

std::vector<Input> everyInput() {
    std::vector<Input> all{
        {"yaw", [](Inputs& in) -> double& { return in.record.yawDegrees; }, true},
        {"pitch", [](Inputs& in) -> double& { return in.record.pitchDegrees; }, true},
        {"roll", [](Inputs& in) -> double& { return in.record.rollDegrees; }, true},
        {"the record's scale", [](Inputs& in) -> double& { return in.record.scale; }, true},
        {"orbit's yaw", [](Inputs& in) -> double& { return in.angles.yawDegrees; }, true},
        {"orbit's pitch", [](Inputs& in) -> double& { return in.angles.pitchDegrees; }, true},
        {"orbit's roll", [](Inputs& in) -> double& { return in.angles.rollDegrees; }, true},
        {"orbit's distance", [](Inputs& in) -> double& { return in.distanceMetres; }, true},
        {"fov", [](Inputs& in) -> double& { return in.camera.verticalFovDegrees; }},
        {"ortho height", [](Inputs& in) -> double& { return in.camera.orthographicHeightMetres; }},
        {"near", [](Inputs& in) -> double& { return in.camera.nearMetres; }},
        {"scale", [](Inputs& in) -> double& { return in.entity.scale; }},
        {"entity's voxel size", [](Inputs& in) -> double& { return in.entity.voxelSizeMetres; }},
        {"profile's voxel size", [](Inputs& in) -> double& { return in.profile.voxelSizeMetres; }},
        {"sigma", [](Inputs& in) -> double& { return in.profile.sigma; }},
        {"clearance", [](Inputs& in) -> double& { return in.profile.groundClearancePx; }},
        {"view step", [](Inputs& in) -> double& { return in.profile.viewStepDegrees; }},
        {"ambient", [](Inputs& in) -> double& { return in.profile.light.ambient; }},
        {"occlusion", [](Inputs& in) -> double& { return in.profile.light.occlusion; }},
        {"shadow", [](Inputs& in) -> double& { return in.profile.light.shadow; }}};
    addVector(all, "eye", [](Inputs& in) -> glm::dvec3& { return in.camera.eyeMetres; });
    addVector(all, "right", [](Inputs& in) -> glm::dvec3& { return in.camera.right; });
    addVector(all, "up", [](Inputs& in) -> glm::dvec3& { return in.camera.up; });
    addVector(all, "forward", [](Inputs& in) -> glm::dvec3& { return in.camera.forward; });
    addVector(all, "anchor", [](Inputs& in) -> glm::dvec3& { return in.entity.anchor; });
    addVector(all, "centre", [](Inputs& in) -> glm::dvec3& { return in.entity.centreFromMiddle; });
    addVector(all, "position", [](Inputs& in) -> glm::dvec3& { return in.entity.anchorMetres; });
    addVector(all, "light", [](Inputs& in) -> glm::dvec3& { return in.profile.light.towardLight; });
    for (int column = 0; column < 3; ++column)
        addVector(all, "axes", [column](Inputs& in) -> glm::dvec3& {
            return in.entity.worldFromVoxelAxes[column];
        });
    return all;
}

Inputs inputsWith(const Subject& subject, const Input& input, double odd, Registration registration,
                  DepthRule depth, bool orthographic) {
    Inputs in;
    in.profile.registration = registration;
    in.profile.depth = depth;
    if (input.early) input.at(in) = odd;
    Subject placed = subject;
    placed.entity = in.record;
    in.entity = placed.centredAt(glm::dvec3(0.0), in.profile);
    in.camera = orbitCamera(in.angles, glm::dvec3(0.0), in.distanceMetres, 45.0, {512, 512});
    in.camera.orthographic = orthographic;
    if (!input.early) input.at(in) = odd;
    return in;
}

// The axes and the scale that are quantised.
void sweepOrthoViews(Sweep& sweep, GpuProbe& probe, const Subject& subject) {
    for (const double odd : kOddNumbers)
        for (int number = 0; number < 10; ++number) {
            OrthoView view = orthoView({33, 21, 7}, 4.0);
            const std::array<glm::dvec3*, 3> axes{&view.right, &view.up, &view.forward};
            if (number == 9)
                view.sigmaInForce = odd;
            else
                (*axes[static_cast<std::size_t>(number / 3)])[number % 3] = odd;
            const auto lattice = quantiseView(view, subject.octree.size);
            const std::string name = "axes or scale = " + std::to_string(odd);
            if (lattice) {
                sweep.count(validateLattice(*lattice, subject.octree.size).has_value(), name);
                probe.compareWindow(subject, *lattice);
            } else {
                ++sweep.refused;
                sweep.count(!lattice.error().message.empty(), name);
            }
        }
}

}  // namespace

Sweep sweepInputs(GpuProbe& probe) {
    Sweep sweep{
        "inputs",
        "NaN, infinity, denormals, huge numbers, 0 and -1 in every input of camera, entity, "
        "profile and view"};
    const Subject subject = letters();
    for (const bool orthographic : {false, true})
        for (const Registration registration : {Registration::modelCentre, Registration::anchor})
            for (const DepthRule depth :
                 {DepthRule::centre, DepthRule::groundSafe, DepthRule::perPixel})
                for (const Input& input : everyInput())
                    for (const double odd : kOddNumbers) {
                        const Inputs in =
                            inputsWith(subject, input, odd, registration, depth, orthographic);
                        const auto result = viewSprite(in.entity, in.camera, in.profile);
                        const std::string name = input.name + " = " + std::to_string(odd);
                        if (!result) {
                            ++sweep.refused;
                            sweep.count(!result.error().message.empty(), name);
                        } else if (result->view) {
                            sweep.count(
                                finite(*result->view, in.camera) &&
                                    validateLattice(result->view->lattice, subject.octree.size)
                                        .has_value(),
                                name);
                            // Both depths that go their own way through the shaders.
                            if ((registration == Registration::modelCentre &&
                                 depth == DepthRule::groundSafe) ||
                                (registration == Registration::anchor &&
                                 depth == DepthRule::perPixel)) {
                                probe.compareWindow(subject, result->view->lattice);
                                probe.draw(subject, in.entity, in.camera, in.profile);
                            }
                        } else {
                            sweep.count(result->unseen.has_value(), name);
                        }
                    }
    sweepOrthoViews(sweep, probe, subject);
    return sweep;
}

}  // namespace voxprite::conformance
