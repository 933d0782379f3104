#include "app/cli/conformance/temporal.h"

#include <cmath>
#include <optional>

#include "app/cli/conformance/subjects.h"
#include "core/sprite/placed_entity.h"

namespace voxprite::conformance {
namespace {

constexpr double kTrembleRadians = 1e-3;

// Ways round the model, in degrees a frame.
struct TurnWay {
    OrbitAngles start;
    double yawPerFrame;
    double pitchPerFrame;
};
constexpr int kFramesAWay = 240;
constexpr int kFramesTrembling = 60;
constexpr int kFramesAComparison = 5;  // with the exact view
// The pitch drifts, so that no step has it among its views by chance.
constexpr std::array<TurnWay, 3> kWays{TurnWay{{3.7, 17.2, 0.0}, kTurnPerFrameDegrees, 0.014},
                                       TurnWay{{131.3, 38.6, 0.0}, kTurnPerFrameDegrees, -0.022},
                                       TurnWay{{77.0, 12.0, 0.0}, 0.08, 0.06}};

// A sprite as it is shown: colours by the pixel's place on the grid.
struct Shown {
    LatticeView lattice;
    SpriteBuffer buffer;

    [[nodiscard]] Rgba8 at(glm::ivec2 pixel) const {
        const glm::ivec2 cell = pixel - buffer.first;
        if (cell.x < 0 || cell.y < 0 || cell.x >= buffer.size.x || cell.y >= buffer.size.y)
            return Rgba8(0);
        const int row = buffer.size.y - 1 - cell.y;
        return buffer
            .colours[static_cast<std::size_t>(row) * static_cast<std::size_t>(buffer.size.x) +
                     static_cast<std::size_t>(cell.x)];
    }
};

// Pixels of other colours, wherever either shows something; as a share of b's opaque pixels.
double shareChanged(const Shown& a, const Shown& b) {
    const glm::ivec2 low = glm::min(a.buffer.first, b.buffer.first);
    const glm::ivec2 high =
        glm::max(a.buffer.first + a.buffer.size, b.buffer.first + b.buffer.size);
    std::uint64_t changed = 0;
    for (int y = low.y; y < high.y; ++y)
        for (int x = low.x; x < high.x; ++x) changed += a.at({x, y}) != b.at({x, y}) ? 1 : 0;
    return static_cast<double>(changed) / static_cast<double>(b.buffer.opaqueCount());
}

// One viewer of one model: keeps its history, and casts when the view has changed.
class SnappedViewer {
  public:
    SnappedViewer(const TurningModel& model, double stepDegrees) : model_(model) {
        profile_ = plainProfile();
        profile_.viewStepDegrees = stepDegrees;
        entity_ = placeEntity(Entity{}, {glm::ivec3(0), model.octree.size}, profile_);
        entity_.anchorMetres -= entity_.centreMetres();
    }

    // Whether the picture is another one than before.
    bool look(const Camera& camera) {
        const SpriteView view = seen(entity_, camera, profile_, &history_);
        const LitPalette lit = litPalette(model_.palette, view.light8, profile_.outline);
        if (shown_ && shown_->lattice == view.lattice && light8_ == view.light8) return false;
        Shown next{view.lattice, castSprite(model_.octree.view(), view.lattice, lit)};
        changed_ = shown_ ? shareChanged(*shown_, next) : 0.0;
        shown_ = std::move(next);
        light8_ = view.light8;
        return true;
    }
    [[nodiscard]] const Shown& shown() const { return *shown_; }
    [[nodiscard]] double changed() const { return changed_; }  // by the last look that changed
    [[nodiscard]] double distanceMetres() const { return 4.0 * entity_.radiusMetres(); }

  private:
    const TurningModel& model_;
    GameProfile profile_;
    PlacedEntity entity_;
    ViewHistory history_;
    std::optional<Shown> shown_;
    FaceLights light8_;
    double changed_ = 0.0;
};

void measureWay(const TurningModel& model, const TurnWay& way, std::vector<TurnFigures>& sums) {
    SnappedViewer exact(model, 0.0);
    std::vector<SnappedViewer> viewers;
    viewers.reserve(sums.size());
    for (const TurnFigures& figures : sums) viewers.emplace_back(model, figures.stepDegrees);
    for (int frame = 0; frame <= kFramesAWay; ++frame) {
        const Camera camera =
            orbit(way.start.yawDegrees + way.yawPerFrame * frame,
                  way.start.pitchDegrees + way.pitchPerFrame * frame, exact.distanceMetres());
        const bool compared = frame % kFramesAComparison == 0;
        if (compared) exact.look(camera);
        for (std::size_t k = 0; k < sums.size(); ++k) {
            const bool changed = viewers[k].look(camera);
            if (frame == 0) continue;
            sums[k].framesChanged += changed && viewers[k].changed() > 0.0 ? 1.0 : 0.0;
            sums[k].changedADegree += changed ? viewers[k].changed() : 0.0;
            if (compared) sums[k].offTheExact += shareChanged(viewers[k].shown(), exact.shown());
        }
    }
}

// The camera stands still but for a trembling of the hand.
void measureTremble(const TurningModel& model, const TurnWay& way, std::vector<TurnFigures>& sums) {
    constexpr double kTrembleDegrees = kTrembleRadians * 57.29577951308232;
    for (TurnFigures& figures : sums) {
        SnappedViewer viewer(model, figures.stepDegrees);
        Sequence random(11);
        for (int frame = 0; frame <= kFramesTrembling; ++frame) {
            const Camera camera =
                orbit(way.start.yawDegrees + random.between(-kTrembleDegrees, kTrembleDegrees),
                      way.start.pitchDegrees + random.between(-kTrembleDegrees, kTrembleDegrees),
                      viewer.distanceMetres());
            const bool changed = viewer.look(camera);
            figures.changedByTremble += frame > 0 && changed && viewer.changed() > 0.0 ? 1.0 : 0.0;
        }
    }
}

}  // namespace

std::vector<TurnFigures> measureTurns(const std::vector<TurningModel>& models,
                                      const std::vector<double>& stepsDegrees) {
    std::vector<TurnFigures> figures;
    figures.reserve(stepsDegrees.size());
    for (const double step : stepsDegrees) figures.push_back({.stepDegrees = step});
    for (const TurningModel& model : models)
        for (const TurnWay& way : kWays) {
            measureWay(model, way, figures);
            measureTremble(model, way, figures);
        }
    const double ways = static_cast<double>(models.size() * kWays.size());
    const double frames = ways * kFramesAWay;
    for (TurnFigures& one : figures) {
        one.changedAFrame =
            one.framesChanged > 0.0 ? 100.0 * one.changedADegree / one.framesChanged : 0.0;
        one.changedADegree *= 100.0 / (frames * kTurnPerFrameDegrees);
        one.framesChanged *= 100.0 / frames;
        one.offTheExact *= 100.0 * kFramesAComparison / frames;
        one.changedByTremble *= 100.0 / (ways * kFramesTrembling);
    }
    return figures;
}

std::vector<TurningModel> turningSubjects() {
    std::vector<TurningModel> models;
    for (Subject& subject : std::vector{figure(), vehicle(), letters()})
        models.push_back({subject.name, std::move(subject.octree), Palette::standard()});
    return models;
}

}  // namespace voxprite::conformance
