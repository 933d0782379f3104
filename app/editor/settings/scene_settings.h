// What the sprite view shows around the edited model, and how it is drawn: choices of the viewer
// that belong neither to a document nor to the game.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/settings/representation_settings.h"
#include "app/editor/views/sigma_comparison.h"

namespace voxprite::editor {

enum class CopyPattern : std::uint8_t {
    none,
    grid,   // rows and columns around the edited model
    crowd,  // at random places around it, none in another's way
    march   // ranks that walk past it on both sides
};

inline constexpr int kMostCopies = 10'000;
// Closer, and models would stand in each other.
inline constexpr double kLeastSpacing = 0.92;
inline constexpr double kMostSpacing = 8.0;
inline constexpr int kMostPictureScale = 16;

struct CopySettings {
    CopyPattern pattern = CopyPattern::none;
    int count = 100;         // beside the edited model, 1 ... kMostCopies
    double spacing = 1.0;    // times what the sizes of the models suggest
    bool turned = true;      // grid and crowd: each stands its own way, in steps of 45 degrees
    int seed = 1;            // of everything that is random
    bool editedUsed = true;  // the edited model is among those copied
    bool operator==(const CopySettings&) const = default;
};

// A model of another file, to stand among the copies.
struct ExtraModelChoice {
    std::filesystem::path file;
    bool used = true;
    // Of a file with several entities: which one, and what it was called when it was chosen.
    std::optional<std::size_t> entity{};
    std::string entityName{};

    [[nodiscard]] bool names(const ExtraModelChoice& other) const {
        return file == other.file && entity == other.entity;
    }
    bool operator==(const ExtraModelChoice&) const = default;
};

struct SceneSettings {
    CopySettings copies;
    std::vector<ExtraModelChoice> extras;
    double pace = 0.8;        // of the march: heights of the edited model a second, 0 ... 10
    bool everyFrame = false;  // draw without need, to read what a frame costs
    // Of saved and copied sprites: picture pixels a virtual pixel, 1 ... kMostPictureScale.
    int pictureScale = 1;
    SigmaComparison comparison;
    RepresentationSettings representations;

    // One more extra model, in use, and copies to be seen of it; no second time.
    void add(const ExtraModelChoice& extra);
    bool operator==(const SceneSettings&) const = default;
};

[[nodiscard]] nlohmann::json toJson(const SceneSettings& settings);
// Defaults for what is missing; what is out of range is brought into it.
[[nodiscard]] SceneSettings sceneSettingsFrom(const nlohmann::json& json);

}  // namespace voxprite::editor
