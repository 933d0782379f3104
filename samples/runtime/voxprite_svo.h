/* voxprite_svo.h: reads .svo, the octrees that voxprite exports. C99, no dependencies, no memory of
 * its own. SVO.md beside this file specifies the format; this header is the reader's manual.
 *
 * Use    In one C file, and only there, define VOXPRITE_SVO_IMPLEMENTATION before the include:
 *
 *            #define VOXPRITE_SVO_IMPLEMENTATION
 *            #include "voxprite_svo.h"
 *
 *        Then read or map the whole file and open it:
 *
 *            svo_file file;
 *            svo_error error;
 *            if (!svo_open(&file, bytes, length, &error))
 *                printf("byte %llu: %s\n", (unsigned long long)error.offset, error.reason);
 *
 * Safety svo_open() checks everything: version, checksums, every index, every text, every octree.
 *        It never reads outside the bytes. What it accepts is safe to traverse, on the processor
 *        and in a shader; what it refuses leaves `file` without use. O(length), at most 24 KiB of
 *        stack.
 * Owner  The bytes are yours. They must stay, unchanged, as long as the file is used: nothing is
 *        copied, and all pointers point into them. Nothing has to be closed.
 * Space  Voxel (0, 0, 0) is a model's minimum corner, Z is up. The octree's words are those of
 *        SVO.md; `svo_file.nodes` and `.payloads` are ready to be uploaded as they stand (32-bit
 *        little-endian words, two a payload, the low one first).
 * Limits Indices given to the functions below must be in range: they are not checked again, but for
 *        voxel coordinates. Any byte order; `double` must be IEEE 754.
 */
#ifndef VOXPRITE_SVO_H
#define VOXPRITE_SVO_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { SVO_SECTIONS = 12 };

/* UTF-8 without a terminating zero; `bytes` is of no use when `length` is 0. */
typedef struct svo_text {
    const char* bytes;
    uint32_t length;
} svo_text;

/* Why a file was refused, and at which byte. */
typedef struct svo_error {
    const char* reason;
    uint64_t offset;
} svo_error;

typedef struct svo_part {
    const uint8_t* bytes;
    uint64_t length;
} svo_part;

typedef struct svo_file {
    const uint8_t* bytes;
    uint64_t length;
    uint32_t entities; /* at least 1; of a set of several each has models, clips ... of its own */
    uint32_t models;   /* at least 1 */
    uint32_t clips;
    uint32_t frames; /* of all clips, one clip after the other */
    uint32_t sockets;
    const uint8_t* nodes; /* 4 bytes each, of all models */
    uint32_t node_count;
    const uint8_t* payloads; /* 8 bytes each */
    uint32_t payload_count;
    const uint8_t* palette; /* 256 x R, G, B, A; entry 0 is empty. One an entity, in their order */
    svo_part parts[SVO_SECTIONS];
} svo_file;

/* What of the file belongs to one entity; indices are those of the file. */
typedef struct svo_entity {
    uint32_t first_model, model_count; /* at least 1 */
    uint32_t first_clip, clip_count;
    uint32_t first_socket, socket_count;
    const uint8_t* palette; /* 256 x R, G, B, A */
} svo_entity;

typedef struct svo_model {
    svo_text name;
    uint32_t node_offset; /* of the model's first node in svo_file.nodes, in nodes */
    uint32_t payload_offset;
    uint32_t node_count;
    uint32_t payload_count;
    uint32_t max_depth; /* the root is a cube of edge 1 << max_depth, 1 ... 16 */
    uint32_t size[3];   /* voxels; all 0 for an empty model */
    int32_t origin[3];  /* where voxel (0, 0, 0) lies in the entity's own coordinates */
} svo_model;

typedef struct svo_clip {
    svo_text name;
    uint32_t first_frame; /* among all frames */
    uint32_t frame_count; /* at least 1 */
    int loops;
} svo_clip;

typedef struct svo_frame {
    uint32_t model;
    uint32_t milliseconds;
} svo_frame;

/* A named point where the game fastens things. */
typedef struct svo_socket {
    svo_text name;
    uint32_t first_position;
    uint32_t position_count; /* 1: holds always; else one for each frame of the entity's clips */
} svo_socket;

/* What an entity was authored with; the game's own profile wins. */
typedef struct svo_authored {
    svo_text name;
    double voxel_size_metres;
    double sigma;     /* virtual pixels a voxel */
    double anchor[3]; /* voxels from the models' minimum corner */
    int outlined;
    uint8_t outline[4]; /* R, G, B, A */
} svo_authored;

/* 1 when the bytes are a valid .svo; else 0 and the reason in `error` (which may be NULL). */
int svo_open(svo_file* file, const void* bytes, size_t length, svo_error* error);

svo_entity svo_get_entity(const svo_file* file, uint32_t entity);
svo_model svo_get_model(const svo_file* file, uint32_t model);
svo_clip svo_get_clip(const svo_file* file, uint32_t clip);
svo_frame svo_get_frame(const svo_file* file, uint32_t frame);
svo_socket svo_get_socket(const svo_file* file, uint32_t socket);
/* x, y, z in voxels from the models' minimum corner; `position` from the socket's first on. */
void svo_get_position(const svo_file* file, uint32_t position, double xyz[3]);
svo_authored svo_get_authored(const svo_file* file, uint32_t entity);
svo_text svo_get_colour_name(const svo_file* file, uint32_t entity, uint32_t material);

/* The material of a voxel, 0 where it is empty or outside. O(max_depth). */
uint8_t svo_voxel(const svo_file* file, const svo_model* model, uint32_t x, uint32_t y, uint32_t z);

#ifdef __cplusplus
}
#endif
#endif /* VOXPRITE_SVO_H */

#ifdef VOXPRITE_SVO_IMPLEMENTATION
#ifndef VOXPRITE_SVO_IMPLEMENTED
#define VOXPRITE_SVO_IMPLEMENTED

#include <string.h>

enum {
    SVO__MODL,
    SVO__NODE,
    SVO__PAYL,
    SVO__PALT,
    SVO__CNAM,
    SVO__CLIP,
    SVO__FRAM,
    SVO__AUTH,
    SVO__STRS,
    SVO__SOCK, /* from here on a file may lack them */
    SVO__SPOS,
    SVO__ENTY
};

/* Tag, bytes a record, and how many records an entity where that is fixed. */
static const struct {
    char tag[5];
    uint32_t record, count;
} svo__layouts[SVO_SECTIONS] = {{"MODL", 64, 0},  {"NODE", 4, 0},   {"PAYL", 8, 0},
                                {"PALT", 4, 256}, {"CNAM", 8, 256}, {"CLIP", 32, 0},
                                {"FRAM", 8, 0},   {"AUTH", 64, 1},  {"STRS", 1, 0},
                                {"SOCK", 16, 0},  {"SPOS", 24, 0},  {"ENTY", 32, 0}};

static uint32_t svo__u32(const uint8_t* p) {
    return (uint32_t)p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16 | (uint32_t)p[3] << 24;
}

static uint64_t svo__u64(const uint8_t* p) {
    return svo__u32(p) | (uint64_t)svo__u32(p + 4) << 32;
}

static int32_t svo__i32(const uint8_t* p) {
    const uint32_t u = svo__u32(p);
    return u >> 31 ? -(int32_t)(~u) - 1 : (int32_t)u;
}

static double svo__f64(const uint8_t* p) {
    const uint64_t bits = svo__u64(p);
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static const uint8_t* svo__record(const svo_file* file, int section, uint32_t index) {
    return file->parts[section].bytes + (uint64_t)svo__layouts[section].record * index;
}

static uint64_t svo__records(const svo_file* file, int section) {
    return file->parts[section].length / svo__layouts[section].record;
}

static svo_text svo__text(const svo_file* file, const uint8_t* record) {
    svo_text text = {(const char*)file->parts[SVO__STRS].bytes, svo__u32(record + 4)};
    if (text.length > 0) text.bytes += svo__u32(record);
    return text;
}

svo_entity svo_get_entity(const svo_file* file, uint32_t index) {
    svo_entity entity = {0, 0, 0, 0, 0, 0, NULL};
    entity.palette = file->palette + (uint64_t)1024 * index;
    entity.model_count = file->models;
    entity.clip_count = file->clips;
    entity.socket_count = file->sockets;
    if (file->parts[SVO__ENTY].bytes) {
        const uint8_t* r = svo__record(file, SVO__ENTY, index);
        entity.first_model = svo__u32(r);
        entity.model_count = svo__u32(r + 4);
        entity.first_clip = svo__u32(r + 8);
        entity.clip_count = svo__u32(r + 12);
        entity.first_socket = svo__u32(r + 16);
        entity.socket_count = svo__u32(r + 20);
    }
    return entity;
}

svo_model svo_get_model(const svo_file* file, uint32_t index) {
    const uint8_t* r = svo__record(file, SVO__MODL, index);
    svo_model model;
    int axis;
    model.node_offset = svo__u32(r);
    model.payload_offset = svo__u32(r + 4);
    model.max_depth = svo__u32(r + 8);
    for (axis = 0; axis < 3; ++axis) model.size[axis] = svo__u32(r + 12 + 4 * axis);
    model.node_count = svo__u32(r + 24);
    model.payload_count = svo__u32(r + 28);
    for (axis = 0; axis < 3; ++axis) model.origin[axis] = svo__i32(r + 32 + 4 * axis);
    model.name = svo__text(file, r + 44);
    return model;
}

svo_clip svo_get_clip(const svo_file* file, uint32_t index) {
    const uint8_t* r = svo__record(file, SVO__CLIP, index);
    svo_clip clip;
    clip.name = svo__text(file, r);
    clip.first_frame = svo__u32(r + 8);
    clip.frame_count = svo__u32(r + 12);
    clip.loops = (int)(svo__u32(r + 16) & 1);
    return clip;
}

svo_frame svo_get_frame(const svo_file* file, uint32_t index) {
    const uint8_t* r = svo__record(file, SVO__FRAM, index);
    svo_frame frame;
    frame.model = svo__u32(r);
    frame.milliseconds = svo__u32(r + 4);
    return frame;
}

svo_socket svo_get_socket(const svo_file* file, uint32_t index) {
    const uint8_t* r = svo__record(file, SVO__SOCK, index);
    svo_socket socket;
    socket.name = svo__text(file, r);
    socket.first_position = svo__u32(r + 8);
    socket.position_count = svo__u32(r + 12);
    return socket;
}

void svo_get_position(const svo_file* file, uint32_t position, double xyz[3]) {
    const uint8_t* r = svo__record(file, SVO__SPOS, position);
    int axis;
    for (axis = 0; axis < 3; ++axis) xyz[axis] = svo__f64(r + 8 * axis);
}

svo_authored svo_get_authored(const svo_file* file, uint32_t entity) {
    const uint8_t* r = svo__record(file, SVO__AUTH, entity);
    svo_authored authored;
    int axis;
    authored.voxel_size_metres = svo__f64(r);
    authored.sigma = svo__f64(r + 8);
    for (axis = 0; axis < 3; ++axis) authored.anchor[axis] = svo__f64(r + 16 + 8 * axis);
    authored.outlined = (int)(svo__u32(r + 40) & 1);
    memcpy(authored.outline, r + 44, 4);
    authored.name = svo__text(file, r + 48);
    return authored;
}

svo_text svo_get_colour_name(const svo_file* file, uint32_t entity, uint32_t material) {
    return svo__text(file, svo__record(file, SVO__CNAM, 256 * entity + material));
}

static uint32_t svo__bits(uint32_t mask) {
    uint32_t count = 0;
    for (; mask != 0; mask &= mask - 1) ++count;
    return count;
}

uint8_t svo_voxel(const svo_file* file, const svo_model* model, uint32_t x, uint32_t y,
                  uint32_t z) {
    const uint8_t* nodes = file->nodes + (uint64_t)4 * model->node_offset;
    const uint8_t* payloads = file->payloads + (uint64_t)8 * model->payload_offset;
    uint32_t word, bit;
    if (x >= model->size[0] || y >= model->size[1] || z >= model->size[2]) return 0;
    word = svo__u32(nodes);
    for (bit = model->max_depth - 1;; --bit) {
        const uint32_t octant = (z >> bit & 1) << 2 | (y >> bit & 1) << 1 | (x >> bit & 1);
        if (!(word >> 31)) {
            return word >> 30 ? payloads[(uint64_t)8 * (word & 0x3FFFFFFF) + octant]
                              : (uint8_t)word;
        }
        if (!(word >> octant & 1)) return 0;
        word = svo__u32(nodes + (uint64_t)4 * ((word >> 8 & 0x7FFFFF) +
                                               svo__bits(word & ((1u << octant) - 1))));
    }
}

/* ---- Opening: from here on everything is a check. ---- */

typedef struct svo__check {
    svo_file* file;
    svo_error error;
    uint64_t text_bytes; /* of all texts so far: they share none */
    uint64_t solids;     /* voxels of all models so far */
} svo__check;

static int svo__refuse(svo__check* c, uint64_t offset, const char* reason) {
    c->error.offset = offset;
    c->error.reason = reason;
    return 0;
}

static uint64_t svo__offset(const svo__check* c, const uint8_t* p) {
    return (uint64_t)(p - c->file->bytes);
}

/* Of PNG and ZIP, four bits at a time. Start with 0xFFFFFFFF, end with the complement. */
static uint32_t svo__crc(uint32_t crc, const uint8_t* p, uint64_t length) {
    static const uint32_t table[16] = {0x00000000, 0x1DB71064, 0x3B6E20C8, 0x26D930AC,
                                       0x76DC4190, 0x6B6B51F4, 0x4DB26158, 0x5005713C,
                                       0xEDB88320, 0xF00F9344, 0xD6D6A3E8, 0xCB61B38C,
                                       0x9B64C2B0, 0x86D3D2D4, 0xA00AE278, 0xBDBDF21C};
    for (; length > 0; --length) {
        crc ^= *p++;
        crc = crc >> 4 ^ table[crc & 15];
        crc = crc >> 4 ^ table[crc & 15];
    }
    return crc;
}

static int svo__open_table(svo__check* c) {
    static const uint8_t magic[8] = {0x89, 'S', 'V', 'O', '\r', '\n', 0x1A, '\n'};
    static const uint8_t zero[4] = {0, 0, 0, 0};
    svo_file* file = c->file;
    const uint8_t* b = file->bytes;
    uint64_t end;
    uint32_t i, crc, count;
    if (file->length < 8 || memcmp(b, magic, 8) != 0) {
        return svo__refuse(c, 0, "this is not a .svo file");
    }
    if (file->length < 64) return svo__refuse(c, file->length, "the header is cut off");
    if ((svo__u32(b + 8) & 0xFFFF) != 1) return svo__refuse(c, 8, "the version is not known");
    if (svo__u64(b + 16) != file->length) {
        return svo__refuse(c, 16, "the file does not have the length that it should have");
    }
    count = svo__u32(b + 12);
    if (count > (file->length - 64) / 32) {
        return svo__refuse(c, 12, "the section table is longer than the file");
    }
    end = 64 + (uint64_t)32 * count;
    crc = svo__crc(0xFFFFFFFFu, b, 60);
    crc = svo__crc(crc, zero, 4);
    if (~svo__crc(crc, b + 64, end - 64) != svo__u32(b + 60)) {
        return svo__refuse(c, 60, "the header or section table is damaged");
    }
    for (i = 0; i < count; ++i) {
        const uint8_t* entry = b + 64 + (uint64_t)32 * i;
        const uint64_t offset = svo__u64(entry + 8);
        const uint64_t length = svo__u64(entry + 16);
        int known = 0;
        if (offset % 64 != 0 || offset < end || offset > file->length ||
            length > file->length - offset) {
            return svo__refuse(c, svo__offset(c, entry), "a section does not lie within the file");
        }
        end = offset + length;
        if (~svo__crc(0xFFFFFFFFu, b + offset, length) != svo__u32(entry + 24)) {
            return svo__refuse(c, offset, "a section is damaged");
        }
        while (known < SVO_SECTIONS && memcmp(entry, svo__layouts[known].tag, 4) != 0) ++known;
        if (known < SVO_SECTIONS) {
            if (file->parts[known].bytes) {
                return svo__refuse(c, svo__offset(c, entry), "a section occurs twice");
            }
            file->parts[known].bytes = b + offset;
            file->parts[known].length = length;
        } else if (svo__u32(entry + 4) & 1) {
            return svo__refuse(c, svo__offset(c, entry), "a section is not known, but must be");
        }
    }
    return 1;
}

static int svo__open_sections(svo__check* c) {
    svo_file* file = c->file;
    int i;
    file->entities = 1;
    if (file->parts[SVO__ENTY].bytes) {
        const uint64_t count = svo__records(file, SVO__ENTY);
        if (count < 2 || count > 4096) {
            return svo__refuse(c, svo__offset(c, file->parts[SVO__ENTY].bytes),
                               "a set has not 2 ... 4,096 entities");
        }
        file->entities = (uint32_t)count;
    }
    for (i = 0; i < SVO_SECTIONS; ++i) {
        const svo_part part = file->parts[i];
        const uint64_t record = svo__layouts[i].record;
        const uint64_t count = (uint64_t)svo__layouts[i].count * file->entities;
        if (!part.bytes) {
            if (i < SVO__SOCK) return svo__refuse(c, 64, "a required section is missing");
        } else if (part.length % record != 0 || (count != 0 && part.length != record * count)) {
            return svo__refuse(c, svo__offset(c, part.bytes), "a section has a wrong length");
        } else if (part.length / record > 0xFFFFFFFFu) {
            return svo__refuse(c, svo__offset(c, part.bytes), "a section is too long");
        }
    }
    if (!file->parts[SVO__SOCK].bytes != !file->parts[SVO__SPOS].bytes) {
        return svo__refuse(c, 64, "of SOCK and SPOS there is only one");
    }
    file->models = (uint32_t)svo__records(file, SVO__MODL);
    file->clips = (uint32_t)svo__records(file, SVO__CLIP);
    file->frames = (uint32_t)svo__records(file, SVO__FRAM);
    file->sockets = (uint32_t)svo__records(file, SVO__SOCK);
    file->nodes = file->parts[SVO__NODE].bytes;
    file->node_count = (uint32_t)svo__records(file, SVO__NODE);
    file->payloads = file->parts[SVO__PAYL].bytes;
    file->payload_count = (uint32_t)svo__records(file, SVO__PAYL);
    file->palette = file->parts[SVO__PALT].bytes;
    return 1;
}

/* UTF-8 of RFC 3629: shortest forms only, no surrogates, nothing above U+10FFFF. */
static int svo__is_utf8(const uint8_t* p, uint32_t length) {
    uint32_t at = 0;
    while (at < length) {
        const uint8_t lead = p[at++];
        uint32_t more = lead < 0x80 ? 0u : lead < 0xE0 ? 1u : lead < 0xF0 ? 2u : 3u;
        if (lead >= 0x80 && (lead < 0xC2 || lead > 0xF4)) return 0;
        if (more > length - at) return 0;
        if (lead == 0xE0 && p[at] < 0xA0) return 0;
        if (lead == 0xED && p[at] >= 0xA0) return 0;
        if (lead == 0xF0 && p[at] < 0x90) return 0;
        if (lead == 0xF4 && p[at] >= 0x90) return 0;
        for (; more > 0; --more) {
            if ((p[at++] & 0xC0) != 0x80) return 0;
        }
    }
    return 1;
}

static int svo__check_text(svo__check* c, const uint8_t* record) {
    const svo_part texts = c->file->parts[SVO__STRS];
    const uint64_t first = svo__u32(record), length = svo__u32(record + 4);
    c->text_bytes += length;
    if (first + length > texts.length || c->text_bytes > texts.length) {
        return svo__refuse(c, svo__offset(c, record), "a text does not lie within section STRS");
    }
    if (length > 0 && !svo__is_utf8(texts.bytes + first, (uint32_t)length)) {
        return svo__refuse(c, svo__offset(c, texts.bytes) + first, "a text is not UTF-8");
    }
    return 1;
}

/* Reading the words in order, the children of each begin where those of the one before ended, and
 * so do the payloads. Then no node has two parents, and none goes unused. */
static int svo__check_words(svo__check* c, const svo_model* m) {
    const uint8_t* nodes = c->file->nodes + (uint64_t)4 * m->node_offset;
    const uint8_t* payloads = c->file->payloads + (uint64_t)8 * m->payload_offset;
    uint32_t next_node = 1, next_payload = 0, i, k;
    for (i = 0; i < m->node_count; ++i) {
        const uint64_t at = svo__offset(c, nodes + (uint64_t)4 * i);
        const uint32_t word = svo__u32(nodes + (uint64_t)4 * i);
        if (i >= next_node) return svo__refuse(c, at, "a node belongs to no parent");
        if (word == 0 && i != 0) return svo__refuse(c, at, "a node is empty but stored");
        if (word >> 31) {
            const uint32_t children = svo__bits(word & 0xFF);
            const uint8_t* first = nodes + (uint64_t)4 * next_node;
            uint32_t same = 0;
            if (children == 0) return svo__refuse(c, at, "a node has no children");
            if ((word >> 8 & 0x7FFFFF) != next_node) {
                return svo__refuse(c, at, "a node's children are out of breadth-first order");
            }
            if (children > m->node_count - next_node) {
                return svo__refuse(c, at, "a node has children beyond the end");
            }
            for (k = 0; k < children; ++k) same += memcmp(first, first + 4 * k, 4) == 0;
            if (same == 8 && svo__u32(first) <= 0xFF) {
                return svo__refuse(c, at, "a node is not collapsed");
            }
            next_node += children;
        } else if (word >> 30) {
            const uint8_t* payload = payloads + (uint64_t)8 * next_payload;
            if (next_payload >= m->payload_count || (word & 0x3FFFFFFF) != next_payload) {
                return svo__refuse(c, at, "a node's payload is out of order or beyond the end");
            }
            if (memcmp(payload, payload + 1, 7) == 0) {
                return svo__refuse(c, at, "a brick has one material");
            }
            ++next_payload;
        } else if (word > 0xFF) {
            return svo__refuse(c, at, "a node has stray bits");
        }
    }
    if (next_payload == m->payload_count) return 1;
    return svo__refuse(c, svo__offset(c, payloads), "there are payloads without a node");
}

/* Where things lie: leaves at the right depth, nothing solid outside the size. The recursion is as
 * deep as the octree, 16 at most. */
static int svo__check_places(svo__check* c, const svo_model* m, uint32_t index, uint32_t level,
                             uint32_t x, uint32_t y, uint32_t z) {
    const uint8_t* at = c->file->nodes + (uint64_t)4 * (m->node_offset + (uint64_t)index);
    const uint32_t word = svo__u32(at), edge = 1u << level, half = edge / 2;
    uint32_t octant, child = word >> 8 & 0x7FFFFF;
    if (word >> 31) {
        if (level == 1) {
            return svo__refuse(c, svo__offset(c, at), "a node has children below the last level");
        }
        for (octant = 0; octant < 8; ++octant) {
            if (!(word >> octant & 1)) continue;
            if (!svo__check_places(c, m, child++, level - 1, x + (octant & 1) * half,
                                   y + (octant >> 1 & 1) * half, z + (octant >> 2) * half)) {
                return 0;
            }
        }
        return 1;
    }
    if (word >> 30) {
        const uint64_t payload = (uint64_t)m->payload_offset + (word & 0x3FFFFFFF);
        if (level != 1) {
            return svo__refuse(c, svo__offset(c, at), "a brick is above the last level");
        }
        for (octant = 0; octant < 8; ++octant) {
            if (c->file->payloads[8 * payload + octant] == 0) continue;
            ++c->solids;
            if (x + (octant & 1) >= m->size[0] || y + (octant >> 1 & 1) >= m->size[1] ||
                z + (octant >> 2) >= m->size[2]) {
                return svo__refuse(c, svo__offset(c, at), "a node is solid outside the size");
            }
        }
    } else if (word != 0) {
        if (x + edge > m->size[0] || y + edge > m->size[1] || z + edge > m->size[2]) {
            return svo__refuse(c, svo__offset(c, at), "a node is solid outside the size");
        }
        c->solids += (uint64_t)edge * edge * edge;
    }
    if (c->solids <= (uint64_t)1 << 40) return 1;
    return svo__refuse(c, svo__offset(c, at), "the models hold more than 2^40 solid voxels");
}

/* The entities share out all models, clips and sockets, in their order. */
static int svo__check_entities(svo__check* c) {
    const svo_file* file = c->file;
    uint32_t models = 0, clips = 0, sockets = 0, i;
    for (i = 0; i < file->entities; ++i) {
        const svo_entity e = svo_get_entity(file, i);
        if (e.first_model != models || e.model_count > file->models - models ||
            e.first_clip != clips || e.clip_count > file->clips - clips ||
            e.first_socket != sockets || e.socket_count > file->sockets - sockets) {
            return svo__refuse(c, svo__offset(c, svo__record(file, SVO__ENTY, i)),
                               "an entity's models, clips or sockets are not the next ones");
        }
        models += e.model_count;
        clips += e.clip_count;
        sockets += e.socket_count;
        if (e.model_count == 0 && file->entities > 1) {
            return svo__refuse(c, svo__offset(c, svo__record(file, SVO__ENTY, i)),
                               "an entity has no model");
        }
    }
    if (models == file->models && clips == file->clips && sockets == file->sockets) return 1;
    return svo__refuse(c, svo__offset(c, file->parts[SVO__ENTY].bytes),
                       "there are models, clips or sockets that belong to no entity");
}

static int svo__check_models(svo__check* c) {
    svo_file* file = c->file;
    uint64_t nodes = 0, payloads = 0;
    uint32_t i;
    if (file->models == 0) return svo__refuse(c, 64, "the file holds no model");
    for (i = 0; i < file->models; ++i) {
        const uint8_t* record = svo__record(file, SVO__MODL, i);
        const uint64_t at = svo__offset(c, record);
        svo_model m;
        uint32_t depth = 1, axis, empty = 0;
        if (!svo__check_text(c, record + 44)) return 0;
        m = svo_get_model(file, i);
        if (m.node_offset != nodes || m.node_count > file->node_count - nodes) {
            return svo__refuse(c, at, "a model's nodes are not the next ones of NODE");
        }
        if (m.payload_offset != payloads || m.payload_count > file->payload_count - payloads) {
            return svo__refuse(c, at + 4, "a model's payloads are not the next ones of PAYL");
        }
        nodes += m.node_count;
        payloads += m.payload_count;
        if (m.node_count < 1 || m.node_count > 1u << 23) {
            return svo__refuse(c, at + 24, "a model has not 1 ... 8,388,608 nodes");
        }
        for (axis = 0; axis < 3; ++axis) {
            const int64_t length = m.size[axis] > 0 ? m.size[axis] : 1;
            const int64_t first = m.origin[axis], limit = 1 << 24;
            if (m.size[axis] > 65536) {
                return svo__refuse(c, at + 12, "a model is longer than 65,536 voxels");
            }
            if (first < -limit || first + length - 1 > limit) {
                return svo__refuse(c, at + 32, "a model lies beyond 2^24 voxels from the origin");
            }
            while (1u << depth < m.size[axis]) ++depth;
            empty += m.size[axis] == 0;
        }
        if (empty == 1 || empty == 2) {
            return svo__refuse(c, at + 12, "a model's size is 0 on some axes only");
        }
        if (m.max_depth != depth) {
            return svo__refuse(c, at + 8, "a model's depth is not that of its size");
        }
        if (!svo__check_words(c, &m) || !svo__check_places(c, &m, 0, depth, 0, 0, 0)) return 0;
    }
    if (nodes != file->node_count || payloads != file->payload_count) {
        return svo__refuse(c, svo__offset(c, file->nodes) + 4 * nodes,
                           "there are nodes or payloads that belong to no model");
    }
    return 1;
}

/* `shown` has a bit a model, set where a clip shows it; `end` counts frames, `unseen` models. */
static int svo__check_clip(svo__check* c, uint32_t index, const svo_entity* entity, uint8_t* shown,
                           uint32_t* end, uint32_t* unseen) {
    const svo_file* file = c->file;
    const uint8_t* record = svo__record(file, SVO__CLIP, index);
    const uint64_t at = svo__offset(c, record);
    svo_model first;
    svo_clip clip;
    uint32_t k;
    if (!svo__check_text(c, record)) return 0;
    clip = svo_get_clip(file, index);
    if (clip.first_frame != *end || clip.frame_count < 1 ||
        clip.frame_count > file->frames - *end) {
        return svo__refuse(c, at + 8, "a clip's frames are none, or not the next ones of FRAM");
    }
    *end += clip.frame_count;
    for (k = 0; k < clip.frame_count; ++k) {
        const svo_frame frame = svo_get_frame(file, clip.first_frame + k);
        svo_model model;
        if (frame.model < entity->first_model ||
            frame.model - entity->first_model >= entity->model_count) {
            return svo__refuse(c, at, "a clip shows a model that is not, or another entity's");
        }
        if (frame.milliseconds < 1 || frame.milliseconds > 1000000) {
            return svo__refuse(c, at, "a frame lasts not 1 ... 1,000,000 ms");
        }
        model = svo_get_model(file, frame.model);
        if (k == 0) first = model;
        if (memcmp(model.size, first.size, sizeof model.size) != 0 ||
            memcmp(model.origin, first.origin, sizeof model.origin) != 0) {
            return svo__refuse(c, at, "a clip shows models of different sizes or origins");
        }
        *unseen -= !(shown[frame.model / 8] >> frame.model % 8 & 1);
        shown[frame.model / 8] |= (uint8_t)(1 << frame.model % 8);
    }
    return 1;
}

static int svo__check_clips(svo__check* c) {
    const svo_file* file = c->file;
    const uint64_t at = svo__offset(c, file->parts[SVO__CLIP].bytes);
    uint8_t shown[(2 << 16) / 8] = {0};
    uint32_t e, i, end = 0, unseen = file->models;
    if (file->frames > 1 << 16 || file->models > 2 << 16) {
        return svo__refuse(c, at, "the file has more than 65,536 frames");
    }
    for (e = 0; e < file->entities; ++e) {
        const svo_entity entity = svo_get_entity(file, e);
        for (i = 0; i < entity.clip_count; ++i) {
            if (!svo__check_clip(c, entity.first_clip + i, &entity, shown, &end, &unseen)) return 0;
        }
    }
    if (end != file->frames) {
        return svo__refuse(c, svo__offset(c, file->parts[SVO__FRAM].bytes),
                           "there are frames that belong to no clip");
    }
    if (unseen + file->frames > 1 << 16) {
        return svo__refuse(c, at, "the file has more than 65,536 frames");
    }
    return 1;
}

/* A point counted from the models' minimum corner; written so that NaN fails. */
static int svo__is_near(const svo_file* file, const svo_entity* entity, const double xyz[3]) {
    const svo_model first = svo_get_model(file, entity->first_model);
    int axis;
    for (axis = 0; axis < 3; ++axis) {
        const double at = xyz[axis] + first.origin[axis];
        if (!(at >= -1e7 && at <= 1e7)) return 0;
    }
    return 1;
}

static int svo__check_authored(svo__check* c) {
    const svo_file* file = c->file;
    uint32_t e, i;
    for (e = 0; e < file->entities; ++e) {
        const uint8_t* record = svo__record(file, SVO__AUTH, e);
        const uint64_t at = svo__offset(c, record);
        const svo_entity entity = svo_get_entity(file, e);
        svo_authored a;
        if (!svo__check_text(c, record + 48)) return 0;
        a = svo_get_authored(file, e);
        if (!(a.voxel_size_metres >= 1e-6 && a.voxel_size_metres <= 1e6)) {
            return svo__refuse(c, at, "VoxelSize is not 1e-6 ... 1e6 metres");
        }
        if (!(a.sigma >= 1.0 / 64.0 && a.sigma <= 64.0)) {
            return svo__refuse(c, at + 8, "sigma is not 1/64 ... 64");
        }
        if (!svo__is_near(file, &entity, a.anchor)) {
            return svo__refuse(c, at + 16, "the anchor lies beyond 1e7 voxels from the origin");
        }
        if (a.outline[3] != 255) return svo__refuse(c, at + 47, "the outline's alpha is not 255");
        if (svo__u32(entity.palette) != 0) {
            return svo__refuse(c, svo__offset(c, entity.palette),
                               "palette entry 0 is not 0, 0, 0, 0");
        }
        for (i = 0; i < 256; ++i) {
            if (!svo__check_text(c, svo__record(file, SVO__CNAM, 256 * e + i))) return 0;
        }
    }
    return 1;
}

/* `frames` are those of the entity's clips; `end` counts positions. */
static int svo__check_socket(svo__check* c, uint32_t index, const svo_entity* entity,
                             uint32_t frames, uint64_t* end) {
    const svo_file* file = c->file;
    const uint8_t* record = svo__record(file, SVO__SOCK, index);
    const uint64_t at = svo__offset(c, record);
    svo_socket socket;
    uint32_t k;
    if (!svo__check_text(c, record)) return 0;
    socket = svo_get_socket(file, index);
    if (socket.first_position != *end ||
        socket.position_count > svo__records(file, SVO__SPOS) - *end) {
        return svo__refuse(c, at + 8, "a socket's positions are not the next ones of SPOS");
    }
    *end += socket.position_count;
    if (socket.position_count != 1 && (frames == 0 || socket.position_count != frames)) {
        return svo__refuse(c, at + 12, "a socket has neither one position nor one a frame");
    }
    for (k = 0; k < socket.position_count; ++k) {
        double xyz[3];
        svo_get_position(file, socket.first_position + k, xyz);
        if (!svo__is_near(file, entity, xyz)) {
            return svo__refuse(c, at, "a socket lies beyond 1e7 voxels from the origin");
        }
    }
    return 1;
}

static int svo__check_sockets(svo__check* c) {
    const svo_file* file = c->file;
    uint64_t end = 0;
    uint32_t e, i;
    for (e = 0; e < file->entities; ++e) {
        const svo_entity entity = svo_get_entity(file, e);
        uint32_t frames = 0;
        for (i = 0; i < entity.clip_count; ++i) {
            frames += svo_get_clip(file, entity.first_clip + i).frame_count;
        }
        for (i = 0; i < entity.socket_count; ++i) {
            if (!svo__check_socket(c, entity.first_socket + i, &entity, frames, &end)) return 0;
        }
    }
    if (end == svo__records(file, SVO__SPOS)) return 1;
    return svo__refuse(c, svo__offset(c, file->parts[SVO__SPOS].bytes),
                       "there are positions that belong to no socket");
}

int svo_open(svo_file* file, const void* bytes, size_t length, svo_error* error) {
    svo__check c;
    int valid;
    memset(file, 0, sizeof *file);
    memset(&c, 0, sizeof c);
    file->bytes = (const uint8_t*)bytes;
    file->length = length;
    c.file = file;
    valid = svo__open_table(&c) && svo__open_sections(&c) && svo__check_entities(&c) &&
            svo__check_models(&c) && svo__check_clips(&c) && svo__check_authored(&c) &&
            svo__check_sockets(&c);
    if (!valid && error) *error = c.error;
    return valid;
}

#endif /* VOXPRITE_SVO_IMPLEMENTED */
#endif /* VOXPRITE_SVO_IMPLEMENTATION */
