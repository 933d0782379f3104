#include "render/gl/timer_query.h"

#include <glad/gl.h>

namespace voxprite::gl {

namespace {

double msFromNanoseconds(GLuint64 nanoseconds) {
    return static_cast<double>(nanoseconds) * 1e-6;
}

}  // namespace

TimerQuery::TimerQuery() {
    for (Query& span : spans_) span = createTimeQuery();
}

void TimerQuery::begin() {
    // The span about to be used again is lost if it was not read.
    if (begun_ - read_ >= kSpans) read_ = begun_ - kSpans + 1;
    glBeginQuery(GL_TIME_ELAPSED, spans_[begun_++ % kSpans].id());
}

void TimerQuery::end() {
    glEndQuery(GL_TIME_ELAPSED);
}

std::optional<double> TimerQuery::readyMs() {
    while (read_ < begun_) {
        const GLuint span = spans_[read_ % kSpans].id();
        GLint done = 0;
        glGetQueryObjectiv(span, GL_QUERY_RESULT_AVAILABLE, &done);
        if (done == 0) break;
        GLuint64 nanoseconds = 0;
        glGetQueryObjectui64v(span, GL_QUERY_RESULT, &nanoseconds);
        newestMs_ = msFromNanoseconds(nanoseconds);
        ++read_;
    }
    return newestMs_;
}

double TimerQuery::waitMs() {
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(spans_[(begun_ - 1) % kSpans].id(), GL_QUERY_RESULT, &nanoseconds);
    read_ = begun_;
    newestMs_ = msFromNanoseconds(nanoseconds);
    return *newestMs_;
}

}  // namespace voxprite::gl
