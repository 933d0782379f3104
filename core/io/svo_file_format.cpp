#include "core/io/svo_file_format.h"

#include <algorithm>

#include "core/base/hash.h"
#include "core/io/vox_fields.h"
#include "core/svo/validate.h"

namespace voxprite::svo {
namespace {

constexpr std::size_t kMaxSvoFrames = 1 << 16;
static_assert(kMaxSvoFrames <= kMaxFrames, "what a file holds can be opened as a document");
constexpr std::uint64_t kMaxSolids = std::uint64_t{1} << 40;

}  // namespace

std::uint32_t headerCrc(ByteView headerAndTable) {
    Bytes bytes(headerAndTable.begin(), headerAndTable.end());
    std::fill_n(bytes.begin() + kHeaderCrcAt, 4, std::uint8_t{0});
    return crc32(bytes);
}

Status checkText(std::string_view text) {
    if (utf8FromBytes(text) != text) return fail("a text is not UTF-8");
    return {};
}

Status checkModel(const SvoModel& model) {
    if (Status s = checkText(model.name); !s) return s;
    if (Status s = validateCanonical(model.octree); !s) return s;
    const glm::ivec3 min = model.octree.origin;
    for (int axis = 0; axis < 3; ++axis) {
        const auto last = std::int64_t{min[axis]} + std::max(model.octree.size[axis], 1) - 1;
        if (min[axis] < -kMaxCoordinate || last > kMaxCoordinate) {
            return fail("a model lies beyond 2^24 voxels from the origin");
        }
    }
    return {};
}

Status checkClip(const SvoClip& clip, const std::vector<SvoModel>& models) {
    if (Status s = checkText(clip.name); !s) return s;
    const std::string name = "clip \"" + clip.name + "\"";
    if (clip.models.empty()) return fail(name + " has no frames");
    if (clip.durationsMilliseconds.size() != clip.models.size()) {
        return fail(name + " has not one duration a frame");
    }
    for (const std::uint32_t duration : clip.durationsMilliseconds) {
        if (duration < 1 || duration > kMaxFrameMilliseconds) {
            return fail(name + " has a frame of " + std::to_string(duration) +
                        " ms; it must be 1 ... 1000000");
        }
    }
    for (const std::uint32_t model : clip.models) {
        if (model >= models.size()) {
            return fail(name + " shows model " + std::to_string(model) + " of " +
                        std::to_string(models.size()));
        }
        const Octree& first = models[clip.models[0]].octree;
        const Octree& octree = models[model].octree;
        if (octree.size != first.size || octree.origin != first.origin) {
            return fail(name + " shows models of different sizes or origins");
        }
    }
    return {};
}

Status checkSocket(const SvoSocket& socket, const SvoFile& file) {
    if (Status s = checkText(socket.name); !s) return s;
    const std::string name = "socket \"" + socket.name + "\"";
    const std::size_t frames = clipFrames(file);
    if (socket.positions.size() != 1 && (frames == 0 || socket.positions.size() != frames)) {
        return fail(name + " has " + std::to_string(socket.positions.size()) +
                    " positions; it must be 1 or one for each of the clips' " +
                    std::to_string(frames) + " frames");
    }
    Entity entity;  // what holds for the anchor holds for a socket
    for (const glm::dvec3& position : socket.positions) {
        entity.anchorVoxels = position;
        if (!file.models.empty()) {
            *entity.anchorVoxels += glm::dvec3(file.models[0].octree.origin);
        }
        if (!validate(entity)) return fail(name + " lies beyond 1e7 voxels from the origin");
    }
    return {};
}

Status checkValues(const SvoFile& file) {
    if (file.palette[0] != Rgba8(0)) return fail("palette entry 0 is not transparent black");
    if (Status s = checkText(file.name); !s) return s;
    GameProfile profile;
    profile.voxelSizeMetres = file.voxelSizeMetres;
    profile.sigma = file.sigma;
    profile.outline = file.outline;
    if (Status s = validate(profile); !s) return s;
    Entity entity;
    entity.anchorVoxels = file.anchor;
    if (!file.models.empty()) *entity.anchorVoxels += glm::dvec3(file.models[0].octree.origin);
    return validate(entity);
}

Status checkLimits(std::span<const SvoFile> entities) {
    if (entities.empty()) return fail("the file holds no entity");
    if (entities.size() > kMaxEntities) {
        return fail("the file has " + std::to_string(entities.size()) +
                    " entities; 4,096 are the limit");
    }
    std::size_t frames = 0;
    std::uint64_t solids = 0;
    for (const SvoFile& file : entities) {
        if (file.models.empty()) return fail("the file holds no model");
        frames += modelsWithoutClip(file).size() + clipFrames(file);
        for (const SvoModel& model : file.models) {
            solids += solidCount(model.octree.view());
            if (solids > kMaxSolids) return fail("the models hold more than 2^40 solid voxels");
        }
    }
    if (frames > kMaxSvoFrames) {
        return fail("the file has " + std::to_string(frames) + " frames; 65,536 are the limit");
    }
    return {};
}

std::size_t clipFrames(const SvoFile& file) {
    std::size_t frames = 0;
    for (const SvoClip& clip : file.clips) frames += clip.models.size();
    return frames;
}

std::vector<std::uint32_t> modelsWithoutClip(const SvoFile& file) {
    std::vector<bool> shown(file.models.size(), false);
    for (const SvoClip& clip : file.clips) {
        for (const std::uint32_t model : clip.models) shown[model] = true;
    }
    std::vector<std::uint32_t> models;
    for (std::uint32_t i = 0; i < file.models.size(); ++i) {
        if (!shown[i]) models.push_back(i);
    }
    return models;
}

}  // namespace voxprite::svo
