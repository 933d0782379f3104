/* viewer.c: how a game draws an exported sprite, with nothing but GLFW, OpenGL 3.3 and the files
 * beside this one.
 *
 *     cc -std=c99 -O2 viewer.c -o viewer -lglfw -lm
 *     ./viewer knight.svo                         drag to turn, wheel to zoom, + and - for sigma
 *     ./viewer knight.svo --lattice view.json     the hashes of its sprite from each view that
 *                                                 `voxprite render --json` printed into the file
 *
 * Also: --entity N of a file with several (or Tab, for the next), --model N of it instead of the
 * first clip; --yaw and --pitch (degrees), --sigma; --screenshot OUT.ppm. Everything about sprites
 * is in sprite_gl.h; here are a camera and a window.
 */
#include <math.h>

#include "sprite_gl.h"

#include "sha256.h"
#define VOXPRITE_SVO_IMPLEMENTATION
#include "voxprite_svo.h"
#define VOXPRITE_LATTICE_IMPLEMENTATION
#include "voxprite_lattice.h"

static const double radians = 3.14159265358979323846 / 180;
static const uint8_t no_outline[4] = {0, 0, 0, 0};

static sprite_gl gl;
static GLuint backdrop;
static double yaw = 34, pitch = 20, zoom = 1; /* degrees */
static double wanted = 4;                     /* sigma: virtual pixels a voxel */
static double grabbed[2];
static int dragging, paused;
static uint32_t entity, entities; /* which one is shown, of how many */

static const char* backdrop_glsl =
    "uniform vec3 eye, right, up, ahead, foot;\n" /* right and up reach to the window's edge */
    "uniform float radius;\n"
    "uniform ivec2 window;\n"
    "layout(location = 0) out vec4 colour;\n"
    "void main() {\n"
    "    vec2 at = 2.0 * gl_FragCoord.xy / vec2(window) - 1.0;\n"
    "    vec3 ray = normalize(ahead + at.x * right + at.y * up);\n"
    "    vec3 haze = vec3(0.73, 0.78, 0.79);\n"
    "    vec3 sky = mix(haze, vec3(0.42, 0.55, 0.66), smoothstep(0.0, 0.7, ray.z));\n"
    "    float t = (foot.z - eye.z) / ray.z;\n"
    "    float away = length(eye.xy + t * ray.xy - foot.xy) / radius;\n"
    "    float shadow = 0.42 * (1.0 - smoothstep(0.1, 0.75, away));\n"
    "    vec3 ground = vec3(0.49, 0.57, 0.44) * (1.0 - shadow);\n"
    "    ground = mix(ground, haze, 1.0 - exp(-max(0.0, away - 1.0) * 0.12));\n"
    "    colour = vec4(ray.z < 0.0 && t > 0.0 ? ground : sky, 1.0);\n"
    "}\n";

static void set3(const char* name, const double v[3], double by) {
    GLfloat f[3];
    int k;
    for (k = 0; k < 3; ++k) f[k] = (GLfloat)(v[k] * by);
    glUniform3fv(at(backdrop, name), 1, f);
}

/* Voxel space: Z is up, the model's minimum corner lies at (0, 0, 0). The camera looks at the
 * model's centre, so the rays run as it looks; for another sprite they run from the eye to its
 * centre. */
static void draw(const svo_file* file, const svo_model* m, int width, int height) {
    static const double light[3] = {0.35, -0.55, 0.8}; /* the profile's own, turned to Z up */
    const double cy = cos(yaw * radians), sy = sin(yaw * radians);
    const double cp = cos(pitch * radians), sp = sin(pitch * radians);
    const double right[3] = {cy, sy, 0}, up[3] = {-sy * sp, cy * sp, cp};
    const double ahead[3] = {-sy * cp, cy * cp, -sp};
    const double focal = 2.6, aspect = (double)width / height, near_plane = 0.1;
    const svo_authored authored = svo_get_authored(file, entity);
    double centre[3], foot[3], eye[3], radius = 0, distance, x = 0, y = 0, sigma = wanted;
    GLfloat clip[16] = {0};
    lattice_view view;
    uint8_t light8[3];
    int k, c;
    for (k = 0; k < 3; ++k) centre[k] = foot[k] = m->size[k] / 2.0;
    for (k = 0; k < 3; ++k) radius += centre[k] * centre[k];
    radius = sqrt(radius) + 1;
    distance = 2.9 * radius / zoom;
    for (k = 0; k < 3; ++k) eye[k] = centre[k] - ahead[k] * distance;
    foot[2] = 0;
    /* Below a screen pixel a virtual pixel: cast at half the density. */
    while (sigma > 1 && focal * height / 2 / distance < sigma) sigma /= 2;

    /* Cast: only where something has changed, in a game. */
    if (!lattice_from_axes(&view, right, up, ahead, sigma, m->size)) return;
    lattice_face_light(view.D, light, 0.55, light8);
    if (view.size[0] > 0) {
        sprite_cast(&gl, file, entity, m, &view, light8,
                    authored.outlined ? authored.outline : no_outline);
    }

    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, width, height);
    glUseProgram(backdrop);
    set3("eye", eye, 1);
    set3("right", right, aspect / focal);
    set3("up", up, 1 / focal);
    set3("ahead", ahead, 1);
    set3("foot", foot, 1);
    glUniform1f(at(backdrop, "radius"), (GLfloat)radius);
    glUniform2i(at(backdrop, "window"), width, height);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    if (view.size[0] == 0) return;

    /* Show: the sprite stands in the plane through the model's centre, across the rays. Where its
     * left and bottom edge lie, seen from there: */
    for (k = 0; k < 3; ++k) {
        x += (m->size[k] / 2 - centre[k]) * right[k];
        y += (m->size[k] / 2 - centre[k]) * up[k];
    }
    x += (view.first[0] - 0.5 + lattice_sample_offset(sigma)) / sigma;
    y += (view.first[1] - 0.5 + lattice_sample_offset(sigma)) / sigma;
    /* The columns of projection times camera times (right / sigma, up / sigma, 0, corner). */
    for (c = 0; c < 4; ++c) {
        double seen[3] = {0, 0, 0};
        for (k = 0; k < 3; ++k) {
            const double p = c == 0   ? right[k] / sigma
                             : c == 1 ? up[k] / sigma
                             : c == 2 ? 0
                                      : centre[k] + x * right[k] + y * up[k] - eye[k];
            seen[0] += p * right[k];
            seen[1] += p * up[k];
            seen[2] += p * ahead[k];
        }
        clip[4 * c] = (GLfloat)(focal / aspect * seen[0]);
        clip[4 * c + 1] = (GLfloat)(focal * seen[1]);
        clip[4 * c + 3] = (GLfloat)seen[2];
    }
    sprite_blit(&gl, clip, (GLfloat)(1 - 2 * near_plane / distance));
}

/* The sprites of given views, by hash: WIDTHxHEIGHT, SHA-256 of the colours, SHA-256 of the ids. */
static void hash_views(const svo_file* file, const svo_model* m, const char* path) {
    const svo_authored authored = svo_get_authored(file, entity);
    size_t length;
    const char* text = read_file(path, &length);
    while (*text != 0) {
        static const uint8_t full[3] = {255, 255, 255};
        lattice_shot shot;
        const char* refused = lattice_from_json(&shot, &text);
        const int32_t* size = shot.view.size;
        const int outlined = shot.has_light ? shot.outlined : authored.outlined;
        uint8_t* pixels;
        char hex[65];
        int k;
        if (refused) fail(path, refused);
        length = (size_t)4 * (size_t)size[0] * (size_t)size[1];
        pixels = (uint8_t*)malloc(length + 1);
        if (!pixels) fail(path, "needs more memory than there is");
        if (length > 0) {
            sprite_cast(&gl, file, entity, m, &shot.view, shot.has_light ? shot.light8 : full,
                        !outlined        ? no_outline
                        : shot.has_light ? shot.outline
                                         : authored.outline);
        }
        printf("%dx%d", size[0], size[1]);
        for (k = 0; k < 2; ++k) {
            if (length > 0) sprite_read(&gl, k, pixels);
            sha256_hex(pixels, length, hex);
            printf(" %s", hex);
        }
        printf("\n");
        free(pixels);
    }
}

static void save_window(const char* path, int width, int height) {
    const size_t length = (size_t)width * (size_t)height * 3;
    uint8_t* pixels = (uint8_t*)malloc(length);
    FILE* out = fopen(path, "wb");
    int y;
    if (!out || !pixels) fail(path, "cannot be written");
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    fprintf(out, "P6 %d %d 255\n", width, height);
    for (y = height; y-- > 0;) {
        glReadPixels(0, y, width, 1, GL_RGB, GL_UNSIGNED_BYTE, pixels);
        fwrite(pixels, 3, (size_t)width, out);
    }
    if (fclose(out) != 0) fail(path, "cannot be written");
    free(pixels);
}

static void on_button(GLFWwindow* window, int button, int action, int mods) {
    (void)button, (void)mods;
    dragging = action == GLFW_PRESS;
    glfwGetCursorPos(window, &grabbed[0], &grabbed[1]);
}

static void on_move(GLFWwindow* window, double x, double y) {
    if (!dragging) return;
    yaw -= (x - grabbed[0]) * 0.4;
    pitch = fmin(fmax(pitch + (y - grabbed[1]) * 0.4, -90), 90);
    glfwGetCursorPos(window, &grabbed[0], &grabbed[1]);
}

static void on_wheel(GLFWwindow* window, double x, double y) {
    (void)window, (void)x;
    zoom = fmin(fmax(zoom * pow(1.1, y), 0.05), 2.4);
}

static void on_key(GLFWwindow* window, int key, int code, int action, int mods) {
    (void)window, (void)code, (void)mods;
    if (key == GLFW_KEY_TAB && action == GLFW_PRESS) entity = (entity + 1) % entities;
}

static void on_text(GLFWwindow* window, unsigned int letter) {
    (void)window;
    if (letter == '+' || letter == '=') wanted = fmin(wanted * 2, 32);
    if (letter == '-') wanted = fmax(wanted / 2, 0.25);
    if (letter == ' ') paused = !paused;
}

/* What the entity's first clip shows. */
static uint32_t model_at(const svo_file* file, double seconds) {
    const svo_entity shown = svo_get_entity(file, entity);
    double all = 0, now;
    uint32_t k = 0;
    svo_clip clip;
    svo_frame frame;
    if (shown.clip_count == 0) return shown.first_model;
    clip = svo_get_clip(file, shown.first_clip);
    for (; k < clip.frame_count; ++k) {
        all += svo_get_frame(file, clip.first_frame + k).milliseconds;
    }
    now = clip.loops ? fmod(seconds * 1000, all) : fmin(seconds * 1000, all);
    for (k = 0;; ++k) {
        frame = svo_get_frame(file, clip.first_frame + k);
        now -= frame.milliseconds;
        if (now < 0 || k + 1 == clip.frame_count) return frame.model;
    }
}

/* Number `only` of the entity's models, if it has so many. */
static uint32_t shown_model(const svo_file* file, long only, double seconds) {
    const svo_entity shown = svo_get_entity(file, entity);
    if (only < 0 || only >= (long)shown.model_count) return model_at(file, seconds);
    return shown.first_model + (uint32_t)only;
}

int main(int argc, char** argv) {
    const char *path = argc > 1 ? argv[1] : NULL, *views = NULL, *screenshot = NULL;
    const char *defines[2] = {"#define SPRITE_VERTEX\n", "\n"}, *text[2];
    double seconds = 0, before = 0, sigma = 0;
    long only = -1;
    int i, width, height;
    size_t length;
    char *bytes, title[200];
    svo_file file;
    svo_error error;
    svo_model model;
    GLuint nothing;
    GLFWwindow* window;

    if (!path)
        fail("usage",
             "viewer FILE.svo [--entity N] [--model N] [--lattice FILE] [--screenshot OUT.ppm]");
    bytes = read_file(path, &length);
    if (!svo_open(&file, bytes, length, &error)) fail(path, error.reason);
    entities = file.entities;
    for (i = 2; i + 1 < argc; i += 2) {
        const char* value = argv[i + 1];
        if (strcmp(argv[i], "--entity") == 0) entity = (uint32_t)strtoul(value, NULL, 10);
        if (strcmp(argv[i], "--model") == 0) only = atol(value);
        if (strcmp(argv[i], "--lattice") == 0) views = value;
        if (strcmp(argv[i], "--screenshot") == 0) screenshot = value;
        if (strcmp(argv[i], "--yaw") == 0) yaw = atof(value);
        if (strcmp(argv[i], "--pitch") == 0) pitch = atof(value);
        if (strcmp(argv[i], "--sigma") == 0) sigma = fmin(fmax(atof(value), 0.25), 32);
    }
    if (entity >= entities) fail(path, "has no such entity");
    if (only >= (long)svo_get_entity(&file, entity).model_count) fail(path, "has no such model");
    wanted = sigma > 0 ? sigma : svo_get_authored(&file, entity).sigma;

    if (!glfwInit()) fail("GLFW", "does not start; is there a display?");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_VISIBLE, views || screenshot ? GLFW_FALSE : GLFW_TRUE);
    window = glfwCreateWindow(1280, 800, path, NULL, NULL);
    if (!window) fail("GLFW", "makes no window with OpenGL 3.3");
    glfwMakeContextCurrent(window);
    load_gl();
    glGenVertexArrays(1, &nothing);
    glBindVertexArray(nothing);
    sprite_gl_create(&gl, &file);
    if (views) {
        model = svo_get_model(&file, shown_model(&file, only < 0 ? 0 : only, 0));
        hash_views(&file, &model, views);
        return 0;
    }
    text[0] = read_file(SPRITE_GLSL, &length);
    text[1] = backdrop_glsl;
    backdrop = make_program("#version 330\n", defines, text);
    glfwSetMouseButtonCallback(window, on_button);
    glfwSetCursorPosCallback(window, on_move);
    glfwSetScrollCallback(window, on_wheel);
    glfwSetKeyCallback(window, on_key);
    glfwSetCharCallback(window, on_text);
    glfwSwapInterval(1);
    while (!glfwWindowShouldClose(window)) {
        const double now = glfwGetTime();
        if (!paused) seconds += now - before;
        before = now;
        model = svo_get_model(&file, shown_model(&file, only, seconds));
        glfwGetFramebufferSize(window, &width, &height);
        if (width > 0 && height > 0) draw(&file, &model, width, height);
        if (screenshot) {
            save_window(screenshot, width, height);
            break;
        }
        snprintf(title, sizeof title, "%.100s - sigma %g, %d x %d virtual pixels", path, wanted,
                 gl.size[0], gl.size[1]);
        glfwSetWindowTitle(window, title);
        glfwSwapBuffers(window);
        glfwPollEvents();
    }
    glfwTerminate();
    return 0;
}
