#include "core/billboard/snapshot_blit.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "core/base/parallel.h"
#include "core/sprite/view_axes.h"

namespace voxprite {

namespace {

// Right, up and forward of the eye ray to the centre, as upright as the camera.
glm::dmat3 axesToward(glm::dvec3 centreFromEye, const Camera& camera) {
    if (camera.orthographic) return {camera.right, camera.up, camera.forward};
    const glm::dvec3 forward = glm::normalize(centreFromEye);
    // The centre lies ahead, so that the ray is not along the camera's right.
    const glm::dvec3 right =
        glm::normalize(camera.right - forward * glm::dot(camera.right, forward));
    return {right, glm::cross(right, forward), forward};
}

// One snapshot, ready to be asked what it shows at a screen position.
class ScreenSnapshot {
  public:
    ScreenSnapshot(const BlitSource& source, double metresPerVoxel, SnapshotDepth depth,
                   const Camera& camera)
        : weight(source.weight),
          buffer_(source.snapshot->buffer),
          depths_(depth == SnapshotDepth::perPixel ? &source.snapshot->depth : nullptr),
          plane_(*source.plane),
          pixelFromScreen_(pixelFromScreen(plane_, camera)),
          forwardInPlane_(camera.forward * glm::dmat3(plane_.right, plane_.up, plane_.forward)),
          metresPerVoxel_(metresPerVoxel) {}

    double weight;

    // The index of the pixel that is shown there, if there is one and it is not empty.
    [[nodiscard]] std::optional<std::size_t> at(glm::dvec2 screenPx) const {
        const glm::dvec3 p = pixelFromScreen_ * glm::dvec3(screenPx, 1.0);
        if (!(p.z > 0.0)) return std::nullopt;
        const double column = std::floor(p.x / p.z) - buffer_.first.x;
        const double row = buffer_.first.y + buffer_.size.y - 1 - std::floor(p.y / p.z);
        // Written so that NaN fails.
        if (!(column >= 0.0 && row >= 0.0 && column < buffer_.size.x && row < buffer_.size.y))
            return std::nullopt;
        const auto index =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(buffer_.size.x) +
            static_cast<std::size_t>(column);
        if (buffer_.ids[index] == kIdEmpty) return std::nullopt;
        return index;
    }
    [[nodiscard]] Rgba8 colour(std::size_t index) const { return buffer_.colours[index]; }
    [[nodiscard]] double depthMetres(std::size_t index) const {
        if (depths_ == nullptr) return plane_.depthMetres;
        const auto width = static_cast<std::size_t>(buffer_.size.x);
        const auto column = static_cast<int>(index % width);
        const auto row = static_cast<int>(index / width);
        const glm::dvec2 pixel(buffer_.first + glm::ivec2(column, buffer_.size.y - 1 - row));
        // The shift of a registration at the anchor moves the picture and not the model.
        const glm::dvec2 fromCentre =
            (pixel + 0.5 - plane_.pixelFromCentre - plane_.registrationShiftPx) *
            plane_.metresPerPx;
        const double behind = behindPlane((*depths_)[index], pixel) * metresPerVoxel_;
        return std::max(
            plane_.depthMetres,
            plane_.planeDepthMetres + glm::dot(forwardInPlane_, glm::dvec3(fromCentre, behind)));
    }

  private:
    // Voxels along the snapshot's forward from the plane through the centre.
    [[nodiscard]] double behindPlane(double depth, glm::dvec2 pixel) const {
        if (!plane_.viewOfSet || plane_.lattice.U != glm::ivec3(0)) return depth;
        // Of kind seed: a distance along the ray of a picture with an opening of 2R at 8R.
        const double edge = buffer_.size.x;
        const double radius = plane_.metresPerPx * edge * 0.5 / metresPerVoxel_;
        const glm::dvec2 across = (pixel + 0.5 - 0.5 * edge) * (2.0 / (edge * kSnapshotDistance));
        return depth / glm::length(glm::dvec3(across, 1.0)) - kSnapshotDistance * radius;
    }

    const SpriteBuffer& buffer_;
    const std::vector<float>* depths_;
    const SpriteView& plane_;
    glm::dmat3 pixelFromScreen_;
    glm::dvec3 forwardInPlane_;
    double metresPerVoxel_;
};

// What all snapshots together show at a screen position.
struct Mixed {
    glm::dvec3 colour{0.0};
    double covered = 0.0;  // weight
    double heaviest = 0.0;
    double depthMetres = 0.0;
};

Mixed mixedAt(std::span<const ScreenSnapshot> snapshots, glm::dvec2 screenPx) {
    Mixed mixed;
    for (const ScreenSnapshot& snapshot : snapshots) {
        const std::optional<std::size_t> index = snapshot.at(screenPx);
        if (!index) continue;
        mixed.colour += glm::dvec3(snapshot.colour(*index)) * snapshot.weight;
        mixed.covered += snapshot.weight;
        if (snapshot.weight <= mixed.heaviest) continue;
        mixed.heaviest = snapshot.weight;
        mixed.depthMetres = snapshot.depthMetres(*index);
    }
    return mixed;
}

}  // namespace

SnapshotCanvas::SnapshotCanvas(glm::ivec2 sizePx, Rgba8 background)
    : colours(sizePx.x, sizePx.y, background), depths(colours.pixels.size(), 0.0f) {}

Result<SeenSnapshots> seeSnapshots(const PlacedEntity& entity, const Camera& camera,
                                   const ViewSet& views, int sizePx, const SnapshotChoice& choice,
                                   ViewHistory* history) {
    if (auto ok = validate(camera); !ok) return Failure(ok.error());
    if (auto ok = validate(entity); !ok) return Failure(ok.error());
    SeenSnapshots seen;
    const glm::ivec3 size = entity.modelSize;
    if (size.x == 0 || size.y == 0 || size.z == 0) {
        seen.unseen = Unseen::emptyModel;
        return seen;
    }
    const double metresPerVoxel = entity.metresPerVoxel();
    const double radius = std::max(1.0, glm::length(glm::dvec3(size)) * 0.5) * metresPerVoxel;
    const glm::dvec3 centre =
        (entity.anchorMetres - camera.eyeMetres) +
        entity.worldFromVoxelAxes * ((glm::dvec3(size) * 0.5 - entity.anchor) * metresPerVoxel);
    const double depth = glm::dot(centre, camera.forward);
    if (!std::isfinite(depth)) return fail("the entity is too far from the camera");
    if (depth <= camera.nearMetres) {
        seen.unseen = Unseen::behindCamera;
        return seen;
    }
    if (radius < camera.metresPerScreenPx(depth)) {
        seen.unseen = Unseen::subPixel;
        return seen;
    }

    SpriteView plane;
    plane.centreFromEyeMetres = centre;
    plane.planeDepthMetres = depth;
    plane.depthMetres =
        choice.depth == SnapshotDepth::centre ? depth : std::max(camera.nearMetres, depth - radius);
    plane.metresPerPx = 2.0 * radius / sizePx;
    plane.screenPxPerPx = plane.metresPerPx / camera.metresPerScreenPx(depth);
    plane.pixelFromCentre = glm::dvec2(0.5 * sizePx);
    plane.lattice.size = glm::ivec2(sizePx);

    const glm::dmat3 trueAxes =
        glm::transpose(entity.worldFromVoxelAxes) * axesToward(centre, camera);
    const glm::dvec3 towardEye = -trueAxes[2];
    std::vector<ViewSet::Weighted> wanted;
    if (choice.blend) {
        wanted = views.blend(towardEye);
    } else {
        const std::optional<int> before = history != nullptr ? history->viewOfSet : std::nullopt;
        wanted = {{*views.nearest(towardEye, before), 1.0}};  // the axes are finite
        if (history != nullptr) history->viewOfSet = wanted.front().view;
    }
    seen.degreesOff = glm::degrees(angleBetween(views.direction(wanted.front().view), towardEye));
    const glm::dmat3 screen(camera.right, camera.up, camera.forward);
    for (const auto& [view, weight] : wanted) {
        const glm::dmat3 axes = views.roll == SnapshotRoll::matched
                                    ? rolledToMatch(screen, trueAxes, views.axes(view), size)
                                    : screen;
        plane.right = axes[0];
        plane.up = axes[1];
        plane.forward = axes[2];
        plane.viewOfSet = view;
        plane.degreesOff = seen.degreesOff;
        seen.shown.push_back({view, weight, plane});
    }
    return seen;
}

void blitSnapshots(std::span<const BlitSource> sources, double metresPerVoxel, SnapshotDepth depth,
                   const Camera& camera, SnapshotCanvas& canvas) {
    std::vector<ScreenSnapshot> snapshots;
    double weight = 0.0;
    for (const BlitSource& source : sources) {
        snapshots.emplace_back(source, metresPerVoxel, depth, camera);
        weight += source.weight;
    }
    Image& colours = canvas.colours;
    parallelFor(colours.height, 0, [&](int firstRow, int lastRow) {
        for (int y = firstRow; y < lastRow; ++y) {
            for (int x = 0; x < colours.width; ++x) {
                const Mixed mixed = mixedAt(snapshots, glm::dvec2(x, y) + 0.5);
                if (!(mixed.covered > 0.0 && 2.0 * mixed.covered >= weight)) continue;
                float& there = canvas.depths[static_cast<std::size_t>(y) *
                                                 static_cast<std::size_t>(colours.width) +
                                             static_cast<std::size_t>(x)];
                const float own = camera.reversedDepth(mixed.depthMetres);
                if (!(own > there)) continue;
                there = own;
                colours.at(x, y) = Rgba8(glm::floor(mixed.colour / mixed.covered + 0.5), 255);
            }
        }
    });
}

}  // namespace voxprite
