// The small scene: sky, ground with its grid and a shadow, and the sprite standing in it.
//
// Voxel space: Z up, the model's minimum corner at the origin. The camera turns about the model's
// centre and looks at it, so the rays of the sprite run as it looks.
"use strict";

const backdropShader = version + `
uniform vec3 eye, right, up, ahead, foot;  // right and up reach to the picture's edge
uniform vec2 screen, half_size;
uniform float radius, cell;
layout(location = 0) out vec4 colour;

float lines(vec2 at, float width, vec2 footprint) {
    vec2 wide = max(vec2(width), footprint);
    vec2 off = abs(fract(at - 0.5) - 0.5);
    vec2 line = (1.0 - smoothstep(0.5 * wide - 0.5 * footprint, 0.5 * wide + 0.5 * footprint, off)) *
                (width / wide);
    return max(line.x, line.y);
}

void main() {
    vec2 at = 2.0 * gl_FragCoord.xy / screen - 1.0;
    vec3 ray = normalize(ahead + at.x * right + at.y * up);
    vec3 haze = vec3(0.745, 0.795, 0.80);
    vec3 sky = mix(haze, vec3(0.39, 0.53, 0.66), smoothstep(0.0, 0.6, ray.z));
    float t = (foot.z - eye.z) / ray.z;
    vec2 spot = eye.xy + t * ray.xy - foot.xy;
    vec2 footprint = fwidth(spot / cell);
    float away = length(spot) / radius;
    vec3 ground = vec3(0.478, 0.560, 0.430);
    float near = exp(-away * 0.35);
    ground *= 1.0 - 0.16 * near * lines(spot / cell + 0.5, 0.02, footprint);
    float shadow = length(spot / (half_size + 0.12 * radius));
    ground *= 1.0 - 0.46 * (1.0 - smoothstep(0.25, 1.0, shadow));
    ground = mix(ground, haze, 1.0 - exp(-max(0.0, away - 1.4) * 0.16));
    colour = vec4(ray.z < 0.0 && t > 0.0 ? ground : sky, 1.0);
}`;

const quadShader = version + `
uniform mat4 clip_from_pixel;
uniform ivec2 sprite_size;
out vec2 pixel;
void main() {
    pixel = vec2(sprite_size) * vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = clip_from_pixel * vec4(pixel, 0.0, 1.0);
}`;

const blitShader = version + `
uniform usampler2D sprite;
in vec2 pixel;
layout(location = 0) out vec4 colour;
void main() {
    ivec2 at = clamp(ivec2(floor(pixel)), ivec2(0), textureSize(sprite, 0) - 1);
    uvec4 word = texelFetch(sprite, at, 0);
    if (word.a == 0u) discard;
    colour = vec4(word) / 255.0;
}`;

class Scene {
    constructor(gl, caster) {
        this.gl = gl;
        this.caster = caster;
        this.backdrop = makeProgram(gl, triangleShader, backdropShader);
        this.blit = makeProgram(gl, quadShader, blitShader);
        this.yaw = 34;   // degrees: at 0 the eye is on the model's -Y side
        this.pitch = 20;
        this.zoom = 1;
        this.last = "";  // what the sprite in the caster was made of
    }

    // Draws a model of an entity of the file that the caster has open; tells how: { sigma in force,
    // size, by, milliseconds } or { refused }.
    draw(entity, model, sigma, width, height) {
        const radians = Math.PI / 180, focal = 2.6, aspect = width / height;
        const cy = Math.cos(this.yaw * radians), sy = Math.sin(this.yaw * radians);
        const cp = Math.cos(this.pitch * radians), sp = Math.sin(this.pitch * radians);
        const right = [cy, sy, 0], up = [-sy * sp, cy * sp, cp], ahead = [-sy * cp, cy * cp, -sp];
        const centre = model.size.map((length) => length / 2);
        const radius = Math.hypot(...centre) + 1, distance = 3.0 * Math.max(1, 1 / aspect) * radius / this.zoom;
        const eye = centre.map((c, k) => c - ahead[k] * distance);
        // Below a screen pixel a virtual pixel: half as many.
        const screenPixels = focal * height / 2 / distance;
        while (sigma > 0.25 && screenPixels < sigma) sigma /= 2;

        this.drawBackdrop({ eye, right, up, ahead, centre, radius, model, width, height, focal, aspect });
        const view = Lattice.fromAxes({ right, up, forward: ahead }, sigma, model.size);
        if (model.size[0] === 0) return { sigma, size: [0, 0], by: "gpu" };
        if (!view || !this.caster.canShow(view)) return { refused: "this view has too many pixels" };
        const told = this.castWhenNew(entity, model, view);

        // The sprite stands in the plane through the centre, across the rays; pixels count from the
        // corner floor(size / 2).
        const { gl } = this, offset = Lattice.sampleOffset(sigma);
        const corner = model.size.map((length, k) => Math.floor(length / 2) - centre[k]);
        const along = (axis) => corner.reduce((sum, c, k) => sum + c * axis[k], 0);
        const x = along(right) + (view.first[0] - 0.5 + offset) / sigma;
        const y = along(up) + (view.first[1] - 0.5 + offset) / sigma;
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.viewport(0, 0, width, height);
        this.caster.bind(this.blit, { sprite: this.caster.finished.textures[0] });
        gl.uniformMatrix4fv(this.blit.at("clip_from_pixel"), false, [
            focal / aspect / sigma, 0, 0, 0, 0, focal / sigma, 0, 0, 0, 0, 0, 0,
            focal / aspect * x, focal * y, 0, distance]);
        gl.uniform2iv(this.blit.at("sprite_size"), view.size);
        gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
        return { sigma, size: view.size, ...told };
    }

    // A sprite is a pure function of model, view and light: what is the same needs no ray.
    castWhenNew(entity, model, view) {
        const light8 = Lattice.faceLight(view.D, [0.35, -0.55, 0.8], 0.55);
        const what = JSON.stringify([entity.models.indexOf(model), view, light8]);
        if (what !== this.last || entity !== this.lastEntity) {
            const { palette, authored } = entity;
            this.by = this.caster.cast(model, palette, view, light8, authored.outline);
            this.last = what;
            this.lastEntity = entity;
        }
        return { by: this.by };
    }

    drawBackdrop({ eye, right, up, ahead, centre, radius, model, width, height, focal, aspect }) {
        const { gl } = this, p = this.backdrop;
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.viewport(0, 0, width, height);
        gl.useProgram(p.program);
        gl.uniform3fv(p.at("eye"), eye);
        gl.uniform3fv(p.at("right"), right.map((c) => c * aspect / focal));
        gl.uniform3fv(p.at("up"), up.map((c) => c / focal));
        gl.uniform3fv(p.at("ahead"), ahead);
        gl.uniform3fv(p.at("foot"), [centre[0], centre[1], 0]);
        gl.uniform2fv(p.at("half_size"), [model.size[0] / 2, model.size[1] / 2]);
        gl.uniform2fv(p.at("screen"), [width, height]);
        gl.uniform1f(p.at("radius"), radius);
        gl.uniform1f(p.at("cell"), 2 ** Math.max(1, Math.round(Math.log2(radius / 3))));
        gl.drawArrays(gl.TRIANGLES, 0, 3);
    }
}
