#include "app/editor/session/playback.h"

namespace voxprite::editor {

std::optional<int> Playback::clip(const Document& document) const {
    if (!clip_ || *clip_ >= static_cast<int>(document.clips.size())) return std::nullopt;
    return clip_;
}

Clip Playback::played(const Session& session, const ViewSettings& view) const {
    const Document& document = session.document();
    if (const auto chosen = clip(document)) {
        return document.clips[static_cast<std::size_t>(*chosen)];
    }
    return wholeAnimation(session.frames(), view.framesPerSecond);
}

Status Playback::advance(Session& session, ViewSettings& view, double seconds) {
    const bool plays = view.playing && session.frames() > 1;
    const bool starts = plays && !plays_;
    plays_ = plays;
    if (!plays) return {};
    const Clip clip = played(session, view);
    // Another frame was shown by hand: go on from there. From the end, begin again.
    if (starts || head_.frame != session.frame()) head_ = {session.frame(), 0.0, false};
    if (starts && !clip.loop && head_.frame == clip.last) head_.frame = clip.first;
    head_ = advanced(clip, head_, seconds);
    if (head_.ended) view.playing = false;
    return session.setFrame(head_.frame);
}

}  // namespace voxprite::editor
