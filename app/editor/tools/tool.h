// What every tool of the edit view is: input of one frame goes in; the coming edit (a preview) and
// at most one action come out. A tool changes nothing itself and knows no window, so that scripts,
// tests and measurements drive it as the view does.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/editor/session/large_preview.h"
#include "app/editor/session/session.h"
#include "app/editor/settings/settings.h"
#include "app/editor/views/picking.h"
#include "core/edit/history.h"
#include "core/sprite/camera.h"

namespace voxprite::editor {

class ViewDrawing;
struct Theme;

// What the hand does over the edit view this frame; positions in pixels from its top left corner.
struct ToolInput {
    glm::dvec2 pointerPx{0.0};
    // Where the pointer went since the last frame, from where it was then; a fast hand leaves few
    // points.
    std::vector<glm::dvec2> pathPx;
    bool hovered = false;   // the pointer is over the view, and nothing else has it
    bool pressed = false;   // the left button went down here
    bool held = false;      // it is down, and went down here
    bool released = false;  // it went up again
    double wheel = 0.0;     // notches; only while the tool wants them
    bool shift = false;
    bool control = false;
    bool alt = false;
};

// All that the coming edit depends on, but for what a tool is already making: while it is the same,
// the preview is.
struct Aim {
    std::optional<Pick> pick;
    EditMode mode = EditMode::attach;
    ToolSettings settings;
    std::uint64_t revision = 0;   // of the session
    std::uint64_t selection = 0;  // of what is selected
    bool operator==(const Aim&) const = default;
    // Nothing else has changed than where the pointer is.
    [[nodiscard]] bool differsInPickAlone(Aim other) const {
        other.pick = pick;
        return other == *this;
    }
};

struct ToolContext {
    Session& session;  // to aim at; and to say which object is being edited
    ToolSettings& settings;
    const Camera& camera;
    const ToolInput& input;
    // Under the pointer, in the document as it is; nothing off the model and the ground.
    std::optional<Pick> pick;
    float scale = 1.0f;  // device pixels a pixel: handles are as large for the hand everywhere

    // The chosen mode; while Shift is held attach and erase change places.
    [[nodiscard]] EditMode mode() const {
        if (!input.shift || settings.mode == EditMode::paint) return settings.mode;
        return settings.mode == EditMode::attach ? EditMode::erase : EditMode::attach;
    }
    [[nodiscard]] Aim aim() const {
        return {pick, mode(), settings, session.revision(), session.selection().revision()};
    }
};

struct ToolResult {
    // The coming edit, shown in both views until the next one; nothing when it is as it was.
    std::optional<std::vector<VoxelPatch>> preview;
    // What comes in its place when that is of very many voxels: shown once it has been worked out
    // behind the window, if it is still what is coming.
    PlanPreview largePreview;
    std::optional<Action> action;
    std::string refusal;  // why nothing happens, for the artist
};

// A figure of what is being made, to be typed instead of dragged: "Width" 12.
struct ToolFigure {
    const char* name;
    int value;
    int min, max;
};

class Tool {
  public:
    Tool() = default;
    virtual ~Tool() = default;
    Tool(const Tool&) = delete;
    Tool& operator=(const Tool&) = delete;

    // Once a frame while it is the tool in hand.
    [[nodiscard]] virtual ToolResult update(const ToolContext& context) = 0;
    // Over the picture: handles, the voxel under the pointer, sizes. After update() of this frame.
    virtual void draw(const ToolContext& /*context*/, const ViewDrawing& /*drawing*/,
                      const Theme& /*theme*/) const {}

    // Something is being made that is not yet part of the document.
    [[nodiscard]] virtual bool busy() const { return false; }
    // Enter, or another tool is taken: what is being made becomes an action.
    [[nodiscard]] virtual std::optional<Action> confirm(Session& /*session*/) {
        return std::nullopt;
    }
    // Esc: it is dropped.
    virtual void cancel() {}
    // The wheel is the tool's and not the camera's.
    [[nodiscard]] virtual bool wantsWheel() const { return false; }

    // Figures of what is being made; nothing while nothing is.
    [[nodiscard]] virtual std::vector<ToolFigure> figures() const { return {}; }
    virtual void setFigure(std::size_t /*index*/, int /*value*/) {}
    // "12 × 5 × 1" for the status bar; empty while nothing is being made.
    [[nodiscard]] virtual std::string sizeText() const { return {}; }
};

}  // namespace voxprite::editor
