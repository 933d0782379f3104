// Drives the page of samples/web in the tests: casts all jobs with it, reads the conformance set,
// and uses it as a person would. What came of it is written into the document.
"use strict";

(() => {
    const bytesOf = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));

    // The fractions of square and cube roots of primes, from whole numbers alone.
    const primes = [];
    for (let n = 2; primes.length < 64; ++n) {
        if (primes.every((p) => n % p !== 0)) primes.push(n);
    }
    const fraction = (n, degree) => {
        let root = 0n;
        for (let bit = 1n << 40n; bit > 0n; bit >>= 1n) {
            if ((root + bit) ** BigInt(degree) <= BigInt(n) << BigInt(32 * degree)) root += bit;
        }
        return Number(root & 0xffffffffn) | 0;
    };
    const rounds = Int32Array.from(primes, (p) => fraction(p, 3));
    const first = Int32Array.from(primes.slice(0, 8), (p) => fraction(p, 2));

    function sha256(bytes) {
        const k = rounds, h = first.slice(), turn = (x, n) => (x >>> n) | (x << (32 - n));
        const padded = new Uint8Array(Math.ceil((bytes.length + 9) / 64) * 64);
        padded.set(bytes);
        padded[bytes.length] = 0x80;
        const data = new DataView(padded.buffer);
        data.setUint32(padded.length - 8, Math.floor(bytes.length / 2 ** 29));
        data.setUint32(padded.length - 4, (bytes.length * 8) >>> 0);
        const w = new Int32Array(64);
        for (let block = 0; block < padded.length; block += 64) {
            for (let i = 0; i < 16; ++i) w[i] = data.getInt32(block + 4 * i);
            for (let i = 16; i < 64; ++i) {
                const a = w[i - 15], b = w[i - 2];
                w[i] = w[i - 16] + (turn(a, 7) ^ turn(a, 18) ^ (a >>> 3)) + w[i - 7] +
                    (turn(b, 17) ^ turn(b, 19) ^ (b >>> 10));
            }
            let a = h[0], b = h[1], c = h[2], d = h[3], e = h[4], f = h[5], g = h[6], j = h[7];
            for (let i = 0; i < 64; ++i) {
                const t1 = (j + (turn(e, 6) ^ turn(e, 11) ^ turn(e, 25)) + ((e & f) ^ (~e & g)) +
                    k[i] + w[i]) | 0;
                const t2 = ((turn(a, 2) ^ turn(a, 13) ^ turn(a, 22)) +
                    ((a & b) ^ (a & c) ^ (b & c))) | 0;
                j = g;
                g = f;
                f = e;
                e = (d + t1) | 0;
                d = c;
                c = b;
                b = a;
                a = (t1 + t2) | 0;
            }
            h[0] += a;
            h[1] += b;
            h[2] += c;
            h[3] += d;
            h[4] += e;
            h[5] += f;
            h[6] += g;
            h[7] += j;
        }
        return Array.from(h, (x) => (x >>> 0).toString(16).padStart(8, "0")).join("");
    }

    function hashesOf({ size, colours, ids }) {
        return `${size[0]}x${size[1]} ${sha256(colours)} ${sha256(new Uint8Array(ids.buffer))}`;
    }

    // Sprites on their way back from the GPU. Each wait for a software driver costs as much as a
    // dozen sprites, so they are all packed into one buffer and waited for once.
    class Packed {
        constructor(gl, pixels) {
            this.gl = gl;
            this.sizes = [];
            this.end = 0;
            this.buffer = gl.createBuffer();
            gl.bindBuffer(gl.PIXEL_PACK_BUFFER, this.buffer);
            gl.bufferData(gl.PIXEL_PACK_BUFFER, Math.max(32 * pixels, 16), gl.STREAM_READ);
            gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
        }
        // What the caster has finished. Integers are read as 32 bits a channel.
        add({ finished, size: [w, h] }) {
            const { gl } = this;
            gl.bindFramebuffer(gl.FRAMEBUFFER, finished.framebuffer);
            gl.bindBuffer(gl.PIXEL_PACK_BUFFER, this.buffer);
            for (const attachment of [gl.COLOR_ATTACHMENT1, gl.COLOR_ATTACHMENT0]) {
                gl.readBuffer(attachment);
                gl.readPixels(0, 0, w, h, gl.RGBA_INTEGER, gl.UNSIGNED_INT, this.end);
                this.end += 16 * w * h;
            }
            gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
            this.sizes.push([w, h]);
        }
        // As SpriteCaster.read() gives them, in their order.
        all() {
            const { gl } = this, words = new Uint32Array(this.end / 4);
            gl.bindBuffer(gl.PIXEL_PACK_BUFFER, this.buffer);
            gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, words);
            gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
            gl.deleteBuffer(this.buffer);
            let at = 0;
            return this.sizes.map(([w, h]) => {
                const ids = new Uint32Array(w * h), colours = new Uint8Array(4 * w * h);
                const rgba = at + 4 * w * h;
                for (let y = 0; y < h; ++y) {
                    for (let x = 0; x < w; ++x) {
                        const to = w * (h - 1 - y) + x, from = 4 * (w * y + x);
                        ids[to] = words[at + from];
                        for (let k = 0; k < 4; ++k) colours[4 * to + k] = words[rgba + from + k];
                    }
                }
                at = rgba + 4 * w * h;
                return { size: [w, h], colours, ids };
            });
        }
    }

    function castJobs(caster) {
        let count = 0;
        return jobs.sets.map(({ svo, jobs: list }) => {
            const file = Svo.read(bytesOf(svo).buffer);
            caster.open(file);
            const views = list.map(({ shot: { lattice } }) => Lattice.fromJson(lattice));
            const packed = new Packed(caster.gl,
                views.reduce((sum, { size }) => sum + size[0] * size[1], 0));
            const told = list.map(({ entity, model, shot: { lit } }, i) => {
                const { models, palette } = file.entities[entity], view = views[i];
                const by = caster.cast(models[model], palette, view, lit.light8, lit.outline);
                packed.add(caster);
                if (++count % 7 !== 0 || by !== "gpu" || view.size[0] * view.size[1] >= 8000) {
                    return { by };
                }
                // The processor casts some of those too that it need not, and the page's own way
                // of reading gives the same.
                return { by, read: hashesOf(caster.read()),
                    processor: hashesOf(Lattice.cast(file, models[model], view,
                        Lattice.litPalette(palette, lit.light8), lit.outline)) };
            });
            packed.all().forEach((sprite, i) => { told[i].hashes = hashesOf(sprite); });
            return told;
        });
    }

    // What index.json tells of an entity of a set.
    function toldOf({ authored, palette, models, clips, sockets }) {
        const colours = [];
        for (let i = 0; i < 256; ++i) {
            const rgba = [...palette.slice(4 * i, 4 * i + 4)];
            if (rgba.some((channel) => channel !== 0)) colours.push([i, ...rgba]);
        }
        return {
            name: authored.name, anchor: authored.anchor, colours,
            models: models.length, clips: clips.length, sockets: sockets.length,
        };
    }

    // All that is wrong with one file of the conformance set.
    function faultsOf({ svo, entry }) {
        let file = null;
        try {
            file = Svo.read(bytesOf(svo).buffer);
        } catch (error) {
            const refused = error instanceof Svo.Refused && error.offset >= 0;
            return refused && !entry.valid ? [] : [`${entry.file}: ${error}`];
        }
        if (!entry.valid) return [`${entry.file} was accepted`];
        const models = file.models.map((m) => ({
            name: m.name, size: m.size, origin: m.origin, max_depth: m.maxDepth,
            nodes: m.nodes, payloads: m.payloads,
        }));
        const { entities } = file;
        const clips = entities.flatMap((e) => e.clips).map((c) => ({
            name: c.name, loops: c.loops, frames: c.frames.map((f) => [f.model, f.milliseconds]),
        }));
        const flat = (value) => JSON.stringify(value, (_, v) =>
            (v && typeof v === "object" && !Array.isArray(v)
                ? Object.fromEntries(Object.entries(v).sort()) : v));
        const faults = [];
        const expect = (what, mine, theirs) => {
            if (flat(mine) !== flat(theirs)) faults.push(`${entry.file}: ${what} ${flat(mine)}`);
        };
        expect("models", models, entry.models.map(({ voxels, ...rest }) => rest));
        expect("clips", clips, entry.clips);
        expect("sockets", entities.flatMap((e) => e.sockets), entry.sockets);
        if (entry.entities) expect("entities", entities.map(toldOf), entry.entities);
        entry.models.forEach(({ voxels, size }, i) => {
            const solid = new Map(voxels.map(([x, y, z, m]) => [`${x},${y},${z}`, m]));
            const far = Math.max(...size) > 64;
            const cells = far ? voxels : [];
            for (let z = 0; z <= size[2] && !far; ++z) {
                for (let y = 0; y <= size[1]; ++y) {
                    for (let x = 0; x <= size[0]; ++x) cells.push([x, y, z]);
                }
            }
            for (const [x, y, z] of cells) {
                const mine = Svo.voxel(file, file.models[i], x, y, z);
                if (mine !== (solid.get(`${x},${y},${z}`) ?? 0)) faults.push(`${entry.file}: voxel`);
            }
        });
        return faults;
    }

    // The browser reads dropped files in its own time, which a page that is being dumped does not
    // wait for: here their bytes are at hand.
    async function drop(bytes, name) {
        const transfer = new DataTransfer();
        transfer.items.add(new File([bytes], name));
        const file = transfer.files[0];
        File.prototype.arrayBuffer = async () => bytes.buffer;
        Object.defineProperty(transfer, "files", { value: [file] });
        const event = new DragEvent("drop", { dataTransfer: transfer, cancelable: true });
        Object.defineProperty(event, "dataTransfer", { value: transfer });
        window.dispatchEvent(event);
        for (let i = 0; i < 20; ++i) await null;
    }

    // As a person: nothing but events, and what the page says.
    async function usePage() {
        const wrong = [], at = (id) => document.getElementById(id), { scene } = Page;
        let checks = 0;
        const check = (holds, what) => {
            ++checks;
            if (!holds) wrong.push(`${what}: ${at("name").textContent}; ${at("said").textContent}`);
        };
        const oak = bytesOf(jobs.sets[1].svo);
        Page.open(bytesOf(sampleSvo).buffer, "walk.svo");
        check(at("name").textContent === "knight" && !at("play").hidden, "starts with the sample");
        await drop(oak, "oak.svo");
        check(at("name").textContent === "oak.svo" && at("play").hidden, "opens what is dropped");
        check(/voxels/.test(at("facts").textContent) && at("said").className === "dim", "says so");
        const broken = jobs.conformance.find((c) => c.entry.file === "cycle.svo");
        await drop(bytesOf(broken.svo), "cycle.svo");
        check(at("said").classList.contains("wrong") && /cycle.svo.*byte/.test(at("said").textContent),
            "refuses what is broken");
        check(at("name").textContent === "oak.svo", "keeps the one before");
        const set = jobs.conformance.find((c) => c.entry.file === "set.svo");
        check(at("entity-row").hidden, "asks for no entity where there is one");
        await drop(bytesOf(set.svo), "set.svo");
        check(!at("entity-row").hidden && at("entity").options.length === 3 &&
            at("name").textContent === "step", "lists the entities of a set");
        at("entity").value = 1;
        at("entity").dispatchEvent(new Event("input"));
        check(at("name").textContent === "lively" && !at("play").hidden, "shows another entity");
        await drop(oak, "oak.svo");
        check(at("entity-row").hidden && at("name").textContent === "oak.svo", "and one file again");
        const { yaw } = scene;
        const canvas = at("scene"), move = (type, x) => canvas.dispatchEvent(
            new PointerEvent(type, { pointerId: 1, clientX: x, clientY: 300, bubbles: true }));
        canvas.setPointerCapture = () => {};
        move("pointerdown", 300);
        move("pointermove", 400);
        move("pointerup", 400);
        check(Math.abs(scene.yaw - (yaw - 40)) < 1e-9, "turns");
        at("sigma").value = 3;
        at("sigma").dispatchEvent(new Event("input"));
        const file = Svo.read(oak.buffer), [entity] = file.entities;
        const told = scene.draw(entity, file.models[0], 2, 1280, 800);
        check(told.sigma === 2 && told.by === "gpu", "draws");
        const refused = () => at("said").classList.contains("wrong");
        scene.draw = () => ({ refused: "this view has too many pixels" });
        Page.draw();
        check(refused(), "says what it cannot draw");
        delete scene.draw;
        Page.draw();
        check(!refused(), "and no longer when it can");
        // Every colour of the sprite shows, exactly.
        const { gl } = Page, seen = new Set(), words = new Uint8Array(4 * 1280 * 800);
        canvas.width = 1280;
        canvas.height = 800;
        scene.draw(entity, file.models[0], 2, 1280, 800);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.readPixels(0, 0, 1280, 800, gl.RGBA, gl.UNSIGNED_BYTE, words);
        for (const word of new Uint32Array(words.buffer)) seen.add(word);
        const { colours } = scene.caster.read();
        const missing = new Set(new Uint32Array(colours.buffer).filter((c) => c && !seen.has(c)));
        check(missing.size === 0, `shows every colour but ${missing.size}`);
        // The shaders for engines compile here, too.
        const part = (name) => `${version}#define ${name}\n${jobs.shaders}`;
        makeProgram(gl, part("SPRITE_VERTEX"), part("SPRITE_CAST"));
        makeProgram(gl, part("SPRITE_VERTEX"), part("SPRITE_OUTLINE"));
        makeProgram(gl, part("SPRITE_QUAD"), part("SPRITE_BLIT"));
        check(gl.getError() === gl.NO_ERROR, "makes no GL errors");
        return { page: wrong, page_checks: checks };
    }

    // Views whose integers are not those of core.
    function quantisedOtherwise() {
        return jobs.views.filter(({ basis, sigma, size, lattice }) => {
            const view = Lattice.fromAxes(basis, sigma, size);
            return Object.entries(Lattice.fromJson(lattice)).some(([key, value]) =>
                JSON.stringify(view[key]) !== JSON.stringify(value));
        });
    }

    async function run() {
        const result = { sets: castJobs(new SpriteCaster(Page.gl)) };
        result.conformance = jobs.conformance.flatMap(faultsOf);
        result.conformed = jobs.conformance.length;
        result.views = quantisedOtherwise();
        return Object.assign(result, await usePage());
    }

    run().catch((error) => ({ error: `${error} ${error.stack}` })).then((result) => {
        const out = document.createElement("pre");
        // Nothing that HTML would escape may stand in it.
        out.textContent = `RESULT[${JSON.stringify(result).replace(/[<>&]/g, "?")}]RESULT`;
        document.body.append(out);
    });
})();
