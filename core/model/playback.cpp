#include "core/model/playback.h"

#include <cmath>

namespace voxprite {
namespace {

double clipSeconds(const Clip& clip) {
    double seconds = 0.0;
    for (int frame = clip.first; frame <= clip.last; ++frame) seconds += frameSeconds(clip, frame);
    return seconds;
}

}  // namespace

double frameSeconds(const Clip& clip, int frame) {
    if (clip.durationsMilliseconds.empty()) return 1.0 / clip.framesPerSecond;
    return clip.durationsMilliseconds[static_cast<std::size_t>(frame - clip.first)] / 1000.0;
}

PlayHead advanced(const Clip& clip, PlayHead head, double seconds) {
    if (head.frame < clip.first || head.frame > clip.last) head = {clip.first, 0.0, false};
    head.seconds += seconds;
    // However long it was away, a head goes round at most once.
    if (clip.loop) head.seconds = std::fmod(head.seconds, clipSeconds(clip));
    while (head.seconds >= frameSeconds(clip, head.frame)) {
        if (head.frame == clip.last && !clip.loop) {
            return {clip.last, frameSeconds(clip, clip.last), true};
        }
        head.seconds -= frameSeconds(clip, head.frame);
        head.frame = head.frame == clip.last ? clip.first : head.frame + 1;
    }
    return head;
}

Clip wholeAnimation(int frames, double framesPerSecond) {
    Clip clip;
    clip.last = frames - 1;
    clip.framesPerSecond = framesPerSecond;
    return clip;
}

}  // namespace voxprite
