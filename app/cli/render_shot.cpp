#include "app/cli/render_shot.h"

#include <CLI/Error.hpp>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "app/cli/lattice_json.h"
#include "app/cli/source.h"
#include "app/cli/stopwatch.h"
#include "core/io/profile_json.h"
#include "core/model/entity_voxels.h"
#include "core/sprite/coarse_entity.h"
#include "core/svo/bake.h"
#include "core/svo/coarsen.h"

namespace voxprite::cli {
namespace {

// A value that came from the command line alone is wrong usage when it is out of range.
void requireUsage(const Status& status) {
    if (!status) throw CLI::ValidationError(status.error().message);
}

template <class T>
void overrideBy(const std::optional<T>& given, T& value) {
    if (given) value = *given;
}

Result<GameProfile> profileOf(const RenderOptions& options) {
    GameProfile profile;
    if (options.profile) {
        const Result<GameProfile> read = readProfileFile(*options.profile);
        if (!read) return read;
        profile = *read;
    } else {
        profile.minification = false;  // a headless picture shows the sigma that it was asked for
    }
    overrideBy(options.voxelSizeMetres, profile.voxelSizeMetres);
    overrideBy(options.sigma, profile.sigma);
    overrideBy(options.view, profile.view);
    overrideBy(options.registration, profile.registration);
    overrideBy(options.proxy, profile.proxy);
    overrideBy(options.depth, profile.depth);
    overrideBy(options.shading, profile.shading);
    overrideBy(options.occlusion, profile.light.occlusion);
    overrideBy(options.shadow, profile.light.shadow);
    overrideBy(options.clearancePx, profile.groundClearancePx);
    overrideBy(options.minification, profile.minification);
    overrideBy(options.viewStepDegrees, profile.viewStepDegrees);
    requireUsage(validate(profile));
    return profile;
}

Entity entityOf(Entity entity, const RenderOptions& options, const IBox& bounds) {
    if (options.anchorVoxels) {
        entity.anchorVoxels = glm::dvec3(bounds.min) + *options.anchorVoxels;
    }
    if (options.rotateDegrees) {
        entity.yawDegrees = options.rotateDegrees->x;
        entity.pitchDegrees = options.rotateDegrees->y;
        entity.rollDegrees = options.rotateDegrees->z;
    }
    overrideBy(options.scale, entity.scale);
    overrideBy(options.positionMetres, entity.positionMetres);
    requireUsage(validate(entity));
    return entity;
}

// The sphere around the model and two virtual pixels more: what has to fit.
double radiusToShow(const PlacedEntity& placed, const GameProfile& profile) {
    return placed.radiusMetres() + 2.0 * profile.voxelSizeMetres / profile.sigma;
}

Camera cameraOf(const RenderOptions& options, const PlacedEntity& placed,
                const GameProfile& profile) {
    if (options.distanceMetres && !(*options.distanceMetres > 0.0)) {
        throw CLI::ValidationError("--distance", "must be greater than 0");
    }
    // Before anything is computed from them.
    Camera asked;
    asked.verticalFovDegrees = options.fovDegrees;
    asked.viewportPx = options.sizePx;
    requireUsage(validate(asked));
    const double radius = radiusToShow(placed, profile);
    const double aspect = static_cast<double>(options.sizePx.x) / options.sizePx.y;
    const double halfHeight = std::tan(options.fovDegrees * std::numbers::pi / 360.0);
    // The narrower of the two half angles holds the sphere.
    const double fitting = radius / std::sin(std::atan(halfHeight * std::min(1.0, aspect)));
    const double distance = options.distanceMetres.value_or(fitting);
    Camera camera =
        orbitCamera({options.yawDegrees, options.pitchDegrees, options.rollDegrees},
                    placed.centreMetres(), distance, options.fovDegrees, options.sizePx);
    camera.nearMetres = std::clamp(distance * 1e-3, 1e-9, 0.01);
    camera.orthographic = options.orthographic;
    camera.orthographicHeightMetres =
        options.orthographicHeightMetres.value_or(2.0 * radius / std::min(1.0, aspect));
    requireUsage(validate(camera));
    return camera;
}

std::optional<Ground> groundOf(const RenderOptions& options, const Shot& shot) {
    if (!options.ground) return std::nullopt;
    Ground ground;
    ground.heightMetres = options.groundHeightMetres.value_or(shot.placed.anchorMetres.y -
                                                              groundClearanceMetres(shot.profile));
    return ground;
}

// sigma * scale from the steps: U spans one virtual pixel.
double sigmaOf(const LatticeView& lattice, double scale) {
    const double stepsPerVoxel = std::ldexp(1.0, lattice.positionBits + kStepShift);
    return stepsPerVoxel / glm::length(glm::dvec3(lattice.U)) / scale;
}

Status castGivenLattice(Shot& shot, const std::string& path) {
    const Result<LatticeFile> file = readLatticeFile(path, shot.octree.size);
    if (!file) return Failure(file.error());
    shot.lattice = file->lattice;
    shot.latticeGiven = true;
    shot.sigmaInForce = file->sigmaInForce.value_or(sigmaOf(shot.lattice, shot.placed.scale));
    shot.lights = faceLights(shot.lattice.D, glm::transpose(shot.placed.worldFromVoxelAxes),
                             shot.profile.light);
    shot.lit = litPalette(shot.palette, shot.lights, shot.profile.outline, shot.profile.shading);
    return {};
}

Status viewFromCamera(Shot& shot) {
    const Result<SpriteViewResult> seen =
        shot.mode == RenderMode::billboard
            ? viewSnapshot(shot.placed, shot.camera, shot.profile, shot.snapshots.views)
            : viewSprite(shot.placed, shot.camera, shot.profile);
    if (!seen) return Failure(seen.error());
    shot.view = seen->view;
    shot.unseen = seen->unseen;
    shot.sigmaInForce = shot.view ? shot.view->sigmaInForce : shot.profile.sigma;
    if (shot.view) {
        shot.lattice = shot.view->lattice;
        shot.lights = shot.view->light8;
        shot.lit =
            litPalette(shot.palette, shot.lights, shot.profile.outline, shot.profile.shading);
    }
    return {};
}

void checkLevels(const char* option, int levels) {
    if (levels >= 0 && levels <= kMaxOctreeDepth) return;
    throw CLI::ValidationError(option, "must be 0 ... " + std::to_string(kMaxOctreeDepth));
}

// The coarser octree in the place of the fine one; sockets with it.
Status makeCoarser(Shot& shot, glm::ivec3 origin, int levels) {
    Result<Octree> coarse = coarsen(shot.octree.view(), origin, levels);
    if (!coarse) return Failure(coarse.error());
    const glm::dvec3 before(origin - (coarse->origin << levels));
    for (ShotSocket& socket : shot.sockets) {
        socket.position = (socket.position + before) / static_cast<double>(1 << levels);
    }
    shot.placed = coarseEntity(shot.placed, origin, levels);
    shot.octree = std::move(*coarse);
    return {};
}

}  // namespace

Result<Shot> makeShot(const RenderOptions& options, Times& times) {
    Stopwatch watch;
    Result<LoadedDocument> loaded =
        loadSource(options.input, options.model, options.variant, options.reading);
    if (!loaded) return Failure(loaded.error());
    times.emplace_back("load", watch.lapMilliseconds());

    const Document& document = loaded->document;
    const int frames = frameCount(document);
    if (options.frame < 0 || options.frame >= frames) {
        return failInFile(options.input, "there is no frame " + std::to_string(options.frame) +
                                             "; the file has " + std::to_string(frames) +
                                             ", counted from 0");
    }
    const IBox bounds = entityBounds(document);
    Result<Octree> octree = bake(flatten(document, options.frame), bounds);
    if (!octree) return Failure(inFile(std::move(octree), options.input).error());
    times.emplace_back("bake", watch.lapMilliseconds());

    const Result<GameProfile> profile = profileOf(options);
    if (!profile) return Failure(profile.error());
    Shot shot;
    shot.octree = std::move(*octree);
    shot.palette = document.palette;
    shot.warnings = warningsJson(*loaded);
    for (const Socket& socket : document.sockets) {
        const glm::dvec3 position = positionAt(socket, options.frame) - glm::dvec3(bounds.min);
        shot.sockets.push_back({socket.name, position});
    }
    shot.profile = *profile;
    shot.mode = options.mode.value_or(
        profile->mode == SpriteMode::singlePass ? RenderMode::singlePass : RenderMode::sprite);
    shot.placed = placeEntity(entityOf(document.entity, options, bounds), bounds, *profile);
    if (!options.positionMetres) shot.placed.anchorMetres -= shot.placed.centreMetres();
    checkLevels("--octree-depth", options.octreeDepth);
    checkLevels("--levels", options.levels);
    if (options.levels > 0) {
        if (Status coarser = makeCoarser(shot, bounds.min, options.levels); !coarser) {
            return Failure(inFile(std::move(coarser), options.input).error());
        }
    }
    shot.camera = cameraOf(options, shot.placed, *profile);
    shot.ground = groundOf(options, shot);
    shot.background = options.background;
    shot.clusterBudgetPx = options.clusterBudgetPx;
    shot.tintLevels = options.tintLevels;
    shot.octreeDepth = options.octreeDepth;
    if (shot.mode == RenderMode::voxels && shot.octreeDepth < shot.octree.maxDepth) {
        // What is cut off cannot shade what stays.
        shot.profile.light.occlusion = 0.0;
        shot.profile.light.shadow = 0.0;
    }
    shot.snapshots = options.snapshots;
    if (shot.mode == RenderMode::billboard) {
        if (options.lattice) throw CLI::ValidationError("--lattice", "is not for snapshots");
        if (shot.snapshots.kind == SnapshotKind::seed) return shot;
        if (shot.snapshots.depth) {
            shot.profile.depth = *shot.snapshots.depth == SnapshotDepth::centre
                                     ? DepthRule::centre
                                     : DepthRule::perPixel;
        }
    }
    if (!showsSprite(shot.mode)) {
        if (options.lattice) throw CLI::ValidationError("--lattice", "is for sprites");
        return shot;
    }
    Status status =
        options.lattice ? castGivenLattice(shot, *options.lattice) : viewFromCamera(shot);
    if (!status) return Failure(inFile(std::move(status), options.input).error());
    return shot;
}

}  // namespace voxprite::cli
