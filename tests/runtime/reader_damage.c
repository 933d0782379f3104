/* The C reader and every damage: `reader_damage FILE... -- OTHER...`, built with the sanitizers.
 * Each file is cut at every length and has every byte flipped, with checksums that are wrong and
 * with such that are right; what is accepted all the same is walked through. Each variant lies in
 * memory of its very own length, so that the sanitizer sees a byte read too many. The other files
 * are taken as they are, broken ones too. */
#include <stdio.h>
#include <stdlib.h>

#define VOXPRITE_SVO_IMPLEMENTATION
#include "samples/runtime/voxprite_svo.h"

static unsigned long accepted, refused, sum;

static void put_u32(uint8_t* p, uint32_t value) {
    int i;
    for (i = 0; i < 4; ++i) p[i] = (uint8_t)(value >> 8 * i);
}

/* Makes length and checksums right, as far as there is a table. */
static void reseal(uint8_t* bytes, size_t length) {
    uint64_t i, count;
    if (length < 64) return;
    put_u32(bytes + 16, (uint32_t)length);
    put_u32(bytes + 20, 0);
    count = svo__u32(bytes + 12);
    if (count > (length - 64) / 32) return;
    for (i = 0; i < count; ++i) {
        uint8_t* entry = bytes + 64 + 32 * i;
        const uint64_t offset = svo__u64(entry + 8), size = svo__u64(entry + 16);
        if (offset > length || size > length - offset) continue;
        put_u32(entry + 24, ~svo__crc(0xFFFFFFFFu, bytes + offset, size));
    }
    put_u32(bytes + 60, 0);
    put_u32(bytes + 60, ~svo__crc(0xFFFFFFFFu, bytes, 64 + 32 * count));
}

static void read_text(svo_text text) {
    uint32_t i;
    for (i = 0; i < text.length; ++i) sum += (unsigned char)text.bytes[i];
}

/* Everything that a file offers. */
static void read_all(const svo_file* file) {
    uint32_t i, k;
    double xyz[3];
    for (i = 0; i < file->models; ++i) {
        const svo_model model = svo_get_model(file, i);
        read_text(model.name);
        for (k = 0; k < 200; ++k) {
            sum += svo_voxel(file, &model, k % 7, k / 7 % 7, k / 49);
            sum += svo_voxel(file, &model, model.size[0] - 1 - k % 7, model.size[1] - 1 - k / 7 % 7,
                             model.size[2] - 1 - k / 49);
        }
        for (k = 0; k < 4 * model.node_count; ++k) sum += file->nodes[4 * model.node_offset + k];
        for (k = 0; k < 8 * model.payload_count; ++k) {
            sum += file->payloads[8 * model.payload_offset + k];
        }
    }
    for (i = 0; i < file->clips; ++i) {
        const svo_clip clip = svo_get_clip(file, i);
        read_text(clip.name);
        for (k = 0; k < clip.frame_count; ++k) {
            sum += svo_get_model(file, svo_get_frame(file, clip.first_frame + k).model).size[0];
        }
    }
    for (i = 0; i < file->sockets; ++i) {
        const svo_socket socket = svo_get_socket(file, i);
        read_text(socket.name);
        for (k = 0; k < socket.position_count; ++k) {
            svo_get_position(file, socket.first_position + k, xyz);
            sum += xyz[0] > 0.0;
        }
    }
    for (i = 0; i < file->entities; ++i) {
        const svo_entity entity = svo_get_entity(file, i);
        for (k = 0; k < 256; ++k) read_text(svo_get_colour_name(file, i, k));
        for (k = 0; k < 1024; ++k) sum += entity.palette[k];
        for (k = 0; k < entity.model_count; ++k) {
            sum += svo_get_model(file, entity.first_model + k).size[0];
        }
        for (k = 0; k < entity.clip_count; ++k) {
            sum += svo_get_clip(file, entity.first_clip + k).frame_count;
        }
        for (k = 0; k < entity.socket_count; ++k) {
            sum += svo_get_socket(file, entity.first_socket + k).position_count;
        }
        read_text(svo_get_authored(file, i).name);
    }
}

/* 1 when accepted. */
static int try_bytes(const uint8_t* bytes, size_t length, int seal) {
    uint8_t* own = (uint8_t*)malloc(length > 0 ? length : 1);
    svo_file file;
    svo_error error = {NULL, 0};
    int valid;
    if (own == NULL) abort();
    memcpy(own, bytes, length);
    if (seal) reseal(own, length);
    valid = svo_open(&file, own, length, &error);
    if (valid) {
        ++accepted;
        read_all(&file);
    } else {
        ++refused;
        if (error.reason == NULL || error.offset > length) {
            fprintf(stderr, "refused without a reason or a place\n");
            abort();
        }
    }
    free(own);
    return valid;
}

static uint8_t bytes[1 << 16];

static size_t read_bytes(const char* path) {
    FILE* in = fopen(path, "rb");
    const size_t length = in ? fread(bytes, 1, sizeof bytes, in) : 0;
    if (in) fclose(in);
    return length;
}

static int damage(const char* path) {
    const size_t length = read_bytes(path);
    size_t at;
    if (length == 0 || length == sizeof bytes || !try_bytes(bytes, length, 0)) {
        fprintf(stderr, "%s is no small valid file\n", path);
        return 0;
    }
    for (at = 0; at < length; ++at) {
        static const uint8_t flips[3] = {0x01, 0x80, 0xFF};
        int i;
        if (try_bytes(bytes, at, 0)) {
            fprintf(stderr, "%s: cut to %lu bytes it was accepted\n", path, (unsigned long)at);
            return 0;
        }
        try_bytes(bytes, at, 1);
        for (i = 0; i < 3; ++i) {
            bytes[at] ^= flips[i];
            try_bytes(bytes, length, 0);
            try_bytes(bytes, length, 1);
            bytes[at] ^= flips[i];
        }
    }
    return 1;
}

int main(int argc, char** argv) {
    int i, whole = 0;
    for (i = 1; i < argc; ++i) {
        if (strcmp(argv[i], "--") == 0) {
            whole = 1;
        } else if (whole) {
            try_bytes(bytes, read_bytes(argv[i]), 0);
        } else if (!damage(argv[i])) {
            return 1;
        }
    }
    printf("%lu variants accepted and walked, %lu refused (%lu)\n", accepted, refused, sum);
    return accepted > 0 && refused > 0 ? 0 : 1;
}
