#include "render/gl/draw_state.h"

#include <glad/gl.h>

namespace voxprite::gl {

namespace {

void enable(GLenum what, bool on) {
    if (on) {
        glEnable(what);
    } else {
        glDisable(what);
    }
}

// Depth is reversed: nearer is greater.
GLenum depthFunction(DepthTest test) {
    switch (test) {
        case DepthTest::off:
            return GL_ALWAYS;
        case DepthTest::nearer:
            return GL_GREATER;
        case DepthTest::nearerOrEqual:
            return GL_GEQUAL;
        case DepthTest::behind:
            return GL_LESS;
    }
    return GL_ALWAYS;
}

}  // namespace

void apply(const DrawState& state) {
    // Writing depth needs the test switched on, even if it always passes.
    enable(GL_DEPTH_TEST, state.depthTest != DepthTest::off || state.depthWrite);
    glDepthFunc(depthFunction(state.depthTest));
    glDepthMask(state.depthWrite ? GL_TRUE : GL_FALSE);
    enable(GL_BLEND, state.blend);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    enable(GL_CULL_FACE, state.cull != Cull::none);
    glCullFace(state.cull == Cull::frontFaces ? GL_FRONT : GL_BACK);
    glFrontFace(GL_CCW);
    const GLboolean colour = state.colourWrite ? GL_TRUE : GL_FALSE;
    glColorMask(colour, colour, colour, colour);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glDisable(GL_PRIMITIVE_RESTART);
}

}  // namespace voxprite::gl
