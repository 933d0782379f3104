#include "app/trade/meter.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numeric>
#include <random>

#include "app/trade/drawer.h"
#include "app/trade/gl_stage.h"
#include "app/trade/shown_errors.h"
#include "core/base/thread_stopwatch.h"
#include "core/measure/compare.h"
#include "core/measure/temporal.h"
#include "core/sprite/perspective_picture.h"
#include "core/trace/ideal_caster.h"
#include "render/measure_representations.h"

namespace voxprite::trade {
namespace {

constexpr int kMostRepeats = 50;
constexpr int kSectionFrames = 8;  // of a way, timed together
constexpr double kMostSizePx = 512.0;
constexpr double kWayPitchDegrees = 22.0;
constexpr double kWayClimb = 0.2;  // degrees of pitch a degree of yaw, to and fro

// The mean frame of a way, as it is gone along; section by section.
class WayTimes {
  public:
    explicit WayTimes(std::size_t frames) : frames_(frames) {}
    void add(double milliseconds) {
        if (added_++ % kSectionFrames == 0) sections_.push_back(0.0);
        sections_.back() += milliseconds / static_cast<double>(frames_);
    }
    [[nodiscard]] std::vector<double> take() { return std::move(sections_); }

  private:
    std::size_t frames_;
    std::size_t added_ = 0;
    std::vector<double> sections_;
};

// The angle of the whole rotation from one camera's axes to another's, roll included; precise for
// small angles too.
double degreesBetween(const Camera& a, const Camera& b) {
    const auto squared = [](glm::dvec3 d) { return glm::dot(d, d); };
    const double sum =
        squared(a.right - b.right) + squared(a.up - b.up) + squared(a.forward - b.forward);
    return glm::degrees(2.0 * std::asin(std::min(1.0, std::sqrt(sum / 8.0))));
}

Status validate(const Plan& plan) {
    if (Status profile = voxprite::validate(plan.profile); !profile) return profile;
    if (plan.sizesPx.empty()) return fail("there is no size to measure at");
    for (const double size : plan.sizesPx)
        if (!(size >= 1.0 && size <= kMostSizePx))
            return fail("sizes to measure at must be 1 ... 512 pixels");
    if (!std::is_sorted(plan.sizesPx.begin(), plan.sizesPx.end()))
        return fail("sizes to measure at must ascend");
    if (plan.views < 1 || plan.frames < 2 || !(plan.degreesAFrame > 0.0) || plan.leastRepeats < 1 ||
        plan.idealSamples < 1 || !(plan.flipPixelsPerDegree > 0.0))
        return fail("a plan needs views, frames, turns, repeats, samples and pixels a degree");
    const std::size_t recorded = plan.recordedWay.size();
    if (recorded == 1 || recorded > kMostWayFrames)
        return fail("a recorded way has 2 ... 10000 frames");
    return {};
}

}  // namespace

Plan quickPlan(const GameProfile& profile) {
    Plan plan;
    plan.profile = profile;
    plan.sizesPx = {64};
    plan.views = 2;
    plan.frames = 40;
    plan.degreesAFrame = 2.25;
    plan.leastRepeats = 2;
    plan.repeatMilliseconds = 0.0;
    plan.idealSamples = 500;
    return plan;
}

struct Meter::Impl {
    std::shared_ptr<const Model> model;
    Plan plan;
    ModelParts parts;
    GlStage* gl = nullptr;
    std::vector<OrbitAngles> views;
    double wayStartDegrees = 0.0;
    // By size and view, made when they are first asked for.
    struct Truth {
        explicit Truth(Shown made, double pixelsPerDegree)
            : shown(std::move(made)), compared(shown.image, pixelsPerDegree) {}
        Shown shown;
        ComparedPicture compared;
    };
    struct Yardsticks {
        std::unique_ptr<const Truth> sprite, perspective;
    };
    std::vector<std::vector<Yardsticks>> yardsticks;

    Impl(std::shared_ptr<const Model> measured, Plan how, GlStage* stage);
    [[nodiscard]] Setting wanted() const;
    [[nodiscard]] Camera camera(const OrbitAngles& view, double sizePx) const {
        return cameraAtSize(parts.placed().radiusMetres(), sizePx, view,
                            glm::ivec2(edgeAtSize(sizePx)));
    }
    [[nodiscard]] std::vector<Camera> way(double sizePx) const;
    [[nodiscard]] Result<Shown> yardstick(Yardstick which, const Camera& camera);
    [[nodiscard]] Result<const Truth*> kept(Yardstick which, std::size_t size, std::size_t view);
    [[nodiscard]] NumberErrors numbers(const Drawer& drawer, std::size_t view) const;
    [[nodiscard]] Status measureErrors(Drawer& drawer, std::size_t size, AtSize& out,
                                       const Progress& progress, bool& stopped);
    [[nodiscard]] Status measureWay(Drawer& drawer, const Setting& setting,
                                    double prepareMilliseconds, AtSize& out,
                                    const Progress& progress, bool& stopped);
    // The last run counts among the repeats where `already` is 1; else that is 0.
    [[nodiscard]] Status timeWay(Drawer& drawer, const Setting& setting, AtSize& out,
                                 std::size_t already, const Progress& progress, bool& stopped);
    // Nothing when it was stopped.
    [[nodiscard]] Result<std::optional<std::vector<double>>> timeRun(
        Drawer& drawer, const Setting& setting, const std::vector<Camera>& cameras,
        const Progress& progress);
    [[nodiscard]] bool byGl(const Setting& setting) const {
        return gl != nullptr && setting.walk == Walk::lattice;
    }
};

Meter::Impl::Impl(std::shared_ptr<const Model> measured, Plan how, GlStage* stage)
    : model(std::move(measured)), plan(std::move(how)), parts(model, plan.profile), gl(stage) {
    // The generator is the standard's, its numbers the same everywhere; its distributions are not.
    std::mt19937_64 random(plan.seed);
    const auto unit = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
    for (int k = 0; k < plan.views; ++k) {
        const double yaw = 360.0 * unit();
        views.push_back({yaw, -10.0 + 70.0 * unit(), 0.0});
    }
    wayStartDegrees = 360.0 * unit();
    yardsticks.resize(plan.sizesPx.size());
    for (std::vector<Yardsticks>& ofSize : yardsticks) ofSize.resize(views.size());
}

// The sprite that the game asks for, without what only makes it cheaper.
Setting Meter::Impl::wanted() const {
    Setting setting = settingOf(plan.profile);
    setting.mode = SpriteMode::spriteBuffer;
    setting.viewStepDegrees = 0.0;
    setting.proxy = ProxyShape::quad;
    return setting;
}

std::vector<Camera> Meter::Impl::way(double sizePx) const {
    std::vector<Camera> cameras;
    for (const OrbitAngles& each : plan.recordedWay) cameras.push_back(camera(each, sizePx));
    if (!cameras.empty()) return cameras;
    for (int k = 0; k < plan.frames; ++k) {
        const double turned = k * plan.degreesAFrame;
        // To and fro, without a corner.
        const double climbed = kWayClimb * 50.0 * std::sin(glm::radians(turned) * 180.0 / 50.0);
        cameras.push_back(
            camera({wayStartDegrees + turned, kWayPitchDegrees + climbed / 3.0, 0.0}, sizePx));
    }
    return cameras;
}

Result<Shown> Meter::Impl::yardstick(Yardstick which, const Camera& camera) {
    if (which == Yardstick::sprite) {
        Result<Drawer> drawer = Drawer::create(parts, plan.profile, wanted(), gl);
        if (!drawer) return Failure(drawer.error());
        return drawer->draw(camera, false);
    }
    PerspectivePicture picture =
        perspectivePicture(model->octree.view(), model->palette, parts.placed(), plan.profile.light,
                           plan.profile.shading, camera, Rgba8(0), kMaxOctreeDepth, plan.threads);
    return Shown{std::move(picture.image), std::move(picture.ids), 0.0, 0.0};
}

Result<const Meter::Impl::Truth*> Meter::Impl::kept(Yardstick which, std::size_t size,
                                                    std::size_t view) {
    Yardsticks& both = yardsticks[size][view];
    std::unique_ptr<const Truth>& one = which == Yardstick::sprite ? both.sprite : both.perspective;
    if (!one) {
        Result<Shown> made = yardstick(which, camera(views[view], plan.sizesPx[size]));
        if (!made) return Failure(made.error());
        one = std::make_unique<const Truth>(std::move(*made), plan.flipPixelsPerDegree);
    }
    return one.get();
}

// Every n-th sample of the buffer, so that there are few enough; which ones depends on the view.
NumberErrors Meter::Impl::numbers(const Drawer& drawer, std::size_t view) const {
    NumberErrors errors;
    const Drawer::Cast& cast = *drawer.lastCast();
    const SpriteBuffer& buffer = *cast.buffer;
    const auto most = static_cast<std::size_t>(plan.idealSamples);
    const std::size_t step = std::max<std::size_t>(1, (buffer.ids.size() + most - 1) / most);
    std::uint64_t other = 0, lost = 0;
    for (std::size_t at = view % step; at < buffer.ids.size(); at += step) {
        const auto column = static_cast<int>(at % static_cast<std::size_t>(buffer.size.x));
        const auto row = static_cast<int>(at / static_cast<std::size_t>(buffer.size.x));
        const glm::ivec2 pixel{buffer.first.x + column, buffer.first.y + buffer.size.y - 1 - row};
        const LatticeHit truth = castIdeal(drawer.octree(), cast.view.ortho, pixel);
        const bool hit = buffer.ids[at] >= kIdFirstVoxel;
        if (truth.material == 0 && !hit) continue;
        ++errors.samples;
        if ((truth.material != 0) != hit)
            ++lost;
        else if (voxelId(truth.voxel, drawer.octree().size) != buffer.ids[at])
            ++other;
    }
    if (errors.samples > 0) {
        errors.voxels = static_cast<double>(other + lost) / static_cast<double>(errors.samples);
        errors.silhouette = static_cast<double>(lost) / static_cast<double>(errors.samples);
    }
    return errors;
}

Status Meter::Impl::measureErrors(Drawer& drawer, std::size_t size, AtSize& out,
                                  const Progress& progress, bool& stopped) {
    drawer.forget();
    ErrorMean sprite, perspective;
    NumberMean numberMean;
    for (std::size_t view = 0; view < views.size(); ++view) {
        if (!progress.reached(static_cast<double>(view) / static_cast<double>(views.size()))) {
            stopped = true;
            return {};
        }
        const Result<Shown> shown = drawer.draw(camera(views[view], out.sizePx), false);
        if (!shown) return Failure(shown.error());
        const ComparedPicture compared(shown->image, plan.flipPixelsPerDegree);
        for (const Yardstick which : {Yardstick::sprite, Yardstick::perspective}) {
            const Result<const Truth*> truth = kept(which, size, view);
            if (!truth) return Failure(truth.error());
            const Result<PictureErrors> errors =
                compareShown((*truth)->compared, (*truth)->shown.ids, compared, shown->ids);
            if (!errors) return Failure(errors.error());
            (which == Yardstick::sprite ? sprite : perspective).add(*errors);
        }
        if (drawer.lastCast() && drawer.lastCast()->buffer != nullptr)
            numberMean.add(numbers(drawer, view));
        if (shown->sigmaInForce > 0.0) out.sigmaInForce = shown->sigmaInForce;
        if (shown->screenPxPerPx > 0.0) out.screenPxPerPx = shown->screenPxPerPx;
    }
    out.sprite = sprite.mean();
    out.perspective = perspective.mean();
    out.numbers = numberMean.mean();
    return {};
}

// Once along the way, on the processor where that can draw it, for both backends cast and show the
// same: what it casts, and how restless it looks. Without OpenGL that is the first timed run, too.
Status Meter::Impl::measureWay(Drawer& drawer, const Setting& setting, double prepareMilliseconds,
                               AtSize& out, const Progress& progress, bool& stopped) {
    drawer.forget();
    TemporalMeter restless;
    const std::vector<Camera> cameras = way(out.sizePx);
    WayTimes times(cameras.size());
    for (std::size_t k = 0; k < cameras.size(); ++k) {
        if (!progress.reached(static_cast<double>(k) / static_cast<double>(cameras.size()))) {
            stopped = true;
            return {};
        }
        const ThreadStopwatch watch;
        const Result<Shown> shown = drawer.draw(cameras[k], true);
        if (!shown) return Failure(shown.error());
        times.add(watch.milliseconds());
        const double turned = k > 0 ? degreesBetween(cameras[k - 1], cameras[k]) : 0.0;
        if (Status added = restless.add(shown->image, turned); !added) return added;
    }
    const TemporalFigures& figures = restless.figures();
    out.time = {figures.aDegree(figures.changed), figures.aDegree(figures.flips),
                figures.aDegree(figures.crawl)};
    if (!plan.costs) return {};
    Costs costs;
    const auto frames = static_cast<double>(cameras.size());
    costs.rays = static_cast<double>(drawer.counts().rays) / frames;
    costs.casts = static_cast<double>(drawer.counts().casts) / frames;
    costs.bytes = drawer.bytes();
    costs.prepareMilliseconds = prepareMilliseconds;
    if (setting.drawnBy == Representation::clusters) {
        const Result<const ModelParts::Clusters*> clusters = parts.clusters();
        if (!clusters) return Failure(clusters.error());
        costs.bytes = static_cast<double>((*clusters)->mesh.bytes());
        costs.prepareMilliseconds = (*clusters)->milliseconds;
    }
    costs.backend = byGl(setting) ? "gl" : "cpu";
    if (!byGl(setting)) costs.runsMilliseconds.push_back(times.take());
    out.costs = costs;
    return {};
}

Result<std::optional<std::vector<double>>> Meter::Impl::timeRun(Drawer& drawer,
                                                                const Setting& setting,
                                                                const std::vector<Camera>& cameras,
                                                                const Progress& progress) {
    const GameProfile profile = profileWith(plan.profile, setting);
    ViewHistory history;
    drawer.forget();
    if (byGl(setting)) gl->forget();
    WayTimes times(cameras.size());
    for (std::size_t k = 0; k < cameras.size(); ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(cameras.size());
        if (k % kSectionFrames == 0 && !progress.reached(share))
            return std::optional<std::vector<double>>();
        if (byGl(setting)) {
            const Result<double> drawn = gl->frame(setting, profile, cameras[k], history);
            if (!drawn) return Failure(drawn.error());
            times.add(*drawn);
            continue;
        }
        const ThreadStopwatch watch;
        const Result<Shown> shown = drawer.draw(cameras[k], true);
        if (!shown) return Failure(shown.error());
        times.add(watch.milliseconds());
    }
    return std::optional(times.take());
}

Status Meter::Impl::timeWay(Drawer& drawer, const Setting& setting, AtSize& out,
                            std::size_t already, const Progress& progress, bool& stopped) {
    std::vector<std::vector<double>>& runs = out.costs->runsMilliseconds;
    const std::vector<Camera> cameras = way(out.sizePx);
    const auto spent = [&](const std::vector<double>& run) {
        return std::accumulate(run.begin(), run.end(), 0.0) * static_cast<double>(cameras.size());
    };
    if (byGl(setting) && runs.empty()) {  // what OpenGL compiles for it does not count
        const auto warm = timeRun(drawer, setting, {cameras.begin(), cameras.begin() + 2}, {});
        if (!warm) return Failure(warm.error());
    }
    double sum = already > 0 ? spent(runs.back()) : 0.0;
    const auto least = static_cast<std::size_t>(plan.leastRepeats);
    const auto share = [&](std::size_t count) {
        return std::min(1.0, static_cast<double>(count) / static_cast<double>(least));
    };
    for (std::size_t count = already; count < kMostRepeats; ++count) {
        if (count >= least && sum >= plan.repeatMilliseconds) break;
        auto run = timeRun(drawer, setting, cameras, progress.part(share(count), share(count + 1)));
        if (!run) return Failure(run.error());
        stopped = !*run;
        if (stopped) break;
        sum += spent(**run);
        runs.push_back(std::move(**run));
    }
    out.costs->milliseconds = spreadOfParts(runs);
    return {};
}

Meter::Meter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Meter::~Meter() = default;
Meter::Meter(Meter&&) noexcept = default;
Meter& Meter::operator=(Meter&&) noexcept = default;

Result<Meter> Meter::create(std::shared_ptr<const Model> model, Plan plan, GlStage* gl) {
    if (model == nullptr || model->octree.size == glm::ivec3(0) ||
        node::isEmpty(model->octree.nodes.front()))
        return fail("the model has no voxels to measure");
    if (Status valid = validate(plan); !valid) return Failure(valid.error());
    auto impl = std::make_unique<Impl>(std::move(model), std::move(plan), gl);
    if (gl != nullptr) gl->setModel(impl->parts);
    return Meter(std::move(impl));
}

const Plan& Meter::plan() const {
    return impl_->plan;
}

int Meter::mostLevels() const {
    return impl_->parts.mostLevels();
}

bool Meter::offers(const Setting& setting) const {
    if (setting.drawnBy == Representation::clusters) return impl_->gl != nullptr;
    if (setting.drawnBy == Representation::coarse)
        return setting.coarseLevels >= 1 && setting.coarseLevels <= mostLevels();
    return true;
}

Result<std::optional<Point>> Meter::measure(const AxisSetting& setting, const Progress& progress) {
    if (!offers(setting.setting)) return fail("the model cannot be drawn by this setting");
    GlStage* const stage = impl_->byGl(setting.setting) ? impl_->gl : nullptr;
    Result<Drawer> drawer =
        Drawer::create(impl_->parts, impl_->plan.profile, setting.setting, stage);
    if (!drawer) return Failure(drawer.error());
    const bool clusters = setting.setting.drawnBy == Representation::clusters;
    Result<Drawer> counter = Drawer::create(impl_->parts, impl_->plan.profile, setting.setting,
                                            clusters ? stage : nullptr);
    if (!counter) return Failure(counter.error());
    Point point{setting.axis,
                setting.setting,
                describe(setting.setting, settingOf(impl_->plan.profile)),
                {}};
    const auto sizes = static_cast<double>(impl_->plan.sizesPx.size());
    for (std::size_t size = 0; size < impl_->plan.sizesPx.size(); ++size) {
        const Progress part =
            progress.part(static_cast<double>(size) / sizes, static_cast<double>(size + 1) / sizes);
        AtSize& out = point.bySize.emplace_back();
        out.sizePx = impl_->plan.sizesPx[size];
        bool stopped = false;
        Status measured = impl_->measureErrors(*drawer, size, out, part.part(0.0, 0.4), stopped);
        if (measured && !stopped)
            measured = impl_->measureWay(*counter, setting.setting, drawer->prepareMilliseconds(),
                                         out, part.part(0.4, 0.6), stopped);
        if (measured && !stopped && out.costs)
            measured =
                impl_->timeWay(*drawer, setting.setting, out, out.costs->runsMilliseconds.size(),
                               part.part(0.6, 1.0), stopped);
        if (!measured) return Failure(measured.error());
        if (stopped) return std::optional<Point>();
    }
    return std::optional<Point>(std::move(point));
}

Result<bool> Meter::timeAgain(Point& point, const Progress& progress) {
    GlStage* const stage = impl_->byGl(point.setting) ? impl_->gl : nullptr;
    Result<Drawer> drawer = Drawer::create(impl_->parts, impl_->plan.profile, point.setting, stage);
    if (!drawer) return Failure(drawer.error());
    const auto sizes = static_cast<double>(point.bySize.size());
    double done = 0.0;
    for (AtSize& size : point.bySize) {
        if (!size.costs) continue;
        const Progress part = progress.part(done / sizes, (done + 1.0) / sizes);
        done += 1.0;
        bool stopped = false;
        Status timed = impl_->timeWay(*drawer, point.setting, size, 0, part, stopped);
        if (!timed) return Failure(timed.error());
        if (stopped) return false;
    }
    return true;
}

std::vector<Camera> Meter::cameras(std::size_t size) const {
    std::vector<Camera> cameras;
    for (const OrbitAngles& view : impl_->views)
        cameras.push_back(impl_->camera(view, impl_->plan.sizesPx[size]));
    return cameras;
}

Camera Meter::camera(const OrbitAngles& view, double sizePx) const {
    return impl_->camera(view, sizePx);
}

Result<Shown> Meter::show(const Setting& setting, const Camera& camera) {
    if (!offers(setting)) return fail("the model cannot be drawn by this setting");
    Result<Drawer> drawer = Drawer::create(impl_->parts, impl_->plan.profile, setting, impl_->gl);
    if (!drawer) return Failure(drawer.error());
    return drawer->draw(camera, false);
}

Result<Shown> Meter::showYardstick(Yardstick yardstick, const Camera& camera) {
    return impl_->yardstick(yardstick, camera);
}

}  // namespace voxprite::trade
