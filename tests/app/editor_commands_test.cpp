// The tables of commands, their keys, and how they are found.
#include <gtest/gtest.h>

#include <set>

#include "app/editor/commands/commands.h"
#include "app/editor/commands/fuzzy.h"
#include "app/editor/panels/command_palette.h"
#include "app/editor/window/input.h"
#include "tests/support/random.h"

namespace voxprite::editor {
namespace {

TEST(EditorCommands, EachStandsOnceAndCanBeRun) {
    std::set<CommandId> ids;
    std::set<std::string> tags;
    for (const Command& command : commands()) {
        EXPECT_TRUE(ids.insert(command.id).second) << command.name;
        EXPECT_TRUE(tags.insert(command.tag).second) << command.tag;
        EXPECT_NE(std::string(command.tag), "");
        EXPECT_NE(std::string(command.name), "");
        EXPECT_NE(command.menu, MenuId::none) << command.name << " is in no menu";
        EXPECT_NE(command.run, nullptr) << command.name;
        EXPECT_EQ(&commandOf(command.id), &command);
    }
}

// What floats, or is being made, is of an object and a frame: it comes down before these change.
TEST(EditorCommands, WhatChangesObjectsAndFramesSettlesFirst) {
    for (const Command& command : commands()) {
        if (command.menu != MenuId::object) continue;
        EXPECT_EQ(command.settles, command.id != CommandId::renameObject) << command.name;
    }
    using enum CommandId;
    for (const CommandId id : {togglePlaying, previousFrame, nextFrame, addFrame, addHeldFrame,
                               addEmptyFrame, deleteFrame}) {
        EXPECT_TRUE(commandOf(id).settles) << commandOf(id).name;
    }
}

// Which colours are in use is only known once everything is put down.
TEST(EditorCommands, WhatNeedsUnusedColoursSettlesFirst) {
    using enum CommandId;
    for (const CommandId id : {removeUnusedColours, duplicateColour}) {
        EXPECT_TRUE(commandOf(id).settles) << commandOf(id).name;
    }
}

TEST(EditorCommands, DefaultKeysMeanOneThingEach) {
    for (const Command& command : commands()) {
        EXPECT_EQ(conflictText(command, {}), "") << command.name;
        EXPECT_FALSE(command.chords[0].key == 0 && command.chords[1].key != 0) << command.name;
    }
}

TEST(EditorCommands, EveryKeyIsReadAsItIsWritten) {
    int chords = 0;
    for (int code = 1; code <= kLastKey; ++code) {
        if (!keyName(code)) continue;
        for (int held = 0; held < 8; ++held) {
            const Chord chord{code, (held & 1) != 0, (held & 2) != 0, (held & 4) != 0};
            const auto read = chordNamed(chordText(chord));
            ASSERT_TRUE(read) << chordText(chord);
            EXPECT_EQ(*read, chord) << chordText(chord);
            ++chords;
        }
    }
    EXPECT_GT(chords, 500);
    EXPECT_EQ(chordText(controlShift('Z')), "Ctrl+Shift+Z");
    EXPECT_EQ(chordText(key('-')), "-");
    EXPECT_EQ(chordNamed("ctrl+shift+z"), controlShift('Z'));
    EXPECT_EQ(chordNamed(""), Chord{});
    EXPECT_EQ(chordNamed("Hyper+Z"), std::nullopt);
    EXPECT_EQ(chordNamed("Ctrl+"), std::nullopt);
}

TEST(EditorCommands, BoundAnewTheyShowConflictsAndGoBack) {
    Keymap keymap;
    const Command& undo = commandOf(CommandId::undo);
    const Command& save = commandOf(CommandId::save);
    bindKeys(keymap, undo, {save.chords[0], Chord{}});
    EXPECT_EQ(chordsOf(undo, keymap)[0], save.chords[0]);
    EXPECT_EQ(nameWithKey(CommandId::undo, keymap), "Undo  (Ctrl+S)");
    EXPECT_EQ(conflictText(undo, keymap), "Also means: Save");
    EXPECT_EQ(conflictText(save, keymap), "Also means: Undo");
    // Its old key is free now.
    EXPECT_TRUE(conflictsOf(save, undo.chords[0], keymap).empty());

    bindKeys(keymap, undo, undo.chords);
    EXPECT_TRUE(keymap.empty());
    bindKeys(keymap, undo, {Chord{}, Chord{}});
    EXPECT_EQ(nameWithKey(CommandId::undo, keymap), "Undo");
    EXPECT_EQ(keymap.size(), 1u);
}

bool lists(const std::vector<const Command*>& found, CommandId id) {
    return std::ranges::find(found, id, &Command::id) != found.end();
}

TEST(EditorCommands, TheKeyListIsSearchedByNameMenuAndKey) {
    EXPECT_EQ(commandsWithKey("", {}).size(), commands().size());
    EXPECT_TRUE(lists(commandsWithKey("ctrl+z", {}), CommandId::undo));
    EXPECT_TRUE(lists(commandsWithKey("file save", {}), CommandId::saveAs));
    EXPECT_FALSE(lists(commandsWithKey("file save", {}), CommandId::undo));
    EXPECT_TRUE(commandsWithKey("no such words", {}).empty());
    const Keymap keymap{{"undo", {key('5'), Chord{}}}};
    EXPECT_FALSE(lists(commandsWithKey("ctrl+z", keymap), CommandId::undo));
}

TEST(EditorCommandPalette, FindsEveryCommandByItsName) {
    EXPECT_EQ(commandsMatching("").size(), commands().size());
    for (const Command& command : commands()) {
        const auto found = commandsMatching(command.name);
        ASSERT_FALSE(found.empty()) << command.name;
        EXPECT_EQ(std::string(found.front()->name), command.name);
    }
    EXPECT_EQ(commandsMatching("undo").front()->id, CommandId::undo);
    EXPECT_EQ(commandsMatching("svas").front()->id, CommandId::saveAs);
    EXPECT_TRUE(lists(commandsMatching("file quit"), CommandId::quit));
    EXPECT_TRUE(commandsMatching("qqqqq").empty());
}

TEST(EditorFuzzy, BeginningsAndRunsCountMore) {
    const auto score = [](const char* query, const char* text) {
        const auto match = fuzzyMatch(query, text);
        return match ? match->score : -1000;
    };
    EXPECT_GT(score("sa", "Save as"), score("sa", "Isometric and such"));
    EXPECT_GT(score("sa", "Save"), score("sa", "Save as another file"));
    EXPECT_GT(score("vi", "Saved views"), score("vi", "Save without it"));
    EXPECT_EQ(fuzzyMatch("as", "sa"), std::nullopt);
    EXPECT_EQ(fuzzyMatch("SAVE", "save as")->places, (std::vector<std::size_t>{0, 1, 2, 3}));
    EXPECT_EQ(fuzzyMatch("", "anything")->score, 0);
    EXPECT_FALSE(fuzzyMatch("a", ""));
}

// Against the definition: a match is any ascending choice of equal letters.
TEST(EditorFuzzy, MatchesAreSubsequencesAndNoneIsMissed) {
    test::Random random(11);
    int matched = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto word = [&](int most) {
            std::string text;
            for (int n = random.between(0, most); n > 0; --n) {
                text += "ab "[random.between(0, 2)];
            }
            return text;
        };
        const std::string query = word(4), text = word(9);
        std::string letters;
        for (const char c : query) {
            if (c != ' ') letters += c;
        }
        std::size_t next = 0;
        for (const char c : text) {
            if (next < letters.size() && c == letters[next]) ++next;
        }
        const auto match = fuzzyMatch(query, text);
        ASSERT_EQ(match.has_value(), next == letters.size()) << query << " in " << text;
        if (!match) continue;
        ++matched;
        ASSERT_EQ(match->places.size(), letters.size());
        for (std::size_t k = 0; k < letters.size(); ++k) {
            EXPECT_EQ(text[match->places[k]], letters[k]);
            EXPECT_TRUE(k == 0 || match->places[k - 1] < match->places[k]);
        }
    }
    EXPECT_GT(matched, 100);
}

}  // namespace
}  // namespace voxprite::editor
