/* sprite_gl.h: what a renderer has to do with OpenGL 3.3 to cast and draw the sprites of a .svo
 * file: sprite.glsl compiled, octrees uploaded, two passes for a sprite, one to show it. */
#ifndef SAMPLES_RUNTIME_SPRITE_GL_H
#define SAMPLES_RUNTIME_SPRITE_GL_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gl_functions.h"
#include "voxprite_lattice.h"
#include "voxprite_svo.h"

#ifndef SPRITE_GLSL
#define SPRITE_GLSL "sprite.glsl" /* in the folder that the program runs in */
#endif

enum { TEXTURE_WIDTH = 2048 };

/* One sprite: finished[0] are its colours (RGBA8UI), finished[1] its ids (R32UI). */
typedef struct sprite_gl {
    GLuint cast[2], outline, blit; /* programs; cast with 31 bits and with 53 */
    GLuint octrees, lit_palette;
    GLuint framebuffer[2], rays[2], finished[2];
    int32_t size[2];
} sprite_gl;

static void fail(const char* what, const char* why) {
    fprintf(stderr, "%s: %s\n", what, why);
    exit(1);
}

/* With a zero byte behind it. */
static char* read_file(const char* path, size_t* length) {
    FILE* in = fopen(path, "rb");
    const long size = in && fseek(in, 0, SEEK_END) == 0 ? ftell(in) : -1;
    char* bytes = size >= 0 ? (char*)malloc((size_t)size + 1) : NULL;
    if (!bytes) fail(path, "cannot be opened");
    rewind(in);
    if (fread(bytes, 1, (size_t)size, in) != (size_t)size) fail(path, "cannot be read");
    fclose(in);
    bytes[size] = 0;
    *length = (size_t)size;
    return bytes;
}

static GLuint make_program(const char* version, const char* defines[2], const char* text[2]) {
    const GLuint program = glCreateProgram();
    char log[4096] = "";
    GLint linked;
    int i;
    for (i = 0; i < 2; ++i) {
        const char* parts[3];
        const GLuint shader = glCreateShader(i == 0 ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
        parts[0] = version;
        parts[1] = defines[i];
        parts[2] = text[i];
        glShaderSource(shader, 3, parts, NULL);
        glCompileShader(shader);
        glGetShaderInfoLog(shader, sizeof log, NULL, log);
        glAttachShader(program, shader);
        glGetShaderiv(shader, GL_COMPILE_STATUS, &linked);
        if (!linked) fail(defines[i], log);
    }
    glLinkProgram(program);
    glGetProgramInfoLog(program, sizeof log, NULL, log);
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (!linked) fail(defines[1], log);
    return program;
}

/* Two parts of sprite.glsl. */
static GLuint sprite_program(const char* version, const char* vertex, const char* fragment) {
    size_t length;
    char* shaders = read_file(SPRITE_GLSL, &length);
    const char *defines[2], *text[2];
    GLuint program;
    defines[0] = vertex;
    defines[1] = fragment;
    text[0] = text[1] = shaders;
    program = make_program(version, defines, text);
    free(shaders);
    return program;
}

static GLint at(GLuint program, const char* name) {
    return glGetUniformLocation(program, name);
}

static GLuint make_texture(GLint format, GLenum layout, GLenum type, int width, int height,
                           const void* texels) {
    GLuint texture;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, layout, type, texels);
    return texture;
}

static void use_texture(GLuint program, const char* name, int unit, GLuint texture) {
    glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    glBindTexture(GL_TEXTURE_2D, texture);
    glUniform1i(at(program, name), unit);
}

/* Programs, and the octrees of all models: nodes, then payloads, as they stand in the file. (On
 * big-endian machines swap the bytes of each word.) */
static void sprite_gl_create(sprite_gl* gl, const svo_file* file) {
    const size_t nodes = (size_t)4 * file->node_count, payloads = (size_t)8 * file->payload_count;
    const size_t row = 4 * TEXTURE_WIDTH, rows = (nodes + payloads + row - 1) / row;
    char* texels = (char*)calloc(rows, row);
    const char* triangle = "#define SPRITE_VERTEX\n";
    GLint most, major;
    memset(gl, 0, sizeof *gl);
    gl->cast[0] = sprite_program("#version 330\n", triangle, "#define SPRITE_CAST\n");
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    if (major >= 4) {
        gl->cast[1] = sprite_program("#version 400\n", triangle,
                                     "#define SPRITE_CAST\n#define SPRITE_WIDE\n");
    }
    gl->outline = sprite_program("#version 330\n", triangle, "#define SPRITE_OUTLINE\n");
    gl->blit = sprite_program("#version 330\n", "#define SPRITE_QUAD\n", "#define SPRITE_BLIT\n");
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    if (!texels || rows > (size_t)most) fail("the octrees", "are too large for a texture");
    memcpy(texels, file->nodes, nodes);
    if (payloads > 0) memcpy(texels + nodes, file->payloads, payloads);
    gl->octrees =
        make_texture(GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, TEXTURE_WIDTH, (int)rows, texels);
    free(texels);
}

static void sprite__resize(sprite_gl* gl, const int32_t size[2]) {
    const GLenum both[2] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    GLint most = 0;
    int i, k;
    if (size[0] == gl->size[0] && size[1] == gl->size[1]) return;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    if (size[0] > most || size[1] > most) fail("the sprite", "is too large for a texture");
    memcpy(gl->size, size, sizeof gl->size);
    for (i = 0; i < 2; ++i) {
        GLuint* target = i == 0 ? gl->rays : gl->finished;
        glDeleteTextures(2, target);
        target[0] =
            make_texture(GL_RGBA8UI, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE, size[0], size[1], NULL);
        target[1] = make_texture(GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, size[0], size[1], NULL);
        if (gl->framebuffer[i] == 0) glGenFramebuffers(1, &gl->framebuffer[i]);
        glBindFramebuffer(GL_FRAMEBUFFER, gl->framebuffer[i]);
        for (k = 0; k < 2; ++k) {
            glFramebufferTexture2D(GL_FRAMEBUFFER, both[k], GL_TEXTURE_2D, target[k], 0);
        }
        glDrawBuffers(2, both);
    }
}

/* One ray a virtual pixel, then the outline (R, G, B, 255; all 0 for none). The model is one
 * of the entity; the view's size is not (0, 0). Afterwards the finished sprite is bound for
 * reading. */
static void sprite_cast(sprite_gl* gl, const svo_file* file, uint32_t entity, const svo_model* m,
                        const lattice_view* v, const uint8_t light8[3], const uint8_t outline[4]) {
    const GLuint p = gl->cast[!lattice_is_narrow(v, m->size)];
    uint8_t lit[3 * 1024];
    int32_t origin[3];
    int k;
    if (p == 0) fail("the view", "is too large for 31 bits, and OpenGL 4.0 is not there");
    lattice_lit_palette(svo_get_entity(file, entity).palette, light8, lit);
    glDeleteTextures(1, &gl->lit_palette);
    gl->lit_palette = make_texture(GL_RGBA8UI, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE, 256, 3, lit);
    sprite__resize(gl, v->size);
    for (k = 0; k < 3; ++k) {
        origin[k] = v->C[k] - (int32_t)(m->size[k] / 2) * (1 << v->position_bits);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, gl->framebuffer[0]);
    glViewport(0, 0, v->size[0], v->size[1]);
    glUseProgram(p);
    use_texture(p, "octree", 0, gl->octrees);
    use_texture(p, "lit_palette", 1, gl->lit_palette);
    glUniform1i(at(p, "octree_width"), TEXTURE_WIDTH);
    glUniform1i(at(p, "node_offset"), (GLint)m->node_offset);
    glUniform1i(at(p, "payload_offset"), (GLint)(file->node_count + 2 * m->payload_offset));
    glUniform1i(at(p, "max_depth"), (GLint)m->max_depth);
    glUniform3i(at(p, "model_size"), (GLint)m->size[0], (GLint)m->size[1], (GLint)m->size[2]);
    glUniform1i(at(p, "position_bits"), v->position_bits);
    glUniform3iv(at(p, "origin"), 1, origin);
    glUniform3iv(at(p, "right"), 1, v->U);
    glUniform3iv(at(p, "up"), 1, v->V);
    glUniform3iv(at(p, "direction"), 1, v->D);
    glUniform2iv(at(p, "first"), 1, v->first);
    glDrawArrays(GL_TRIANGLES, 0, 3);

    glBindFramebuffer(GL_FRAMEBUFFER, gl->framebuffer[1]);
    glUseProgram(gl->outline);
    use_texture(gl->outline, "cast_colours", 0, gl->rays[0]);
    use_texture(gl->outline, "cast_ids", 1, gl->rays[1]);
    glUniform4ui(at(gl->outline, "outline_colour"), outline[0], outline[1], outline[2], outline[3]);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

/* The finished sprite onto the framebuffer that is bound. clip_from_pixel: see sprite.glsl. */
static void sprite_blit(const sprite_gl* gl, const GLfloat clip_from_pixel[16], GLfloat depth) {
    glUseProgram(gl->blit);
    use_texture(gl->blit, "sprite", 0, gl->finished[0]);
    glUniformMatrix4fv(at(gl->blit, "clip_from_pixel"), 1, GL_FALSE, clip_from_pixel);
    glUniform2i(at(gl->blit, "sprite_size"), gl->size[0], gl->size[1]);
    glUniform1f(at(gl->blit, "depth"), depth);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

/* Colours (0) or ids (1) of the finished sprite, 4 bytes a pixel, the top row first. */
static void sprite_read(const sprite_gl* gl, int which, uint8_t* pixels) {
    const size_t row = (size_t)4 * (size_t)gl->size[0];
    int y;
    glBindFramebuffer(GL_FRAMEBUFFER, gl->framebuffer[1]);
    glReadBuffer(which == 0 ? GL_COLOR_ATTACHMENT0 : GL_COLOR_ATTACHMENT1);
    for (y = gl->size[1]; y-- > 0; pixels += row) {
        glReadPixels(0, y, gl->size[0], 1, which == 0 ? GL_RGBA_INTEGER : GL_RED_INTEGER,
                     which == 0 ? GL_UNSIGNED_BYTE : GL_UNSIGNED_INT, pixels);
    }
}

#endif
