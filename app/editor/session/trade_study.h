// What settings cost and how far they are off, measured of the open model behind the window: the
// points of a curve, and beside them whatever settings are asked for.
//
// Errors are against the reference: the settings that were in force when measuring began, until the
// artist pins others. So settings that are tried move along the curve instead of becoming its new
// zero. What is no part of a setting (VoxelSize, the light's direction, ...) is the profile's own.
//
// Everything is measured on one thread of the processor (app/trade/meter.h), one setting after the
// other, so that a curve grows point by point. A moment after the model's last change all is
// measured anew; what was being measured of the old one never gets here.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/editor/session/background_job.h"
#include "app/editor/session/session.h"
#include "app/trade/meter.h"

namespace voxprite::editor {

class TradeStudy {
  public:
    // How much is measured; the profile of the plan does not count. An artist waits for it.
    explicit TradeStudy(const trade::Plan& plan = usualPlan()) : plan_(plan) {}
    [[nodiscard]] static trade::Plan usualPlan();

    // Once a frame, on the window's thread, while figures are wanted; `also` are settings that are
    // wanted beside the curve, the most wanted first. `now` in seconds.
    void follow(Session& session, std::span<const trade::Setting> also, double now);
    // Nobody looks: what runs is stopped, what is known is kept.
    void rest();
    // Nothing more is measured of this model until it changes, or again() is called.
    void cancel();
    // All anew.
    void again();
    // Errors are against these settings from now on.
    void pin(const trade::Setting& reference);
    // Another document is open.
    void forget();

    // Good until the next follow(). The reference is the first point.
    [[nodiscard]] const trade::Curve& curve() const { return curve_; }
    // Of the curve or of what was asked for beside it; null while it is not measured.
    [[nodiscard]] const trade::Point* find(const trade::Setting& setting) const;
    // Nothing until the first follow().
    [[nodiscard]] const std::optional<trade::Setting>& reference() const { return reference_; }
    // The profile of the sprite that errors are against.
    [[nodiscard]] const GameProfile& referenceProfile() const { return plan_.profile; }
    [[nodiscard]] const trade::Plan& plan() const { return plan_; }

    // Something is being measured, or will be in a moment.
    [[nodiscard]] bool busy() const;
    [[nodiscard]] bool cancelled() const { return cancelled_; }
    [[nodiscard]] double share() const;  // of what is to be measured, 0 ... 1
    // What went wrong; empty when nothing did.
    [[nodiscard]] const std::string& problem() const { return problem_; }
    // Rises with everything that changes what curve() and find() say.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }
    // Waits for what runs; the next follow() has it.
    void wait() { job_.wait(); }

  private:
    // All that figures depend on, the settings apart.
    struct Terms {
        std::uint64_t model = 0;
        int frame = 0;
        std::optional<std::size_t> variant;
        GameProfile profile;  // the reference's
        Entity entity;
        bool operator==(const Terms&) const = default;
    };
    void start(Session& session);
    void drop();
    [[nodiscard]] std::optional<trade::AxisSetting> next() const;
    void measure(const trade::AxisSetting& setting);
    void take(const trade::AxisSetting& setting, Result<std::optional<trade::Point>> point);

    std::optional<trade::Setting> reference_;
    std::optional<Terms> terms_;
    double changedAt_ = 0.0;
    bool still_ = false;
    bool cancelled_ = false;
    trade::Plan plan_;
    trade::Curve curve_;
    std::vector<trade::Point> others_;
    std::vector<trade::AxisSetting> planned_;  // of the curve
    std::vector<trade::Setting> also_;
    std::vector<trade::Setting> refused_;  // that cannot be measured of this model
    std::shared_ptr<trade::Meter> meter_;  // of one thread at a time: the job's while one runs
    std::string problem_;
    std::uint64_t revision_ = 0;
    BackgroundJob job_;  // last: what it uses goes after it
};

// The settings of the curve: of every axis what the sprite view can show.
[[nodiscard]] std::vector<trade::AxisSetting> settingsOfCurve(const GameProfile& profile,
                                                              int mostLevels);

}  // namespace voxprite::editor
