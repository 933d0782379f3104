// From input to picture in the editor: the tool is told what the hand does, what it will do is
// shown in both views and then done. The hand and the eye are as far from the surface on every
// model, so what grows from model to model is the model alone.
#include <glad/gl.h>

#include <array>
#include <chrono>

#include "app/cli/bench/bench.h"
#include "app/editor/session/session.h"
#include "app/editor/tools/tool_box.h"
#include "core/edit/make_action.h"
#include "render/frame.h"
#include "render/gpu_octree.h"
#include "render/scene_renderer.h"
#include "render/voxel_view.h"

namespace voxprite::bench {
namespace {

using editor::ToolKind;

constexpr glm::ivec2 kViewPx{512, 512};
constexpr double kEyeVoxels = 90.0;  // from the surface
constexpr std::uint8_t kColour = 9;

struct Job {
    const char* name;
    ToolKind tool;
    int tipEdge;
    glm::ivec3 figures;  // what a shape is made; 0: no shape
};
constexpr std::array kJobs{Job{"click", ToolKind::brush, 1, glm::ivec3(0)},
                           Job{"brush_radius_8", ToolKind::brush, 17, glm::ivec3(0)},
                           Job{"box_64", ToolKind::box, 1, glm::ivec3(64)},
                           Job{"fill_all", ToolKind::fill, 1, glm::ivec3(0)}};

class LatencyBench {
  public:
    LatencyBench(SceneRenderer& renderer, VoxelView& voxels)
        : renderer_(renderer), voxels_(voxels) {}

    // A cube's shell, three voxels thick, of one colour.
    [[nodiscard]] Status open(int edge) {
        edge_ = edge;
        if (Status fresh = session_.startNew(); !fresh) return fresh;
        for (int axis = 0; axis < 3; ++axis) {
            for (const int side : {0, edge - 3}) {
                IBox wall{glm::ivec3(0), glm::ivec3(edge)};
                wall.min[axis] = side;
                wall.max[axis] = side + 3;
                Status built = session_.perform(makeAction(
                    "wall", patchBox(session_.document(), 0, wall, EditMode::attach, 5)));
                if (!built) return built;
            }
        }
        const glm::dvec3 top(edge * 0.5, edge * 0.5, edge);
        camera_ = orbitCamera({30.0, 50.0, 0.0}, worldFromVoxel(top), kEyeVoxels, 45.0, kViewPx);
        return draw();
    }

    [[nodiscard]] Result<Json> measure(const Job& job, const Effort& effort) {
        settings_ = {};
        settings_.tool = job.tool;
        settings_.colour = kColour;
        settings_.options.tip = TipShape::sphere;
        settings_.options.tipEdge = job.tipEdge;
        std::vector<double> aimed, preview, done, edit;
        std::uint64_t changed = 0;
        const int runs = effort.quick ? 3 : 7;
        for (int run = 0; run <= runs; ++run) {
            // Somewhere else on the surface each time.
            const glm::dvec2 px(256.0 + 6.0 * run, 262.0 - 5.0 * run);
            const auto start = now();
            if (Status shown = show(job, px); !shown) return Failure(shown.error());
            const auto toPreview = now();
            Result<std::uint64_t> voxels = make();
            if (!voxels) return Failure(voxels.error());
            const auto edited = now();
            if (Status drawn = draw(); !drawn) return Failure(drawn.error());
            const auto drawnAt = now();
            changed = *voxels;
            // The first run warms caches and is not counted.
            if (run > 0) {
                aimed.push_back(aimedAt_ - start);
                preview.push_back(toPreview - start);
                edit.push_back(edited - toPreview);
                done.push_back(drawnAt - toPreview);
            }
            if (Status undone = session_.undo(); !undone) return Failure(undone.error());
            if (Status drawn = draw(); !drawn) return Failure(drawn.error());
        }
        return Json{{"model", "hollow" + std::to_string(edge_)},
                    {"input", job.name},
                    {"voxels", changed},
                    {"preview_edit_ms", median(aimed)},
                    {"preview_ms", median(preview)},
                    {"click_edit_ms", median(edit)},
                    {"click_ms", median(done)}};
    }

  private:
    [[nodiscard]] static double now() {
        const auto time = std::chrono::steady_clock::now().time_since_epoch();
        return std::chrono::duration<double, std::milli>(time).count();
    }

    [[nodiscard]] editor::ToolBox::Outcome frame(glm::dvec2 px, bool pressed, bool held) {
        editor::ToolInput input;
        input.pointerPx = px;
        input.pathPx = {px};
        input.hovered = true;
        input.pressed = pressed;
        input.held = held;
        input.released = !held && held_;
        held_ = held;
        const editor::ToolContext context{
            session_,
            settings_,
            camera_,
            input,
            editor::pick(session_.octree(), session_.bounds(), camera_.rayThrough(px)),
            1.0f};
        editor::ToolBox::Outcome outcome = tools_.update(context, false);
        for (Action& action : outcome.actions) actions_.push_back(std::move(action));
        return outcome;
    }

    // Until both views show what is coming.
    [[nodiscard]] Status show(const Job& job, glm::dvec2 px) {
        px_ = px;
        static_cast<void>(frame(px, false, false));
        if (job.figures != glm::ivec3(0)) {
            static_cast<void>(frame(px, true, true));
            static_cast<void>(frame(px, false, false));
            for (int axis = 0; axis < 3; ++axis) {
                tools_.tool()->setFigure(static_cast<std::size_t>(axis), job.figures[axis]);
            }
            const auto outcome = frame(px, false, false);
            if (!outcome.refusal.empty()) return fail(outcome.refusal);
        }
        // Of very many voxels it is worked out behind the window.
        tools_.finishPreview(session_);
        aimedAt_ = now();
        return draw();
    }

    // The click, or what keeps a shape; how many voxels it changed.
    [[nodiscard]] Result<std::uint64_t> make() {
        if (tools_.busy()) {
            if (auto action = tools_.confirm(session_)) actions_.push_back(std::move(*action));
        } else {
            static_cast<void>(frame(px_, true, true));
            static_cast<void>(frame(px_, false, false));
        }
        std::uint64_t voxels = 0;
        for (Action& action : actions_) {
            if (Status performed = session_.perform(std::move(action)); !performed) {
                return Failure(performed.error());
            }
            for (const ActionPart& part : session_.history().steps().back().parts) {
                if (const auto* patch = std::get_if<VoxelPatch>(&part)) {
                    voxels += patch->changes.size();
                }
            }
        }
        actions_.clear();
        if (voxels == 0) return fail("latency: the tool changed nothing");
        return voxels;
    }

    // As the editor does at the end of a frame.
    [[nodiscard]] Status draw() {
        const OctreeView view = session_.shownOctree().view(session_.shownBounds());
        octree_.update(view, session_.takeOctreeChanges());
        voxels_.draw(editFrame_, octree_, session_.document().palette, session_.placedForEditing(),
                     camera_, {});
        const PlacedEntity placed = session_.placedInGame();
        Scene scene;
        scene.entities.push_back({&octree_, &session_.document().palette, placed, nullptr});
        scene.ground = Ground{};
        // The same place and distance, in the game's measure.
        const double metres = placed.metresPerVoxel();
        const glm::dvec3 top(edge_ * 0.5, edge_ * 0.5, edge_);
        const glm::dvec3 at = placed.worldFromVoxel(top - glm::dvec3(session_.shownBounds().min));
        const Camera camera =
            orbitCamera({30.0, 50.0, 0.0}, at, kEyeVoxels * metres, 45.0, kViewPx);
        const Result<SceneStats> stats = renderer_.draw(
            spriteFrame_, scene, camera, session_.profile(), SpriteMode::spriteBuffer);
        if (!stats) return Failure(stats.error());
        glFinish();
        return {};
    }

    SceneRenderer& renderer_;
    VoxelView& voxels_;
    Frame editFrame_{kViewPx}, spriteFrame_{kViewPx};
    GpuOctree octree_;
    editor::Session session_;
    editor::ToolSettings settings_;
    editor::ToolBox tools_;
    std::vector<Action> actions_;
    Camera camera_;
    glm::dvec2 px_{0.0};
    int edge_ = 0;
    double aimedAt_ = 0.0;  // when the tool had said what is coming, and no picture showed it yet
    bool held_ = false;
};

}  // namespace

Result<Json> benchLatency(const std::vector<BenchModel>& /*models*/, const Effort& effort) {
    Result<SceneRenderer> renderer = SceneRenderer::create();
    if (!renderer) return Failure(renderer.error());
    Result<VoxelView> voxels = VoxelView::create();
    if (!voxels) return Failure(voxels.error());
    Json figures = Json::array();
    LatencyBench bench(*renderer, *voxels);
    for (const int edge : effort.quick ? std::vector{64, 128} : std::vector{64, 128, 256, 512}) {
        progress(effort, "latency: a model of " + std::to_string(edge) + " cubed");
        if (Status opened = bench.open(edge); !opened) return Failure(opened.error());
        for (const Job& job : kJobs) {
            Result<Json> figure = bench.measure(job, effort);
            if (!figure) return Failure(figure.error());
            figures.push_back(std::move(*figure));
        }
    }
    return figures;
}

}  // namespace voxprite::bench
