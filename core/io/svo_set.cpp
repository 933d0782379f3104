#include "core/io/svo_set.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/base/box.h"
#include "core/base/ending.h"
#include "core/base/file.h"
#include "core/io/svo_file_format.h"
#include "core/io/vox_fields.h"

namespace voxprite {
namespace {

// In the errors of a set it must be told which.
template <class T>
Result<T> ofMember(Result<T> result, const SetMember& member) {
    if (!result) result.error().message = "\"" + member.name + "\": " + result.error().message;
    return result;
}

// A still model is called as its entity is.
void rename(SvoFile& entity, const std::string& name) {
    SvoModel& model = entity.models[0];
    if (entity.models.size() == 1 && model.name == entity.name) model.name = name;
    entity.name = name;
}

void makeUnlike(SvoFile& entity, std::set<std::string>& names) {
    std::string name = entity.name;
    for (int number = 2; !names.insert(name).second; ++number) {
        name = entity.name + " " + std::to_string(number);
    }
    rename(entity, name);
}

Result<SvoFile> bakeMember(const SetMember& member) {
    Result<SvoFile> baked = member.model
                                ? bakeModelForExport(member.document, member.profile, *member.model)
                                : bakeForExport(member.document, member.profile);
    if (!baked) return baked;
    if (member.model || baked->name.empty()) {
        rename(*baked, utf8FromBytes(member.name));
    }
    return baked;
}

// By the section table alone; 0 where there is none.
std::size_t entitiesSaid(ByteView bytes) {
    constexpr std::size_t kSectionsAt = 12, kLengthAt = 16;
    ByteReader header(bytes);
    const Result<ByteView> magic = header.take(svo::kMagic.size(), "the magic");
    if (!magic || !std::ranges::equal(*magic, svo::kMagic)) return 0;
    if (bytes.size() < svo::kHeaderBytes) return 0;
    const std::uint32_t sections = *ByteReader(bytes.subspan(kSectionsAt)).u32("");
    const std::string_view tag = svo::kLayouts[svo::ENTY].tag;
    for (std::size_t k = 0; k < sections; ++k) {
        const std::size_t at = svo::kHeaderBytes + k * svo::kSectionEntryBytes;
        if (at + svo::kSectionEntryBytes > bytes.size()) break;
        const ByteView entry = bytes.subspan(at, svo::kSectionEntryBytes);
        if (!std::equal(tag.begin(), tag.end(), entry.begin())) continue;
        const std::uint64_t length = *ByteReader(entry.subspan(kLengthAt)).u64("");
        return length / svo::kLayouts[svo::ENTY].recordBytes;
    }
    return 1;
}

bool isSvoFile(const std::filesystem::path& path) {
    std::error_code unknown;
    return lowerEndingOf(path) == ".svo" && std::filesystem::is_regular_file(path, unknown);
}

}  // namespace

Result<Bytes> exportSvoSet(std::span<const SetMember> members) {
    std::vector<SvoFile> set;
    std::set<std::string> names;
    for (const SetMember& member : members) {
        Result<SvoFile> baked = ofMember(bakeMember(member), member);
        if (!baked) return Failure(baked.error());
        makeUnlike(*baked, names);
        set.push_back(std::move(*baked));
    }
    Result<Bytes> bytes = writeSvoSet(set);
    if (!bytes) return bytes;
    const Result<std::vector<SvoFile>> again = readSvoSet(*bytes);
    if (!again) return Failure(again.error());
    if (*again != set) return fail("the export differs from what was written");
    for (std::size_t i = 0; i < members.size(); ++i) {
        const SetMember& member = members[i];
        const Status same = member.model
                                ? verifyModelExport((*again)[i], member.document, *member.model)
                                : verifyExport((*again)[i], member.document);
        if (!same) return ofMember(Result<Bytes>(Failure(same.error())), member);
    }
    return bytes;
}

std::vector<SetMember> modelsOneByOne(const Document& document, const GameProfile& profile,
                                      const std::string& name) {
    std::vector<SetMember> members;
    for (std::size_t model = 0; model < document.models.size(); ++model) {
        if (document.models[model].voxels.empty()) continue;
        std::string own;
        for (const SceneNode& node : document.nodes) {
            const bool shows = std::ranges::any_of(node.models, [&](const ModelKey& key) {
                return key.model == static_cast<int>(model);
            });
            if (shows && own.empty()) own = node.name;
        }
        if (own.empty()) own = name + " " + std::to_string(members.size() + 1);
        members.push_back({document, profile, static_cast<int>(model), std::move(own)});
    }
    return members;
}

Result<std::vector<SvoFile>> severalEntities(const std::filesystem::path& path) {
    if (!isSvoFile(path)) return {};
    const Result<Bytes> bytes = readFile(path);
    if (!bytes || entitiesSaid(*bytes) < 2) return {};
    Result<std::vector<SvoFile>> set = inFile(readSvoSet(*bytes), path.string());
    if (set && set->size() == 1) set->clear();
    return set;
}

std::size_t entitiesAt(const std::filesystem::path& path) {
    if (!isSvoFile(path)) return 0;
    const Result<Bytes> bytes = readFile(path);
    return bytes ? entitiesSaid(*bytes) : 0;
}

EntityFigures figuresOf(const SvoFile& entity) {
    EntityFigures figures;
    if (!entity.clips.empty()) figures.firstModel = entity.clips[0].models[0];
    figures.voxels = solidCount(entity.models[figures.firstModel].octree.view());
    figures.frames = svo::clipFrames(entity) + svo::modelsWithoutClip(entity).size();
    IBox bounds;
    for (const SvoModel& model : entity.models) {
        bounds = bounds.united({model.octree.origin, model.octree.origin + model.octree.size});
    }
    if (!bounds.empty()) figures.size = bounds.size();
    return figures;
}

}  // namespace voxprite
