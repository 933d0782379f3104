// Speed against accuracy: two settings held against each other, the errors of what shows, and the
// cheapest that is good enough.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>

#include "app/editor/commands/command_context.h"
#include "app/editor/commands/tables.h"
#include "app/editor/panels/toasts.h"
#include "app/editor/session/trade_moves.h"
#include "app/editor/window/icons.h"

namespace voxprite::editor {
namespace {

constexpr const char* kGroup = "Speed and accuracy";
constexpr float kPanelShare = 0.72f;  // of the side panels: the curve and what is done with it

trade::Setting inForce(const CommandContext& c) {
    return settingInForce(c.session.profile(), c.settings.scene.representations);
}

void showPanel(CommandContext& c) {
    WindowSettings& window = c.settings.window;
    window.show(DockTab::trade);
    window.dockShare = std::max(window.dockShare, kPanelShare);
}

// The view shows one thing at a time.
void makeRoom(CommandContext& c) {
    c.settings.scene.comparison.cells = 0;
    c.settings.scene.representations.compared = false;
}

void apply(CommandContext& c, const trade::Setting& setting) {
    const std::string title = titleOf(setting, c.study.reference());
    if (auto step = profileStep(c.session, setting, title)) c.perform(std::move(*step));
    RepresentationSettings& representations = c.settings.scene.representations;
    representations = representationsWith(representations, setting);
}

template <SideShown side>
void show(CommandContext& c) {
    TradeSettings& settings = c.settings.trade;
    if (!settings.b) {
        showPanel(c);
        c.toasts.info("There is no B yet: click a point of the curve");
        return;
    }
    makeRoom(c);
    settings.side = settings.side == side ? SideShown::a : side;
    // A map is of one picture.
    if (settings.side == SideShown::both) settings.heat = false;
}

template <SideShown side>
bool shows(const CommandContext& c) {
    return c.settings.trade.b && c.settings.trade.side == side;
}

void toggleHeatMap(CommandContext& c) {
    TradeSettings& settings = c.settings.trade;
    settings.heat = !settings.heat;
    if (!settings.heat) return;
    makeRoom(c);
    if (settings.side == SideShown::both) settings.side = SideShown::a;
}

void nextYardstick(CommandContext& c) {
    HeatYardstick& yardstick = c.settings.trade.heatYardstick;
    yardstick = static_cast<HeatYardstick>((static_cast<int>(yardstick) + 1) % 3);
}

bool hasB(const CommandContext& c) {
    return c.settings.trade.b.has_value();
}

void swap(CommandContext& c) {
    const trade::Setting a = inForce(c);
    apply(c, *c.settings.trade.b);
    c.settings.trade.b = a;
}

void saveSetting(CommandContext& c, const trade::Setting& setting) {
    std::vector<SavedSetting>& saved = c.settings.trade.saved;
    std::erase_if(saved, [&](const SavedSetting& each) { return each.setting == setting; });
    if (saved.size() == kMostSavedSettings) saved.erase(saved.begin());
    saved.push_back({titleOf(setting, c.study.reference()), setting});
}

void takeCheapest(CommandContext& c) {
    if (const trade::Point* point = cheapestWithinMyError(c.study, c.settings.trade)) {
        const std::string name = titleOf(point->setting, c.study.reference());
        const bool same = point->setting == inForce(c);
        apply(c, trade::Setting(point->setting));
        c.toasts.info(same ? "This is the cheapest within your error: " + name
                           : "Cheapest within your error: " + name);
        return;
    }
    showPanel(c);
    c.toasts.info(c.study.busy() || c.study.curve().points.empty()
                      ? "The curve is still being measured"
                      : "Nothing that was measured is within your error");
}

}  // namespace

std::span<const Command> tradeCommands() {
    using enum CommandId;
    static constexpr std::array kCommands{
        Command{.id = showTrade,
                .tag = "show_trade",
                .menu = MenuId::view,
                .group = kGroup,
                .name = "Trade panel: speed against accuracy",
                .icon = icon::kTrade,
                .run = showPanel},
        Command{.id = toggleHeat,
                .tag = "error_heat",
                .menu = MenuId::view,
                .group = kGroup,
                .name = "Error map over the sprite",
                .icon = icon::kHeat,
                .chords = {shift(GLFW_KEY_E)},
                .separator = true,
                .run = toggleHeatMap,
                .on = [](const CommandContext& c) { return c.settings.trade.heat; }},
        Command{.id = nextHeatYardstick,
                .tag = "error_heat_yardstick",
                .menu = MenuId::view,
                .group = kGroup,
                .name = "Error map: against something else",
                .run = nextYardstick,
                .enabled = [](const CommandContext& c) { return c.settings.trade.heat; }},
        Command{.id = flipSides,
                .tag = "flip_a_b",
                .menu = MenuId::view,
                .group = kGroup,
                .name = "Flip between A and B",
                .icon = icon::kFlip,
                .chords = {key(GLFW_KEY_D)},
                .separator = true,
                .run = show<SideShown::b>,
                .on = shows<SideShown::b>},
        Command{.id = wipeSides,
                .tag = "wipe_a_b",
                .menu = MenuId::view,
                .group = kGroup,
                .name = "Wipe between A and B",
                .icon = icon::kWipe,
                .chords = {shift(GLFW_KEY_D)},
                .run = show<SideShown::both>,
                .on = shows<SideShown::both>},
        Command{.id = swapSides,
                .tag = "swap_a_b",
                .menu = MenuId::view,
                .group = kGroup,
                .name = "Swap A and B",
                .icon = icon::kSwap,
                .run = swap,
                .enabled = hasB},
        Command{.id = applyB,
                .tag = "apply_b",
                .menu = MenuId::view,
                .group = kGroup,
                .name = "Make B the game's settings",
                .icon = icon::kCheck,
                .run = [](CommandContext& c) { apply(c, *c.settings.trade.b); },
                .enabled = hasB},
        Command{.id = keepAsB,
                .tag = "keep_as_b",
                .menu = MenuId::view,
                .group = kGroup,
                .name = "Keep the settings in force as B",
                .icon = icon::kCopy,
                .run = [](CommandContext& c) { c.settings.trade.b = inForce(c); }},
        Command{.id = saveSettingA,
                .tag = "save_setting_a",
                .menu = MenuId::view,
                .group = kGroup,
                .name = "Save the settings in force, to compare with",
                .icon = icon::kSave,
                .run = [](CommandContext& c) { saveSetting(c, inForce(c)); }},
        Command{.id = cheapestWithin,
                .tag = "cheapest_within_error",
                .menu = MenuId::view,
                .group = kGroup,
                .name = "Cheapest within my error",
                .icon = icon::kBudget,
                .separator = true,
                .run = takeCheapest},
        Command{.id = pinReference,
                .tag = "pin_reference",
                .menu = MenuId::view,
                .group = kGroup,
                .name = "Measure errors against the settings in force",
                .icon = icon::kPin,
                .run = [](CommandContext& c) { c.study.pin(inForce(c)); }},
        Command{.id = measureAgain,
                .tag = "measure_again",
                .menu = MenuId::view,
                .group = kGroup,
                .name = "Measure the curve again",
                .icon = icon::kRepeat,
                .run =
                    [](CommandContext& c) {
                        showPanel(c);
                        c.study.again();
                    }},
        Command{.id = cancelMeasuring,
                .tag = "cancel_measuring",
                .menu = MenuId::view,
                .group = kGroup,
                .name = "Stop measuring the curve",
                .run = [](CommandContext& c) { c.study.cancel(); },
                .enabled = [](const CommandContext& c) { return c.study.busy(); }},
    };
    return kCommands;
}

}  // namespace voxprite::editor
