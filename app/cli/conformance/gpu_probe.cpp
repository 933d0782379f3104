#include "app/cli/conformance/gpu_probe.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/sprite/composite.h"

namespace voxprite::conformance {
namespace {

constexpr glm::ivec2 kWindow{32, 24};
constexpr glm::ivec2 kScreen{64, 64};
constexpr std::int64_t kMostComposed = 200'000;  // virtual pixels
constexpr Rgba8 kBackground{10, 20, 200, 255};

// Materials of all subjects, on all faces, and no two alike.
LitPalette testPalette() {
    return litPalette(Palette::standard(), {255, 190, 140}, Outline{});
}

std::uint64_t differences(const Image& a, const Image& b) {
    std::uint64_t count = 0;
    for (std::size_t at = 0; at < a.pixels.size(); ++at)
        count += a.pixels[at] != b.pixels[at] ? 1 : 0;
    return count;
}

bool isOneOf(Rgba8 colour, const LitPalette& lit) {
    if (colour == kBackground || colour == lit.outline.colour) return true;
    for (std::uint8_t axis = 0; axis < 3; ++axis)
        for (int material = 1; material < 256; ++material)
            if (lit.shade(static_cast<std::uint8_t>(material), axis) == colour) return true;
    return false;
}

}  // namespace

GpuProbe::GpuProbe() {
    Result<gl::HeadlessContext> context = gl::HeadlessContext::create();
    if (!context) {
        missing_ = context.error().describe();
        return;
    }
    context_.emplace(std::move(*context));
    Result<SceneRenderer> renderer = SceneRenderer::create();
    if (!renderer) {
        missing_ = renderer.error().describe();
        return;
    }
    renderer_ = std::make_unique<SceneRenderer>(std::move(*renderer));
    frame_ = std::make_unique<Frame>(kScreen);
}

const GpuOctree& GpuProbe::uploaded(const Subject& subject) {
    const auto [entry, isNew] = octrees_.try_emplace(subject.name);
    if (isNew) entry->second.upload(subject.octree.view());
    return entry->second;
}

void GpuProbe::failed(const std::string& what) {
    if (firstFailure_.empty()) firstFailure_ = what;
}

void GpuProbe::compare(const Subject& subject, const LatticeView& lattice, SpriteMode mode,
                       Buffers& sums) {
    const LitPalette lit = testPalette();
    const SpriteBuffer cpu = castSprite(subject.octree.view(), lattice, lit);
    const auto gpu = renderer_->castBuffer(uploaded(subject), lattice, lit, mode);
    ++sums.buffers;
    sums.pixels += cpu.ids.size();
    if (!gpu || gpu->ids.size() != cpu.ids.size()) {
        sums.differing += cpu.ids.size();
        failed(subject.name + ": " + (gpu ? "another size" : gpu.error().describe()));
        return;
    }
    std::uint64_t differing = 0;
    for (std::size_t at = 0; at < cpu.ids.size(); ++at)
        differing += cpu.ids[at] != gpu->ids[at] || cpu.colours[at] != gpu->colours[at] ? 1 : 0;
    if (differing > 0) failed(subject.name + ": the buffers of processor and OpenGL differ");
    sums.differing += differing;
}

void GpuProbe::compareWindow(const Subject& subject, const LatticeView& lattice) {
    if (!missing_.empty() || lattice.size.x <= 0 || lattice.size.y <= 0) return;
    LatticeView window = lattice;
    window.size = glm::min(lattice.size, kWindow);
    const glm::dvec2 room(lattice.size - window.size + 1);
    window.first += glm::ivec2(glm::dvec2(random_.unit(), random_.unit()) * room);
    compare(subject, window,
            windows_.buffers % 2 == 0 ? SpriteMode::spriteBuffer : SpriteMode::singlePass,
            windows_);
}

void GpuProbe::compareWhole(const Subject& subject, const LatticeView& lattice) {
    if (!missing_.empty()) return;
    compare(subject, lattice, SpriteMode::spriteBuffer, wholes_);
}

std::optional<Image> GpuProbe::drawn(const Scene& scene, const Camera& camera,
                                     const GameProfile& profile, SpriteMode mode,
                                     const LitPalette& lit) {
    const Result<SceneStats> stats = renderer_->draw(*frame_, scene, camera, profile, mode);
    if (!stats) {
        failed(stats.error().describe());
        return std::nullopt;
    }
    Image image = frame_->readColour();
    for (const float depth : frame_->readDepth())
        screens_.notANumber += depth >= 0.0f && depth <= 1.0f ? 0 : 1;
    for (const Rgba8 colour : image.pixels)
        if (colour != kBackground && !isOneOf(colour, lit)) ++screens_.notANumber;
    return image;
}

void GpuProbe::draw(const Subject& subject, const PlacedEntity& entity, Camera camera,
                    GameProfile profile) {
    if (!missing_.empty()) return;
    camera.viewportPx = kScreen;
    profile.sigma = std::min(profile.sigma, 1.0);
    const auto seen = viewSprite(entity, camera, profile);
    if (!seen || !seen->view) return;
    const SpriteView& view = *seen->view;
    const LatticeView visible = visibleLattice(view, camera);
    const LitPalette lit = litPalette(palette_, view.light8, profile.outline);

    Scene scene;
    scene.background = kBackground;
    SceneEntity one;
    one.octree = &uploaded(subject);
    one.palette = &palette_;
    one.placed = entity;
    scene.entities.push_back(one);
    const auto buffered = drawn(scene, camera, profile, SpriteMode::spriteBuffer, lit);
    const auto single = drawn(scene, camera, profile, SpriteMode::singlePass, lit);
    ++screens_.frames;
    if (!buffered || !single) {
        screens_.notANumber += 1;
        return;
    }
    const Image empty(kScreen.x, kScreen.y, kBackground);
    screens_.pixels += differences(*buffered, empty);
    screens_.modesDiffer += differences(*buffered, *single);
    if (std::int64_t{visible.size.x} * visible.size.y > kMostComposed) return;
    const SpriteBuffer buffer = castSprite(subject.octree.view(), visible, lit);
    const std::array<CompositeSprite, 1> sprites{CompositeSprite{&view, &buffer, nullptr}};
    screens_.unlikeProcessor += differences(*buffered, composite(sprites, camera, kBackground));
}

}  // namespace voxprite::conformance
