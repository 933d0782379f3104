// Sprites on the GPU: WebGL2, whole numbers of 31 bits alone, so that every driver gives the same
// pixels. What does not fit them is cast by lattice.js on the processor: exact as well, but slower.
"use strict";

const version = "#version 300 es\nprecision highp float;\nprecision highp int;\n" +
    "precision highp usampler2D;\n";

// One ray a virtual pixel. After ../runtime/SVO.md, by divisions: where a ray is behind a crossing
// follows from the crossing alone. (sprite.glsl of ../runtime goes by comparisons.)
const castShader = version + `
uniform usampler2D octree;       // nodes, then payloads; linear index i at (i % width, i / width)
uniform usampler2D lit_palette;  // column = material, row = axis
uniform int width, node_offset, payload_offset, max_depth, position_bits;
uniform ivec3 model_size, origin, right, up, direction;  // origin: C from the middle, floor(size / 2)
uniform ivec2 first;
layout(location = 0) out uvec4 colour;
layout(location = 1) out uint id;

// Axes on which rays run downward are mirrored: cell c becomes edge - 1 - c.
ivec3 speed, low, high, middle, start;

uint word_at(int index) {
    return texelFetch(octree, ivec2(index % width, index / width), 0).r;
}

int floor_div(int x, int by) {
    return x >= 0 ? x / by : -1 - (-1 - x) / by;
}

int way_to(int face, int axis) {
    return ((face - middle[axis]) << position_bits) - start[axis];
}

// The face of these three that is crossed first, or last; at the same time the lowest axis is first.
void crossing(ivec3 faces, bool last, out int axis, out int way) {
    axis = -1;
    for (int k = 0; k < 3; ++k) {
        if (speed[k] == 0) continue;
        int mine = way_to(faces[k], k);
        if (axis >= 0) {
            int a = mine * speed[axis], b = way * speed[k];
            if (last ? a < b : a >= b) continue;
        }
        axis = k;
        way = mine;
    }
}

// An axis above the crossed one has not yet crossed a face that it meets at the same time.
ivec3 cell_behind(int axis, int way) {
    ivec3 cell;
    for (int k = 0; k < 3; ++k) {
        int later = k > axis && speed[k] > 0 ? 1 : 0;
        int moved = floor_div(speed[k] * way - later, speed[axis]);
        cell[k] = middle[k] + ((start[k] + moved) >> position_bits);
    }
    return cell;
}

// The material of a cell, or how large a cube around it is empty: 2^level.
uint look(ivec3 cell, out int level) {
    uint word = word_at(node_offset);
    for (level = max_depth; word >> 31 != 0u;) {
        --level;
        ivec3 bits = (cell >> level) & 1;
        int octant = bits.x | (bits.y << 1) | (bits.z << 2);
        if (((word >> octant) & 1u) == 0u) return 0u;
        uint before = word & ((1u << octant) - 1u);
        before = before - ((before >> 1) & 0x55u);
        before = (before & 0x33u) + ((before >> 2) & 0x33u);
        before = (before + (before >> 4)) & 0x0Fu;
        word = word_at(node_offset + int(((word >> 8) & 0x7FFFFFu) + before));
    }
    if (word >> 30 == 0u) return word;
    level = 0;
    int brick = payload_offset + 2 * int(word & 0x3FFFFFFFu) + (cell.z & 1);
    return (word_at(brick) >> (8 * ((cell.x & 1) | ((cell.y & 1) << 1)))) & 0xFFu;
}

void main() {
    colour = uvec4(0u);
    id = 0u;
    int edge = 1 << max_depth;
    ivec2 pixel = first + ivec2(gl_FragCoord.xy);
    speed = abs(direction);
    start = origin + ((pixel.x * right + pixel.y * up) >> 12);
    ivec3 mirror = ivec3(lessThan(direction, ivec3(0)));
    low = mirror * (edge - model_size);
    high = low + model_size;
    middle = mirror * (edge - 2 * (model_size / 2)) + model_size / 2;
    start *= 1 - 2 * mirror;

    int axis, way, level;
    crossing(low, true, axis, way);
    if (axis < 0) return;
    ivec3 cell = cell_behind(axis, way);
    if (any(lessThan(cell, low))) return;
    while (all(lessThan(cell, high))) {
        ivec3 tree = cell + mirror * (edge - 1 - 2 * cell);
        uint material = look(tree, level);
        if (material != 0u) {
            uvec3 v = uvec3(tree), size = uvec3(model_size);
            colour = texelFetch(lit_palette, ivec2(int(material), axis), 0);
            id = 2u + v.x + size.x * (v.y + size.y * v.z);
            if (id < 2u) id += 2u;  // 2^32 - 1 cells or more
            return;
        }
        crossing(min(((cell >> level) + 1) << level, high), false, axis, way);
        cell = cell_behind(axis, way);
    }
}`;

const outlineShader = version + `
uniform usampler2D colours, ids;
uniform uvec4 outline;  // R, G, B, 255, or all 0
layout(location = 0) out uvec4 colour;
layout(location = 1) out uint id;
uint at(ivec2 p) {
    bool outside = any(lessThan(p, ivec2(0))) || any(greaterThanEqual(p, textureSize(ids, 0)));
    return outside ? 0u : texelFetch(ids, p, 0).r;
}
void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    id = at(p);
    colour = texelFetch(colours, p, 0);
    bool beside = (at(p + ivec2(1, 0)) | at(p - ivec2(1, 0)) | at(p + ivec2(0, 1)) |
                   at(p - ivec2(0, 1))) != 0u;
    if (id != 0u || outline.a == 0u || !beside) return;
    colour = outline;
    id = 1u;
}`;

const triangleShader = version + `
void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}`;

function makeProgram(gl, vertex, fragment) {
    const program = gl.createProgram();
    for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
        const shader = gl.createShader(type);
        gl.shaderSource(shader, text);
        gl.compileShader(shader);
        if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) {
            throw new Error(gl.getShaderInfoLog(shader) || "a shader does not compile");
        }
        gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
        throw new Error(gl.getProgramInfoLog(program) || "a program does not link");
    }
    const places = new Map();
    return {
        program,
        at(name) {
            if (!places.has(name)) places.set(name, gl.getUniformLocation(program, name));
            return places.get(name);
        },
    };
}

class SpriteCaster {
    constructor(gl) {
        this.gl = gl;
        this.castProgram = makeProgram(gl, triangleShader, castShader);
        this.outlineProgram = makeProgram(gl, triangleShader, outlineShader);
        this.most = gl.getParameter(gl.MAX_TEXTURE_SIZE);
        this.size = [0, 0];
        this.rays = { framebuffer: gl.createFramebuffer(), textures: [] };
        this.finished = { framebuffer: gl.createFramebuffer(), textures: [] };
        this.palette = this.texture(gl.RGBA8UI, 256, 3);
    }

    texture(format, width, height) {
        const { gl } = this, texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
        gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
        return texture;
    }

    // A file of Svo.read: its octrees go to the GPU.
    open(file) {
        const { gl } = this, width = 2048, height = Math.ceil(file.words.length / width);
        if (height > this.most) throw new Error("its octrees are too large for a texture");
        const texels = new Uint32Array(width * height);
        texels.set(file.words);
        const octree = this.texture(gl.R32UI, width, height);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, gl.RED_INTEGER, gl.UNSIGNED_INT,
            texels);
        gl.deleteTexture(this.octree);
        this.octree = octree;
        this.file = file;
    }

    resize(size) {
        if (size[0] === this.size[0] && size[1] === this.size[1]) return;
        const { gl } = this;
        for (const target of [this.rays, this.finished]) {
            target.textures.forEach((texture) => gl.deleteTexture(texture));
            target.textures = [gl.RGBA8UI, gl.R32UI].map((format) => this.texture(format, ...size));
            gl.bindFramebuffer(gl.FRAMEBUFFER, target.framebuffer);
            target.textures.forEach((texture, k) => gl.framebufferTexture2D(gl.FRAMEBUFFER,
                gl.COLOR_ATTACHMENT0 + k, gl.TEXTURE_2D, texture, 0));
            gl.drawBuffers([gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT1]);
        }
        this.size = [...size];
    }

    bind(program, textures) {
        const { gl } = this;
        gl.useProgram(program.program);
        Object.entries(textures).forEach(([name, texture], unit) => {
            gl.activeTexture(gl.TEXTURE0 + unit);
            gl.bindTexture(gl.TEXTURE_2D, texture);
            gl.uniform1i(program.at(name), unit);
        });
    }

    canShow(view) {
        return view.size.every((length) => length >= 1 && length <= this.most);
    }

    // Casts a sprite into this.finished, in the colours of its entity. Who did it: "gpu", or "cpu"
    // where 31 bits are too few.
    cast(model, palette, view, light8, outline) {
        const { gl, file } = this, lit = Lattice.litPalette(palette, light8);
        this.resize(view.size);
        if (!Lattice.isNarrow(view, model.size)) {
            this.upload(Lattice.cast(file, model, view, lit, outline));
            return "cpu";
        }
        gl.activeTexture(gl.TEXTURE0);
        gl.bindTexture(gl.TEXTURE_2D, this.palette);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 256, 3, gl.RGBA_INTEGER, gl.UNSIGNED_BYTE, lit);
        const p = this.castProgram, [w, h] = view.size;
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.rays.framebuffer);
        gl.viewport(0, 0, w, h);
        this.bind(p, { octree: this.octree, lit_palette: this.palette });
        gl.uniform1i(p.at("width"), 2048);
        gl.uniform1i(p.at("node_offset"), model.nodeOffset);
        gl.uniform1i(p.at("payload_offset"), file.nodeCount + 2 * model.payloadOffset);
        gl.uniform1i(p.at("max_depth"), model.maxDepth);
        gl.uniform1i(p.at("position_bits"), view.bits);
        gl.uniform3iv(p.at("model_size"), model.size);
        gl.uniform3iv(p.at("origin"),
            view.C.map((c, k) => c - Math.floor(model.size[k] / 2) * 2 ** view.bits));
        gl.uniform3iv(p.at("right"), view.U);
        gl.uniform3iv(p.at("up"), view.V);
        gl.uniform3iv(p.at("direction"), view.D);
        gl.uniform2iv(p.at("first"), view.first);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.finished.framebuffer);
        this.bind(this.outlineProgram, { colours: this.rays.textures[0], ids: this.rays.textures[1] });
        gl.uniform4uiv(this.outlineProgram.at("outline"), outline ? [...outline, 255] : [0, 0, 0, 0]);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        return "gpu";
    }

    // Rows of textures run upward, those of sprites downward.
    upload({ size: [w, h], colours, ids }) {
        const { gl } = this, [first, second] = this.finished.textures;
        gl.activeTexture(gl.TEXTURE0);
        for (let y = 0; y < h; ++y) {
            const row = (h - 1 - y) * w;
            gl.bindTexture(gl.TEXTURE_2D, first);
            gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, y, w, 1, gl.RGBA_INTEGER, gl.UNSIGNED_BYTE,
                colours.subarray(4 * row, 4 * (row + w)));
            gl.bindTexture(gl.TEXTURE_2D, second);
            gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, y, w, 1, gl.RED_INTEGER, gl.UNSIGNED_INT,
                ids.subarray(row, row + w));
        }
    }

    // The finished sprite as bytes: RGBA rows, and ids (32 bits, as the machine has them).
    read() {
        const { gl } = this, [w, h] = this.size;
        const colours = new Uint8Array(4 * w * h), ids = new Uint32Array(w * h);
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.finished.framebuffer);
        gl.readBuffer(gl.COLOR_ATTACHMENT0);
        // Integers are read as 32 bits a channel.
        const wide = new Uint32Array(4 * w * h);
        gl.readPixels(0, 0, w, h, gl.RGBA_INTEGER, gl.UNSIGNED_INT, wide);
        for (let y = 0; y < h; ++y) {
            colours.set(wide.subarray(4 * w * y, 4 * w * (y + 1)), 4 * w * (h - 1 - y));
        }
        gl.readBuffer(gl.COLOR_ATTACHMENT1);
        gl.readPixels(0, 0, w, h, gl.RGBA_INTEGER, gl.UNSIGNED_INT, wide);
        for (let y = 0; y < h; ++y) {
            const row = w * (h - 1 - y);
            for (let x = 0; x < w; ++x) ids[row + x] = wide[4 * (w * y + x)];
        }
        gl.readBuffer(gl.COLOR_ATTACHMENT0);
        return { size: [w, h], colours, ids };
    }
}
