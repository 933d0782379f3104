#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

#include "app/editor/commands/command_context.h"
#include "app/editor/commands/tables.h"
#include "app/editor/session/object_selection.h"
#include "app/editor/window/icons.h"
#include "core/edit/free_name.h"
#include "core/edit/scene_edits.h"

namespace voxprite::editor {
namespace {

const SceneNode& chosenNode(const CommandContext& c) {
    const auto index = static_cast<std::size_t>(c.objects.node(c.session));
    return c.session.document().nodes[index];
}

bool hasChosen(const CommandContext& c) {
    return c.objects.node(c.session) > 0;
}
bool hasSeveral(const CommandContext& c) {
    return c.objects.nodes(c.session).size() > 1 || (hasChosen(c) && chosenNode(c).isGroup());
}
bool hasGroup(const CommandContext& c) {
    return hasChosen(c) && chosenNode(c).isGroup();
}

// The node that an edit has put last becomes the chosen one.
void performAndChooseLast(CommandContext& c, Action action) {
    c.perform(std::move(action), [&c] {
        c.objects.choose(c.session, static_cast<int>(c.session.document().nodes.size()) - 1);
    });
}

void duplicate(CommandContext& c, Copy copy) {
    const auto first = static_cast<int>(c.session.document().nodes.size());
    c.perform(duplicateNode(c.session.document(), c.objects.node(c.session), copy),
              [&c, first] { c.objects.choose(c.session, first); });
}

std::string nameFor(const CommandContext& c, const char* stem) {
    return freeName(stem, c.session.document().nodes);
}

template <int axis>
void turn(CommandContext& c) {
    c.perform(
        turnNode(c.session.document(), c.objects.node(c.session), c.session.frame(), axis, 1));
}
template <int axis>
void mirror(CommandContext& c) {
    c.perform(mirrorNode(c.session.document(), c.objects.node(c.session), c.session.frame(), axis));
}

}  // namespace

std::span<const Command> objectCommands() {
    using enum CommandId;
    static constexpr std::array kCommands{
        Command{.id = addObject,
                .tag = "add_object",
                .menu = MenuId::object,
                .name = "Add object",
                .icon = icon::kPlus,
                .settles = true,
                .run =
                    [](CommandContext& c) {
                        performAndChooseLast(
                            c, voxprite::addObject(c.session.document(), nameFor(c, "Object")));
                    }},
        Command{.id = duplicateObject,
                .tag = "duplicate_object",
                .menu = MenuId::object,
                .name = "Duplicate object",
                .icon = icon::kCopy,
                .chords = {controlShift(GLFW_KEY_D)},
                .settles = true,
                .run = [](CommandContext& c) { duplicate(c, Copy::own); },
                .enabled = hasChosen},
        Command{.id = duplicateLinked,
                .tag = "duplicate_linked",
                .menu = MenuId::object,
                .name = "Duplicate linked",
                .icon = icon::kLink,
                .settles = true,
                .run = [](CommandContext& c) { duplicate(c, Copy::linked); },
                .enabled = hasChosen},
        Command{.id = makeSingleUser,
                .tag = "make_single_user",
                .menu = MenuId::object,
                .name = "Make single user",
                .icon = icon::kUnlink,
                .settles = true,
                .run =
                    [](CommandContext& c) {
                        c.perform(voxprite::makeSingleUser(c.session.document(),
                                                           c.objects.node(c.session)));
                    },
                .enabled =
                    [](const CommandContext& c) {
                        return hasChosen(c) &&
                               sharesModels(c.session.document(), c.objects.node(c.session));
                    }},
        Command{.id = renameObject,
                .tag = "rename_object",
                .menu = MenuId::object,
                .name = "Rename object",
                .icon = icon::kRename,
                .chords = {key(GLFW_KEY_F2)},
                .run =
                    [](CommandContext& c) {
                        c.settings.window.show(DockTab::objects);
                        c.objects.rename(c.objects.node(c.session));
                    },
                .enabled = hasChosen},
        Command{.id = groupObjects,
                .tag = "group_objects",
                .menu = MenuId::object,
                .name = "Group",
                .icon = icon::kGroup,
                .chords = {control(GLFW_KEY_G)},
                .separator = true,
                .settles = true,
                .run =
                    [](CommandContext& c) {
                        const std::vector<int> nodes = c.objects.nodes(c.session);
                        performAndChooseLast(
                            c, groupNodes(c.session.document(), nodes, nameFor(c, "Group")));
                    },
                .enabled = hasChosen},
        Command{.id = ungroupObjects,
                .tag = "ungroup_objects",
                .menu = MenuId::object,
                .name = "Ungroup",
                .icon = icon::kUngroup,
                .chords = {controlShift(GLFW_KEY_G)},
                .settles = true,
                .run =
                    [](CommandContext& c) {
                        c.perform(ungroup(c.session.document(), c.objects.node(c.session)));
                    },
                .enabled = hasGroup},
        Command{.id = mergeObjects,
                .tag = "merge_objects",
                .menu = MenuId::object,
                .name = "Merge",
                .icon = icon::kMerge,
                .chords = {control(GLFW_KEY_M)},
                .settles = true,
                .run =
                    [](CommandContext& c) {
                        const std::vector<int> nodes = c.objects.nodes(c.session);
                        performAndChooseLast(
                            c, mergeNodes(c.session.document(), nodes, chosenNode(c).name));
                    },
                .enabled = hasSeveral},
        Command{.id = deleteObject,
                .tag = "delete_object",
                .menu = MenuId::object,
                .name = "Delete object",
                .icon = icon::kDelete,
                .settles = true,
                .run =
                    [](CommandContext& c) {
                        c.perform(deleteNodes(c.session.document(), c.objects.nodes(c.session)));
                    },
                .enabled = hasChosen},
        Command{.id = hideObject,
                .tag = "hide_object",
                .menu = MenuId::object,
                .name = "Hidden",
                .icon = icon::kHidden,
                .chords = {control(GLFW_KEY_H)},
                .separator = true,
                .settles = true,
                .run =
                    [](CommandContext& c) {
                        c.perform(setHidden(c.session.document(), c.objects.node(c.session),
                                            !chosenNode(c).hidden));
                    },
                .enabled = hasChosen,
                .on = [](const CommandContext& c) { return hasChosen(c) && chosenNode(c).hidden; }},
        Command{.id = lockObject,
                .tag = "lock_object",
                .menu = MenuId::object,
                .name = "Locked",
                .icon = icon::kLocked,
                .settles = true,
                .run =
                    [](CommandContext& c) {
                        c.perform(setLocked(c.session.document(), c.objects.node(c.session),
                                            !chosenNode(c).locked));
                    },
                .enabled = hasChosen,
                .on = [](const CommandContext& c) { return hasChosen(c) && chosenNode(c).locked; }},
        Command{.id = turnObjectX,
                .tag = "turn_object_x",
                .menu = MenuId::object,
                .name = "Turn object about X",
                .icon = icon::kTurn,
                .separator = true,
                .settles = true,
                .run = turn<0>,
                .enabled = hasChosen},
        Command{.id = turnObjectY,
                .tag = "turn_object_y",
                .menu = MenuId::object,
                .name = "Turn object about Y",
                .icon = icon::kTurn,
                .settles = true,
                .run = turn<1>,
                .enabled = hasChosen},
        Command{.id = turnObjectZ,
                .tag = "turn_object_z",
                .menu = MenuId::object,
                .name = "Turn object about Z",
                .icon = icon::kTurn,
                .settles = true,
                .run = turn<2>,
                .enabled = hasChosen},
        Command{.id = mirrorObjectX,
                .tag = "mirror_object_x",
                .menu = MenuId::object,
                .name = "Mirror object in X",
                .icon = icon::kMirrorX,
                .settles = true,
                .run = mirror<0>,
                .enabled = hasChosen},
        Command{.id = mirrorObjectY,
                .tag = "mirror_object_y",
                .menu = MenuId::object,
                .name = "Mirror object in Y",
                .icon = icon::kMirrorX,
                .settles = true,
                .run = mirror<1>,
                .enabled = hasChosen},
        Command{.id = mirrorObjectZ,
                .tag = "mirror_object_z",
                .menu = MenuId::object,
                .name = "Mirror object in Z",
                .icon = icon::kMirrorZ,
                .settles = true,
                .run = mirror<2>,
                .enabled = hasChosen},
    };
    return kCommands;
}

}  // namespace voxprite::editor
