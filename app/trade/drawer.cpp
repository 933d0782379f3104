#include "app/trade/drawer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include "app/trade/fp32_walk.h"
#include "app/trade/gl_stage.h"
#include "core/base/stopwatch.h"
#include "core/billboard/snapshot_blit.h"
#include "core/sprite/composite.h"
#include "core/sprite/sprite_outline.h"

namespace voxprite::trade {
namespace {

constexpr int kOneThread = 1;
constexpr std::array<glm::ivec2, 4> kNeighbours{glm::ivec2{-1, 0}, glm::ivec2{1, 0},
                                                glm::ivec2{0, -1}, glm::ivec2{0, 1}};

Shown nothing(const Camera& camera) {
    Shown shown{Image(camera.viewportPx.x, camera.viewportPx.y), {}, 0.0, 0.0};
    shown.ids.assign(shown.image.pixels.size(), kIdEmpty);
    return shown;
}

// castSprite() with the rival's walk: the same samples, from outside the model, without rounding to
// the lattice.
SpriteBuffer castByFloats(const OctreeView& octree, const SpriteView& view, const LitPalette& lit) {
    const OrthoView& ortho = view.ortho;
    const double offset = sampleOffsetPx(ortho.sigmaInForce);
    const double away = 2.0 * std::max({octree.size.x, octree.size.y, octree.size.z});
    const std::array<float, 3> direction{static_cast<float>(ortho.forward.x),
                                         static_cast<float>(ortho.forward.y),
                                         static_cast<float>(ortho.forward.z)};
    const FaceShader shader(octree, lit.rays);
    SpriteBuffer buffer{view.lattice.first, view.lattice.size, {}, {}};
    for (int row = 0; row < buffer.size.y; ++row)
        for (int column = 0; column < buffer.size.x; ++column) {
            const glm::dvec2 sample =
                glm::dvec2(buffer.first.x + column, buffer.first.y + buffer.size.y - 1 - row) +
                offset;
            const glm::dvec3 origin =
                glm::dvec3(octree.size / 2) +
                (ortho.right * sample.x + ortho.up * sample.y) / ortho.sigmaInForce -
                ortho.forward * away;
            const LatticeHit hit =
                castFp32Walk(octree,
                             {static_cast<float>(origin.x), static_cast<float>(origin.y),
                              static_cast<float>(origin.z)},
                             direction);
            if (hit.material == 0) {
                buffer.colours.emplace_back(0);
                buffer.ids.push_back(kIdEmpty);
                continue;
            }
            const FaceShade shade =
                lit.rays.any() ? shader.shadeOf(seenFace(hit, view.lattice.D)) : FaceShade{};
            buffer.colours.push_back(lit.shade(hit.material, hit.faceAxis, shade));
            buffer.ids.push_back(voxelId(hit.voxel, octree.size));
        }
    if (lit.outline.enabled) dilateOutline(buffer, lit.outline.colour);
    return buffer;
}

// What a single pass asks of one virtual pixel, and how many rays that takes. A buffer that is
// known already tells what they would hit.
class SinglePass {
  public:
    SinglePass(const OctreeView& octree, const LatticeView& lattice, const LitPalette& lit,
               const SpriteBuffer* known)
        : octree_(octree),
          lattice_(lattice),
          lit_(lit),
          known_(known),
          caster_(octree, lattice),
          shader_(octree, lit.rays) {}

    struct Fragment {
        Rgba8 colour{0};
        std::uint32_t id = kIdEmpty;
    };
    Fragment at(glm::ivec2 pixel) {
        const Fragment own = cast(pixel, true);
        if (own.id != kIdEmpty || !lit_.outline.enabled) return own;
        const Rgba8 outline = lit_.outline.colour;
        for (const glm::ivec2 step : kNeighbours)
            if (cast(pixel + step, false).id != kIdEmpty)
                return {{outline.x, outline.y, outline.z, 255}, kIdOutline};
        return {};
    }
    [[nodiscard]] std::uint64_t rays() const { return rays_; }

  private:
    Fragment cast(glm::ivec2 pixel, bool shaded) {
        ++rays_;
        if (known_ != nullptr) return lookUp(pixel);
        const LatticeHit hit = caster_.cast(pixel);
        if (hit.material == 0) return {};
        FaceShade shade;
        if (shaded && lit_.rays.any()) shade = shader_.shadeOf(seenFace(hit, lattice_.D));
        return {lit_.shade(hit.material, hit.faceAxis, shade), voxelId(hit.voxel, octree_.size)};
    }
    [[nodiscard]] Fragment lookUp(glm::ivec2 pixel) const {
        const glm::ivec2 cell = pixel - known_->first;
        if (cell.x < 0 || cell.y < 0 || cell.x >= known_->size.x || cell.y >= known_->size.y)
            return {};
        const auto at =
            static_cast<std::size_t>((known_->size.y - 1 - cell.y) * known_->size.x + cell.x);
        if (known_->ids[at] < kIdFirstVoxel) return {};
        return {known_->colours[at], known_->ids[at]};
    }

    const OctreeView& octree_;
    const LatticeView& lattice_;
    const LitPalette& lit_;
    const SpriteBuffer* known_;
    LatticeCaster caster_;
    FaceShader shader_;
    std::uint64_t rays_ = 0;
};

}  // namespace

Drawer::Drawer(ModelParts& parts, const GameProfile& game, const Setting& setting, GlStage* stage)
    : parts_(&parts),
      profile_(profileWith(game, setting)),
      setting_(setting),
      stage_(stage),
      octree_(parts.model().octree.view()),
      placed_(parts.placed()) {}

Result<Drawer> Drawer::create(ModelParts& parts, const GameProfile& game, const Setting& setting,
                              GlStage* stage) {
    Drawer drawer(parts, game, setting, stage);
    if (setting.drawnBy == Representation::coarse) {
        const Result<const ModelParts::Coarse*> coarse = parts.coarse(setting.coarseLevels);
        if (!coarse) return Failure(coarse.error());
        drawer.octree_ = (*coarse)->octree.view();
        drawer.placed_ = (*coarse)->placed;
        drawer.ownVoxels_ = false;
        drawer.prepared_ = (*coarse)->milliseconds;
    }
    if (setting.drawnBy == Representation::snapshot) {
        Result<ViewSet> views = ViewSet::named(setting.viewSet);
        if (!views) return Failure(views.error());
        drawer.views_ = std::move(*views);
        if (setting.snapshotKind == SnapshotKind::seed)
            drawer.light_.emplace(parts.model().palette, drawer.profile_.light,
                                  glm::transpose(drawer.placed_.worldFromVoxelAxes),
                                  drawer.profile_.outline, drawer.profile_.shading);
    }
    return drawer;
}

void Drawer::forget() {
    history_ = {};
    kept_.clear();
    snapshots_.clear();
    keptBytes_ = 0;
    last_.reset();
    counts_ = {};
}

std::size_t Drawer::Kept::bytes() const {
    return buffer->ids.size() * (sizeof(Rgba8) + sizeof(std::uint32_t));
}

template <class Pictures>
void Drawer::keepWithin(Pictures& kept, double milliseconds, std::size_t rays) {
    counts_.castMilliseconds += milliseconds;
    ++counts_.casts;
    counts_.rays += rays;
    counts_.castBytes += kept.back().bytes();
    keptBytes_ += kept.back().bytes();
    for (; keptBytes_ > kMostKeptBytes && kept.size() > 1; kept.pop_front())
        keptBytes_ -= kept.front().bytes();
    counts_.mostKeptBytes = std::max<std::uint64_t>(counts_.mostKeptBytes, keptBytes_);
}

Result<const SpriteBuffer*> Drawer::bufferOf(const SpriteView& view) {
    // Seen again is mostly what was just seen.
    for (auto kept = kept_.rbegin(); kept != kept_.rend(); ++kept)
        if (kept->lattice == view.lattice && kept->lights == view.light8) return kept->buffer.get();
    const Stopwatch watch;
    const LitPalette lit =
        litPalette(parts_->model().palette, view.light8, profile_.outline, profile_.shading);
    auto buffer = std::make_unique<SpriteBuffer>();
    if (setting_.walk == Walk::fp32) {
        *buffer = castByFloats(octree_, view, lit);
    } else if (stage_ != nullptr) {
        Result<SpriteBuffer> cast = stage_->castBuffer(setting_, view.lattice, lit);
        if (!cast) return Failure(cast.error());
        *buffer = std::move(*cast);
    } else {
        *buffer = castSprite(octree_, view.lattice, lit, kOneThread);
    }
    const double milliseconds = watch.milliseconds();
    kept_.push_back({view.lattice, view.light8, std::move(buffer)});
    keepWithin(kept_, milliseconds, kept_.back().buffer->ids.size());
    return kept_.back().buffer.get();
}

Result<Shown> Drawer::drawSinglePass(const SpriteView& view, const Camera& camera) {
    const LitPalette lit =
        litPalette(parts_->model().palette, view.light8, profile_.outline, profile_.shading);
    std::optional<SpriteBuffer> known;
    if (stage_ != nullptr) {
        Result<SpriteBuffer> cast = stage_->castBuffer(setting_, view.lattice, lit);
        if (!cast) return Failure(cast.error());
        known = std::move(*cast);
    }
    Shown shown = nothing(camera);
    const glm::dmat3 mapping = pixelFromScreen(view, camera);
    glm::dvec2 least(camera.viewportPx), most(0.0);
    for (const glm::dvec3& corner : quadFromEye(view, view.lattice.first, view.lattice.size)) {
        const glm::dvec2 at = camera.projectFromEye(corner).screenPx;
        least = glm::min(least, at);
        most = glm::max(most, at);
    }
    const glm::ivec2 first(glm::max(glm::floor(least), glm::dvec2(0.0)));
    const glm::ivec2 last(glm::min(glm::ceil(most), glm::dvec2(camera.viewportPx)));
    const glm::ivec2 end = view.lattice.first + view.lattice.size;
    SinglePass pass(octree_, view.lattice, lit, known ? &*known : nullptr);
    for (int y = first.y; y < last.y; ++y)
        for (int x = first.x; x < last.x; ++x) {
            const glm::dvec2 screenPx = glm::dvec2(x, y) + 0.5;
            const glm::dvec3 p = mapping * glm::dvec3(screenPx, 1.0);
            if (!(p.z > 0.0)) continue;
            const glm::ivec2 pixel(glm::floor(glm::dvec2(p) / p.z));
            if (pixel.x < view.lattice.first.x || pixel.y < view.lattice.first.y ||
                pixel.x >= end.x || pixel.y >= end.y)
                continue;
            if (view.proxy == ProxyShape::box && !meetsProxyBox(view, camera.rayFromEye(screenPx)))
                continue;
            const SinglePass::Fragment fragment = pass.at(pixel);
            shown.image.at(x, y) = fragment.colour;
            shown.ids[static_cast<std::size_t>(y) * static_cast<std::size_t>(shown.image.width) +
                      static_cast<std::size_t>(x)] = fragment.id;
        }
    counts_.rays += pass.rays();
    return shown;
}

Result<Shown> Drawer::drawSeed(const Camera& camera, ViewHistory* history) {
    const Result<SeenSnapshots> seen =
        seeSnapshots(placed_, camera, *views_, setting_.snapshotPx, {}, history);
    if (!seen) return Failure(seen.error());
    if (seen->shown.empty()) return nothing(camera);
    const ShownSnapshot& one = seen->shown.front();
    auto known = std::find_if(snapshots_.begin(), snapshots_.end(),
                              [&](const Snapshot& each) { return each.view == one.view; });
    if (known == snapshots_.end()) {
        const Stopwatch watch;
        snapshots_.push_back(
            castSnapshot(octree_, *light_, *views_, one.view, setting_.snapshotPx, kOneThread));
        keepWithin(snapshots_, watch.milliseconds(), snapshots_.back().buffer.ids.size());
        known = std::prev(snapshots_.end());
    }
    SpriteOnScreen shown = onScreen(one.plane, known->buffer, camera);
    return Shown{std::move(shown.image), std::move(shown.ids), 0.0, one.plane.screenPxPerPx};
}

Result<Shown> Drawer::draw(const Camera& camera, bool history) {
    last_.reset();
    ViewHistory* const before = history ? &history_ : nullptr;
    if (setting_.drawnBy == Representation::clusters) {
        if (stage_ == nullptr) return fail("clusters are drawn by OpenGL alone");
        return stage_->show(setting_, profile_, camera);
    }
    if (light_) return drawSeed(camera, before);
    const Result<SpriteViewResult> seen =
        views_ ? viewSnapshot(placed_, camera, profile_, *views_, before)
               : viewSprite(placed_, camera, profile_, before);
    if (!seen) return Failure(seen.error());
    if (!seen->view) return nothing(camera);
    const SpriteView& view = *seen->view;
    Shown shown;
    if (profile_.mode == SpriteMode::singlePass && !views_ && setting_.walk == Walk::lattice) {
        Result<Shown> drawn = drawSinglePass(view, camera);
        if (!drawn) return drawn;
        shown = std::move(*drawn);
        last_ = Cast{view, nullptr};
    } else {
        const Result<const SpriteBuffer*> buffer = bufferOf(view);
        if (!buffer) return Failure(buffer.error());
        SpriteOnScreen seenOnScreen = onScreen(view, **buffer, camera);
        shown.image = std::move(seenOnScreen.image);
        shown.ids = std::move(seenOnScreen.ids);
        last_ = Cast{view, *buffer};
    }
    shown.sigmaInForce = view.sigmaInForce;
    shown.screenPxPerPx = view.screenPxPerPx;
    // Cells of a coarser octree are numbered their own way.
    if (!ownVoxels_) shown.ids.clear();
    return shown;
}

double Drawer::bytes() const {
    const auto held = static_cast<double>(bytesOf(octree_));
    if (!views_ || counts_.casts == 0) return held + static_cast<double>(counts_.mostKeptBytes);
    const double each = static_cast<double>(counts_.castBytes) / static_cast<double>(counts_.casts);
    return held + each * views_->count();
}

double Drawer::prepareMilliseconds() const {
    if (!views_ || counts_.casts == 0) return prepared_;
    return prepared_ +
           counts_.castMilliseconds / static_cast<double>(counts_.casts) * views_->count();
}

}  // namespace voxprite::trade
