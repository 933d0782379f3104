// The page itself: files come in, the scene is turned, sigma is chosen.
"use strict";

const Page = (() => {
    const at = (id) => document.getElementById(id);
    const sigmas = [0.5, 1, 1.5, 2, 3, 4, 6, 8, 12, 16];
    const canvas = at("scene");
    const gl = canvas.getContext("webgl2", { antialias: false, alpha: false, depth: false });
    let file = null, entity = null, scene = null, stale = true, paused = false, turning = false;
    let clipMilliseconds = 0, before = 0, held = null, still = "", refused = false;

    function say(text, wrong = false) {
        at("said").textContent = text;
        at("said").classList.toggle("wrong", wrong);
        refused = false;
    }

    function showFacts() {
        const model = shownModel(), size = model.size.join(" × ");
        const height = model.size[2] * entity.authored.voxelSizeMetres;
        const clips = entity.clips.length > 0 ? `, ${entity.clips[0].frames.length} frames` : "";
        at("name").textContent = entity.authored.name || still || "untitled";
        at("facts").textContent = `${size} voxels, ${Number(height.toPrecision(3))} m high${clips}`;
    }

    function open(buffer, name) {
        let next;
        try {
            next = Svo.read(buffer);
            scene.caster.open(next);
        } catch (error) {
            const place = error instanceof Svo.Refused ? ` (byte ${error.offset})` : "";
            say(`${name}: ${error.message}${place}`, true);
            return false;
        }
        file = next;
        still = name;
        at("entity-row").hidden = file.entities.length === 1;
        at("entity").replaceChildren(...file.entities.map(({ authored }, i) =>
            new Option(authored.name || `entity ${i + 1}`, i)));
        show(0);
        return true;
    }

    // Another entity of the file.
    function show(index) {
        entity = file.entities[index];
        at("entity").value = index;
        clipMilliseconds = 0;
        const nearest = sigmas.reduce((best, sigma, i) =>
            (Math.abs(Math.log(sigma / entity.authored.sigma)) <
                Math.abs(Math.log(sigmas[best] / entity.authored.sigma)) ? i : best), 0);
        at("sigma").value = nearest;
        at("play").hidden = entity.clips.length === 0;
        at("model-row").hidden = entity.clips.length > 0 || entity.models.length === 1;
        at("model").max = entity.models.length - 1;
        at("model").value = 0;
        say("");
        showFacts();
        stale = true;
    }

    async function openFile(chosen) {
        if (!chosen) return;
        try {
            open(await chosen.arrayBuffer(), chosen.name);
        } catch {
            say(`${chosen.name}: cannot be read`, true);
        }
    }

    // What the first clip shows now; without clips the model that is chosen.
    function shownModel() {
        if (entity.clips.length === 0) return entity.models[Number(at("model").value)];
        const { frames, loops } = entity.clips[0];
        const all = frames.reduce((sum, frame) => sum + frame.milliseconds, 0);
        let now = loops ? clipMilliseconds % all : Math.min(clipMilliseconds, all - 1);
        for (const frame of frames) {
            now -= frame.milliseconds;
            if (now < 0) return file.models[frame.model];
        }
        return file.models[frames[0].model];
    }

    function draw() {
        const scale = window.devicePixelRatio || 1;
        const width = Math.max(1, Math.round(canvas.clientWidth * scale));
        const height = Math.max(1, Math.round(canvas.clientHeight * scale));
        if (canvas.width !== width || canvas.height !== height) {
            canvas.width = width;
            canvas.height = height;
        }
        const sigma = sigmas[Number(at("sigma").value)];
        const told = scene.draw(entity, shownModel(), sigma, width, height);
        if (told.refused) {
            say(told.refused, true);
            refused = true;
            return;
        }
        // What went wrong with a file stays until something else is said.
        if (refused) say("");
        at("sigma-value").textContent = told.sigma === sigma ? `${sigma}` : `${sigma} (${told.sigma})`;
        at("model-value").textContent = `${Number(at("model").value) + 1} of ${entity.models.length}`;
        if (at("said").classList.contains("wrong")) return;
        say(`${told.size.join(" × ")} virtual pixels` + (told.by === "cpu"
            ? ". Too large for WebGL's 31 bits: cast, as exactly, by the processor" : ""));
    }

    function frame(now) {
        const passed = Math.min(now - before, 100);
        before = now;
        if (entity.clips.length > 0 && !paused) {
            const shown = shownModel();
            clipMilliseconds += passed;
            stale = stale || shownModel() !== shown;
        }
        if (turning) {
            scene.yaw += passed * 0.02;
            stale = true;
        }
        if (stale) {
            stale = false;
            draw();
        }
        requestAnimationFrame(frame);
    }

    function turn(x, y) {
        scene.yaw -= x;
        scene.pitch = Math.min(Math.max(scene.pitch + y, -90), 90);
        stale = true;
    }

    function listen() {
        canvas.addEventListener("pointerdown", (event) => {
            held = event;
            canvas.setPointerCapture(event.pointerId);
            canvas.classList.add("held");
        });
        canvas.addEventListener("pointermove", (event) => {
            if (!held || event.pointerId !== held.pointerId) return;
            turn((event.clientX - held.clientX) * 0.4, (event.clientY - held.clientY) * 0.4);
            held = event;
        });
        for (const end of ["pointerup", "pointercancel"]) {
            canvas.addEventListener(end, () => {
                held = null;
                canvas.classList.remove("held");
            });
        }
        canvas.addEventListener("wheel", (event) => {
            event.preventDefault();
            scene.zoom = Math.min(Math.max(scene.zoom * 1.0015 ** -event.deltaY, 0.05), 2.4);
            stale = true;
        }, { passive: false });
        canvas.addEventListener("keydown", (event) => {
            const step = { ArrowLeft: [-5, 0], ArrowRight: [5, 0], ArrowUp: [0, 5], ArrowDown: [0, -5] };
            if (event.key === " ") at("play").click();
            if (!step[event.key] && event.key !== " ") return;
            event.preventDefault();
            if (step[event.key]) turn(...step[event.key]);
        });
        at("sigma").addEventListener("input", () => { say(""); stale = true; });
        at("entity").addEventListener("input", () => show(Number(at("entity").value)));
        at("model").addEventListener("input", () => { showFacts(); stale = true; });
        at("file").addEventListener("change", (event) => openFile(event.target.files[0]));
        at("play").addEventListener("click", () => {
            paused = !paused;
            at("play").textContent = paused ? "Play" : "Pause";
        });
        at("turn").addEventListener("click", () => {
            turning = !turning;
            at("turn").textContent = turning ? "Stand still" : "Turntable";
        });
        window.addEventListener("resize", () => { stale = true; });
        window.addEventListener("dragover", (event) => {
            event.preventDefault();
            at("drop").classList.add("over");
        });
        window.addEventListener("dragleave", (event) => {
            if (!event.relatedTarget) at("drop").classList.remove("over");
        });
        window.addEventListener("drop", (event) => {
            event.preventDefault();
            at("drop").classList.remove("over");
            openFile(event.dataTransfer.files[0]);
        });
    }

    if (!gl) {
        say("This browser has no WebGL2, which the sprites are cast with.", true);
        return {};
    }
    scene = new Scene(gl, new SpriteCaster(gl));
    open(Uint8Array.from(atob(sampleSvo), (c) => c.charCodeAt(0)).buffer, "walk.svo");
    listen();
    draw();
    requestAnimationFrame(frame);
    return { scene, open, draw, gl };
})();
