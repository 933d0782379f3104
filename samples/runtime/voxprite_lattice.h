/* voxprite_lattice.h: a view of a model as integers, from which a sprite is cast. C99, no
 * dependencies but the maths library.
 *
 * Use    In one C file define VOXPRITE_LATTICE_IMPLEMENTATION before the include. Each frame:
 *
 *            lattice_view view;
 *            lattice_from_axes(&view, right, up, forward, sigma, model.size);
 *            lattice_face_light(view.D, toward_light, 0.55, light8);
 *            lattice_lit_palette(file.palette, light8, lit);
 *
 *        and hand the numbers to sprite.glsl. Once they are integers, every processor and every
 *        GPU makes the same sprite of them, bit for bit. The first line gives the integers that
 *        voxprite itself would cast.
 * Space  That of the octree: voxels, Z up, the model's minimum corner at (0, 0, 0). Axes are
 *        orthonormal: right and up of the picture, forward the way the rays run. Sprites of the
 *        same model, axes and sigma are the same: keep them and cast again only what changed.
 * Rays   Pixel (i, j), i to the right and j up, is the infinite line through
 *        C + ((i * U + j * V) >> 12)   along D, in steps of 2^-position_bits voxels.
 */
#ifndef VOXPRITE_LATTICE_H
#define VOXPRITE_LATTICE_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct lattice_view {
    int32_t position_bits, direction_bits;
    int32_t C[3], D[3], U[3], V[3];
    int32_t first[2], size[2]; /* pixels of the sprite, with one all round for the outline */
} lattice_view;

/* What `voxprite render --json` prints: the view, and the colours' light where it is there. */
typedef struct lattice_shot {
    lattice_view view;
    int has_light;
    uint8_t light8[3];  /* by axis, of the faces that the rays see */
    int outlined;       /* with has_light */
    uint8_t outline[4]; /* R, G, B, 255 */
} lattice_shot;

enum { LATTICE_MAX_PIXELS = 1 << 24 };

/* Quantises a view; sigma, virtual pixels a voxel, is 1/64 ... 64. 0 when the sprite would have
 * more than LATTICE_MAX_PIXELS; the size is (0, 0) for an empty model. */
int lattice_from_axes(lattice_view* view, const double right[3], const double up[3],
                      const double forward[3], double sigma, const uint32_t model_size[3]);

/* Where the sample of a pixel lies in it, from its left and bottom edge, 0 ... 1. Pixel (i, j)
 * covers the sprite plane from (i - 1/2 + offset) / sigma voxels right of the corner floor(size /
 * 2) on. */
double lattice_sample_offset(double sigma);

/* Do all products fit 31 bits? Then sprite.glsl casts with `int`; else define SPRITE_WIDE. */
int lattice_is_narrow(const lattice_view* view, const uint32_t model_size[3]);

/* The lights, 0 ... 255, of the three faces that the rays see: 255 (ambient + (1 - ambient) n . l),
 * rounded. `toward_light` in voxel space, any length. */
void lattice_face_light(const int32_t D[3], const double toward_light[3], double ambient,
                        uint8_t light8[3]);

/* 256 colours for each axis, (channel * light8 + 127) / 255 with alpha 255: 3 * 1024 bytes. */
void lattice_lit_palette(const uint8_t palette[1024], const uint8_t light8[3], uint8_t* lit);

/* Reads the JSON object at *text, which ends with a zero byte, and moves *text behind it. NULL, or
 * why the view cannot be cast. */
const char* lattice_from_json(lattice_shot* shot, const char** text);

#ifdef __cplusplus
}
#endif
#endif /* VOXPRITE_LATTICE_H */

#ifdef VOXPRITE_LATTICE_IMPLEMENTATION
#ifndef VOXPRITE_LATTICE_IMPLEMENTED
#define VOXPRITE_LATTICE_IMPLEMENTED

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of all integer vectors within +-8192 the one at the smallest angle to `forward`. At the scale s
 * the largest component is s and the others are s b and s c, rounded up or down. */
static void lattice__direction(const double forward[3], int32_t D[3]) {
    double size[3], b, c, best_q = 0, best_norm = 0;
    int order[3] = {0, 1, 2}, k, s, corner;
    int32_t best[3] = {1, 0, 0}, divisor, rest;
    for (k = 0; k < 3; ++k) size[k] = fabs(forward[k]);
    for (k = 0; k < 3; ++k) {
        const int low = k == 1 ? 1 : 0, was = order[low];
        if (size[order[low]] < size[order[low + 1]]) {
            order[low] = order[low + 1];
            order[low + 1] = was;
        }
    }
    b = size[order[1]] / size[order[0]];
    c = size[order[2]] / size[order[0]];
    for (s = 1; s <= 8192 && !(best_norm > 0 && best_q == 0); ++s) {
        const double floor_b = floor(s * b), floor_c = floor(s * c);
        for (corner = 0; corner < 4; ++corner) {
            const double db = (corner & 1) - (s * b - floor_b), vb = floor_b + (corner & 1);
            const double dc = (corner >> 1) - (s * c - floor_c), vc = floor_c + (corner >> 1);
            const double skew = db * c - dc * b;
            const double q = db * db + dc * dc + skew * skew;
            const double norm = (double)s * s + vb * vb + vc * vc;
            if (best_norm != 0 && q * best_norm >= best_q * norm) continue;
            best[0] = s;
            best[1] = (int32_t)vb;
            best[2] = (int32_t)vc;
            best_q = q;
            best_norm = norm;
        }
    }
    divisor = best[0];
    for (k = 1; k < 3; ++k) {
        int32_t other = best[k];
        for (; other != 0; other = rest) {
            rest = divisor % other;
            divisor = other;
        }
    }
    for (k = 0; k < 3; ++k) {
        const int32_t component = best[k] / divisor;
        D[order[k]] = forward[order[k]] < 0 ? -component : component;
    }
}

static void lattice__cross(const int32_t a[3], const int32_t b[3], double out[3]) {
    int k;
    for (k = 0; k < 3; ++k) {
        const int n = (k + 1) % 3, m = (k + 2) % 3;
        out[k] = (double)((int64_t)a[n] * b[m] - (int64_t)a[m] * b[n]);
    }
}

/* The pixels along U or V that can meet the model's box: the product with a normal of the other two
 * vectors leaves one pixel coordinate alone. The box is a step larger, for rays start rounded
 * down. */
static void lattice__interval(const lattice_view* view, const uint32_t size[3],
                              const double normal[3], double determinant, double ends[2]) {
    double low = 0, high = 0;
    int k;
    for (k = 0; k < 3; ++k) {
        const double from = -(double)view->C[k];
        const double to = ldexp((double)size[k], view->position_bits) + 1 + from;
        low += fmin(normal[k] * from, normal[k] * to);
        high += fmax(normal[k] * from, normal[k] * to);
    }
    ends[0] = ceil((determinant < 0 ? high : low) * 4096 / determinant) - 1;
    ends[1] = floor((determinant < 0 ? low : high) * 4096 / determinant) + 1;
}

/* As far as voxprite itself refines a view. */
static int lattice__in_range(const lattice_view* view) {
    const int32_t limit = 1 << 28;
    int k;
    for (k = 0; k < 3; ++k) {
        if (abs(view->C[k]) > limit || abs(view->U[k]) > limit || abs(view->V[k]) > limit) return 0;
    }
    return 1;
}

static int lattice__positions(lattice_view* view, const double right[3], const double up[3],
                              double sigma, const uint32_t size[3]) {
    const double steps = ldexp(1.0, view->position_bits), step = ldexp(steps / sigma, 12);
    const double offset = lattice_sample_offset(sigma) / sigma;
    double normal[3], i[2], j[2], determinant = 0;
    int k;
    for (k = 0; k < 3; ++k) {
        const double corner = size[k] / 2;
        view->C[k] = (int32_t)floor((corner + (right[k] + up[k]) * offset) * steps + 0.5 + 0.5);
        view->U[k] = (int32_t)floor(right[k] * step + 0.5);
        view->V[k] = (int32_t)floor(up[k] * step + 0.5);
    }
    lattice__cross(view->V, view->D, normal);
    for (k = 0; k < 3; ++k) determinant += normal[k] * view->U[k];
    lattice__interval(view, size, normal, determinant, i);
    lattice__cross(view->D, view->U, normal);
    lattice__interval(view, size, normal, determinant, j);
    if (!((i[1] - i[0] + 1) * (j[1] - j[0] + 1) <= LATTICE_MAX_PIXELS)) return 0;
    view->first[0] = (int32_t)i[0];
    view->first[1] = (int32_t)j[0];
    view->size[0] = (int32_t)(i[1] - i[0]) + 1;
    view->size[1] = (int32_t)(j[1] - j[0]) + 1;
    return 1;
}

double lattice_sample_offset(double sigma) {
    if (sigma < 1) return sigma / 2;
    return sigma == floor(sigma) ? 1.0 / 2 : 1.0 / 3;
}

int lattice_from_axes(lattice_view* view, const double right[3], const double up[3],
                      const double forward[3], double sigma, const uint32_t model_size[3]) {
    memset(view, 0, sizeof *view);
    view->direction_bits = 13;
    lattice__direction(forward, view->D);
    for (view->position_bits = 8; ldexp(1.0, view->position_bits) < 16 * sigma;) {
        ++view->position_bits;
    }
    if (!lattice__positions(view, right, up, sigma, model_size)) return 0;
    if (model_size[0] == 0) view->size[0] = view->size[1] = view->first[0] = view->first[1] = 0;
    while (view->position_bits < 12) {
        lattice_view finer = *view;
        ++finer.position_bits;
        if (model_size[0] > 0 && !lattice__positions(&finer, right, up, sigma, model_size)) break;
        if (!lattice__in_range(&finer) || !lattice_is_narrow(&finer, model_size)) break;
        *view = finer;
    }
    return 1;
}

int lattice_is_narrow(const lattice_view* view, const uint32_t model_size[3]) {
    const int64_t limit = (int64_t)1 << 31;
    int64_t largest = 0;
    int k, corner;
    for (k = 0; k < 3; ++k) largest = llabs(view->D[k]) > largest ? llabs(view->D[k]) : largest;
    for (k = 0; k < 3; ++k) {
        const int64_t steps = (int64_t)1 << view->position_bits, centre = model_size[k] / 2;
        const int64_t half = ((int64_t)model_size[k] - centre) * steps;
        for (corner = 0; corner < 4; ++corner) {
            const int64_t i = view->first[0] + (corner & 1 ? (int64_t)view->size[0] - 1 : 0);
            const int64_t j = view->first[1] + (corner & 2 ? (int64_t)view->size[1] - 1 : 0);
            const int64_t u = i * view->U[k], v = j * view->V[k], step = 4096;
            const int64_t moved = u + v >= 0 ? (u + v) / step : -((step - 1 - (u + v)) / step);
            const int64_t origin = view->C[k] - centre * steps + moved;
            if (llabs(u) >= limit || llabs(v) >= limit || llabs(u + v) >= limit ||
                (llabs(origin) + half) * largest >= limit) {
                return 0;
            }
        }
    }
    return 1;
}

void lattice_face_light(const int32_t D[3], const double toward_light[3], double ambient,
                        uint8_t light8[3]) {
    double largest = 0, length = 0;
    int k;
    for (k = 0; k < 3; ++k) largest = fmax(largest, fabs(toward_light[k]));
    for (k = 0; k < 3 && largest > 0; ++k) length += pow(toward_light[k] / largest, 2);
    for (k = 0; k < 3; ++k) {
        const double normal = D[k] > 0 ? -1 : D[k] < 0 ? 1 : 0;
        const double lit = largest > 0 ? normal * toward_light[k] / largest / sqrt(length) : 0;
        const double light = ambient + (1 - ambient) * fmax(0, lit);
        light8[k] = (uint8_t)floor(255 * fmin(fmax(light, 0), 1) + 0.5);
    }
}

void lattice_lit_palette(const uint8_t palette[1024], const uint8_t light8[3], uint8_t* lit) {
    int axis, i;
    for (axis = 0; axis < 3; ++axis) {
        for (i = 0; i < 1024; ++i) {
            *lit++ = i % 4 == 3 ? 255 : (uint8_t)((palette[i] * light8[axis] + 127) / 255);
        }
    }
}

/* ---- JSON, as much of it as a view needs. All give NULL where the text is something else. ---- */

static const char* json__space(const char* p) {
    while (p && (*p == ' ' || *p == '\t' || *p == '\n' || *p == '\r')) ++p;
    return p;
}

static const char* json__skip(const char* p, int depth) {
    const char open = p ? *p : 0;
    if (open == '"') {
        for (++p; *p != '"'; ++p) {
            if (*p == '\\') ++p;
            if (*p == 0) return NULL;
        }
        return p + 1;
    }
    if (open == '{' || open == '[') {
        const char close = open == '{' ? '}' : ']';
        if (depth == 0) return NULL;
        p = json__space(p + 1);
        while (p && *p != close) {
            if (open == '{') {
                p = *p == '"' ? json__space(json__skip(p, depth)) : NULL;
                if (!p || *p != ':') return NULL;
                p = json__space(p + 1);
            }
            p = json__space(json__skip(p, depth - 1));
            if (!p || (*p != ',' && *p != close)) return NULL;
            if (*p == ',') p = json__space(p + 1);
        }
        return p ? p + 1 : NULL;
    }
    if (!p || !strchr("-0123456789tfn", open) || open == 0) return NULL;
    while (*p && strchr("+-.0123456789abcdefghijklmnopqrstuvwxyzE", *p)) ++p;
    return p;
}

/* The value of a member of the object at p, which json__skip() has accepted. */
static const char* json__find(const char* p, const char* key) {
    const size_t length = strlen(key);
    if (!p || *p != '{') return NULL;
    for (p = json__space(p + 1); *p == '"';) {
        const char* name = p + 1;
        p = json__space(json__space(json__skip(p, 1)) + 1);
        if (strncmp(name, key, length) == 0 && name[length] == '"') return p;
        p = json__space(json__skip(p, 64));
        if (*p == ',') p = json__space(p + 1);
    }
    return NULL;
}

/* `count` integers within +-limit: a list, or one by itself. */
static int json__integers(const char* p, int count, int32_t limit, int32_t* out) {
    const int list = p && *p == '[';
    int k;
    if (!p || (list ? 0 : count != 1)) return 0;
    for (k = 0; k < count; ++k) {
        char* end;
        long value;
        p = json__space(p + list);
        value = strtol(p, &end, 10);
        if (end == p || value < -limit || value > limit) return 0;
        out[k] = (int32_t)value;
        p = json__space(end);
        if (list && *p != (k + 1 < count ? ',' : ']')) return 0;
    }
    return list || !strchr(".eE", *p) || *p == 0;
}

const char* lattice_from_json(lattice_shot* shot, const char** text) {
    const char *object = json__space(*text), *end = json__skip(object, 64), *l, *bits, *lit;
    lattice_view* view = &shot->view;
    int32_t step = 0, light[3], outline[3];
    int k;
    memset(shot, 0, sizeof *shot);
    if (!end || *object != '{') return "this is not a JSON object";
    *text = json__space(end);
    l = json__find(object, "lattice");
    if (!l) l = object; /* the view by itself */
    bits = json__find(l, "bits");
    if (!json__integers(json__find(bits, "position"), 1, 13, &view->position_bits) ||
        !json__integers(json__find(bits, "direction"), 1, 13, &view->direction_bits) ||
        !json__integers(json__find(bits, "step"), 1, 12, &step) || view->position_bits < 1 ||
        view->direction_bits < 0 || step != 12) {
        return "the lattice's bits are not such";
    }
    if (!json__integers(json__find(l, "C"), 3, 1 << 28, view->C) ||
        !json__integers(json__find(l, "D"), 3, 1 << view->direction_bits, view->D) ||
        !json__integers(json__find(l, "U"), 3, 1 << 28, view->U) ||
        !json__integers(json__find(l, "V"), 3, 1 << 28, view->V)) {
        return "C, D, U or V of the lattice is missing or out of range";
    }
    if (!json__integers(json__find(l, "first"), 2, LATTICE_MAX_PIXELS, view->first) ||
        !json__integers(json__find(l, "size"), 2, LATTICE_MAX_PIXELS, view->size) ||
        view->size[0] < 0 || view->size[1] < 0 ||
        (int64_t)view->size[0] * view->size[1] > LATTICE_MAX_PIXELS) {
        return "the lattice's first pixel or size is missing or out of range";
    }
    for (k = 0; k < 12; ++k) { /* how far rays start from the model */
        const int64_t i = view->first[0] + (k & 1 ? (int64_t)view->size[0] - 1 : 0);
        const int64_t j = view->first[1] + (k & 2 ? (int64_t)view->size[1] - 1 : 0);
        if (llabs(i * view->U[k / 4] + j * view->V[k / 4]) >= (int64_t)1 << 42) {
            return "a ray of the lattice starts too far away";
        }
    }
    lit = json__find(object, "lit");
    if (!lit) return NULL;
    if (!json__integers(json__find(lit, "light8"), 3, 255, light)) return "light8 is no light";
    if (strncmp(json__find(lit, "shading") ? json__find(lit, "shading") : "", "\"multiply\"", 10)) {
        return "only the shading \"multiply\" is known here";
    }
    if (strncmp(json__find(lit, "face_rays") ? json__find(lit, "face_rays") : "", "false", 5)) {
        return "occlusion and shadow are not known here";
    }
    shot->has_light = 1;
    shot->outlined = json__integers(json__find(lit, "outline"), 3, 255, outline);
    for (k = 0; k < 3; ++k) {
        if (light[k] < 0 || (shot->outlined && outline[k] < 0)) return "light8 is no light";
        shot->light8[k] = (uint8_t)light[k];
        shot->outline[k] = (uint8_t)(shot->outlined ? outline[k] : 0);
    }
    shot->outline[3] = 255;
    return NULL;
}

#endif /* VOXPRITE_LATTICE_IMPLEMENTED */
#endif /* VOXPRITE_LATTICE_IMPLEMENTATION */
