// The numbers that this program is about: the game's two, then the entity's own.
#include <array>
#include <cmath>
#include <cstdio>

#include "app/editor/panels/panels.h"
#include "app/editor/panels/widgets.h"
#include "app/editor/window/icons.h"
#include "core/model/entity_voxels.h"

namespace voxprite::editor {
namespace {

constexpr std::array kViewRules{
    Choice{"Camera", "Rays run along the camera's own direction"},
    Choice{"Entity", "Rays run from the eye to the entity: turning the camera changes nothing"}};
constexpr std::array kRegistrations{
    Choice{"Centre", "The pixel grid belongs to the model's centre"},
    Choice{"Anchor", "The anchor's pixel stays on the anchor: feet do not slide"}};
constexpr std::array kProxies{
    Choice{"Quad", "Draw the sprite's own rectangle: nothing is cut away"},
    Choice{"Box", "Draw the projection of the proxy box"}};
constexpr std::array kDepths{
    Choice{"Centre", "One depth a sprite, that of its centre"},
    Choice{"Ground", "As centre, pulled forward so that the ground hides no pixel"},
    Choice{"Pixel", "Each pixel has the depth of its voxel"}};

constexpr std::array kSpriteModes{
    Choice{"Buffers", "Each sprite is cast once, a ray a virtual pixel, and kept while it shows"},
    Choice{"Single pass", "Every screen pixel casts its own rays: the same picture, slower"}};

constexpr std::array kShadings{
    Choice{"Multiply", "Light multiplies the colours"},
    Choice{"Palette", "Light picks from the palette's ramps: a sprite has only your colours"}};

std::string text(const char* format, double value) {
    std::array<char, 64> buffer{};
    std::snprintf(buffer.data(), buffer.size(), format, value);
    return buffer.data();
}

bool outlineRow(Ui& ui, GameProfile& profile) {
    bool changed = switchRow(ui, "inspector.outline", "Outline", profile.outline.enabled);
    ImGui::SameLine(0.0f, ui.theme.px(24));
    const Rgba8 colour = profile.outline.colour;
    float rgb[3] = {static_cast<float>(colour.x) / 255.0f, static_cast<float>(colour.y) / 255.0f,
                    static_cast<float>(colour.z) / 255.0f};
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    if (ImGui::ColorEdit3("##outlineColour", rgb,
                          ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoLabel)) {
        const auto byte = [](float c) { return static_cast<std::uint8_t>(std::lround(c * 255)); };
        profile.outline.colour = Rgba8(byte(rgb[0]), byte(rgb[1]), byte(rgb[2]), 255);
        changed = true;
    }
    ui.edits.watchItem(ui.session);
    return changed;
}

void gameSection(Ui& ui, GameProfile& profile) {
    if (!section(ui, "Game")) return;
    static_cast<void>(logSliderRow(ui, "inspector.sigma", "Sigma σ", profile.sigma, 0.25, 16.0,
                                   snapSigma, "Virtual pixels a voxel, shared by the whole game"));
    static_cast<void>(numberRow(ui, "inspector.voxelSize", "VoxelSize", profile.voxelSizeMetres,
                                {1e-6, 1e6, 0.001, "%.4g m"},
                                "Metres a voxel, shared by the whole game"));
    static_cast<void>(outlineRow(ui, profile));
}

void anchorPresets(Ui& ui, Entity& entity, const IBox& bounds) {
    struct Preset {
        const char* label;
        const char* hint;
        double z;
    };
    constexpr std::array kPresets{Preset{"Bottom", "Bottom centre; follows the model", 0.0},
                                  Preset{"Centre", "The model's centre", 0.5},
                                  Preset{"Top", "Top centre", 1.0}};
    const Theme& theme = ui.theme;
    rowLabel(ui, "");
    const float gap = theme.px(4), square = theme.px(24);
    // What is left beside the words is shared evenly.
    float spare = ImGui::GetContentRegionAvail().x - square - 3 * gap;
    for (const Preset& preset : kPresets) spare -= ImGui::CalcTextSize(preset.label).x;
    const float air = std::floor(spare / static_cast<float>(kPresets.size()));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, theme.px(0, 4));
    for (const Preset& preset : kPresets) {
        if (ImGui::Button(preset.label, {ImGui::CalcTextSize(preset.label).x + air, square})) {
            entity.anchorVoxels.reset();
            if (preset.z > 0.0) {
                glm::dvec3 anchor = anchorVoxels(entity, bounds);
                anchor.z = bounds.min.z + preset.z * bounds.size().z;
                entity.anchorVoxels = anchor;
            }
        }
        ui.edits.watchItem(ui.session);
        ui.probe.markItem(std::string("inspector.anchor.") + preset.label);
        tooltip(ui, preset.hint);
        ImGui::SameLine(0.0f, gap);
    }
    ImGui::PopStyleVar();
    const bool picking = ui.settings.tool.tool == ToolKind::anchor;
    commandButton(ui, CommandId::toolAnchor, picking ? Lit::filled : Lit::off, square);
}

void entitySection(Ui& ui, Entity& entity) {
    if (!section(ui, "Proxy box")) return;
    const IBox& bounds = ui.session.bounds();
    glm::dvec3 anchor = anchorVoxels(entity, bounds);
    if (vectorRow(ui, "inspector.anchor", "Anchor", anchor, {-1e6, 1e6, 0.1, "%.1f"},
                  "The point, in voxels, that stands at the entity's position")) {
        entity.anchorVoxels = anchor;
    }
    anchorPresets(ui, entity, bounds);

    glm::dvec3 angles(entity.yawDegrees, entity.pitchDegrees, entity.rollDegrees);
    if (vectorRow(ui, "inspector.rotation", "Rotation", angles, {-360.0, 360.0, 0.5, "%.0f°"},
                  "Yaw, pitch and roll in degrees", false)) {
        entity.yawDegrees = angles.x;
        entity.pitchDegrees = angles.y;
        entity.rollDegrees = angles.z;
    }
    static_cast<void>(vectorRow(ui, "inspector.position", "Position", entity.positionMetres,
                                {-1e9, 1e9, 0.01, "%.2f"},
                                "Of the anchor in the world, in metres; y is up"));
    static_cast<void>(numberRow(ui, "inspector.scale", "Scale", entity.scale,
                                {1e-3, 1e3, 0.005, "%.3f"}, "Uniform"));
    const double metres =
        bounds.empty() ? 0.0
                       : bounds.size().z * entity.scale * ui.session.profile().voxelSizeMetres;
    readoutRow(ui, "Height", text("%.2f m", metres), "Of the model in the game, unrotated");
}

void rulesSection(Ui& ui, GameProfile& profile) {
    if (!section(ui, "Rules of the game")) return;
    static_cast<void>(enumRow(ui, "inspector.view", "View", profile.view, kViewRules));
    static_cast<void>(enumRow(ui, "inspector.mode", "Mode", profile.mode, kSpriteModes));
    static_cast<void>(enumRow(ui, "inspector.registration", "Registered at", profile.registration,
                              kRegistrations));
    static_cast<void>(enumRow(ui, "inspector.depth", "Depth", profile.depth, kDepths));
    static_cast<void>(enumRow(ui, "inspector.proxy", "Region", profile.proxy, kProxies));
    static_cast<void>(
        switchRow(ui, "inspector.minification", "Minification", profile.minification,
                  "Halve sigma while a virtual pixel is smaller than a screen pixel"));
    static_cast<void>(numberRow(ui, "inspector.viewStep", "View step", profile.viewStepDegrees,
                                {0.0, 45.0, 0.1, "%.1f°"}, "Views snap to this step; 0 is off"));
    static_cast<void>(numberRow(ui, "inspector.clearance", "Clearance", profile.groundClearancePx,
                                {0.0, 64.0, 0.05, "%.1f px"},
                                "Virtual pixels between the ground and what stands on it"));
}

void lightSection(Ui& ui, GameProfile& profile) {
    if (!section(ui, "Light", false)) return;
    static_cast<void>(numberRow(ui, "inspector.ambient", "Ambient", profile.light.ambient,
                                {0.0, 1.0, 0.005, "%.2f"}, "Light of a face turned away"));
    glm::dvec3 towardLight = profile.light.towardLight;
    if (vectorRow(ui, "inspector.light", "Toward", towardLight, {-1.0, 1.0, 0.01, "%.2f"},
                  "Direction of the light in the world; y is up") &&
        towardLight != glm::dvec3(0.0)) {
        profile.light.towardLight = towardLight;
    }
    static_cast<void>(enumRow(ui, "inspector.shading", "Shading", profile.shading, kShadings));
    static_cast<void>(numberRow(ui, "inspector.occlusion", "Occlusion", profile.light.occlusion,
                                {0.0, 1.0, 0.005, "%.2f"},
                                "How dark faces get that voxels stand around; 0 is off"));
    static_cast<void>(numberRow(ui, "inspector.shadow", "Shadow", profile.light.shadow,
                                {0.0, 1.0, 0.005, "%.2f"},
                                "How much light faces lose that lie in shadow; 0 is off"));
}

}  // namespace

void drawInspector(Ui& ui) {
    const float gap = ui.theme.px(6);
    GameProfile profile = ui.session.profile();
    Entity entity = ui.session.document().entity;
    gameSection(ui, profile);
    ImGui::Dummy({0, gap});
    entitySection(ui, entity);
    ImGui::Dummy({0, gap});
    rulesSection(ui, profile);
    ImGui::Dummy({0, gap});
    lightSection(ui, profile);
    if (profile != ui.session.profile() && validate(profile)) {
        ui.edits.push("Game profile", ProfileEdit{ui.session.profile(), profile});
    }
    if (entity != ui.session.document().entity && validate(entity)) {
        ui.edits.push("Proxy box", EntityEdit{ui.session.document().entity, entity});
    }
}

}  // namespace voxprite::editor
