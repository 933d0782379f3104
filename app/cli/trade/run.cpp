#include "app/cli/trade/run.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>

#include "app/cli/bench/bench.h"
#include "app/cli/source.h"
#include "app/cli/trade/growth.h"
#include "app/trade/gl_stage.h"
#include "app/trade/model_parts.h"
#include "commit.h"
#include "core/base/file.h"
#include "core/base/stopwatch.h"
#include "core/model/entity_voxels.h"
#include "core/svo/bake.h"
#include "render/gl/context.h"

namespace voxprite::trade {
namespace {

// Ctrl+C can reach the program nowhere else.
volatile std::sig_atomic_t interrupted = 0;

class Interrupts {
  public:
    Interrupts() : before_(std::signal(SIGINT, [](int) { interrupted = 1; })) { interrupted = 0; }
    ~Interrupts() { std::signal(SIGINT, before_); }
    Interrupts(const Interrupts&) = delete;
    Interrupts& operator=(const Interrupts&) = delete;

  private:
    void (*before_)(int);
};

std::string clockText(double seconds) {
    std::array<char, 32> text{};
    const int whole = static_cast<int>(seconds + 0.5);
    std::snprintf(text.data(), text.size(), "%d:%02d", whole / 60, whole % 60);
    return text.data();
}

// One line that is written over on a terminal; elsewhere a line now and then.
class ProgressLine {
  public:
    explicit ProgressLine(double whole) : whole_(whole), terminal_(isatty(STDERR_FILENO) == 1) {}
    ~ProgressLine() {
        if (terminal_ && said_) std::fputc('\n', stderr);
    }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    // `weight` of the whole; call progress() for the part that begins.
    void begin(const std::string& what, double weight) {
        done_ += weightNow_;
        weightNow_ = weight;
        what_ = what;
    }
    [[nodiscard]] Progress progress() {
        return {[this](double share) {
                    if (interrupted != 0) stop_.request_stop();
                    say((done_ + weightNow_ * share) / whole_);
                },
                stop_.get_token()};
    }
    [[nodiscard]] bool stopped() const { return interrupted != 0; }

  private:
    void say(double share) {
        const double now = watch_.milliseconds() / 1000.0;
        if (now - last_ < (terminal_ ? 0.1 : 5.0)) return;
        last_ = now;
        said_ = true;
        const std::string left =
            share > 0.02 ? ", " + clockText(now / share * (1.0 - share)) + " left" : "";
        std::fprintf(stderr, "%s%3.0f %%%s: %s%s", terminal_ ? "\r" : "", 100.0 * share,
                     left.c_str(), what_.c_str(), terminal_ ? "\x1b[K" : "\n");
        std::fflush(stderr);
    }

    double whole_;
    bool terminal_;
    bool said_ = false;
    Stopwatch watch_;
    double last_ = 0.0;
    double done_ = 0.0, weightNow_ = 0.0;
    std::string what_;
    std::stop_source stop_;
};

// A model that is to be measured, and how.
struct Subject {
    std::shared_ptr<const Model> model;
    GameProfile profile;
    std::string file;
    std::vector<AxisSetting> settings, lightSettings;

    [[nodiscard]] GameProfile lit() const {
        GameProfile full = profile;
        full.light.occlusion = full.light.shadow = kFullLight;
        return full;
    }
    [[nodiscard]] int count() const {
        return static_cast<int>(settings.size() + lightSettings.size());
    }
};

void leaveOutClusters(std::vector<AxisSetting>& settings) {
    settings.erase(std::remove_if(settings.begin(), settings.end(),
                                  [](const AxisSetting& one) {
                                      return one.setting.drawnBy == Representation::clusters;
                                  }),
                   settings.end());
}

Result<Subject> subjectOf(const std::string& file, const RunOptions& options, bool gl) {
    Result<LoadedDocument> loaded =
        cli::loadSource(file, std::nullopt, std::nullopt, options.reading);
    if (!loaded) return Failure(loaded.error());
    const VoxelGrid voxels = flatten(loaded->document, 0);
    if (voxels.empty()) return failInFile(file, "its first frame has no voxels to measure");
    Result<Octree> octree = bake(voxels, entityBounds(loaded->document));
    if (!octree) return Failure(inFile(std::move(octree), file).error());
    const Result<GameProfile> profile = cli::profileForSaving(options.profile, loaded->document);
    if (!profile) return Failure(profile.error());
    Subject subject;
    subject.file = file;
    subject.profile = *profile;
    auto model = std::make_shared<Model>();
    model->name = std::filesystem::path(file).stem().string();
    model->octree = std::move(*octree);
    model->palette = std::move(loaded->document.palette);
    model->entity = loaded->document.entity;
    const int levels = ModelParts(model, subject.profile).mostLevels();
    subject.model = std::move(model);
    const Effort effort = options.quick ? Effort::quick : Effort::full;
    subject.settings = settingsAlong(options.axes, subject.profile, levels, effort);
    const bool light =
        std::find(options.axes.begin(), options.axes.end(), Axis::light) != options.axes.end();
    const Light& own = subject.profile.light;
    if (light && own.occlusion == 0.0 && own.shadow == 0.0)
        subject.lightSettings =
            settingsAlong(std::array{Axis::game, Axis::light}, subject.lit(), levels, effort);
    if (!gl) leaveOutClusters(subject.settings);
    return subject;
}

// Sizes by the model: as large as lets a virtual pixel of the game's own sigma cover a good screen
// pixel, where sigma counts; and a third of that.
std::vector<double> sizesOf(const std::shared_ptr<const Model>& model, const GameProfile& profile,
                            bool quick) {
    const double radius =
        ModelParts(model, profile).placed().radiusMetres() / profile.voxelSizeMetres;
    const double near =
        std::round(std::clamp(1.25 * profile.sigma * radius, 32.0, quick ? 112.0 : 200.0));
    if (quick) return {near};
    return {std::round(near / 3.0), near};
}

Plan planOf(const RunOptions& options, const std::shared_ptr<const Model>& model,
            const GameProfile& profile) {
    Plan plan;
    plan.profile = profile;
    plan.sizesPx = sizesOf(model, profile, options.quick);
    plan.seed = options.seed;
    plan.threads = 0;
    plan.recordedWay = options.recordedWay;
    if (!options.quick) return plan;
    plan.views = 2;
    plan.frames = 40;
    plan.degreesAFrame = 2.25;
    plan.repeatMilliseconds = 0.0;
    plan.idealSamples = 1000;
    return plan;
}

// Every setting is timed once more after all others, so that a busy while of the machine does not
// fall upon one of them. Of the time that a setting takes, that part:
constexpr double kAgainWeight = 0.3;

bool hasWalks(const std::vector<AxisSetting>& settings) {
    return std::any_of(settings.begin(), settings.end(),
                       [](const AxisSetting& each) { return each.axis == Axis::walk; });
}

// What the rival's walk, which the processor alone has, is compared with.
Status measureOnProcessor(const Subject& subject, const Plan& plan, ProgressLine& line,
                          Curve& curve, std::vector<Skipped>& skipped) {
    Result<Meter> meter = Meter::create(subject.model, plan);
    if (!meter) return Failure(meter.error());
    line.begin(curve.model + ", on the processor", 0.0);
    Result<std::optional<Point>> point =
        meter->measure({Axis::walk, settingOf(plan.profile)}, line.progress());
    if (!point) {
        skipped.push_back({"as the game has it, on the processor", point.error().message});
        return {};
    }
    if (!*point) return {};
    (*point)->name += ", on the processor";
    // As often as all others.
    const Result<bool> timed = meter->timeAgain(**point, line.progress());
    if (!timed) return Failure(timed.error());
    if (*timed) curve.points.push_back(std::move(**point));
    return {};
}

// Adds the points to the curve until it is stopped; and to `skipped` what cannot be drawn.
Status measureCurve(const Subject& subject, const std::vector<AxisSetting>& settings,
                    const Plan& plan, GlStage* stage, ProgressLine& line, Curve& curve,
                    std::vector<Skipped>& skipped) {
    curve.model = subject.model->name;
    curve.profile = plan.profile;
    curve.backend = stage != nullptr ? "gl" : "cpu";
    Result<Meter> meter = Meter::create(subject.model, plan, stage);
    if (!meter) return Failure(inFile(std::move(meter), subject.file).error());
    for (const AxisSetting& each : settings) {
        if (line.stopped()) return {};
        line.begin(curve.model + ", " + describe(each.setting, settingOf(plan.profile)),
                   1.0 - kAgainWeight);
        Result<std::optional<Point>> point = meter->measure(each, line.progress());
        if (!point && each.axis != Axis::game) {
            skipped.push_back(
                {describe(each.setting, settingOf(plan.profile)), point.error().message});
            continue;
        }
        if (!point) return Failure(inFile(std::move(point), subject.file).error());
        if (!*point) return {};
        curve.points.push_back(std::move(**point));
    }
    for (auto point = curve.points.rbegin(); point != curve.points.rend(); ++point) {
        line.begin(curve.model + ", timed again: " + point->name, kAgainWeight);
        const Result<bool> timed = meter->timeAgain(*point, line.progress());
        if (!timed) return Failure(inFile(timed, subject.file).error());
        if (!*timed) return {};
    }
    return stage != nullptr && hasWalks(settings)
               ? measureOnProcessor(subject, plan, line, curve, skipped)
               : Status();
}

Status measureModel(const Subject& subject, const RunOptions& options, GlStage* stage,
                    ProgressLine& line, ModelReport& out) {
    const OctreeView octree = subject.model->octree.view();
    out.file = subject.file;
    out.size = octree.size;
    out.voxels = solidCount(octree);
    out.octreeBytes = bytesOf(octree);
    out.settings = subject.count() + (stage != nullptr && hasWalks(subject.settings) ? 1 : 0);
    out.plan = planOf(options, subject.model, subject.profile);
    Status measured =
        measureCurve(subject, subject.settings, planOf(options, subject.model, subject.profile),
                     stage, line, out.curve, out.skipped);
    if (!measured || subject.lightSettings.empty() || line.stopped()) return measured;
    return measureCurve(subject, subject.lightSettings,
                        planOf(options, subject.model, subject.lit()), stage, line,
                        out.light.emplace(), out.skipped);
}

constexpr double kGrowthWeight = 10.0;  // settings that it takes as long as

// That the report can be written there shows before it is measured.
Status makeFolder(const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) return failInFile(folder, "cannot make the folder: " + error.message());
    if (access(folder.c_str(), W_OK) != 0)
        return failInFile(folder, "the folder cannot be written to");
    return {};
}

}  // namespace

Result<TradeReport> runTrade(const RunOptions& options) {
    const Interrupts interrupts;
    TradeReport report;
    report.commit = VOXPRITE_COMMIT;
    report.machine = bench::machine();
    report.machine["gl"] = nullptr;

    std::optional<gl::HeadlessContext> context;
    std::optional<GlStage> stage;
    if (options.gl) {
        Result<gl::HeadlessContext> created = gl::HeadlessContext::create();
        if (!created && options.needGl) return Failure(created.error());
        if (created) {
            context.emplace(std::move(*created));
            report.machine["gl"] = gl::driverInfo().renderer + ", " + gl::driverInfo().version;
            Result<GlStage> made = GlStage::create();
            if (!made) return Failure(made.error());
            stage.emplace(std::move(*made));
        }
    }
    report.backend = stage ? "gl" : "cpu";

    std::vector<Subject> subjects;
    double whole = options.growth ? kGrowthWeight : 0.0;
    for (const std::string& file : options.files) {
        Result<Subject> subject = subjectOf(file, options, stage.has_value());
        if (!subject) return Failure(subject.error());
        whole += subject->count();
        subjects.push_back(std::move(*subject));
    }
    if (Status folder = makeFolder(options.folder); !folder) return Failure(folder.error());
    if (options.writeProfile) {
        if (Status may = checkWritable(*options.writeProfile); !may) return Failure(may.error());
    }
    ProgressLine line(whole);
    for (const Subject& subject : subjects) {
        if (line.stopped()) break;
        ModelReport model;
        Status measured = measureModel(subject, options, stage ? &*stage : nullptr, line, model);
        if (!measured) report.failures.push_back(measured.error());
        if (measured || !model.curve.points.empty()) report.models.push_back(std::move(model));
    }
    if (options.growth && !line.stopped()) {
        line.begin("costs that grow", kGrowthWeight);
        Result<std::vector<Growth>> growth =
            measureGrowth(options.quick, stage.has_value(), line.progress());
        if (growth)
            report.growth = std::move(*growth);
        else
            report.failures.push_back(growth.error());
    }
    report.finished = !line.stopped();
    return report;
}

Curve combined(const std::vector<ModelReport>& models) {
    if (models.empty()) return {};
    Curve all = models.front().curve;
    for (std::size_t k = 1; k < models.size(); ++k) {
        std::vector<Point> common;
        for (Point& point : all.points)
            for (const Point& other : models[k].curve.points) {
                if (other.setting != point.setting) continue;
                point.bySize.insert(point.bySize.end(), other.bySize.begin(), other.bySize.end());
                common.push_back(std::move(point));
                break;
            }
        all.points = std::move(common);
    }
    return all;
}

}  // namespace voxprite::trade
