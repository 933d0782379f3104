// Where a sprite differs from what it stands for, as colours over it, with the mean.
//
// Both pictures are drawn by the view's own renderer once nothing has changed for a moment; what
// they differ by is worked out on a thread of its own. A hand that moves is never waited on, and
// no map is shown over a picture that it is not of.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/editor/session/background_job.h"
#include "app/editor/settings/trade_settings.h"
#include "app/editor/views/orbit_camera.h"
#include "app/editor/views/view_canvas.h"
#include "core/base/image.h"
#include "core/measure/plane.h"
#include "render/picture_texture.h"
#include "render/scene_renderer.h"
#include "render/voxel_view.h"

namespace voxprite::editor {

// Of two pictures of a view, cut to where either shows something.
struct HeatMap {
    glm::ivec2 min{0};  // where in the view it lies
    Plane errors;       // FLIP of each pixel, 0 ... 1
    Image image;        // heatColour() of it; transparent where neither picture shows anything
    double mean = 0.0;  // flipInside() of the two
    bool equal = true;  // not one pixel differs
    // The error under a pixel of the view; nothing where there is no sprite.
    [[nodiscard]] std::optional<double> at(glm::ivec2 viewPx) const;
};
// Fails when they differ in size.
[[nodiscard]] Result<HeatMap> heatMapOf(const Image& yardstick, const Image& shown);

class ErrorHeat {
  public:
    // What the map is of. `shown` is drawn as the view draws it, from the history of its view.
    struct Subject {
        SceneEntity shown;
        const GpuOctree* octree = nullptr;  // the exact model and its place
        PlacedEntity placed;
        Camera camera;
    };
    // All that the pictures depend on.
    struct Terms {
        std::uint64_t octree = 0, session = 0, library = 0;
        GameProfile profile;    // of what shows
        GameProfile reference;  // of the reference's exact sprite
        OrbitCamera camera;
        glm::ivec2 sizePx{0};
        RepresentationChoice choice;
        std::string views;
        double clusterBudgetPx = 1.0;
        HeatYardstick yardstick = HeatYardstick::exactView;
        bool operator==(const Terms&) const = default;
    };

    // Once a frame while the map is wanted, with the window's GL context. A history stays as it is.
    [[nodiscard]] Status follow(const Terms& terms, const Subject& subject,
                                SceneRenderer& renderer);
    void clear();
    // Something is still to be worked out.
    [[nodiscard]] bool busy() const { return terms_ && !map_ && !failed_; }
    // Waits for what is being worked out; the next follow() has it.
    void wait() { job_.wait(); }

    // Of the terms followed last; null until it is worked out.
    [[nodiscard]] const HeatMap* map() const { return map_ ? &*map_ : nullptr; }

    // The map over the picture, and what its colours mean; between the canvas' begin() and end().
    void show(Ui& ui, const ViewCanvas& canvas, glm::dvec2 pointerPx) const;

  private:
    struct Pictures {
        Image yardstick, shown;
    };
    [[nodiscard]] Result<Pictures> draw(const Subject& subject, SceneRenderer& renderer);
    [[nodiscard]] Result<Image> drawPerspective(const Subject& subject);

    std::optional<Terms> terms_;
    int still_ = 0;  // frames in a row with the same terms
    bool failed_ = false;
    std::optional<HeatMap> map_;
    PictureTexture texture_;
    std::unique_ptr<Frame> frame_;
    std::optional<VoxelView> voxels_;
    BackgroundJob job_;  // last: what it uses goes after it
};

}  // namespace voxprite::editor
