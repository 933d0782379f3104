/* The functions of OpenGL 3.3 that the sample calls, loaded through GLFW. */
#ifndef SAMPLES_RUNTIME_GL_FUNCTIONS_H
#define SAMPLES_RUNTIME_GL_FUNCTIONS_H

#define GLFW_INCLUDE_GLCOREARB
#include <GLFW/glfw3.h>

#define GL_FUNCTIONS(X)                                      \
    X(PFNGLACTIVETEXTUREPROC, glActiveTexture)               \
    X(PFNGLATTACHSHADERPROC, glAttachShader)                 \
    X(PFNGLBINDFRAMEBUFFERPROC, glBindFramebuffer)           \
    X(PFNGLBINDTEXTUREPROC, glBindTexture)                   \
    X(PFNGLBINDVERTEXARRAYPROC, glBindVertexArray)           \
    X(PFNGLCOMPILESHADERPROC, glCompileShader)               \
    X(PFNGLCREATEPROGRAMPROC, glCreateProgram)               \
    X(PFNGLCREATESHADERPROC, glCreateShader)                 \
    X(PFNGLDELETETEXTURESPROC, glDeleteTextures)             \
    X(PFNGLDRAWARRAYSPROC, glDrawArrays)                     \
    X(PFNGLDRAWBUFFERSPROC, glDrawBuffers)                   \
    X(PFNGLFRAMEBUFFERTEXTURE2DPROC, glFramebufferTexture2D) \
    X(PFNGLGENFRAMEBUFFERSPROC, glGenFramebuffers)           \
    X(PFNGLGENTEXTURESPROC, glGenTextures)                   \
    X(PFNGLGENVERTEXARRAYSPROC, glGenVertexArrays)           \
    X(PFNGLGETINTEGERVPROC, glGetIntegerv)                   \
    X(PFNGLGETPROGRAMINFOLOGPROC, glGetProgramInfoLog)       \
    X(PFNGLGETPROGRAMIVPROC, glGetProgramiv)                 \
    X(PFNGLGETSHADERIVPROC, glGetShaderiv)                   \
    X(PFNGLGETSHADERINFOLOGPROC, glGetShaderInfoLog)         \
    X(PFNGLGETUNIFORMLOCATIONPROC, glGetUniformLocation)     \
    X(PFNGLLINKPROGRAMPROC, glLinkProgram)                   \
    X(PFNGLPIXELSTOREIPROC, glPixelStorei)                   \
    X(PFNGLREADBUFFERPROC, glReadBuffer)                     \
    X(PFNGLREADPIXELSPROC, glReadPixels)                     \
    X(PFNGLSHADERSOURCEPROC, glShaderSource)                 \
    X(PFNGLTEXIMAGE2DPROC, glTexImage2D)                     \
    X(PFNGLTEXPARAMETERIPROC, glTexParameteri)               \
    X(PFNGLUNIFORM1FPROC, glUniform1f)                       \
    X(PFNGLUNIFORM1IPROC, glUniform1i)                       \
    X(PFNGLUNIFORM2IPROC, glUniform2i)                       \
    X(PFNGLUNIFORM3IPROC, glUniform3i)                       \
    X(PFNGLUNIFORM2IVPROC, glUniform2iv)                     \
    X(PFNGLUNIFORM3FVPROC, glUniform3fv)                     \
    X(PFNGLUNIFORM3IVPROC, glUniform3iv)                     \
    X(PFNGLUNIFORM4UIPROC, glUniform4ui)                     \
    X(PFNGLUNIFORMMATRIX4FVPROC, glUniformMatrix4fv)         \
    X(PFNGLUSEPROGRAMPROC, glUseProgram)                     \
    X(PFNGLVIEWPORTPROC, glViewport)
#define GL_DECLARE(type, name) static type name;
GL_FUNCTIONS(GL_DECLARE)

static void load_gl(void) {
#define GL_LOAD(type, name) name = (type)glfwGetProcAddress(#name);
    GL_FUNCTIONS(GL_LOAD)
}

#endif
