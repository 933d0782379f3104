// Numbers that are none, or hardly: in every input there is. Each case ends in an error or in a
// sprite whose every number is finite.
#include <array>
#include <functional>
#include <limits>

#include "app/cli/conformance/finite.h"
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

struct Inputs {
    PlacedEntity entity;
    Camera camera;
    GameProfile profile;
};

struct Input {
    std::string name;
    std::function<double&(Inputs&)> at;
};

void addVector(std::vector<Input>& all, const std::string& name,
               const std::function<glm::dvec3&(Inputs&)>& vector) {
    for (int axis = 0; axis < 3; ++axis)
        all.push_back({name + "." + "xyz"[axis],
                       [vector, axis](Inputs& in) -> double& { return vector(in)[axis]; }});
}

std::vector<Input> everyInput() {
    std::vector<Input> all{
        {"fov", [](Inputs& in) -> double& { return in.camera.verticalFovDegrees; }},
        {"ortho height", [](Inputs& in) -> double& { return in.camera.orthographicHeightMetres; }},
        {"near", [](Inputs& in) -> double& { return in.camera.nearMetres; }},
        {"scale", [](Inputs& in) -> double& { return in.entity.scale; }},
        {"entity's voxel size", [](Inputs& in) -> double& { return in.entity.voxelSizeMetres; }},
        {"profile's voxel size", [](Inputs& in) -> double& { return in.profile.voxelSizeMetres; }},
        {"sigma", [](Inputs& in) -> double& { return in.profile.sigma; }},
        {"clearance", [](Inputs& in) -> double& { return in.profile.groundClearancePx; }},
        {"view step", [](Inputs& in) -> double& { return in.profile.viewStepDegrees; }},
        {"ambient", [](Inputs& in) -> double& { return in.profile.light.ambient; }}};
    addVector(all, "eye", [](Inputs& in) -> glm::dvec3& { return in.camera.eyeMetres; });
    addVector(all, "right", [](Inputs& in) -> glm::dvec3& { return in.camera.right; });
    addVector(all, "up", [](Inputs& in) -> glm::dvec3& { return in.camera.up; });
    addVector(all, "forward", [](Inputs& in) -> glm::dvec3& { return in.camera.forward; });
    addVector(all, "anchor", [](Inputs& in) -> glm::dvec3& { return in.entity.anchor; });
    addVector(all, "position", [](Inputs& in) -> glm::dvec3& { return in.entity.anchorMetres; });
    addVector(all, "light", [](Inputs& in) -> glm::dvec3& { return in.profile.light.towardLight; });
    for (int column = 0; column < 3; ++column)
        addVector(all, "axes", [column](Inputs& in) -> glm::dvec3& {
            return in.entity.worldFromVoxelAxes[column];
        });
    return all;
}

}  // namespace

Sweep sweepInputs() {
    Sweep sweep{"inputs",
                "NaN, infinity, denormals, huge numbers, 0 and -1 in every input of camera, entity "
                "and profile"};
    const Subject subject = letters();
    for (const bool orthographic : {false, true})
        for (const Registration registration : {Registration::modelCentre, Registration::anchor})
            for (const DepthRule depth :
                 {DepthRule::centre, DepthRule::groundSafe, DepthRule::perPixel})
                for (const Input& input : everyInput())
                    for (const double odd : kOddNumbers) {
                        Inputs in;
                        in.profile.registration = registration;
                        in.profile.depth = depth;
                        in.entity = subject.centredAt(glm::dvec3(0.0), in.profile);
                        in.camera = orbit(30, 20, 4);
                        in.camera.orthographic = orthographic;
                        input.at(in) = odd;
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
                        } else {
                            sweep.count(result->unseen.has_value(), name);
                        }
                    }
    return sweep;
}

}  // namespace voxprite::conformance
