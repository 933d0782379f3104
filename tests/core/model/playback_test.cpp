#include "core/model/playback.h"

#include <gtest/gtest.h>

namespace voxprite {
namespace {

Clip uneven() {
    return Clip{"odd", 2, 4, 8.0, true, {100, 50, 350}};
}

// Which frame shows after so many milliseconds, worked out from the start.
int frameAt(const Clip& clip, int milliseconds) {
    int total = 0;
    for (const int duration : clip.durationsMilliseconds) total += duration;
    int rest = milliseconds % total;
    int frame = clip.first;
    for (const int duration : clip.durationsMilliseconds) {
        if (rest < duration) return frame;
        rest -= duration;
        ++frame;
    }
    return -1;
}

TEST(Playback, ShowsTheFrameThatIsDueHoweverItGetsThere) {
    for (const int step : {1, 7, 16, 49, 333, 1250}) {
        PlayHead head{2, 0.0, false};
        for (int now = step; now < 3000; now += step) {
            head = advanced(uneven(), head, step / 1000.0);
            // Half a millisecond on, so that rounding decides nothing.
            const PlayHead shortly = advanced(uneven(), head, 0.0005);
            EXPECT_EQ(shortly.frame, frameAt(uneven(), now)) << step << " " << now;
            EXPECT_FALSE(head.ended);
        }
    }
}

TEST(Playback, ARateHoldsForAllFrames) {
    const Clip clip = wholeAnimation(5, 8.0);
    EXPECT_EQ(clip.first, 0);
    EXPECT_EQ(clip.last, 4);
    EXPECT_EQ(frameSeconds(clip, 3), 0.125);
    EXPECT_EQ(frameSeconds(uneven(), 3), 0.05);
    PlayHead head;
    for (int frame = 1; frame < 12; ++frame) {
        head = advanced(clip, head, 0.125);
        EXPECT_EQ(head.frame, frame % 5);
    }
}

TEST(Playback, EndsAtTheLastFrameOfAClipThatDoesNotLoop) {
    Clip clip = uneven();
    clip.loop = false;
    PlayHead head = advanced(clip, {2, 0.0, false}, 0.499);
    EXPECT_EQ(head.frame, 4);
    EXPECT_FALSE(head.ended);
    head = advanced(clip, head, 0.002);
    EXPECT_EQ(head.frame, 4);
    EXPECT_TRUE(head.ended);
    EXPECT_TRUE(advanced(clip, head, 1e6).ended);
}

TEST(Playback, BeginsWithTheClipFromOutside) {
    for (const int frame : {-1, 0, 1, 5, 100}) {
        EXPECT_EQ(advanced(uneven(), {frame, 7.0, false}, 0.01).frame, 2);
    }
    // Long away: no loop is counted one by one.
    EXPECT_EQ(advanced(uneven(), {2, 0.0, false}, 1e9).ended, false);
}

}  // namespace
}  // namespace voxprite
