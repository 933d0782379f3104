#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

#include "core/io/svo_file_format.h"
#include "core/io/vox_fields.h"
#include "core/model/entity_voxels.h"
#include "core/svo/bake.h"

namespace voxprite {
namespace {

// What a frame shows; equal keys mean equal voxels.
using FrameKey = std::vector<int>;

FrameKey keyOf(const Document& document, int frame) {
    FrameKey key;
    for (const Instance& instance : instancesOf(document, frame)) {
        const Placement& placement = instance.entityFromModel;
        const glm::ivec3 t = placement.translation;
        key.insert(key.end(), {instance.model, placement.rotation.toVoxByte(), t.x, t.y, t.z});
    }
    return key;
}

SvoFile emptyFile(const Document& document, const GameProfile& profile, std::string_view name) {
    SvoFile file;
    file.name = utf8FromBytes(name);
    file.palette = document.palette.colours;
    std::transform(document.palette.names.begin(), document.palette.names.end(),
                   file.colourNames.begin(), [](const std::string& n) { return utf8FromBytes(n); });
    file.voxelSizeMetres = profile.voxelSizeMetres;
    file.sigma = profile.sigma;
    file.outline = profile.outline;
    return file;
}

// Of the clip's frame number `frame`. Those of a rate add up to the clip's length, however they
// round.
std::uint32_t durationOf(const Clip& clip, int frame) {
    if (!clip.durationsMilliseconds.empty()) {
        return static_cast<std::uint32_t>(
            clip.durationsMilliseconds[static_cast<std::size_t>(frame)]);
    }
    const auto milliseconds = [&](int frames) {
        return std::llround(frames * 1000.0 / clip.framesPerSecond);
    };
    return static_cast<std::uint32_t>(std::max(milliseconds(frame + 1) - milliseconds(frame), 1LL));
}

// Sets the clip's durations from those of a file: a rate whose frames round to them if there is
// one, a whole one before others, so that a file made from a file is the same; else one by one.
void setDurations(Clip& clip, const std::vector<std::uint32_t>& durations) {
    // Milliseconds a frame: after k frames k of them have to round to what has passed by then.
    double least = 0.0;
    double most = std::numeric_limits<double>::infinity();
    double passed = 0.0;
    double frames = 0.0;
    for (const std::uint32_t duration : durations) {
        passed += duration;
        frames += 1.0;
        least = std::max(least, (passed - 0.5) / frames);
        most = std::min(most, (passed + 0.5) / frames);
    }
    const double mean = 1000.0 * frames / passed;
    const double whole = std::round(mean);
    if (1000.0 / whole > least && 1000.0 / whole < most) {
        clip.framesPerSecond = whole;
    } else if (least < most) {
        clip.framesPerSecond = 2000.0 / (least + most);
    } else {
        clip.framesPerSecond = mean;
        clip.durationsMilliseconds.assign(durations.begin(), durations.end());
    }
}

SvoClip clipOf(const Clip& clip, const std::vector<std::uint32_t>& modelOfFrame) {
    SvoClip result;
    result.name = utf8FromBytes(clip.name);
    result.loop = clip.loop;
    for (int frame = clip.first; frame <= clip.last; ++frame) {
        result.models.push_back(modelOfFrame[static_cast<std::size_t>(frame)]);
        result.durationsMilliseconds.push_back(durationOf(clip, frame - clip.first));
    }
    return result;
}

// The clips that an export of the document has.
std::vector<Clip> clipsOf(const Document& document) {
    std::vector<Clip> clips = document.clips;
    const int frames = frameCount(document);
    if (clips.empty() && frames > 1) {
        Clip all;
        all.name = "all";
        all.last = frames - 1;
        clips.push_back(all);
    }
    return clips;
}

// The frames of the document that an export of its clips shows, one clip after the other.
std::vector<int> framesOf(const std::vector<Clip>& clips) {
    std::vector<int> frames;
    for (const Clip& clip : clips) {
        for (int frame = clip.first; frame <= clip.last; ++frame) frames.push_back(frame);
    }
    return frames;
}

SvoSocket socketOf(const Socket& socket, const std::vector<int>& frames, glm::dvec3 minimum) {
    SvoSocket result;
    result.name = utf8FromBytes(socket.name);
    for (const int frame : frames) {
        result.positions.push_back(positionAt(socket, frame) - minimum);
    }
    const bool still =
        std::ranges::adjacent_find(result.positions, std::not_equal_to{}) == result.positions.end();
    if (still) result.positions = {positionAt(socket, frames.empty() ? 0 : frames[0]) - minimum};
    return result;
}

// Its frames are those of the file's clips, in their order.
Socket socketFrom(const SvoSocket& exported, glm::dvec3 minimum) {
    Socket socket;
    socket.name = exported.name;
    socket.positions.clear();
    for (int frame = 0; frame < static_cast<int>(exported.positions.size()); ++frame) {
        const glm::dvec3 place = exported.positions[static_cast<std::size_t>(frame)] + minimum;
        if (socket.positions.empty() || socket.positions.back().positionVoxels != place) {
            socket.positions.push_back({frame, place});
        }
    }
    return socket;
}

Failure different(const std::string& what, glm::ivec3 voxel, int expected, int found) {
    return fail("the export differs from the document: " + what + ", voxel (" +
                std::to_string(voxel.x) + ", " + std::to_string(voxel.y) + ", " +
                std::to_string(voxel.z) + ") should be " + std::to_string(expected) + " and is " +
                std::to_string(found));
}

// Every voxel of the grid is in the octree, and the octree has no other.
Status compare(const Octree& octree, const VoxelGrid& voxels, const std::string& what) {
    const OctreeView view = octree.view();
    Status same;
    voxels.forEachSolid([&](glm::ivec3 v, std::uint8_t value) {
        if (!same) return;
        const std::uint8_t found = materialAt(view, v - octree.origin);
        if (found != value) same = different(what, v, value, found);
    });
    if (!same || solidCount(view) == voxels.solidCount()) return same;
    toVoxels(octree).forEachSolid([&](glm::ivec3 v, std::uint8_t value) {
        if (same && voxels.get(v) == 0) same = different(what, v, 0, value);
    });
    return same;
}

// What frames have in common.
Status compareCommon(const SvoFile& file, const Document& document, const glm::dvec3& anchor) {
    if (file.palette != document.palette.colours) return fail("the export has another palette");
    if (file.anchor != anchor) return fail("the export has another anchor");
    return {};
}

Status compareSockets(const SvoFile& file, const Document& document,
                      const std::vector<Clip>& clips) {
    const Failure others = fail("the export has other sockets");
    if (file.sockets.size() != document.sockets.size()) return others;
    const glm::dvec3 minimum(entityBounds(document).min);
    std::vector<int> frames = framesOf(clips);
    if (frames.empty()) frames.push_back(0);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        for (std::size_t k = 0; k < file.sockets.size(); ++k) {
            const SvoSocket& socket = file.sockets[k];
            const glm::dvec3 place = positionAt(document.sockets[k], frames[i]) - minimum;
            if (socket.name != utf8FromBytes(document.sockets[k].name)) return others;
            if (socket.positions[socket.positions.size() == 1 ? 0 : i] != place) return others;
        }
    }
    return {};
}

glm::dvec3 anchorFromMinimum(const Entity& entity, const IBox& bounds) {
    return anchorVoxels(entity, bounds) - glm::dvec3(bounds.min);
}

}  // namespace

Result<SvoFile> bakeForExport(const Document& document, const GameProfile& profile) {
    SvoFile file = emptyFile(document, profile, document.entity.name);
    const IBox bounds = entityBounds(document);
    file.anchor = anchorFromMinimum(document.entity, bounds);

    const int frames = frameCount(document);
    std::map<FrameKey, std::uint32_t> modelOfKey;
    std::vector<std::uint32_t> modelOfFrame;
    for (int frame = 0; frame < frames; ++frame) {
        const auto [known, isNew] = modelOfKey.try_emplace(keyOf(document, frame), 0);
        if (isNew) {
            SvoModel model;
            model.name = frames == 1 ? file.name : "frame " + std::to_string(frame);
            Result<Octree> octree = bake(flatten(document, frame), bounds);
            if (!octree) return tl::unexpected(octree.error());
            model.octree = std::move(*octree);
            const auto equal =
                std::find_if(file.models.begin(), file.models.end(),
                             [&](const SvoModel& m) { return m.octree == model.octree; });
            known->second = static_cast<std::uint32_t>(equal - file.models.begin());
            if (equal == file.models.end()) file.models.push_back(std::move(model));
        }
        modelOfFrame.push_back(known->second);
    }
    const std::vector<Clip> clips = clipsOf(document);
    for (const Clip& clip : clips) file.clips.push_back(clipOf(clip, modelOfFrame));
    for (const Socket& socket : document.sockets) {
        file.sockets.push_back(socketOf(socket, framesOf(clips), glm::dvec3(bounds.min)));
    }
    return file;
}

Result<SvoFile> bakeModelForExport(const Document& document, const GameProfile& profile,
                                   int model) {
    if (model < 0 || static_cast<std::size_t>(model) >= document.models.size()) {
        return fail("there is no model " + std::to_string(model) + "; the file has " +
                    std::to_string(document.models.size()));
    }
    std::string name = "model " + std::to_string(model);
    for (const SceneNode& node : document.nodes) {
        const bool shows = std::any_of(node.models.begin(), node.models.end(),
                                       [&](const ModelKey& key) { return key.model == model; });
        if (shows && !node.name.empty()) name = node.name;
    }
    const VoxelGrid& voxels = document.models[static_cast<std::size_t>(model)].voxels;
    SvoFile file = emptyFile(document, profile, name);
    const IBox bounds = voxels.bounds();
    file.anchor = anchorFromMinimum(Entity{}, bounds);
    Result<Octree> octree = bake(voxels, bounds);
    if (!octree) return tl::unexpected(octree.error());
    file.models.push_back({file.name, std::move(*octree)});
    return file;
}

Status verifyExport(ByteView bytes, const Document& document) {
    const Result<SvoFile> file = readSvo(bytes);
    if (!file) return tl::unexpected(file.error());
    return verifyExport(*file, document);
}

Status verifyExport(const SvoFile& file, const Document& document) {
    const glm::dvec3 anchor = anchorFromMinimum(document.entity, entityBounds(document));
    if (Status s = compareCommon(file, document, anchor); !s) return s;
    const std::vector<Clip> clips = clipsOf(document);
    if (clips.size() != file.clips.size()) return fail("the export has other clips");
    if (Status s = compareSockets(file, document, clips); !s) return s;

    // Frames shown by a clip are compared with what the clip shows there; the others with the
    // models that no clip shows, and one of those must be equal.
    std::vector<std::vector<std::uint32_t>> modelsOfFrame(
        static_cast<std::size_t>(frameCount(document)));
    for (std::size_t c = 0; c < clips.size(); ++c) {
        const SvoClip& exported = file.clips[c];
        const auto length = static_cast<std::size_t>(clips[c].last - clips[c].first) + 1;
        if (exported.models.size() != length) return fail("the export has other clips");
        for (std::size_t i = 0; i < length; ++i) {
            modelsOfFrame[static_cast<std::size_t>(clips[c].first) + i].push_back(
                exported.models[i]);
        }
    }
    std::map<FrameKey, std::vector<std::uint32_t>> compared;
    for (int frame = 0; frame < frameCount(document); ++frame) {
        const std::string what = "frame " + std::to_string(frame);
        const std::vector<std::uint32_t>& shown = modelsOfFrame[static_cast<std::size_t>(frame)];
        std::vector<std::uint32_t>& done = compared[keyOf(document, frame)];
        const bool known = std::all_of(shown.begin(), shown.end(), [&](std::uint32_t model) {
            return std::find(done.begin(), done.end(), model) != done.end();
        });
        if (known && !done.empty()) continue;
        const VoxelGrid voxels = flatten(document, frame);
        for (const std::uint32_t model : shown) {
            if (Status s = compare(file.models[model].octree, voxels, what); !s) return s;
            done.push_back(model);
        }
        if (!shown.empty()) continue;
        Status last = fail("the export lacks " + what);
        for (std::uint32_t model = 0; model < file.models.size() && !last; ++model) {
            last = compare(file.models[model].octree, voxels, what);
            if (last) done.push_back(model);
        }
        if (!last) return last;
    }
    return {};
}

Status verifyModelExport(ByteView bytes, const Document& document, int model) {
    const Result<SvoFile> file = readSvo(bytes);
    if (!file) return tl::unexpected(file.error());
    return verifyModelExport(*file, document, model);
}

Status verifyModelExport(const SvoFile& file, const Document& document, int model) {
    if (file.models.size() != 1 || !file.clips.empty()) return fail("the export has other models");
    const VoxelGrid& voxels = document.models[static_cast<std::size_t>(model)].voxels;
    const glm::dvec3 anchor = anchorFromMinimum(Entity{}, voxels.bounds());
    if (Status s = compareCommon(file, document, anchor); !s) return s;
    return compare(file.models[0].octree, voxels, "model " + std::to_string(model));
}

Document documentFromSvo(const SvoFile& file) {
    Document document;
    document.palette.colours = file.palette;
    document.palette.names = file.colourNames;
    document.authored = {file.voxelSizeMetres, file.sigma};
    document.entity.name = file.name;

    // Voxels start at the origin of their model space, where the octree's cubes are the grid's
    // blocks; the placement takes them to where they belong.
    IBox bounds;
    for (const SvoModel& model : file.models) {
        Octree octree = model.octree;
        octree.origin = glm::ivec3(0);
        document.models.push_back({toVoxels(octree), {glm::ivec3(0), octree.size}});
        const IBox solid = document.models.back().voxels.bounds();
        if (solid.empty()) continue;
        bounds = bounds.united({solid.min + model.octree.origin, solid.max + model.octree.origin});
    }

    SceneNode object;
    object.name = file.name;
    object.parent = 0;
    object.placements.clear();
    int frame = 0;
    const auto show = [&](std::uint32_t model) {
        Placement placement;
        placement.translation = file.models[model].octree.origin;
        if (object.placements.empty() || object.placements.back().placement != placement) {
            object.placements.push_back({frame, placement});
        }
        object.models.push_back({frame, static_cast<int>(model)});
        ++frame;
    };
    for (const SvoClip& exported : file.clips) {
        Clip clip;
        clip.name = exported.name;
        clip.loop = exported.loop;
        clip.first = frame;
        setDurations(clip, exported.durationsMilliseconds);
        for (const std::uint32_t model : exported.models) show(model);
        clip.last = frame - 1;
        document.clips.push_back(clip);
    }
    for (const std::uint32_t model : svo::modelsWithoutClip(file)) show(model);

    document.nodes[0].children.push_back(1);
    document.nodes.push_back(std::move(object));
    const glm::dvec3 minimum(file.models.empty() ? glm::ivec3(0) : file.models[0].octree.origin);
    for (const SvoSocket& exported : file.sockets) {
        document.sockets.push_back(socketFrom(exported, minimum));
    }
    if (!file.models.empty()) {
        const glm::dvec3 anchor = file.anchor + minimum;
        if (anchor != anchorVoxels(Entity{}, bounds)) document.entity.anchorVoxels = anchor;
    }
    return document;
}

}  // namespace voxprite
