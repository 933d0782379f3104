#include "render/measure_representations.h"

#include <glad/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <random>

#include "core/measure/compare.h"

namespace voxprite {

namespace {

constexpr double kFovDegrees = 45.0;
constexpr int kCrowdEdgePx = 256;  // about as large as a crowd's picture gets
constexpr int kMostInRow = 6;
constexpr int kTimedFrames = 3;
constexpr double kLeastTurnDegrees = 3.0;  // of the camera, from frame to frame
constexpr double kCrowdPitchDegrees = 20.0;

SceneEntity entityOf(const MeasuredModel& model, RepresentationChoice choice, glm::dvec3 centre,
                     double turnDegrees) {
    SceneEntity exact{model.octree, model.palette, model.placed};
    const SinCos turn = sinCosDegrees(turnDegrees);
    const glm::dmat3 aboutUp({turn.cos, 0, -turn.sin}, {0, 1, 0}, {turn.sin, 0, turn.cos});
    exact.placed.worldFromVoxelAxes = aboutUp * exact.placed.worldFromVoxelAxes;
    exact.placed.anchorMetres += centre - exact.placed.centreMetres();
    return drawnBy(exact, choice, model.levels, *model.views);
}

double microsecondsOf(SceneRenderer& renderer, Frame& frame, const Scene& scene,
                      const Camera& camera, const GameProfile& profile, Status& status) {
    const auto start = std::chrono::steady_clock::now();
    const Result<SceneStats> drawn = renderer.draw(frame, scene, camera, profile, profile.mode);
    if (!drawn) status = Failure(drawn.error());
    glFinish();
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start)
        .count();
}

// Of one entity in a crowd that the camera goes round, the empty picture not counted. All are as
// far away, in rows across the picture, and each stands its own way.
Result<double> costAtSize(SceneRenderer& renderer, const MeasuredModel& model,
                          const GameProfile& profile, RepresentationChoice choice, double sizePx) {
    const int edge = edgeAtSize(sizePx);
    const int inRow = std::clamp(kCrowdEdgePx / edge, 1, kMostInRow);
    const double radius = model.placed.radiusMetres();
    const double spacing = edge * radius / sizePx;
    const double turnDegrees = std::max(kLeastTurnDegrees, 1.1 * profile.viewStepDegrees);
    Frame frame(glm::ivec2(edge * inRow));
    Status status;
    double least = std::numeric_limits<double>::infinity(), empty = least;
    // The first frame makes what is kept.
    for (int each = 0; each <= kTimedFrames; ++each) {
        const Camera camera = cameraAtSize(
            radius, sizePx, {turnDegrees * each, kCrowdPitchDegrees, 0.0}, frame.sizePx());
        Scene scene;
        scene.clusterBudgetPx = model.clusterBudgetPx;
        const double none = microsecondsOf(renderer, frame, scene, camera, profile, status);
        for (int k = 0; k < inRow * inRow; ++k) {
            const glm::dvec2 at = glm::dvec2(k % inRow, k / inRow) - 0.5 * (inRow - 1);
            const glm::dvec3 centre = (camera.right * at.x + camera.up * at.y) * spacing;
            scene.entities.push_back(entityOf(model, choice, centre, 137.5 * k));
        }
        const double all = microsecondsOf(renderer, frame, scene, camera, profile, status);
        if (!status) return Failure(status.error());
        if (each == 0) continue;
        empty = std::min(empty, none);
        least = std::min(least, all);
    }
    return std::max(0.0, least - empty) / (inRow * inRow);
}

}  // namespace

std::vector<OrbitAngles> viewsOf(const MeasuringPlan& plan) {
    std::mt19937 random(plan.seed);
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    std::vector<OrbitAngles> views;
    for (int k = 0; k < plan.views; ++k) {
        const double yaw = 360.0 * unit();
        views.push_back({yaw, -10.0 + 70.0 * unit(), 0.0});
    }
    return views;
}

int edgeAtSize(double sizePx) {
    return 2 * static_cast<int>(std::ceil(1.25 * sizePx)) + 16;
}

Camera cameraAtSize(double radiusMetres, double sizePx, const OrbitAngles& view,
                    glm::ivec2 viewportPx) {
    const double tangentPerPx = std::tan(glm::radians(kFovDegrees) / 2.0) / kReferenceHeightPx;
    const double fov = glm::degrees(2.0 * std::atan(tangentPerPx * viewportPx.y));
    return orbitCamera(view, glm::dvec3(0.0), radiusMetres / (sizePx * 2.0 * tangentPerPx), fov,
                       viewportPx);
}

Result<Image> pictureAtSize(SceneRenderer& renderer, const MeasuredModel& model,
                            const GameProfile& profile, RepresentationChoice choice, double sizePx,
                            const OrbitAngles& view) {
    const Camera camera =
        cameraAtSize(model.placed.radiusMetres(), sizePx, view, glm::ivec2(edgeAtSize(sizePx)));
    Scene scene;
    scene.clusterBudgetPx = model.clusterBudgetPx;
    scene.entities = {entityOf(model, choice, glm::dvec3(0.0), 0.0)};
    Frame frame(camera.viewportPx);
    const Result<SceneStats> drawn = renderer.draw(frame, scene, camera, profile, profile.mode);
    if (!drawn) return Failure(drawn.error());
    return frame.readColour();
}

struct RepresentationMeter::Impl {
    MeasuredModel model;
    GameProfile profile;
    MeasuringPlan plan;
    std::vector<OrbitAngles> views;
    RepresentationTable table;
    // A step compares one representation from one view, or times it after the last view.
    std::size_t size = 0, view = 0, choice = 0;
    Image exact;  // of this size and view

    [[nodiscard]] std::size_t stepsOfSize() const {
        return table.size() * (views.size() + (plan.costs ? 1 : 0));
    }
    [[nodiscard]] bool timing() const { return view == views.size(); }
    void advance();
    [[nodiscard]] Status measure(SceneRenderer& renderer, RepresentationFigures& figures);
};

void RepresentationMeter::Impl::advance() {
    if (++choice < table.size()) return;
    choice = 0;
    if (++view < views.size() + (plan.costs ? 1 : 0)) return;
    view = 0;
    ++size;
}

Status RepresentationMeter::Impl::measure(SceneRenderer& renderer, RepresentationFigures& figures) {
    const double sizePx = plan.sizesPx[size];
    if (figures.bySize.size() == size) figures.bySize.push_back({sizePx, 0.0, 0.0});
    RepresentationFigures::AtSize& figure = figures.bySize.back();
    if (timing()) {
        const Result<double> cost = costAtSize(renderer, model, profile, figures.choice, sizePx);
        if (!cost) return Failure(cost.error());
        figure.microseconds = *cost;
        return {};
    }
    Result<Image> picture =
        pictureAtSize(renderer, model, profile, figures.choice, sizePx, views[view]);
    if (!picture) return Failure(picture.error());
    if (figures.choice.kind == Representation::sprite) {
        exact = std::move(*picture);
        return {};
    }
    const Result<double> error = flipInside(exact, *picture);
    if (!error) return Failure(error.error());
    figure.error = std::max(figure.error, *error);
    return {};
}

RepresentationMeter::RepresentationMeter(const MeasuredModel& model, const GameProfile& profile,
                                         const MeasuringPlan& plan)
    : impl_(std::make_unique<Impl>()) {
    impl_->model = model;
    impl_->profile = profile;
    impl_->plan = plan;
    impl_->views = viewsOf(plan);
    // The exact sprite comes first: the others are compared with it.
    for (const RepresentationChoice choice : choicesOf(*model.levels)) {
        impl_->table.push_back({choice, {}});
    }
}

bool RepresentationMeter::done() const {
    return impl_->size == impl_->plan.sizesPx.size() || impl_->stepsOfSize() == 0;
}

double RepresentationMeter::share() const {
    if (done()) return 1.0;
    const std::size_t before = impl_->view * impl_->table.size() + impl_->choice;
    const std::size_t all = impl_->plan.sizesPx.size() * impl_->stepsOfSize();
    return static_cast<double>(impl_->size * impl_->stepsOfSize() + before) /
           static_cast<double>(all);
}

Status RepresentationMeter::step(SceneRenderer& renderer) {
    if (done()) return {};
    const Status measured = impl_->measure(renderer, impl_->table[impl_->choice]);
    if (measured) impl_->advance();
    return measured;
}

const RepresentationTable& RepresentationMeter::table() const {
    return impl_->table;
}

Result<RepresentationTable> measureRepresentations(SceneRenderer& renderer,
                                                   const MeasuredModel& model,
                                                   const GameProfile& profile,
                                                   const MeasuringPlan& plan) {
    RepresentationMeter meter(model, profile, plan);
    while (!meter.done()) {
        if (const Status measured = meter.step(renderer); !measured) {
            return Failure(measured.error());
        }
    }
    return meter.table();
}

RepresentationMeter::~RepresentationMeter() = default;
RepresentationMeter::RepresentationMeter(RepresentationMeter&&) noexcept = default;
RepresentationMeter& RepresentationMeter::operator=(RepresentationMeter&&) noexcept = default;

}  // namespace voxprite
