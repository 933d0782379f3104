// voxprite render IN -o OUT.png: a sprite as the game shows it, or the voxels themselves.
#include <cstdio>

#include "app/cli/command.h"
#include "app/cli/lattice_json.h"
#include "app/cli/outputs.h"
#include "app/cli/render_shot.h"
#include "core/base/file.h"
#include "core/io/png.h"
#include "core/io/profile_json.h"
#include "core/sprite/sprite_point.h"

namespace voxprite::cli {
namespace {

const char* nameOfUnseen(Unseen reason) {
    switch (reason) {
        case Unseen::emptyModel:
            return "empty_model";
        case Unseen::cameraInside:
            return "camera_inside";
        case Unseen::behindCamera:
            return "behind_camera";
        case Unseen::subPixel:
            return "sub_pixel";
    }
    return "unknown";
}

// Where the sockets show, in the buffer's pixels; nowhere when there is no buffer.
Json socketsJson(const Shot& shot) {
    Json sockets = Json::array();
    for (const ShotSocket& socket : shot.sockets) {
        Json json{{"name", textJson(socket.name)}, {"px", nullptr}, {"visible", false}};
        if (shot.lattice.size.x > 0) {
            const SpritePoint at =
                locateInSprite(shot.lattice, shot.octree.view(), socket.position);
            json["px"] = {at.px.x, at.px.y};
            json["visible"] = at.visible;
        }
        sockets.push_back(std::move(json));
    }
    return sockets;
}

// What a runtime needs beside the lattice to make the same colours of the palette
// (samples/runtime/SVO.md).
Json litJson(const Shot& shot) {
    const Outline& outline = shot.lit.outline;
    Json colour = nullptr;
    if (outline.enabled) colour = {outline.colour.x, outline.colour.y, outline.colour.z};
    return {{"light8", shot.lights.open},
            {"shading", nameOf(shot.profile.shading)},
            {"face_rays", shot.lit.rays.any()},
            {"outline", std::move(colour)}};
}

Json clustersJson(const ChosenClusters& clusters) {
    Json levels = Json::array();
    std::uint64_t chosen = 0, triangles = 0;
    for (const ChosenClusters::Level& level : clusters.levels) {
        chosen += level.clusters;
        triangles += level.triangles;
        levels.push_back(
            {{"level", level.level}, {"clusters", level.clusters}, {"triangles", level.triangles}});
    }
    return {{"clusters", chosen},
            {"triangles", triangles},
            {"levels", std::move(levels)},
            {"all_clusters", clusters.allClusters},
            {"bytes", clusters.bytes}};
}

Json snapshotsJson(const Shot& shot, const ChosenSnapshots& chosen) {
    const SnapshotRequest& request = shot.snapshots;
    Json views = Json::array();
    for (const ViewSet::Weighted& one : chosen.views) {
        const glm::dvec3 direction = request.views.direction(one.view);
        views.push_back({{"view", one.view},
                         {"weight", one.weight},
                         {"direction", {direction.x, direction.y, direction.z}}});
    }
    Json json{{"kind", nameOf(request.kind)},
              {"view_set", request.views.name()},
              {"views", request.views.count()},
              {"shown", std::move(views)}};
    if (chosen.unseen) json["unseen"] = nameOfUnseen(*chosen.unseen);
    if (!chosen.views.empty()) {
        json["view"] = chosen.views.front().view;
        json["degrees_off"] = chosen.degreesOff;
    }
    json["roll"] = nameOf(request.views.roll);
    if (request.kind == SnapshotKind::seed) {
        json["size_px"] = request.sizePx;
        json["depth"] = nameOf(request.depth.value_or(SnapshotDepth::centre));
    }
    json["bytes"] = chosen.bytes;
    return json;
}

Json reportJson(const RenderOptions& options, const Shot& shot, const Drawn& drawn,
                const Times& times) {
    Json json{{"backend", nameOf(options.backend)}, {"mode", nameOf(shot.mode)}};
    if (!drawn.driver.empty()) json["gl"] = drawn.driver;
    if (drawn.buffer) {
        const SpriteBuffer& buffer = *drawn.buffer;
        const bool sprite = !drawn.snapshots || shot.snapshots.kind == SnapshotKind::sprite;
        if (sprite) json["sigma_in_force"] = shot.sigmaInForce;
        if (shot.unseen) json["unseen"] = nameOfUnseen(*shot.unseen);
        json["buffer"] = {{"size", {buffer.size.x, buffer.size.y}},
                          {"sha256", buffer.sha256()},
                          {"ids_sha256", buffer.idsSha256()},
                          {"opaque", buffer.opaqueCount()},
                          {"outline", buffer.outlineCount()}};
        if (sprite) {
            json["lattice"] = latticeJson(shot.lattice);
            json["lit"] = litJson(shot);
        }
        json["sockets"] = socketsJson(shot);
    }
    if (drawn.snapshots) json["snapshots"] = snapshotsJson(shot, *drawn.snapshots);
    if (drawn.clusters) json["clusters"] = clustersJson(*drawn.clusters);
    const glm::ivec2 size = shot.latticeGiven && drawn.buffer ? drawn.buffer->size : options.sizePx;
    json["image"] = {{"size", {size.x, size.y}}};
    Json ms = Json::object();
    for (const auto& [name, milliseconds] : times) ms[name] = milliseconds;
    json["ms"] = std::move(ms);
    json["warnings"] = shot.warnings;
    return json;
}

std::string describe(const RenderOptions& options, const Shot& shot, const Drawn& drawn) {
    std::string text;
    if (options.output) text += *options.output + "\n";
    if (options.buffer) text += *options.buffer + "\n";
    if (drawn.clusters) {
        for (const ChosenClusters::Level& level : drawn.clusters->levels) {
            text += "level " + std::to_string(level.level) + ": " + std::to_string(level.clusters) +
                    " clusters, " + std::to_string(level.triangles) + " triangles\n";
        }
    }
    if (drawn.snapshots && !drawn.snapshots->views.empty()) {
        char line[256];
        std::snprintf(line, sizeof line, "view %d of %s, %.2f degrees off the true one\n",
                      drawn.snapshots->views.front().view, shot.snapshots.views.name().c_str(),
                      drawn.snapshots->degreesOff);
        text += line;
    }
    if (!drawn.buffer) return text;
    if (drawn.snapshots && shot.snapshots.kind == SnapshotKind::seed) return text;
    char line[256];
    std::snprintf(line, sizeof line,
                  "sprite %d x %d, %llu opaque, %llu outline, sigma in force %g%s\n",
                  drawn.buffer->size.x, drawn.buffer->size.y,
                  static_cast<unsigned long long>(drawn.buffer->opaqueCount()),
                  static_cast<unsigned long long>(drawn.buffer->outlineCount()), shot.sigmaInForce,
                  shot.unseen ? ", not seen" : "");
    return text + line;
}

// Both or none, as far as can be told before.
Status writePictures(const RenderOptions& options, const Drawn& drawn) {
    if (options.buffer) {
        if (drawn.buffer->size.x == 0) {
            return failInFile(*options.buffer, "the sprite is not seen, so it has no buffer");
        }
        if (Status may = checkWritable(*options.buffer); !may) return may;
    }
    if (options.output) {
        if (Status s = inFile(writePngFile(*options.output, *drawn.image), *options.output); !s) {
            return s;
        }
    }
    if (!options.buffer) return {};
    return inFile(writePngFile(*options.buffer, drawn.buffer->image()), *options.buffer);
}

void checkFiles(const RenderOptions& options) {
    std::vector<std::string> inputs{options.input};
    for (const auto& input : {options.profile, options.lattice}) {
        if (input) inputs.push_back(*input);
    }
    const auto check = [&](const Output& output) {
        checkEnding(output, {".png"});
        checkReplacesNone(output, inputs);
    };
    if (options.output) check({"--output", *options.output});
    if (options.buffer) check({"--buffer", *options.buffer});
    if (options.output && options.buffer && isSameFile(*options.output, *options.buffer)) {
        throw CLI::ValidationError("--buffer", "has the name of the picture that -o writes");
    }
}

Result<Report> render(const RenderOptions& options) {
    checkFiles(options);
    const RenderMode mode = options.mode.value_or(RenderMode::sprite);
    if (options.buffer && !showsSprite(mode)) {
        throw CLI::ValidationError("--buffer",
                                   std::string("mode ") + nameOf(mode) + " has no sprite buffer");
    }
    if (mode == RenderMode::clusters && options.backend == Backend::cpu) {
        throw CLI::ValidationError("--mode", "clusters are drawn by OpenGL: add --backend gl");
    }
    if (options.clusterBudgetPx < 0.0) {
        throw CLI::ValidationError("--cluster-budget", "is not below 0");
    }
    Times times;
    const Result<Shot> shot = makeShot(options, times);
    if (!shot) return Failure(shot.error());
    const bool wantImage = options.output.has_value();
    const bool billboard = shot->mode == RenderMode::billboard;
    const auto draw = options.backend == Backend::gl ? drawOnGl : drawOnCpu;
    Result<Drawn> drawn = billboard && shot->snapshots.kind == SnapshotKind::seed
                              ? drawSnapshots(*shot, options.backend, wantImage, times)
                              : draw(*shot, shot->mode, wantImage, times);
    if (drawn && billboard && !drawn->snapshots) {
        drawn->snapshots = chosenSprite(*shot, *drawn->buffer);
    }
    if (!drawn) return Failure(inFile(Result<Drawn>(drawn), options.input).error());
    if (Status written = writePictures(options, *drawn); !written) {
        return Failure(written.error());
    }
    return Report{reportJson(options, *shot, *drawn, times),
                  describe(options, *shot, *drawn) + warningLines(shot->warnings)};
}

}  // namespace

void addRender(CLI::App& app, Command& command) {
    CLI::App& sub = *app.add_subcommand("render", "Draw a model as the game's sprite");
    auto options = std::make_shared<RenderOptions>();
    addRenderOptions(sub, *options);
    addJsonFlag(sub, command);
    sub.callback([&command, options] {
        if (!options->output && !options->buffer && !command.json) {
            throw CLI::RequiredError("-o OUT.png, --buffer OUT.png or --json");
        }
        command.run = [options] { return render(*options); };
    });
}

}  // namespace voxprite::cli
