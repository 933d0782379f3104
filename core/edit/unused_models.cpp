#include "core/edit/unused_models.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace voxprite {

namespace {

std::vector<bool> shownModels(const Document& document) {
    std::vector<bool> shown(document.models.size(), false);
    for (const SceneNode& node : document.nodes) {
        for (const ModelKey& key : node.models) shown[static_cast<std::size_t>(key.model)] = true;
    }
    return shown;
}

}  // namespace

int unusedModels(const Document& document) {
    return static_cast<int>(std::ranges::count(shownModels(document), false));
}

Document withoutUnusedModels(Document document) {
    const std::vector<bool> shown = shownModels(document);
    std::vector<int> numbers(shown.size(), 0);
    std::vector<Model> kept;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        if (!shown[i]) continue;
        numbers[i] = static_cast<int>(kept.size());
        kept.push_back(std::move(document.models[i]));
    }
    document.models = std::move(kept);
    for (SceneNode& node : document.nodes) {
        for (ModelKey& key : node.models) key.model = numbers[static_cast<std::size_t>(key.model)];
    }
    return document;
}

}  // namespace voxprite
