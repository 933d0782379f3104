#include "app/editor/views/scene_representations.h"

#include <cmath>
#include <set>

namespace voxprite::editor {
namespace {

constexpr int kTintPercent = 58;

// Is a sphere of that radius, by its centre, somewhere on the screen?
bool inView(const PlacedEntity& placed, const Camera& camera, double radiusPx) {
    if (!(radiusPx >= 0.0)) return false;
    const glm::dvec2 at = camera.project(placed.centreMetres()).screenPx;
    return at.x > -radiusPx && at.y > -radiusPx && at.x < camera.viewportPx.x + radiusPx &&
           at.y < camera.viewportPx.y + radiusPx;
}

}  // namespace

const char* nameOf(Representation kind) {
    constexpr std::array kNames{"Exact", "Snapshot", "Clusters", "Coarse"};
    return kNames[static_cast<std::size_t>(kind)];
}

Rgba8 tintOf(Representation kind) {
    constexpr std::array kTints{Rgba8(82, 196, 108, 255), Rgba8(72, 150, 255, 255),
                                Rgba8(255, 160, 40, 255), Rgba8(226, 84, 196, 255)};
    return kTints[static_cast<std::size_t>(kind)];
}

Palette tinted(const Palette& palette, Rgba8 tint) {
    Palette result = palette;
    for (std::size_t index = 1; index < result.colours.size(); ++index) {
        for (int channel = 0; channel < 3; ++channel) {
            const int own = result.colours[index][channel];
            result.colours[index][channel] = static_cast<std::uint8_t>(
                (own * (100 - kTintPercent) + tint[channel] * kTintPercent + 50) / 100);
        }
    }
    return result;
}

void SceneRepresentations::keepTinted(const Scene& scene, bool tint) {
    std::set<const Palette*> palettes;
    for (const SceneEntity& entity : scene.entities) {
        if (tint) palettes.insert(entity.palette);
    }
    // The palette of a model that has gone is not there any more.
    std::erase_if(tinted_, [&](const auto& item) { return !palettes.contains(item.first.first); });
    for (auto& [key, palette] : tinted_) palette = tinted(*key.first, tintOf(key.second));
}

RepresentationShares SceneRepresentations::choose(
    Scene& scene, const Camera& camera, const RepresentationSettings& settings,
    const LevelLibrary& library, std::span<std::optional<RepresentationChoice>> before) {
    RepresentationShares shares;
    std::map<const GpuOctree*, std::pair<const GpuModelLevels*, const RepresentationTable*>> known;
    keepTinted(scene, settings.tint);
    scene.clusterBudgetPx = settings.clusterBudgetPx;
    const ChoiceRules rules = settings.rules();
    for (std::size_t k = 0; k < scene.entities.size(); ++k) {
        SceneEntity& entity = scene.entities[k];
        auto& [levels, table] = known[entity.octree];
        if (table == nullptr) {
            levels = library.levelsOf(entity.octree);
            table = &library.tableOf(entity.octree);
        }
        const double sizePx = representationSizePx(entity.placed, camera);
        const RepresentationChoice choice = voxprite::choose(*table, sizePx, rules, before[k]);
        before[k] = choice;
        const bool seen = inView(entity.placed, camera, sizePx);
        entity = drawnBy(entity, choice, levels, library.views());
        RepresentationShare& share = shares[static_cast<std::size_t>(entity.representation)];
        if (seen) {
            ++share.entities;
            const RepresentationFigures* figures = figuresOf(*table, choice);
            const double cost = figures != nullptr ? microsecondsAt(*figures, sizePx) : 0.0;
            if (std::isfinite(cost)) share.microseconds += cost;
        }
        if (!settings.tint) continue;
        const std::pair key(entity.palette, entity.representation);
        auto found = tinted_.find(key);
        if (found == tinted_.end()) {
            found =
                tinted_.emplace(key, tinted(*entity.palette, tintOf(entity.representation))).first;
        }
        entity.palette = &found->second;
    }
    return shares;
}

}  // namespace voxprite::editor
