// Edits of the animation as actions: pure functions of a document. A frame belongs to the whole
// document: putting one in, taking one out or moving it does so for every object, socket and clip.
#pragma once

#include <string>

#include "core/edit/history.h"

namespace voxprite {

// What the object shows in a frame that is put in. Everything else holds still.
enum class NewFrame : std::uint8_t {
    copy,  // a copy of its voxels, to be edited on its own
    held,  // the very same model
    empty  // an empty model
};
// Puts a frame in after `frame`. Fails at kMaxFrames.
[[nodiscard]] Result<Action> addFrame(const Document& document, int object, int frame,
                                      NewFrame what);
// Fails for the only frame. A clip that showed nothing else goes.
[[nodiscard]] Result<Action> deleteFrame(const Document& document, int frame);
// Frame `from` becomes frame `to`; those between move up. Clips keep their first and last.
[[nodiscard]] Action moveFrame(const Document& document, int from, int to);

// A clip of the frames first ... last, with a name that no other has.
[[nodiscard]] Action addClip(const Document& document, int first, int last);
// `clip` is an index into Document::clips. Its durations are made as many as its frames; where
// `value` has those of before, each frame keeps its own.
[[nodiscard]] Action setClip(const Document& document, int clip, Clip value,
                             std::uint64_t mergeKey);
[[nodiscard]] Action deleteClip(const Document& document, int clip);

}  // namespace voxprite
