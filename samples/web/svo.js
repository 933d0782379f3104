// Reads .svo, the octrees that voxprite exports: the whole of ../runtime/SVO.md, with all its checks.
//
//     const file = Svo.read(arrayBuffer);     // or a Svo.Refused with .message and .offset
//     file.entities[0].models[0].size         // [x, y, z] voxels
//     file.words                              // Uint32Array: all nodes, then all payloads
//     Svo.voxel(file, file.models[0], x, y, z)
"use strict";

const Svo = (() => {
    class Refused extends Error {
        constructor(offset, message) {
            super(message);
            this.offset = offset;
        }
    }

    const magic = [0x89, 0x53, 0x56, 0x4f, 0x0d, 0x0a, 0x1a, 0x0a];
    // Bytes a record, and how many records an entity where that is fixed.
    const required = {
        MODL: [64], NODE: [4], PAYL: [8], PALT: [4, 256], CNAM: [8, 256],
        CLIP: [32], FRAM: [8], AUTH: [64, 1], STRS: [1],
    };
    const optional = { SOCK: [16], SPOS: [24], ENTY: [32] };

    const crcTable = Uint32Array.from({ length: 256 }, (_, n) => {
        for (let bit = 0; bit < 8; ++bit) n = n & 1 ? (n >>> 1) ^ 0xedb88320 : n >>> 1;
        return n;
    });
    function crc32(...parts) {
        let crc = 0xffffffff;
        for (const bytes of parts) {
            for (let i = 0; i < bytes.length; ++i) {
                crc = (crc >>> 8) ^ crcTable[(crc ^ bytes[i]) & 255];
            }
        }
        return ~crc >>> 0;
    }

    function bitCount(mask) {
        let count = 0;
        for (; mask !== 0; mask &= mask - 1) ++count;
        return count;
    }

    class Reader {
        constructor(buffer) {
            this.bytes = new Uint8Array(buffer);
            this.data = new DataView(buffer);
            this.sections = {};
            this.entities = 1;
            this.textBytes = 0;
            this.solids = 0;
        }

        check(holds, offset, message) {
            if (!holds) throw new Refused(offset, message);
        }
        u32(at) {
            return this.data.getUint32(at, true);
        }
        i32(at) {
            return this.data.getInt32(at, true);
        }
        f64(at) {
            return this.data.getFloat64(at, true);
        }
        // Lengths and offsets of a file in memory are well below 2^53.
        u64(at) {
            return this.u32(at + 4) * 2 ** 32 + this.u32(at);
        }
        start(tag) {
            return this.sections[tag].offset;
        }
        records(tag) {
            const section = this.sections[tag];
            return section ? section.length / (required[tag] || optional[tag])[0] : 0;
        }

        readTable() {
            const { bytes } = this;
            this.check(magic.every((byte, i) => bytes[i] === byte), 0, "this is not a .svo file");
            this.check(bytes.length >= 64, bytes.length, "the header is cut off");
            this.check(this.data.getUint16(8, true) === 1, 8, "the version is not known");
            this.check(this.u64(16) === bytes.length, 16,
                "the file does not have the length that it should have");
            const count = this.u32(12);
            this.check(count <= (bytes.length - 64) / 32, 12,
                "the section table is longer than the file");
            let end = 64 + 32 * count;
            const sealed = crc32(bytes.subarray(0, 60), new Uint8Array(4), bytes.subarray(64, end));
            this.check(sealed === this.u32(60), 60, "the header or section table is damaged");
            for (let i = 0; i < count; ++i) {
                const entry = 64 + 32 * i;
                const tag = String.fromCharCode(...bytes.subarray(entry, entry + 4));
                const offset = this.u64(entry + 8), length = this.u64(entry + 16);
                this.check(offset % 64 === 0 && offset >= end && offset <= bytes.length &&
                    length <= bytes.length - offset, entry,
                    "a section does not lie within the file");
                end = offset + length;
                this.check(crc32(bytes.subarray(offset, end)) === this.u32(entry + 24), offset,
                    `section ${tag} is damaged`);
                if (Object.hasOwn(required, tag) || Object.hasOwn(optional, tag)) {
                    this.check(!this.sections[tag], entry, `section ${tag} occurs twice`);
                    this.sections[tag] = { offset, length };
                } else {
                    this.check((this.u32(entry + 4) & 1) === 0, entry,
                        `section ${tag} is not known, but must be`);
                }
            }
            if (this.sections.ENTY) {
                this.entities = this.records("ENTY");
                this.check(this.entities >= 2 && this.entities <= 4096, this.start("ENTY"),
                    "a set has not 2 ... 4,096 entities");
            }
            for (const [tag, [record, records]] of
                [...Object.entries(required), ...Object.entries(optional)]) {
                const section = this.sections[tag];
                this.check(section || tag in optional, 64, `section ${tag} is missing`);
                if (!section) continue;
                this.check(section.length % record === 0 &&
                    (!records || section.length === record * records * this.entities), section.offset,
                    `section ${tag} has a wrong length`);
            }
            this.check(!this.sections.SOCK === !this.sections.SPOS, 64,
                "of SOCK and SPOS there is only one");
        }

        text(at) {
            const first = this.u32(at), length = this.u32(at + 4), texts = this.sections.STRS;
            this.textBytes += length;
            this.check(first + length <= texts.length && this.textBytes <= texts.length, at,
                "a text does not lie within section STRS");
            const from = texts.offset + first;
            try {
                return new TextDecoder("utf-8", { fatal: true, ignoreBOM: true })
                    .decode(this.bytes.subarray(from, from + length));
            } catch {
                throw new Refused(from, "a text is not UTF-8");
            }
        }
        vector(at, bytes, get) {
            return [0, 1, 2].map((axis) => get.call(this, at + bytes * axis));
        }

        // What of the file each entity has; they share out all models, clips and sockets.
        readShares() {
            const tags = ["MODL", "CLIP", "SOCK"], ends = [0, 0, 0], all = tags.map((t) => this.records(t));
            if (!this.sections.ENTY) return [{ first: ends, count: all }];
            const shares = [];
            for (let i = 0; i < this.entities; ++i) {
                const at = this.start("ENTY") + 32 * i;
                const first = this.vector(at, 8, this.u32), count = this.vector(at + 4, 8, this.u32);
                this.check(first.every((f, k) => f === ends[k] && count[k] <= all[k] - f), at,
                    "an entity's models, clips or sockets are not the next ones");
                this.check(count[0] > 0, at, "an entity has no model");
                count.forEach((n, k) => { ends[k] += n; });
                shares.push({ first, count });
            }
            this.check(ends.every((end, k) => end === all[k]), this.start("ENTY"),
                "there are models, clips or sockets that belong to no entity");
            return shares;
        }

        readModels() {
            const models = [];
            let nodes = 0, payloads = 0;
            this.check(this.records("MODL") > 0, 64, "the file holds no model");
            for (let i = 0; i < this.records("MODL"); ++i) {
                const at = this.start("MODL") + 64 * i;
                const model = {
                    name: this.text(at + 44),
                    nodeOffset: this.u32(at),
                    payloadOffset: this.u32(at + 4),
                    maxDepth: this.u32(at + 8),
                    size: this.vector(at + 12, 4, this.u32),
                    nodes: this.u32(at + 24),
                    payloads: this.u32(at + 28),
                    origin: this.vector(at + 32, 4, this.i32),
                };
                this.check(model.nodeOffset === nodes &&
                    model.nodes <= this.records("NODE") - nodes, at,
                    "a model's nodes are not the next ones of NODE");
                this.check(model.payloadOffset === payloads &&
                    model.payloads <= this.records("PAYL") - payloads, at + 4,
                    "a model's payloads are not the next ones of PAYL");
                nodes += model.nodes;
                payloads += model.payloads;
                this.check(model.nodes >= 1 && model.nodes <= 2 ** 23, at + 24,
                    "a model has not 1 ... 8,388,608 nodes");
                const longest = Math.max(...model.size);
                this.check(longest <= 65536, at + 12, "a model is longer than 65,536 voxels");
                this.check(longest === 0 || Math.min(...model.size) > 0, at + 12,
                    "a model's size is 0 on some axes only");
                this.check(model.origin.every((first, axis) => first >= -(2 ** 24) &&
                    first + Math.max(model.size[axis], 1) - 1 <= 2 ** 24), at + 32,
                    "a model lies beyond 2^24 voxels from the origin");
                let depth = 1;
                while (2 ** depth < longest) ++depth;
                this.check(model.maxDepth === depth, at + 8,
                    "a model's depth is not that of its size");
                this.checkWords(model);
                this.checkPlaces(model, 0, depth, 0, 0, 0);
                models.push(model);
            }
            this.check(nodes === this.records("NODE") && payloads === this.records("PAYL"),
                this.start("NODE") + 4 * nodes, "there are nodes or payloads that belong to no model");
            return models;
        }

        // Breadth first: the children of each begin where those of the one before ended.
        checkWords(model) {
            const first = this.start("NODE") + 4 * model.nodeOffset;
            const bricks = this.start("PAYL") + 8 * model.payloadOffset;
            let nextNode = 1, nextPayload = 0;
            for (let i = 0; i < model.nodes; ++i) {
                const at = first + 4 * i, word = this.u32(at);
                this.check(i < nextNode, at, "a node belongs to no parent");
                this.check(word !== 0 || i === 0, at, "a node is empty but stored");
                if (word >>> 31) {
                    const children = bitCount(word & 255);
                    this.check(children > 0, at, "a node has no children");
                    this.check(((word >>> 8) & 0x7fffff) === nextNode, at,
                        "a node's children are out of breadth-first order");
                    this.check(children <= model.nodes - nextNode, at,
                        "a node has children beyond the end");
                    const one = this.u32(first + 4 * nextNode);
                    let alike = one <= 255 ? 0 : -8;
                    for (let k = 0; k < children; ++k) {
                        alike += this.u32(first + 4 * (nextNode + k)) === one;
                    }
                    this.check(alike !== 8, at, "a node is not collapsed");
                    nextNode += children;
                } else if (word >>> 30) {
                    this.check(nextPayload < model.payloads &&
                        (word & 0x3fffffff) === nextPayload, at,
                        "a node's payload is out of order or beyond the end");
                    const brick = bricks + 8 * nextPayload++;
                    const materials = this.bytes.subarray(brick, brick + 8);
                    this.check(materials.some((m) => m !== materials[0]), at,
                        "a brick has one material");
                } else {
                    this.check(word <= 255, at, "a node has stray bits");
                }
            }
            this.check(nextPayload === model.payloads, bricks, "there are payloads without a node");
        }

        // Leaves at the right depth, nothing solid outside the size.
        checkPlaces(model, index, level, x, y, z) {
            const at = this.start("NODE") + 4 * (model.nodeOffset + index), word = this.u32(at);
            const [width, depth, height] = model.size, edge = 2 ** level, half = edge / 2;
            const outside = "a node is solid outside the size";
            if (word >>> 31) {
                this.check(level > 1, at, "a node has children below the last level");
                let child = (word >>> 8) & 0x7fffff;
                for (let o = 0; o < 8; ++o) {
                    if (!((word >>> o) & 1)) continue;
                    this.checkPlaces(model, child++, level - 1, x + (o & 1) * half,
                        y + ((o >> 1) & 1) * half, z + (o >> 2) * half);
                }
            } else if (word >>> 30) {
                this.check(level === 1, at, "a brick is above the last level");
                const brick = this.start("PAYL") + 8 * (model.payloadOffset + (word & 0x3fffffff));
                for (let o = 0; o < 8; ++o) {
                    if (this.bytes[brick + o] === 0) continue;
                    ++this.solids;
                    this.check(x + (o & 1) < width && y + ((o >> 1) & 1) < depth &&
                        z + (o >> 2) < height, at, outside);
                }
            } else if (word !== 0) {
                this.check(x + edge <= width && y + edge <= depth && z + edge <= height, at, outside);
                this.solids += edge ** 3;
            }
            this.check(this.solids <= 2 ** 40, at, "the models hold more than 2^40 solid voxels");
        }

        // Frames tell models by their number in the file.
        readClip(models, at, share, first) {
            const count = this.u32(at + 12);
            const clip = { name: this.text(at), loops: (this.u32(at + 16) & 1) === 1, frames: [] };
            this.check(this.u32(at + 8) === first && count >= 1 && count <= this.records("FRAM") - first,
                at + 8, "a clip's frames are none, or not the next ones of FRAM");
            for (let k = 0; k < count; ++k) {
                const frame = this.start("FRAM") + 8 * (first + k);
                const model = this.u32(frame), milliseconds = this.u32(frame + 4);
                this.check(model >= share.first[0] && model - share.first[0] < share.count[0], at,
                    "a clip shows a model that is not, or another entity's");
                this.check(milliseconds >= 1 && milliseconds <= 1000000, at,
                    "a frame lasts not 1 ... 1,000,000 ms");
                clip.frames.push({ model, milliseconds });
                const one = models[model], other = models[clip.frames[0].model];
                this.check(one.size.every((length, axis) => length === other.size[axis]) &&
                    one.origin.every((o, axis) => o === other.origin[axis]), at,
                    "a clip shows models of different sizes or origins");
            }
            return clip;
        }

        readClips(models, shares) {
            const clips = [], shown = new Set();
            let end = 0;
            for (const share of shares) {
                for (let i = 0; i < share.count[1]; ++i) {
                    const clip = this.readClip(models, this.start("CLIP") + 32 * clips.length, share, end);
                    for (const { model } of clip.frames) shown.add(model);
                    end += clip.frames.length;
                    clips.push(clip);
                }
            }
            const all = this.records("FRAM");
            this.check(end === all, this.start("FRAM") + 8 * end,
                "there are frames that belong to no clip");
            this.check(all + models.length - shown.size <= 65536, this.start("MODL"),
                "the file has more than 65,536 frames");
            return clips;
        }

        // Written so that NaN fails.
        isNear(point, model) {
            return point.every((x, axis) => Math.abs(x + model.origin[axis]) <= 1e7);
        }

        readAuthored(entity, firstModel) {
            const at = this.start("AUTH") + 64 * entity;
            const authored = {
                name: this.text(at + 48),
                voxelSizeMetres: this.f64(at),
                sigma: this.f64(at + 8),
                anchor: this.vector(at + 16, 8, this.f64),
                outline: (this.u32(at + 40) & 1) === 1 ? [...this.bytes.slice(at + 44, at + 47)] : null,
            };
            this.check(authored.voxelSizeMetres >= 1e-6 && authored.voxelSizeMetres <= 1e6, at,
                "VoxelSize is not 1e-6 ... 1e6 metres");
            this.check(authored.sigma >= 1 / 64 && authored.sigma <= 64, at + 8,
                "sigma is not 1/64 ... 64");
            this.check(this.isNear(authored.anchor, firstModel), at + 16,
                "the anchor lies beyond 1e7 voxels from the origin");
            this.check(this.bytes[at + 47] === 255, at + 47, "the outline's alpha is not 255");
            return authored;
        }

        readPalette(entity) {
            const at = this.start("PALT") + 1024 * entity;
            this.check(this.u32(at) === 0, at, "palette entry 0 is not 0, 0, 0, 0");
            return this.bytes.slice(at, at + 1024);
        }

        readColourNames(entity) {
            const names = [];
            for (let i = 0; i < 256; ++i) names.push(this.text(this.start("CNAM") + 2048 * entity + 8 * i));
            return names;
        }

        // `position` is the next one of the file, `frames` are those of the entity's clips.
        readSocket(at, frames, firstModel, position) {
            const count = this.u32(at + 12), socket = { name: this.text(at), positions: [] };
            this.check(this.u32(at + 8) === position && count <= this.records("SPOS") - position,
                at + 8, "a socket's positions are not the next ones of SPOS");
            this.check(count === 1 || (frames > 0 && count === frames), at + 12,
                "a socket has neither one position nor one a frame");
            for (let k = 0; k < count; ++k) {
                const xyz = this.vector(this.start("SPOS") + 24 * (position + k), 8, this.f64);
                this.check(this.isNear(xyz, firstModel), at,
                    "a socket lies beyond 1e7 voxels from the origin");
                socket.positions.push(xyz);
            }
            return socket;
        }

        // Nodes, then payloads, two words each: what goes into a texture.
        readWords() {
            const nodes = this.records("NODE"), payloads = 2 * this.records("PAYL");
            const words = new Uint32Array(nodes + payloads);
            for (let i = 0; i < nodes; ++i) words[i] = this.u32(this.start("NODE") + 4 * i);
            for (let i = 0; i < payloads; ++i) {
                words[nodes + i] = this.u32(this.start("PAYL") + 4 * i);
            }
            return words;
        }

        read() {
            this.readTable();
            const shares = this.readShares(), models = this.readModels();
            const clips = this.readClips(models, shares), entities = [];
            let positions = 0;
            shares.forEach(({ first, count }, i) => {
                const own = (list, k) => list.slice(first[k], first[k] + count[k]);
                const entity = {
                    models: own(models, 0),
                    clips: own(clips, 1),
                    authored: this.readAuthored(i, models[first[0]]),
                    palette: this.readPalette(i),
                    colourNames: this.readColourNames(i),
                    sockets: [],
                };
                const frames = entity.clips.reduce((sum, clip) => sum + clip.frames.length, 0);
                for (let k = 0; k < count[2]; ++k) {
                    const at = this.start("SOCK") + 16 * (first[2] + k);
                    const socket = this.readSocket(at, frames, entity.models[0], positions);
                    positions += socket.positions.length;
                    entity.sockets.push(socket);
                }
                entities.push(entity);
            });
            this.check(positions === this.records("SPOS"), 64,
                "there are positions that belong to no socket");
            return { entities, models, words: this.readWords(), nodeCount: this.records("NODE") };
        }
    }

    // The material of a voxel, 0 where it is empty or outside.
    function voxel(file, model, x, y, z) {
        if (x >= model.size[0] || y >= model.size[1] || z >= model.size[2]) return 0;
        let word = file.words[model.nodeOffset];
        for (let bit = model.maxDepth - 1; ; --bit) {
            const octant = (((z >>> bit) & 1) << 2) | (((y >>> bit) & 1) << 1) | ((x >>> bit) & 1);
            if (word >>> 31) {
                if (!((word >>> octant) & 1)) return 0;
                const child = ((word >>> 8) & 0x7fffff) + bitCount(word & ((1 << octant) - 1));
                word = file.words[model.nodeOffset + child];
            } else if (word >>> 30) {
                const brick = file.nodeCount + 2 * (model.payloadOffset + (word & 0x3fffffff));
                return (file.words[brick + (octant >> 2)] >>> (8 * (octant & 3))) & 255;
            } else {
                return word;
            }
        }
    }

    return { Refused, read: (buffer) => new Reader(buffer).read(), voxel };
})();
