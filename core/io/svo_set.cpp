#include "core/io/svo_set.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/io/svo_file.h"
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

}  // namespace voxprite
