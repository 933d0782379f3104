#include "core/io/profile_json.h"

#include <array>
#include <utility>

#include "core/base/file.h"
#include "core/io/json_value.h"

namespace voxprite {
namespace {

constexpr int kVersion = 1;

template <class E>
struct Named {
    E value;
    const char* name;
};
template <class E>
Named(E, const char*) -> Named<E>;

constexpr std::array kViewRules{Named{ViewRule::cameraForward, "camera_forward"},
                                Named{ViewRule::towardEntity, "toward_entity"}};
constexpr std::array kRegistrations{Named{Registration::modelCentre, "model_centre"},
                                    Named{Registration::anchor, "anchor"}};
constexpr std::array kProxyShapes{Named{ProxyShape::quad, "quad"}, Named{ProxyShape::box, "box"}};
constexpr std::array kDepthRules{Named{DepthRule::centre, "centre"},
                                 Named{DepthRule::groundSafe, "ground_safe"},
                                 Named{DepthRule::perPixel, "per_pixel"}};
constexpr std::array kSpriteModes{Named{SpriteMode::spriteBuffer, "sprite_buffer"},
                                  Named{SpriteMode::singlePass, "single_pass"}};
constexpr std::array kShadings{Named{Shading::multiply, "multiply"},
                               Named{Shading::palette, "palette"}};

template <class E, std::size_t N>
const char* nameIn(const std::array<Named<E>, N>& table, E value) {
    for (const Named<E>& entry : table) {
        if (entry.value == value) return entry.name;
    }
    return "unknown";
}

template <class E, std::size_t N>
Result<E> valueIn(const std::array<Named<E>, N>& table, std::string_view name) {
    std::string choices;
    for (const Named<E>& entry : table) {
        if (name == entry.name) return entry.value;
        choices += (choices.empty() ? "" : ", ") + std::string(entry.name);
    }
    return fail("\"" + std::string(name) + "\" is none of: " + choices);
}

template <class E>
void readNamed(JsonObject& object, const char* key, E& value,
               Result<E> (*named)(std::string_view)) {
    const std::optional<JsonValue> field = object.find(key);
    if (!field) return;
    const Result<E> result = named(field->text());
    if (!result) field->fail(result.error().message);
    value = *result;
}

GameProfile profileFromJson(const nlohmann::ordered_json& json) {
    JsonObject object{JsonValue(json, "")};
    const JsonValue version = object.need("voxprite_profile");
    if (version.integer(1) > kVersion) version.fail("written by a newer version of voxprite");

    GameProfile profile;
    object.read("voxelSizeMetres", profile.voxelSizeMetres);
    object.read("sigma", profile.sigma);
    readNamed(object, "view", profile.view, viewRuleNamed);
    readNamed(object, "registration", profile.registration, registrationNamed);
    readNamed(object, "proxy", profile.proxy, proxyShapeNamed);
    readNamed(object, "depth", profile.depth, depthRuleNamed);
    readNamed(object, "mode", profile.mode, spriteModeNamed);
    object.read("groundClearancePx", profile.groundClearancePx);
    object.read("minification", profile.minification);
    object.read("viewStepDegrees", profile.viewStepDegrees);
    if (const auto field = object.find("outline")) {
        JsonObject outline(*field);
        outline.read("enabled", profile.outline.enabled);
        outline.read("colour", profile.outline.colour);
        outline.refuseUnknown();
    }
    if (const auto field = object.find("light")) {
        JsonObject light(*field);
        light.read("ambient", profile.light.ambient);
        light.read("towardLight", profile.light.towardLight);
        light.read("occlusion", profile.light.occlusion);
        light.read("shadow", profile.light.shadow);
        light.refuseUnknown();
    }
    readNamed(object, "shading", profile.shading, shadingNamed);
    object.refuseUnknown();
    return profile;
}

}  // namespace

const char* nameOf(ViewRule value) {
    return nameIn(kViewRules, value);
}
const char* nameOf(Registration value) {
    return nameIn(kRegistrations, value);
}
const char* nameOf(ProxyShape value) {
    return nameIn(kProxyShapes, value);
}
const char* nameOf(DepthRule value) {
    return nameIn(kDepthRules, value);
}
const char* nameOf(SpriteMode value) {
    return nameIn(kSpriteModes, value);
}
const char* nameOf(Shading value) {
    return nameIn(kShadings, value);
}

Result<ViewRule> viewRuleNamed(std::string_view name) {
    return valueIn(kViewRules, name);
}
Result<Registration> registrationNamed(std::string_view name) {
    return valueIn(kRegistrations, name);
}
Result<ProxyShape> proxyShapeNamed(std::string_view name) {
    return valueIn(kProxyShapes, name);
}
Result<DepthRule> depthRuleNamed(std::string_view name) {
    return valueIn(kDepthRules, name);
}
Result<SpriteMode> spriteModeNamed(std::string_view name) {
    return valueIn(kSpriteModes, name);
}
Result<Shading> shadingNamed(std::string_view name) {
    return valueIn(kShadings, name);
}

Result<GameProfile> readProfile(std::string_view text) {
    const auto json = parseJson(text);
    if (!json) return Failure(json.error());
    Result<GameProfile> profile = readFields([&] { return profileFromJson(*json); });
    if (!profile) return profile;
    if (Status valid = validate(*profile); !valid) return Failure(valid.error());
    return profile;
}

std::string writeProfile(const GameProfile& profile) {
    const glm::dvec3 light = profile.light.towardLight;
    const nlohmann::ordered_json json{
        {"voxprite_profile", kVersion},
        {"voxelSizeMetres", profile.voxelSizeMetres},
        {"sigma", profile.sigma},
        {"view", nameOf(profile.view)},
        {"registration", nameOf(profile.registration)},
        {"proxy", nameOf(profile.proxy)},
        {"depth", nameOf(profile.depth)},
        {"mode", nameOf(profile.mode)},
        {"groundClearancePx", profile.groundClearancePx},
        {"minification", profile.minification},
        {"viewStepDegrees", profile.viewStepDegrees},
        {"outline",
         {{"enabled", profile.outline.enabled}, {"colour", colourText(profile.outline.colour)}}},
        {"light",
         {{"ambient", profile.light.ambient},
          {"towardLight", {light.x, light.y, light.z}},
          {"occlusion", profile.light.occlusion},
          {"shadow", profile.light.shadow}}},
        {"shading", nameOf(profile.shading)},
    };
    return json.dump(2) + "\n";
}

Result<GameProfile> readProfileFile(const std::filesystem::path& path) {
    const Result<std::string> text = readTextFile(path);
    if (!text) return Failure(text.error());
    return inFile(readProfile(*text), path.string());
}

Status writeProfileFile(const std::filesystem::path& path, const GameProfile& profile) {
    if (Status valid = validate(profile); !valid) return inFile(std::move(valid), path.string());
    return writeFileAtomically(path, writeProfile(profile));
}

}  // namespace voxprite
