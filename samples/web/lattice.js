// A view of a model as integers, and the sprite that they are: on the processor, exactly, whatever
// the model's size. The rules are those of ../runtime/SVO.md; sprite.js does the same on the GPU.
"use strict";

const Lattice = (() => {
    const maxPixels = 2 ** 24;
    const axes = [0, 1, 2];
    const cross = (a, b) => axes.map((k) => {
        const n = (k + 1) % 3, m = (k + 2) % 3;
        return a[n] * b[m] - a[m] * b[n];
    });
    const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

    // Of all integer vectors within +-8192 the one at the smallest angle.
    function direction(forward) {
        const order = [...axes].sort((a, b) => Math.abs(forward[b]) - Math.abs(forward[a]));
        const b = Math.abs(forward[order[1]] / forward[order[0]]);
        const c = Math.abs(forward[order[2]] / forward[order[0]]);
        let best = null, bestQ = 0, bestNorm = 1;
        for (let s = 1; s <= 8192 && !(best && bestQ === 0); ++s) {
            for (let corner = 0; corner < 4; ++corner) {
                const vb = Math.floor(s * b) + (corner & 1), vc = Math.floor(s * c) + (corner >> 1);
                const db = vb - s * b, dc = vc - s * c, skew = db * c - dc * b;
                const q = db * db + dc * dc + skew * skew, norm = s * s + vb * vb + vc * vc;
                if (best && q * bestNorm >= bestQ * norm) continue;
                best = [s, vb, vc];
                bestQ = q;
                bestNorm = norm;
            }
        }
        let divisor = best[0];
        for (let other of best.slice(1)) {
            while (other !== 0) [divisor, other] = [other, divisor % other];
        }
        const D = [0, 0, 0];
        order.forEach((axis, k) => {
            D[axis] = Math.sign(forward[axis]) * best[k] / divisor || 0;
        });
        return D;
    }

    // Where the sample of a pixel lies in it, from its left and bottom edge.
    function sampleOffset(sigma) {
        return sigma < 1 ? sigma / 2 : Number.isInteger(sigma) ? 1 / 2 : 1 / 3;
    }

    // The pixels along U or V whose rays can meet the model's box, and one more at both ends.
    function interval(view, size, normal, determinant) {
        let low = 0, high = 0;
        for (const k of axes) {
            const ends = [-view.C[k], size[k] * 2 ** view.bits + 1 - view.C[k]];
            low += Math.min(normal[k] * ends[0], normal[k] * ends[1]);
            high += Math.max(normal[k] * ends[0], normal[k] * ends[1]);
        }
        if (determinant < 0) [low, high] = [high, low];
        return [Math.ceil(low * 4096 / determinant) - 1, Math.floor(high * 4096 / determinant) + 1];
    }

    function quantised(bits, D, { right, up }, sigma, size) {
        const steps = 2 ** bits, step = steps * 4096 / sigma;
        const offset = sampleOffset(sigma) / sigma;
        const view = {
            bits, D,
            C: axes.map((k) => Math.floor((Math.floor(size[k] / 2) +
                (right[k] + up[k]) * offset) * steps + 1)),
            U: right.map((x) => Math.floor(x * step + 0.5)),
            V: up.map((x) => Math.floor(x * step + 0.5)),
        };
        const determinant = dot(view.U, cross(view.V, D));
        const i = interval(view, size, cross(view.V, D), determinant);
        const j = interval(view, size, cross(D, view.U), determinant);
        view.first = [i[0], j[0]];
        view.size = [i[1] - i[0] + 1, j[1] - j[0] + 1];
        return view;
    }

    // Orthonormal axes in voxel space; null when the sprite would have more than 2^24 pixels.
    function fromAxes(basis, sigma, size) {
        const fits = (view) => view.size[0] * view.size[1] <= maxPixels;
        // As far as voxprite itself refines a view.
        const inRange = ({ C, U, V }) => [...C, ...U, ...V].every((x) => Math.abs(x) <= 2 ** 28);
        const D = direction(basis.forward);
        let bits = 8;
        while (2 ** bits < 16 * sigma) ++bits;
        let view = quantised(bits, D, basis, sigma, size);
        if (!fits(view)) return null;
        while (view.bits < 12) {
            const finer = quantised(view.bits + 1, D, basis, sigma, size);
            if (!fits(finer) || !inRange(finer) || !isNarrow(finer, size)) break;
            view = finer;
        }
        return view;
    }

    // The `lattice` of `voxprite render --json`.
    function fromJson({ bits, C, D, U, V, first, size }) {
        return { bits: bits.position, C, D, U, V, first, size };
    }

    function corners(view) {
        const last = axes.slice(0, 2).map((k) => view.first[k] + view.size[k] - 1);
        return [view.first, last, [view.first[0], last[1]], [last[0], view.first[1]]];
    }

    // Do all products fit 31 bits? Then WebGL can cast it.
    function isNarrow(view, size) {
        const limit = 2 ** 31, largest = Math.max(...view.D.map(Math.abs));
        return axes.every((k) => {
            const centre = Math.floor(size[k] / 2), half = (size[k] - centre) * 2 ** view.bits;
            return corners(view).every(([i, j]) => {
                const u = i * view.U[k], v = j * view.V[k];
                const origin = view.C[k] - centre * 2 ** view.bits + Math.floor((u + v) / 4096);
                return Math.abs(u) < limit && Math.abs(v) < limit && Math.abs(u + v) < limit &&
                    (Math.abs(origin) + half) * largest < limit;
            });
        });
    }

    // 0 ... 255, of the three faces that the rays see; the light in voxel space.
    function faceLight(D, towardLight, ambient) {
        const length = Math.hypot(...towardLight);
        return D.map((d, k) => {
            const lit = Math.max(0, -Math.sign(d) * towardLight[k] / length);
            return Math.floor(255 * (ambient + (1 - ambient) * lit) + 0.5);
        });
    }

    // 3 rows of 256 colours, one row an axis.
    function litPalette(palette, light8) {
        const lit = new Uint8Array(3 * 1024);
        for (let i = 0; i < lit.length; ++i) {
            const axis = Math.floor(i / 1024);
            lit[i] = i % 4 === 3 ? 255 : Math.floor((palette[i % 1024] * light8[axis] + 127) / 255);
        }
        return lit;
    }

    // The cells that one ray meets: numbers are whole and below 2^53, so doubles are exact. Nothing
    // is made anew for a ray.
    class Caster {
        constructor(file, model, view) {
            Object.assign(this, { file, model, view });
            const { D } = view, edge = 2 ** model.maxDepth;
            this.steps = 2 ** view.bits;
            this.speed = D.map(Math.abs);
            // Where rays run downward an axis is mirrored: cell c becomes edge - 1 - c.
            this.mirror = D.map((d) => (d < 0 ? edge : 0));
            this.low = axes.map((k) => (D[k] < 0 ? edge - model.size[k] : 0));
            this.high = axes.map((k) => this.low[k] + model.size[k]);
            this.start = [0, 0, 0];
            this.ends = [0, 0, 0];
            this.cell = [0, 0, 0];
            this.tree = [0, 0, 0];
            this.axis = 0;  // of the last crossing
            this.way = 0;   // its time, times the speed of that axis
            this.level = 0;
        }
        begin(i, j) {
            const { C, U, V, D } = this.view;
            for (let k = 0; k < 3; ++k) {
                const at = C[k] + Math.floor((i * U[k] + j * V[k]) / 4096);
                this.start[k] = D[k] < 0 ? this.mirror[k] * this.steps - at : at;
            }
        }
        // To the face of these three that the ray crosses first, or last. At the same time the
        // lowest axis comes first. False where the ray does not move at all.
        cross(faces, last) {
            const { speed, start, steps } = this;
            let axis = -1, way = 0;
            for (let k = 0; k < 3; ++k) {
                if (speed[k] === 0) continue;
                const mine = faces[k] * steps - start[k];
                if (axis >= 0) {
                    const order = mine * speed[axis] - way * speed[k];
                    if (last ? order < 0 : order >= 0) continue;
                }
                axis = k;
                way = mine;
            }
            if (axis < 0) return false;
            this.axis = axis;
            this.way = way;
            // The cell right behind: an axis above it has not yet crossed what it meets then.
            for (let k = 0; k < 3; ++k) {
                const later = k > axis && speed[k] > 0 ? 1 : 0;
                const moved = Math.floor((speed[k] * way - later) / speed[axis]);
                this.cell[k] = Math.floor((start[k] + moved) / steps);
            }
            return true;
        }
        // The material of the cell in `tree`; where it is 0, `level` tells how large a cube is empty.
        look() {
            const { words, nodeCount } = this.file, { nodeOffset, payloadOffset } = this.model;
            const [x, y, z] = this.tree;
            let word = words[nodeOffset], level = this.model.maxDepth;
            while (word >>> 31) {
                --level;
                const octant = ((x >>> level) & 1) | (((y >>> level) & 1) << 1) |
                    (((z >>> level) & 1) << 2);
                this.level = level;
                if (!((word >>> octant) & 1)) return 0;
                let child = nodeOffset + ((word >>> 8) & 0x7fffff);
                for (let o = 0; o < octant; ++o) child += (word >>> o) & 1;
                word = words[child];
            }
            this.level = word >>> 30 ? 0 : level;
            if (!(word >>> 30)) return word;
            const octant = (x & 1) | ((y & 1) << 1) | ((z & 1) << 2);
            const brick = nodeCount + 2 * (payloadOffset + (word & 0x3fffffff));
            return (words[brick + (octant >> 2)] >>> (8 * (octant & 3))) & 255;
        }
        inside() {
            const { cell, high } = this;
            return cell[0] < high[0] && cell[1] < high[1] && cell[2] < high[2];
        }
        // The material that is hit, at `tree` through a face of `axis`; 0 for none.
        cast(i, j) {
            const { cell, low, high, tree, ends, mirror } = this;
            this.begin(i, j);
            if (!this.cross(low, true)) return 0;
            if (cell[0] < low[0] || cell[1] < low[1] || cell[2] < low[2]) return 0;
            while (this.inside()) {
                for (let k = 0; k < 3; ++k) {
                    tree[k] = mirror[k] > 0 ? mirror[k] - 1 - cell[k] : cell[k];
                }
                const material = this.look();
                if (material !== 0) return material;
                const edge = 2 ** this.level;
                for (let k = 0; k < 3; ++k) {
                    ends[k] = Math.min((Math.floor(cell[k] / edge) + 1) * edge, high[k]);
                }
                this.cross(ends, false);
            }
            return 0;
        }
    }

    // { size, colours: Uint8Array RGBA, ids: Uint32Array }, the top row first. `outline`: [r, g, b]
    // or null.
    function cast(file, model, view, lit, outline) {
        const [width, height] = view.size;
        const colours = new Uint8Array(4 * width * height), ids = new Uint32Array(width * height);
        const caster = new Caster(file, model, view), [sizeX, sizeY] = model.size;
        for (let row = 0, at = 0; row < height; ++row) {
            for (let column = 0; column < width; ++column, ++at) {
                const material =
                    caster.cast(view.first[0] + column, view.first[1] + height - 1 - row);
                if (material === 0) continue;
                const [x, y, z] = caster.tree, from = 1024 * caster.axis + 4 * material;
                colours.set(lit.subarray(from, from + 4), 4 * at);
                // Modulo 2^32, but 0 and 1 have a meaning.
                ids[at] = 2 + x + Math.imul(sizeX, y + Math.imul(sizeY, z));
                if (ids[at] < 2) ids[at] += 2;
            }
        }
        if (outline) dilate(width, height, colours, ids, [...outline, 255]);
        return { size: view.size, colours, ids };
    }

    function dilate(width, height, colours, ids, outline) {
        const opaque = (x, y) =>
            x >= 0 && y >= 0 && x < width && y < height && ids[y * width + x] > 1;
        for (let y = 0, at = 0; y < height; ++y) {
            for (let x = 0; x < width; ++x, ++at) {
                if (ids[at] > 1) continue;
                if (opaque(x - 1, y) || opaque(x + 1, y) || opaque(x, y - 1) || opaque(x, y + 1)) {
                    ids[at] = 1;
                    colours.set(outline, 4 * at);
                }
            }
        }
    }

    return { fromAxes, fromJson, isNarrow, sampleOffset, faceLight, litPalette, cast, maxPixels };
})();
