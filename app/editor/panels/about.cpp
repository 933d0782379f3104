#include "app/editor/panels/about.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include "core/model/store_version.h"
#include "render/gl/context.h"

namespace voxprite::editor {
namespace {

std::string dotted(int major, int minor, int patch) {
    return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

}  // namespace

std::vector<AboutLine> aboutLines() {
    const gl::DriverInfo driver = gl::driverInfo();
    return {{"voxprite", VOXPRITE_VERSION},
            {"OpenGL", driver.version},
            {"Driver", driver.renderer},
            {"Window", glfwGetVersionString()},
            {"Interface", std::string("Dear ImGui ") + IMGUI_VERSION},
            {"Type", "FreeType " + dotted(FREETYPE_MAJOR, FREETYPE_MINOR, FREETYPE_PATCH)},
            {"Voxels", storeVersion()},
            {"Arithmetic",
             std::string("GLM ") + dotted(GLM_VERSION_MAJOR, GLM_VERSION_MINOR, GLM_VERSION_PATCH)},
            {"JSON", "nlohmann " + dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                                          NLOHMANN_JSON_VERSION_PATCH)}};
}

}  // namespace voxprite::editor
