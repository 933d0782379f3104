// The editor: one window, two live views of one document. Everything else in this folder is
// private to it.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "core/base/result.h"

namespace voxprite {

struct EditorOptions {
    std::vector<std::filesystem::path> files;  // the first is opened
    // Of a file with several entities: this one, without asking.
    std::optional<std::size_t> entity;
    std::optional<std::filesystem::path> profile;  // game profile in use
    // Writes the window's content to a PNG after `frames` frames and quits.
    std::optional<std::filesystem::path> screenshot;
    int frames = 3;
    // At content scale 1; the window is that much larger on a denser display, as far as it fits.
    // Not set: as large as it was last, and where it was; 1280x800 the first time.
    std::optional<glm::ivec2> windowPx;
    std::optional<double> contentScale;  // else the display's own (Xft.dpi and its like)
    // JSON lines of input, replayed instead of the user's (see play_script.h).
    std::optional<std::filesystem::path> playScript;
    std::optional<std::filesystem::path> record;  // the user's input is written here
    // Unsaved work is copied into this folder; not set: the user's own (recovery_folder.h), and
    // none for a run that takes a screenshot or replays a script.
    std::optional<std::filesystem::path> recovery;
    // Where widgets and views lie on screen is written here whenever it changes, for tests.
    std::optional<std::filesystem::path> layoutDump;
    // Where the window's thread spent the longest frames of each stretch that the script marks
    // (window/frame_report.h) is written here at the end.
    std::optional<std::filesystem::path> frameTimes;
    // When the parts of the start were done (window/start_times.h) is written here at the end.
    std::optional<std::filesystem::path> startTimes;
};

// Returns when the user closes the window. Fails when there is no display, no OpenGL 4.5, or a
// file named in the options cannot be used.
[[nodiscard]] Status runEditor(const EditorOptions& options);

}  // namespace voxprite
