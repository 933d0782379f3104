// Chooses by what each entity of the scene is drawn, and colours them by it if the artist wants to
// see.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <utility>

#include "app/editor/settings/representation_settings.h"
#include "app/editor/views/level_library.h"
#include "app/editor/views/scene_figures.h"
#include "core/model/palette.h"
#include "render/scene_renderer.h"

namespace voxprite::editor {

[[nodiscard]] const char* nameOf(Representation kind);  // "Snapshot"
// What entities that are drawn so are tinted with.
[[nodiscard]] Rgba8 tintOf(Representation kind);
[[nodiscard]] Palette tinted(const Palette& palette, Rgba8 tint);

class SceneRepresentations {
  public:
    // `before`: what was chosen for each entity in the last picture of the same cell, and now is
    // for this one. What a model does not offer yet is drawn exactly. The scene reads the library
    // and this object.
    RepresentationShares choose(Scene& scene, const Camera& camera,
                                const RepresentationSettings& settings, const LevelLibrary& library,
                                std::span<std::optional<RepresentationChoice>> before);

  private:
    // Those of this scene's palettes, as they are now.
    void keepTinted(const Scene& scene, bool tint);

    std::map<std::pair<const Palette*, Representation>, Palette> tinted_;
};

}  // namespace voxprite::editor
