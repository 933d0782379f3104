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

Result<ExtraModel> load(const std::filesystem::path& file) {
    Result<LoadedDocument> loaded = loadDocument(file);
    if (!loaded) return Failure(loaded.error());
    const Document& document = loaded->document;
    ExtraModel model;
    model.file = file;
    model.name = file.stem().string();
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

bool chosen(const std::vector<ExtraModelChoice>& choices, const std::filesystem::path& file) {
    return std::ranges::find(choices, file, &ExtraModelChoice::file) != choices.end();
}

}  // namespace

const GpuOctree& ExtraModel::at(double seconds) const {
    const auto count = static_cast<double>(frames.size());
    const double frame = std::floor(std::max(seconds, 0.0) * framesPerSecond);
    return frames[static_cast<std::size_t>(std::fmod(frame, count))];
}

std::vector<Error> ExtraModels::follow(const std::vector<ExtraModelChoice>& choices) {
    std::vector<Error> errors;
    if (std::erase_if(models_, [&](const auto& m) { return !chosen(choices, m.file); }) > 0) {
        ++revision_;
    }
    std::erase_if(failed_, [&](const auto& file) { return !chosen(choices, file); });
    for (const ExtraModelChoice& choice : choices) {
        if (find(choice.file) != nullptr || failed(choice.file)) continue;
        Result<ExtraModel> model = load(choice.file);
        if (model) {
            models_.push_back(std::move(*model));
            ++revision_;
        } else {
            errors.push_back(model.error());
            failed_.push_back(choice.file);
        }
    }
    return errors;
}

const ExtraModel* ExtraModels::find(const std::filesystem::path& file) const {
    const auto found = std::ranges::find(models_, file, &ExtraModel::file);
    return found != models_.end() ? &*found : nullptr;
}

bool ExtraModels::failed(const std::filesystem::path& file) const {
    return std::ranges::find(failed_, file) != failed_.end();
}

bool ExtraModels::animated() const {
    return std::ranges::any_of(models_, [](const auto& m) { return m.frames.size() > 1; });
}

}  // namespace voxprite::editor
