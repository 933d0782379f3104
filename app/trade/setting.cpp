#include "app/trade/setting.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/io/profile_json.h"

namespace voxprite::trade {
namespace {

struct AxisName {
    const char* name;
    const char* title;
};
constexpr std::array<AxisName, kAxes> kNames{{{"game", "As the game has it"},
                                              {"sigma", "Sigma"},
                                              {"mode", "Mode"},
                                              {"view_step", "View step"},
                                              {"proxy", "Proxy"},
                                              {"registration", "Registration"},
                                              {"light", "Light"},
                                              {"snapshots", "Snapshots"},
                                              {"levels", "Octree levels"},
                                              {"clusters", "Clusters"},
                                              {"walk", "Walk"},
                                              {"mixed", "Sigma and view step"}}};

std::string numberText(double number) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", number);
    return text.data();
}

std::string viewsText(const std::string& viewSet) {
    const Result<ViewSet> views = ViewSet::named(viewSet);
    return views ? std::to_string(views->count()) : viewSet;
}

std::string drawnByText(const Setting& setting) {
    switch (setting.drawnBy) {
        case Representation::sprite:
            return "exact sprite";
        case Representation::snapshot: {
            const std::string views = "snapshots of " + viewsText(setting.viewSet) + " views";
            return setting.snapshotKind == SnapshotKind::sprite
                       ? views
                       : views + ", " + std::to_string(setting.snapshotPx) + " px wide";
        }
        case Representation::clusters:
            return "clusters, " + numberText(setting.clusterBudgetPx) + " px off at most";
        case Representation::coarse:
            return "octree coarser by " + std::to_string(setting.coarseLevels);
    }
    return {};
}

// Collects settings, none twice.
class Settings {
  public:
    Settings(const GameProfile& profile, Effort effort)
        : game_(settingOf(profile)), effort_(effort) {}

    void along(Axis axis, int mostCoarseLevels);
    [[nodiscard]] std::vector<AxisSetting> take() { return std::move(all_); }

  private:
    void add(Axis axis, const Setting& setting) {
        const auto same = [&](const AxisSetting& one) { return one.setting == setting; };
        if (setting == game_ && axis != Axis::game) return;
        if (std::none_of(all_.begin(), all_.end(), same)) all_.push_back({axis, setting});
    }
    template <class Change>
    void vary(Axis axis, Change change) {
        Setting setting = game_;
        change(setting);
        add(axis, setting);
    }
    template <class T>
    [[nodiscard]] std::vector<T> values(std::vector<T> quick, std::vector<T> full) const {
        return effort_ == Effort::quick ? std::move(quick) : std::move(full);
    }
    void snapshots();
    void light();
    void mixed();

    Setting game_;
    Effort effort_;
    std::vector<AxisSetting> all_;
};

void Settings::snapshots() {
    for (const std::string& set :
         values<std::string>({"canonical26", "octahedral:8", "octahedral:16", "octahedral:36"},
                             {"canonical26", "octahedral:8", "octahedral:12", "octahedral:16",
                              "octahedral:24", "octahedral:36"}))
        vary(Axis::snapshots, [&](Setting& setting) {
            setting.drawnBy = Representation::snapshot;
            setting.viewSet = set;
        });
    for (const std::string& set :
         values<std::string>({"canonical26"}, {"canonical26", "octahedral:16"}))
        for (const int px : values<int>({64, 128}, {32, 64, 128, 256}))
            vary(Axis::snapshots, [&](Setting& setting) {
                setting.drawnBy = Representation::snapshot;
                setting.snapshotKind = SnapshotKind::seed;
                setting.viewSet = set;
                setting.snapshotPx = px;
            });
}

void Settings::light() {
    vary(Axis::light, [](Setting& setting) { setting.occlusion = 0.0; });
    vary(Axis::light, [](Setting& setting) { setting.shadow = 0.0; });
    vary(Axis::light, [](Setting& setting) { setting.occlusion = setting.shadow = 0.0; });
}

void Settings::mixed() {
    for (const double share : values<double>({0.5}, {0.5, 0.25}))
        for (const double step : values<double>({2.5, 5.0}, {1.0, 2.5, 5.0}))
            vary(Axis::mixed, [&](Setting& setting) {
                setting.sigma = std::clamp(share * game_.sigma, 1.0 / 64.0, 64.0);
                setting.viewStepDegrees = step;
            });
}

void Settings::along(Axis axis, int mostCoarseLevels) {
    switch (axis) {
        case Axis::game:
            return add(axis, game_);
        case Axis::sigma:
            for (const double sigma :
                 values<double>({0.5, 1, 2, 4, 8}, {0.125, 0.25, 0.5, 1, 1.5, 2, 3, 4, 6, 8}))
                vary(axis, [&](Setting& setting) { setting.sigma = sigma; });
            return;
        case Axis::mode:
            return vary(axis, [](Setting& setting) {
                setting.mode = setting.mode == SpriteMode::spriteBuffer ? SpriteMode::singlePass
                                                                        : SpriteMode::spriteBuffer;
            });
        case Axis::viewStep:
            for (const double step :
                 values<double>({0, 1, 2.5, 5, 15}, {0, 0.5, 1, 2.5, 5, 7.5, 11.25, 15}))
                vary(axis, [&](Setting& setting) { setting.viewStepDegrees = step; });
            return;
        case Axis::proxy:
            return vary(axis, [](Setting& setting) {
                setting.proxy =
                    setting.proxy == ProxyShape::quad ? ProxyShape::box : ProxyShape::quad;
            });
        case Axis::registration:
            return vary(axis, [](Setting& setting) {
                setting.registration = setting.registration == Registration::anchor
                                           ? Registration::modelCentre
                                           : Registration::anchor;
            });
        case Axis::light:
            return light();
        case Axis::snapshots:
            return snapshots();
        case Axis::levels:
            for (int levels = 1; levels <= mostCoarseLevels; ++levels)
                vary(axis, [&](Setting& setting) {
                    setting.drawnBy = Representation::coarse;
                    setting.coarseLevels = levels;
                });
            return;
        case Axis::clusters:
            for (const double budget : values<double>({1, 4}, {0, 1, 2, 4, 8}))
                vary(axis, [&](Setting& setting) {
                    setting.drawnBy = Representation::clusters;
                    setting.clusterBudgetPx = budget;
                });
            return;
        case Axis::walk:
            return vary(axis, [](Setting& setting) { setting.walk = Walk::fp32; });
        case Axis::mixed:
            return mixed();
    }
}

}  // namespace

Setting settingOf(const GameProfile& profile) {
    Setting setting;
    setting.sigma = profile.sigma;
    setting.mode = profile.mode;
    setting.viewStepDegrees = profile.viewStepDegrees;
    setting.proxy = profile.proxy;
    setting.registration = profile.registration;
    setting.occlusion = profile.light.occlusion;
    setting.shadow = profile.light.shadow;
    return setting;
}

GameProfile profileWith(GameProfile profile, const Setting& setting) {
    profile.sigma = setting.sigma;
    profile.mode = setting.mode;
    profile.viewStepDegrees = setting.viewStepDegrees;
    profile.proxy = setting.proxy;
    profile.registration = setting.registration;
    profile.light.occlusion = setting.occlusion;
    profile.light.shadow = setting.shadow;
    return profile;
}

bool fitsProfile(const Setting& setting) {
    return setting.drawnBy == Representation::sprite && setting.walk == Walk::lattice;
}

std::string describe(const Setting& setting, const Setting& game) {
    std::string text;
    const auto say = [&](bool differs, const std::string& what) {
        if (differs) text += (text.empty() ? "" : ", ") + what;
    };
    const bool exact = setting.drawnBy == Representation::sprite;
    say(setting.drawnBy != game.drawnBy || !exact, drawnByText(setting));
    say(setting.sigma != game.sigma, "sigma " + numberText(setting.sigma));
    say(setting.mode != game.mode, nameOf(setting.mode));
    say(setting.viewStepDegrees != game.viewStepDegrees,
        setting.viewStepDegrees == 0.0
            ? "views not snapped"
            : "views every " + numberText(setting.viewStepDegrees) + "°");
    say(setting.proxy != game.proxy, std::string("proxy ") + nameOf(setting.proxy));
    say(setting.registration != game.registration, setting.registration == Registration::anchor
                                                       ? "registered at the anchor"
                                                       : "registered at the centre");
    const bool noOcclusion = setting.occlusion == 0.0 && game.occlusion > 0.0;
    say(setting.occlusion != game.occlusion,
        noOcclusion ? "no occlusion" : "occlusion " + numberText(setting.occlusion));
    const bool noShadow = setting.shadow == 0.0 && game.shadow > 0.0;
    say(setting.shadow != game.shadow,
        noShadow ? "no shadow" : "shadow " + numberText(setting.shadow));
    say(setting.walk != game.walk, setting.walk == Walk::fp32 ? "fp32 walk" : "integer lattice");
    return text.empty() ? "as the game has it" : text;
}

const char* nameOf(Axis axis) {
    return kNames[static_cast<std::size_t>(axis)].name;
}
const char* titleOf(Axis axis) {
    return kNames[static_cast<std::size_t>(axis)].title;
}

std::vector<AxisSetting> settingsAlong(std::span<const Axis> axes, const GameProfile& profile,
                                       int mostCoarseLevels, Effort effort) {
    Settings settings(profile, effort);
    for (const Axis axis : axes) settings.along(axis, mostCoarseLevels);
    return settings.take();
}

std::vector<Axis> allAxes() {
    std::vector<Axis> axes;
    for (int k = 0; k < kAxes; ++k) axes.push_back(static_cast<Axis>(k));
    return axes;
}

}  // namespace voxprite::trade
