// Models of other files, ready to be drawn beside the edited one: every frame baked and uploaded
// once.
#pragma once

#include <deque>
#include <filesystem>
#include <list>
#include <optional>
#include <string>
#include <vector>

#include "app/editor/settings/scene_settings.h"
#include "core/base/box.h"
#include "core/base/result.h"
#include "core/model/document.h"
#include "render/gpu_octree.h"

namespace voxprite::editor {

struct ExtraModel {
    ExtraModelChoice choice;  // that it is of
    std::string name;
    Palette palette;
    Entity entity;
    IBox bounds;
    double framesPerSecond = 8.0;
    std::deque<GpuOctree> frames;  // at least one
    std::vector<Octree> octrees;   // of which they are
    // Which frame shows after the animation went on for so long.
    [[nodiscard]] const GpuOctree& at(double seconds) const;
};

class ExtraModels {
  public:
    // Loads what is chosen and not there yet, forgets what is not chosen any more. A file that
    // cannot be read is told once, and tried again only after it has been chosen anew. Needs the
    // window's GL context.
    [[nodiscard]] std::vector<Error> follow(const std::vector<ExtraModelChoice>& chosen);
    // Null while the choice is not loaded. Valid until a follow() that does not choose it.
    [[nodiscard]] const ExtraModel* find(const ExtraModelChoice& choice) const;
    [[nodiscard]] bool failed(const ExtraModelChoice& choice) const;
    // Rises with every model that came or went.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }
    // Some model has an animation.
    [[nodiscard]] bool animated() const;

  private:
    std::list<ExtraModel> models_;
    std::vector<ExtraModelChoice> failed_;
    std::uint64_t revision_ = 0;
};

}  // namespace voxprite::editor
