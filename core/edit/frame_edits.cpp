#include "core/edit/frame_edits.h"

#include <algorithm>
#include <numeric>

#include "core/edit/free_name.h"
#include "core/edit/scene_tree.h"
#include "core/model/entity_voxels.h"

namespace voxprite {
namespace {

using scene::nodeOf;
using scene::sceneAction;

// For each frame to be: the one whose content it takes over.
using Sources = std::vector<int>;

// A key for each frame made into a track; of equal ones in a row the first stays, and the last
// frame's, which says how long the track is.
template <class Key>
std::vector<Key> trackOf(const std::vector<Key>& everyFrame) {
    std::vector<Key> track;
    for (const Key& key : everyFrame) {
        Key held = track.empty() ? key : track.back();
        held.frame = key.frame;
        const bool last = key.frame == static_cast<int>(everyFrame.size()) - 1;
        if (track.empty() || last || held != key) track.push_back(key);
    }
    return track;
}

// `keyAt(frame)` is the key that holds in a frame as it was.
template <class Key, class KeyAt>
std::vector<Key> everyFrame(const Sources& sources, KeyAt keyAt) {
    std::vector<Key> keys;
    for (const int source : sources) {
        Key key = keyAt(source);
        key.frame = static_cast<int>(keys.size());
        keys.push_back(key);
    }
    return keys;
}

template <class Key>
bool isStill(const std::vector<Key>& track) {
    return track.size() == 1 && track[0].frame == 0;
}

std::vector<ModelKey> modelsEveryFrame(const SceneNode& node, const Sources& sources) {
    return everyFrame<ModelKey>(sources, [&](int f) { return ModelKey{0, modelAt(node, f)}; });
}

void resample(SceneNode& node, const Sources& sources) {
    if (!isStill(node.placements)) {
        node.placements = trackOf(everyFrame<PlacementKey>(sources, [&](int f) {
            return PlacementKey{0, placementAt(node, f)};
        }));
        node.glides = false;
        node.loopPlacements = false;
    }
    if (!node.isGroup() && !isStill(node.models)) {
        node.models = trackOf(modelsEveryFrame(node, sources));
        node.loopModels = false;
    }
}

void resample(Socket& socket, const Sources& sources) {
    if (isStill(socket.positions)) return;
    socket.positions = trackOf(everyFrame<SocketKey>(sources, [&](int f) {
        return SocketKey{0, positionAt(socket, f)};
    }));
}

// The action that gives every track the frames that `sources` names; `edit` does the rest.
template <class Edit>
Action framesAction(std::string label, const Document& document, const Sources& sources,
                    Edit edit) {
    Action action = sceneAction(std::move(label), document, [&](SceneEdit& part) {
        for (SceneNode& node : part.after.nodes) resample(node, sources);
        edit(part);
    });
    SocketsEdit sockets{document.sockets, document.sockets};
    for (Socket& socket : sockets.after) resample(socket, sources);
    action.parts.emplace_back(std::move(sockets));
    return action;
}

Sources allFrames(const Document& document) {
    Sources sources(static_cast<std::size_t>(frameCount(document)));
    std::iota(sources.begin(), sources.end(), 0);
    return sources;
}

bool shows(const Clip& clip, int frame) {
    return clip.first <= frame && frame <= clip.last;
}

void insertFrameAfter(Clip& clip, int frame) {
    if (shows(clip, frame) && !clip.durationsMilliseconds.empty()) {
        const auto held = clip.durationsMilliseconds.begin() + (frame - clip.first);
        clip.durationsMilliseconds.insert(held, *held);
    }
    if (frame < clip.first) ++clip.first;
    if (frame <= clip.last) ++clip.last;
}

void eraseFrame(Clip& clip, int frame) {
    if (shows(clip, frame) && !clip.durationsMilliseconds.empty()) {
        clip.durationsMilliseconds.erase(clip.durationsMilliseconds.begin() + (frame - clip.first));
    }
    if (frame < clip.first) --clip.first;
    if (frame <= clip.last) --clip.last;
}

// What was at `from` comes to stand at `to`.
template <class Iterator>
void moveElement(Iterator begin, int from, int to) {
    if (from < to) std::rotate(begin + from, begin + from + 1, begin + to + 1);
    if (to < from) std::rotate(begin + to, begin + from, begin + from + 1);
}

// The lengths of a clip's frames when it begins `frames` later: those before go, but one is left.
// Earlier, the first is repeated.
void moveStart(std::vector<int>& lengths, int frames) {
    const int most = static_cast<int>(lengths.size()) - 1;
    if (frames > 0) {
        lengths.erase(lengths.begin(), lengths.begin() + std::min(frames, most));
    } else {
        lengths.insert(lengths.begin(), static_cast<std::size_t>(-frames), lengths.front());
    }
}

}  // namespace

Result<Action> addFrame(const Document& document, int object, int frame, NewFrame what) {
    Sources sources = allFrames(document);
    if (sources.size() >= kMaxFrames) {
        return fail("there can be no more than " + std::to_string(kMaxFrames) + " frames");
    }
    sources.insert(sources.begin() + frame, frame);
    return framesAction("Add frame", document, sources, [&](SceneEdit& edit) {
        for (Clip& clip : edit.after.clips) insertFrameAfter(clip, frame);
        if (what != NewFrame::held) {
            const SceneNode& before = nodeOf(document.nodes, object);
            std::vector<ModelKey> models = modelsEveryFrame(before, sources);
            models[static_cast<std::size_t>(frame) + 1].model =
                static_cast<int>(document.models.size());
            SceneNode& after = nodeOf(edit.after.nodes, object);
            after.models = trackOf(models);
            after.loopModels = false;
            edit.addedModels.push_back(
                what == NewFrame::empty
                    ? Model{}
                    : document.models[static_cast<std::size_t>(modelAt(before, frame))]);
        }
        scene::keepFrames(edit.after, object, static_cast<int>(sources.size()));
    });
}

Result<Action> deleteFrame(const Document& document, int frame) {
    Sources sources = allFrames(document);
    if (sources.size() == 1) return fail("the only frame cannot be deleted");
    sources.erase(sources.begin() + frame);
    return framesAction("Delete frame", document, sources, [&](SceneEdit& edit) {
        for (Clip& clip : edit.after.clips) eraseFrame(clip, frame);
        std::erase_if(edit.after.clips, [](const Clip& clip) { return clip.last < clip.first; });
    });
}

Action moveFrame(const Document& document, int from, int to) {
    Sources sources = allFrames(document);
    moveElement(sources.begin(), from, to);
    return framesAction("Move frame", document, sources, [&](SceneEdit& edit) {
        for (Clip& clip : edit.after.clips) {
            if (clip.durationsMilliseconds.empty() || !shows(clip, from) || !shows(clip, to)) {
                continue;
            }
            moveElement(clip.durationsMilliseconds.begin(), from - clip.first, to - clip.first);
        }
    });
}

Action addClip(const Document& document, int first, int last) {
    return sceneAction("Add clip", document, [&](SceneEdit& edit) {
        Clip clip;
        clip.name = freeName("Clip", document.clips);
        clip.first = first;
        clip.last = last;
        edit.after.clips.push_back(std::move(clip));
    });
}

Action setClip(const Document& document, int clip, Clip value, std::uint64_t mergeKey) {
    Action action = sceneAction("Edit clip", document, [&](SceneEdit& edit) {
        Clip& before = edit.after.clips[static_cast<std::size_t>(clip)];
        std::vector<int>& lengths = value.durationsMilliseconds;
        if (!lengths.empty()) {
            // Where only the clip begins elsewhere, its frames keep their lengths.
            if (lengths == before.durationsMilliseconds) {
                moveStart(lengths, value.first - before.first);
            }
            lengths.resize(static_cast<std::size_t>(value.last - value.first) + 1, lengths.back());
        }
        before = std::move(value);
    });
    action.mergeKey = mergeKey;
    return action;
}

Action deleteClip(const Document& document, int clip) {
    return sceneAction("Delete clip", document, [&](SceneEdit& edit) {
        edit.after.clips.erase(edit.after.clips.begin() + clip);
    });
}

}  // namespace voxprite
