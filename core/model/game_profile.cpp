#include "core/model/game_profile.h"

#include <glm/geometric.hpp>

#include "core/model/range_check.h"

namespace voxprite {

Status checkVoxelSize(const std::string& field, double metres) {
    return checkRange(field, metres, 1e-6, 1e6, "1e-6 and 1e6 metres");
}

Status checkSigma(const std::string& field, double sigma) {
    return checkRange(field, sigma, kLeastSigma, kMostSigma, "1/64 and 64");
}

namespace {

Status checkChoice(const char* field, int value, int last) {
    if (value >= 0 && value <= last) return {};
    return fail(std::string(field) + " is no choice there is (" + std::to_string(value) + ")");
}

Status validate(const Light& light) {
    if (Status s = checkRange("light.ambient", light.ambient, 0.0, 1.0); !s) return s;
    if (Status s = checkRange("light.occlusion", light.occlusion, 0.0, 1.0); !s) return s;
    if (Status s = checkRange("light.shadow", light.shadow, 0.0, 1.0); !s) return s;
    constexpr double kFar = 1e6;
    for (int axis = 0; axis < 3; ++axis) {
        const std::string field = std::string("light.towardLight.") + "xyz"[axis];
        if (Status s = checkRange(field, light.towardLight[axis], -kFar, kFar); !s) return s;
    }
    if (glm::length(light.towardLight) < 1.0 / kFar) {
        return fail("light.towardLight has no length; it must point toward the light");
    }
    return {};
}

}  // namespace

Status validate(const GameProfile& profile) {
    if (Status s = checkVoxelSize("voxelSizeMetres", profile.voxelSizeMetres); !s) return s;
    if (Status s = checkSigma("sigma", profile.sigma); !s) return s;
    if (Status s = checkChoice("view", static_cast<int>(profile.view), 1); !s) return s;
    if (Status s = checkChoice("registration", static_cast<int>(profile.registration), 1); !s) {
        return s;
    }
    if (Status s = checkChoice("proxy", static_cast<int>(profile.proxy), 1); !s) return s;
    if (Status s = checkChoice("depth", static_cast<int>(profile.depth), 2); !s) return s;
    if (Status s = checkChoice("mode", static_cast<int>(profile.mode), 1); !s) return s;
    if (Status s = checkChoice("shading", static_cast<int>(profile.shading), 1); !s) return s;
    if (Status s = checkRange("groundClearancePx", profile.groundClearancePx, 0.0, 64.0); !s) {
        return s;
    }
    if (Status s = checkRange("viewStepDegrees", profile.viewStepDegrees, 0.0, 45.0); !s) return s;
    if (profile.outline.colour.w != 255) {
        return fail("outline.colour has alpha " + std::to_string(profile.outline.colour.w) +
                    "; it must be 255");
    }
    return validate(profile.light);
}

}  // namespace voxprite
