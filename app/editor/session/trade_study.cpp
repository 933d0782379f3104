#include "app/editor/session/trade_study.h"

#include <algorithm>

#include "app/editor/settings/trade_settings.h"
#include "core/svo/bake.h"

namespace voxprite::editor {
namespace {

// A model that changed is left alone for so long.
constexpr double kStillSeconds = 0.5;

// What the artist sees of the document in this frame, and in these colours.
Result<std::shared_ptr<const trade::Model>> modelOf(const Document& document, int frame,
                                                    const IBox& bounds, Palette palette,
                                                    std::string name) {
    if (bounds.empty()) return fail("There is no voxel to measure");
    Result<Octree> octree = bake(flatten(document, frame), bounds);
    if (!octree) return Failure(octree.error());
    return std::make_shared<const trade::Model>(
        trade::Model{std::move(name), std::move(*octree), std::move(palette), document.entity});
}

}  // namespace

std::vector<trade::AxisSetting> settingsOfCurve(const GameProfile& profile, int mostLevels) {
    const std::vector<trade::Axis> axes = trade::allAxes();
    std::vector<trade::AxisSetting> settings =
        trade::settingsAlong(axes, profile, mostLevels, trade::Effort::quick);
    std::erase_if(settings, [](const trade::AxisSetting& each) {
        return !canBeShown(each.setting) || each.setting.drawnBy == Representation::clusters;
    });
    return settings;
}

trade::Plan TradeStudy::usualPlan() {
    trade::Plan plan = trade::quickPlan({});
    // The figures of a curve are chosen by: times must not tremble much.
    plan.views = 3;
    return plan;
}

const trade::Point* TradeStudy::find(const trade::Setting& setting) const {
    const auto is = [&](const trade::Point& point) { return point.setting == setting; };
    for (const std::vector<trade::Point>* points : {&curve_.points, &others_}) {
        const auto found = std::ranges::find_if(*points, is);
        if (found != points->end()) return &*found;
    }
    return nullptr;
}

void TradeStudy::follow(Session& session, std::span<const trade::Setting> also, double now) {
    if (!reference_) reference_ = trade::settingOf(session.profile());
    Terms terms{session.modelRevision(), session.frame(), session.variant(),
                trade::profileWith(session.profile(), *reference_), session.document().entity};
    terms.entity.positionMetres = glm::dvec3(0.0);  // is looked at wherever it stands
    if (terms_ != terms) {
        drop();
        cancelled_ = false;
        terms_ = terms;
        changedAt_ = now;
    }
    also_.assign(also.begin(), also.end());
    job_.finish();
    still_ = now - changedAt_ >= kStillSeconds;
    if (!still_ || cancelled_ || job_.running() || !problem_.empty()) return;
    if (!meter_) return start(session);
    if (const auto setting = next()) measure(*setting);
}

void TradeStudy::start(Session& session) {
    plan_.profile = terms_->profile;
    job_.start("Measuring",
               [this, plan = plan_, document = session.snapshot(), frame = session.frame(),
                bounds = session.bounds(), palette = session.shownPalette(),
                name = session.title()](JobProgress&) -> BackgroundJob::Done {
                   auto made = std::make_shared<Result<trade::Meter>>(fail("not measured"));
                   auto model = modelOf(*document, frame, bounds, palette, name);
                   *made = model ? trade::Meter::create(*model, plan)
                                 : Result<trade::Meter>(Failure(model.error()));
                   return [this, made, name] {
                       ++revision_;
                       if (!*made) {
                           problem_ = made->error().describe();
                           return;
                       }
                       meter_ = std::make_shared<trade::Meter>(std::move(**made));
                       planned_ = settingsOfCurve(plan_.profile, meter_->mostLevels());
                       std::erase_if(planned_, [this](const trade::AxisSetting& each) {
                           return !meter_->offers(each.setting);
                       });
                       curve_ = {name, plan_.profile, "cpu", {}};
                   };
               });
}

std::optional<trade::AxisSetting> TradeStudy::next() const {
    const auto known = [this](const trade::Setting& setting) {
        return find(setting) != nullptr || std::ranges::find(refused_, setting) != refused_.end();
    };
    // Where the artist stands comes first: it says something without the curve.
    for (const trade::Setting& setting : also_) {
        const auto planned = std::ranges::find(planned_, setting, &trade::AxisSetting::setting);
        if (known(setting)) continue;
        return planned != planned_.end() ? *planned
                                         : trade::AxisSetting{trade::Axis::game, setting};
    }
    const auto missing = std::ranges::find_if(
        planned_, [&](const trade::AxisSetting& each) { return !known(each.setting); });
    if (missing == planned_.end()) return std::nullopt;
    return *missing;
}

void TradeStudy::measure(const trade::AxisSetting& setting) {
    if (!meter_->offers(setting.setting)) {
        refused_.push_back(setting.setting);
        return;
    }
    job_.start("Measuring",
               [this, setting, meter = meter_](JobProgress& progress) -> BackgroundJob::Done {
                   auto point = std::make_shared<Result<std::optional<trade::Point>>>(
                       meter->measure(setting, progress.as("Measuring")));
                   return [this, setting, point] { take(setting, std::move(*point)); };
               });
}

void TradeStudy::take(const trade::AxisSetting& setting,
                      Result<std::optional<trade::Point>> point) {
    if (!point) {
        // One that cannot be drawn does not take the others away.
        refused_.push_back(setting.setting);
        return;
    }
    if (!*point) return;  // stopped: it is measured when somebody looks again
    ++revision_;
    const auto place = std::ranges::find(planned_, setting);
    if (place == planned_.end()) {
        others_.push_back(std::move(**point));
        return;
    }
    // In the order of the plan, whatever came first.
    const auto rank = [this](const trade::Point& each) {
        return std::ranges::find(planned_, each.setting, &trade::AxisSetting::setting) -
               planned_.begin();
    };
    const auto before = std::ranges::find_if(curve_.points, [&](const trade::Point& each) {
        return rank(each) > place - planned_.begin();
    });
    curve_.points.insert(before, std::move(**point));
}

void TradeStudy::rest() {
    job_.finish();
    if (job_.running()) job_.stop();
}

void TradeStudy::cancel() {
    cancelled_ = true;
    rest();
}

void TradeStudy::again() {
    drop();
    terms_.reset();
}

void TradeStudy::pin(const trade::Setting& reference) {
    reference_ = reference;
    // The sprite of the reference is the exact one, whatever it is drawn by.
    const trade::Setting usual;
    reference_->drawnBy = Representation::sprite;
    reference_->viewSet = usual.viewSet;
    reference_->coarseLevels = usual.coarseLevels;
    reference_->clusterBudgetPx = usual.clusterBudgetPx;
}

void TradeStudy::forget() {
    drop();
    terms_.reset();
    reference_.reset();
    cancelled_ = false;
}

void TradeStudy::drop() {
    // The meter goes with the job that still uses it.
    job_.cancel();
    meter_.reset();
    curve_ = {};
    others_.clear();
    planned_.clear();
    refused_.clear();
    problem_.clear();
    ++revision_;
}

bool TradeStudy::busy() const {
    if (!terms_ || !problem_.empty()) return false;
    if (job_.running()) return true;
    return !cancelled_ && (!meter_ || next().has_value());
}

double TradeStudy::share() const {
    if (planned_.empty()) return 0.0;
    const auto done = static_cast<double>(curve_.points.size());
    return std::clamp((done + job_.share()) / static_cast<double>(planned_.size()), 0.0, 1.0);
}

}  // namespace voxprite::editor
