// The GPU's clock.
#include "render/gl/timer_query.h"

#include <glad/gl.h>

#include "render/frame.h"
#include "tests/render/gl_test.h"

namespace voxprite {
namespace {

class TimerQueries : public test::GlTest {};

TEST_F(TimerQueries, KnowNothingBeforeTheFirstSpan) {
    gl::TimerQuery timer;
    EXPECT_FALSE(timer.readyMs());
}

TEST_F(TimerQueries, WaitForTheSpanThatEndedLast) {
    gl::TimerQuery timer;
    Frame frame({64, 64});
    timer.begin();
    frame.begin(Rgba8(10));
    timer.end();
    const double ms = timer.waitMs();
    EXPECT_GE(ms, 0.0);
    EXPECT_EQ(timer.readyMs(), ms);
    // More spans than are kept, none of them read.
    for (int n = 0; n < 9; ++n) {
        timer.begin();
        frame.begin(Rgba8(10));
        timer.end();
    }
    glFinish();
    const std::optional<double> ready = timer.readyMs();
    ASSERT_TRUE(ready);
    EXPECT_EQ(timer.waitMs(), *ready);
}

}  // namespace
}  // namespace voxprite
