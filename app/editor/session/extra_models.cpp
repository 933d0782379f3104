#include "app/editor/session/extra_models.h"

#include <algorithm>
#include <cmath>

#include "core/io/formats.h"
#include "core/model/entity_voxels.h"
#include "core/svo/bake.h"

namespace voxprite::editor {
namespace {

// More of an animation than this is not kept beside the edited model.
constexpr int kMostFrames = 64;

Result<ExtraModel> load(const ExtraModelChoice& choice) {
    const std::filesystem::path& file = choice.file;
    ReadOptions options;
    options.entity = choice.entity;
    Result<LoadedDocument> loaded = loadDocument(file, options);
    if (!loaded) return Failure(loaded.error());
    const Document& document = loaded->document;
    // Files are exported anew: better none than another one.
    if (choice.entity && document.entity.name != choice.entityName) {
        return failInFile(file.string(), "holds \"" + document.entity.name + "\" where \"" +
                                             choice.entityName + "\" was; choose it anew");
    }
    ExtraModel model;
    model.choice = choice;
    model.name = choice.entity ? choice.entityName : file.stem().string();
    model.palette = document.palette;
    model.entity = document.entity;
    model.bounds = entityBounds(document);
    if (model.bounds.empty()) return failInFile(file.string(), "has no voxels to show");
    if (!document.clips.empty()) model.framesPerSecond = document.clips.front().framesPerSecond;
    const int frames = std::min(frameCount(document), kMostFrames);
    for (int frame = 0; frame < frames; ++frame) {
        Result<Octree> octree = bake(flatten(document, frame), model.bounds);
        if (!octree) return inFile(Result<ExtraModel>(Failure(octree.error())), file.string());
        model.frames.emplace_back().upload(octree->view());
        model.octrees.push_back(std::move(*octree));
    }
    return model;
}

bool among(const std::vector<ExtraModelChoice>& choices, const ExtraModelChoice& one) {
    return std::ranges::any_of(choices, [&](const auto& choice) { return choice.names(one); });
}

}  // namespace

const GpuOctree& ExtraModel::at(double seconds) const {
    const auto count = static_cast<double>(frames.size());
    const double frame = std::floor(std::max(seconds, 0.0) * framesPerSecond);
    return frames[static_cast<std::size_t>(std::fmod(frame, count))];
}

std::vector<Error> ExtraModels::follow(const std::vector<ExtraModelChoice>& choices) {
    std::vector<Error> errors;
    if (std::erase_if(models_, [&](const auto& m) { return !among(choices, m.choice); }) > 0) {
        ++revision_;
    }
    std::erase_if(failed_, [&](const auto& choice) { return !among(choices, choice); });
    for (const ExtraModelChoice& choice : choices) {
        if (find(choice) != nullptr || failed(choice)) continue;
        Result<ExtraModel> model = load(choice);
        if (model) {
            models_.push_back(std::move(*model));
            ++revision_;
        } else {
            errors.push_back(model.error());
            failed_.push_back(choice);
        }
    }
    return errors;
}

const ExtraModel* ExtraModels::find(const ExtraModelChoice& choice) const {
    const auto found =
        std::ranges::find_if(models_, [&](const auto& m) { return m.choice.names(choice); });
    return found != models_.end() ? &*found : nullptr;
}

bool ExtraModels::failed(const ExtraModelChoice& choice) const {
    return among(failed_, choice);
}

bool ExtraModels::animated() const {
    return std::ranges::any_of(models_, [](const auto& m) { return m.frames.size() > 1; });
}

}  // namespace voxprite::editor
