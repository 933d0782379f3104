// Which frame of an animation shows when.
#pragma once

#include "core/model/document.h"

namespace voxprite {

// How long a frame of the clip shows.
[[nodiscard]] double frameSeconds(const Clip& clip, int frame);

struct PlayHead {
    int frame = 0;         // of the document
    double seconds = 0.0;  // that it has shown for
    bool ended = false;    // of a clip that does not loop: its last frame has been shown
    bool operator==(const PlayHead&) const = default;
};

// The clip played on by `seconds`. A head outside the clip starts at its first frame.
[[nodiscard]] PlayHead advanced(const Clip& clip, PlayHead head, double seconds);

// All frames of a document as one clip.
[[nodiscard]] Clip wholeAnimation(int frames, double framesPerSecond);

}  // namespace voxprite
