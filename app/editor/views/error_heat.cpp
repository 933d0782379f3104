#include "app/editor/views/error_heat.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "app/editor/views/heat_ramp.h"
#include "app/trade/meter.h"

namespace voxprite::editor {
namespace {

constexpr int kStillFrames = 3;  // before the pictures are drawn

// The pixels that either picture shows, and one more all round where there is room: beyond it
// nothing but background could enter the figures.
struct Part {
    glm::ivec2 min, max;
};
std::optional<Part> partOf(const Image& a, const Image& b) {
    Part part{glm::ivec2(a.width, a.height), glm::ivec2(0)};
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            if (a.at(x, y).w == 0 && b.at(x, y).w == 0) continue;
            part.min = glm::min(part.min, glm::ivec2(x, y));
            part.max = glm::max(part.max, glm::ivec2(x, y) + 1);
        }
    }
    if (part.max.x == 0) return std::nullopt;
    return Part{glm::max(part.min - 1, glm::ivec2(0)),
                glm::min(part.max + 1, glm::ivec2(a.width, a.height))};
}

Image cut(const Image& image, const Part& part) {
    Image result(part.max.x - part.min.x, part.max.y - part.min.y);
    for (int y = 0; y < result.height; ++y) {
        for (int x = 0; x < result.width; ++x) {
            result.at(x, y) = image.at(part.min.x + x, part.min.y + y);
        }
    }
    return result;
}

}  // namespace

std::optional<double> HeatMap::at(glm::ivec2 viewPx) const {
    const glm::ivec2 in = viewPx - min;
    if (in.x < 0 || in.y < 0 || in.x >= errors.width || in.y >= errors.height) return std::nullopt;
    if (image.at(in.x, in.y).w == 0) return std::nullopt;
    return errors.at(in.x, in.y);
}

Result<HeatMap> heatMapOf(const Image& yardstick, const Image& shown) {
    if (yardstick.width != shown.width || yardstick.height != shown.height) {
        return fail("The pictures differ in size");
    }
    HeatMap map;
    const std::optional<Part> part = partOf(yardstick, shown);
    if (!part) return map;
    map.min = part->min;
    const Image a = cut(yardstick, *part), b = cut(shown, *part);
    map.equal = a == b;
    Result<Plane> errors = trade::errorMap({a, {}, 0.0, 0.0}, {b, {}, 0.0, 0.0});
    if (!errors) return Failure(errors.error());
    map.errors = std::move(*errors);
    map.image = Image(a.width, a.height);
    double sum = 0.0;
    std::uint64_t count = 0;
    for (std::size_t k = 0; k < a.pixels.size(); ++k) {
        if (a.pixels[k].w < 128 && b.pixels[k].w < 128) continue;
        sum += map.errors.values[k];
        ++count;
        map.image.pixels[k] = heatColour(map.errors.values[k]);
    }
    map.mean = count > 0 ? sum / static_cast<double>(count) : 0.0;
    return map;
}

void ErrorHeat::clear() {
    terms_.reset();
    map_.reset();
    job_.cancel();
}

Status ErrorHeat::follow(const Terms& terms, const Subject& subject, SceneRenderer& renderer) {
    if (terms_ != terms) {
        clear();
        terms_ = terms;
        still_ = 0;
        failed_ = false;
        return {};
    }
    job_.finish();
    if (map_ || failed_ || job_.running() || ++still_ < kStillFrames) return {};
    Result<Pictures> pictures = draw(subject, renderer);
    failed_ = !pictures;
    if (!pictures) return Failure(pictures.error());
    job_.start(
        "Error map", [this, pictures = std::move(*pictures)](JobProgress&) -> BackgroundJob::Done {
            auto map =
                std::make_shared<Result<HeatMap>>(heatMapOf(pictures.yardstick, pictures.shown));
            return [this, map] {
                failed_ = !*map;
                if (failed_) return;
                map_ = std::move(**map);
                texture_.set(map_->image);
            };
        });
    return {};
}

Result<ErrorHeat::Pictures> ErrorHeat::draw(const Subject& subject, SceneRenderer& renderer) {
    if (!frame_) frame_ = std::make_unique<Frame>(subject.camera.viewportPx);
    frame_->resize(subject.camera.viewportPx);
    ViewHistory history = subject.shown.history != nullptr ? *subject.shown.history : ViewHistory();
    Scene scene;
    scene.clusterBudgetPx = terms_->clusterBudgetPx;
    scene.entities = {subject.shown};
    scene.entities.front().history = &history;
    const auto picture = [&](const GameProfile& profile) -> Result<Image> {
        const Result<SceneStats> stats =
            renderer.draw(*frame_, scene, subject.camera, profile, SpriteMode::spriteBuffer);
        if (!stats) return Failure(stats.error());
        return frame_->readColour();
    };
    Result<Image> shown = picture(terms_->profile);
    if (!shown) return Failure(shown.error());
    Result<Image> yardstick = Image();
    if (terms_->yardstick == HeatYardstick::perspective) {
        yardstick = drawPerspective(subject);
    } else {
        const bool own = terms_->yardstick == HeatYardstick::exactView;
        GameProfile exact = own ? terms_->profile : terms_->reference;
        exact.viewStepDegrees = 0.0;
        exact.proxy = ProxyShape::quad;
        history.snappedSteps.reset();
        if (!own) history.halvings.reset();
        scene.entities = {{subject.octree, subject.shown.palette, subject.placed, &history}};
        yardstick = picture(exact);
    }
    if (!yardstick) return Failure(yardstick.error());
    return Pictures{std::move(*yardstick), std::move(*shown)};
}

Result<Image> ErrorHeat::drawPerspective(const Subject& subject) {
    if (!voxels_) {
        Result<VoxelView> created = VoxelView::create();
        if (!created) return Failure(created.error());
        voxels_ = std::move(*created);
    }
    VoxelViewOptions options;
    options.edges = false;
    options.occlusion = VoxelOcclusion::off;
    options.spriteLight = true;
    options.shading = terms_->reference.shading;
    options.ground = false;
    options.light = terms_->reference.light;
    voxels_->draw(*frame_, *subject.octree, *subject.shown.palette, subject.placed, subject.camera,
                  options);
    Image image = frame_->readColour();
    const std::vector<float> depths = frame_->readDepth();
    // Where no voxel lies is the view's own backdrop.
    for (std::size_t k = 0; k < depths.size(); ++k) {
        if (depths[k] == 0.0f) image.pixels[k] = Rgba8(0);
    }
    return image;
}

}  // namespace voxprite::editor
