#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <utility>

#include "app/editor/commands/command_context.h"
#include "app/editor/commands/tables.h"
#include "app/editor/session/playback.h"
#include "app/editor/window/icons.h"
#include "core/edit/frame_edits.h"

namespace voxprite::editor {
namespace {

bool animated(const CommandContext& c) {
    return c.session.frames() > 1;
}

bool hasObject(const CommandContext& c) {
    return c.session.activeNode() > 0;
}

// By hand: what plays stops.
void step(CommandContext& c, int frames) {
    c.settings.view.playing = false;
    const int count = c.session.frames();
    c.report(c.session.setFrame((c.session.frame() + frames + count) % count));
}

void insertFrame(CommandContext& c, NewFrame what) {
    Result<Action> action =
        voxprite::addFrame(c.session.document(), c.session.activeNode(), c.session.frame(), what);
    if (!action) return c.report(Failure(action.error()));
    const int frame = c.session.frame() + 1;
    c.settings.view.playing = false;
    c.settings.window.showsTimeline = true;
    c.perform(std::move(*action), [&c, frame] { c.report(c.session.setFrame(frame)); });
}

}  // namespace

std::span<const Command> animationCommands() {
    using enum CommandId;
    static constexpr std::array kCommands{
        Command{
            .id = togglePlaying,
            .tag = "play",
            .menu = MenuId::animation,
            .name = "Play",
            .icon = icon::kPlay,
            .chords = {control(GLFW_KEY_SPACE)},
            .settles = true,
            .run = [](CommandContext& c) { c.settings.view.playing = !c.settings.view.playing; },
            .enabled = animated,
            .on = [](const CommandContext& c) { return c.settings.view.playing; }},
        Command{.id = previousFrame,
                .tag = "previous_frame",
                .menu = MenuId::animation,
                .name = "Frame before",
                .icon = icon::kStepBack,
                .chords = {control(GLFW_KEY_PAGE_UP)},
                .repeats = true,
                .settles = true,
                .run = [](CommandContext& c) { step(c, -1); },
                .enabled = animated},
        Command{.id = nextFrame,
                .tag = "next_frame",
                .menu = MenuId::animation,
                .name = "Frame after",
                .icon = icon::kStepForward,
                .chords = {control(GLFW_KEY_PAGE_DOWN)},
                .repeats = true,
                .settles = true,
                .run = [](CommandContext& c) { step(c, 1); },
                .enabled = animated},
        Command{.id = addFrame,
                .tag = "add_frame",
                .menu = MenuId::animation,
                .name = "Add frame",
                .icon = icon::kPlus,
                .chords = {key(GLFW_KEY_INSERT)},
                .separator = true,
                .settles = true,
                .run = [](CommandContext& c) { insertFrame(c, NewFrame::copy); },
                .enabled = hasObject},
        Command{.id = addHeldFrame,
                .tag = "add_held_frame",
                .menu = MenuId::animation,
                .name = "Hold for another frame",
                .icon = icon::kLink,
                .settles = true,
                .run = [](CommandContext& c) { insertFrame(c, NewFrame::held); },
                .enabled = hasObject},
        Command{.id = addEmptyFrame,
                .tag = "add_empty_frame",
                .menu = MenuId::animation,
                .name = "Add empty frame",
                .icon = icon::kFile,
                .settles = true,
                .run = [](CommandContext& c) { insertFrame(c, NewFrame::empty); },
                .enabled = hasObject},
        Command{.id = deleteFrame,
                .tag = "delete_frame",
                .menu = MenuId::animation,
                .name = "Delete frame",
                .icon = icon::kDelete,
                .settles = true,
                .run =
                    [](CommandContext& c) {
                        Result<Action> action =
                            voxprite::deleteFrame(c.session.document(), c.session.frame());
                        if (!action) return c.report(Failure(action.error()));
                        c.perform(std::move(*action));
                    },
                .enabled = animated},
        Command{.id = addClip,
                .tag = "add_clip",
                .menu = MenuId::animation,
                .name = "Add clip",
                .icon = icon::kClip,
                .separator = true,
                .run =
                    [](CommandContext& c) {
                        const auto clips = static_cast<int>(c.session.document().clips.size());
                        c.perform(
                            voxprite::addClip(c.session.document(), 0, c.session.frames() - 1),
                            [&c, clips] { c.playback.chooseClip(clips); });
                    },
                .enabled = animated},
        Command{
            .id = toggleOnionSkin,
            .tag = "onion_skin",
            .menu = MenuId::animation,
            .name = "Onion skin",
            .icon = icon::kOnion,
            .separator = true,
            .run =
                [](CommandContext& c) { c.settings.view.onionSkin = !c.settings.view.onionSkin; },
            .on = [](const CommandContext& c) { return c.settings.view.onionSkin; }},
        Command{.id = toggleTimeline,
                .tag = "timeline",
                .menu = MenuId::animation,
                .name = "Timeline",
                .icon = icon::kFilm,
                .run =
                    [](CommandContext& c) {
                        c.settings.window.showsTimeline = !c.settings.window.showsTimeline;
                    },
                .enabled = animated,
                .on = [](const CommandContext& c) { return c.settings.window.showsTimeline; }},
    };
    return kCommands;
}

}  // namespace voxprite::editor
