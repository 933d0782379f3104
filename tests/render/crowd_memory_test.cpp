// What is remembered from frame to frame, evicted, and drawn at once: none of it shows.
#include <functional>
#include <set>

#include "render/lit_rows.h"
#include "tests/render/crowd_support.h"

namespace voxprite {
namespace {

using test::kBackground;
using test::kViewport;
using test::mismatches;
using test::must;
using test::plainProfile;

class CrowdMemory : public test::Crowds {
  protected:
    // The crowd in three palettes.
    Scene colourful(int count, const GameProfile& profile) {
        Scene scene = rows(count, profile);
        for (std::size_t k = 0; k < scene.entities.size(); ++k) {
            scene.entities[k].palette = &palettes_[k / 2 % palettes_.size()];
        }
        return scene;
    }
    // By a renderer that remembers nothing.
    Picture afresh(const Scene& scene, const Camera& view, const GameProfile& profile,
                   SpriteMode mode) {
        SceneRenderer fresh = must(SceneRenderer::create());
        std::swap(fresh, *renderer_);
        Picture picture = draw(scene, view, profile, mode);
        std::swap(fresh, *renderer_);
        return picture;
    }
    static std::vector<Palette> threePalettes() {
        std::vector<Palette> palettes(3, Palette::standard());
        for (std::size_t index = 1; index < 256; ++index) {
            std::swap(palettes[1].colours[index].x, palettes[1].colours[index].z);
            palettes[2].colours[index].y = static_cast<std::uint8_t>(255 - index);
        }
        return palettes;
    }

    std::vector<Palette> palettes_ = threePalettes();
};

TEST_F(CrowdMemory, BothModesAreOneDrawAndEqualEntitiesDrawnAlone) {
    int variant = 0;
    for (const DepthRule depth : {DepthRule::centre, DepthRule::groundSafe, DepthRule::perPixel}) {
        for (const ProxyShape proxy : {ProxyShape::quad, ProxyShape::box}) {
            GameProfile profile = plainProfile();
            profile.viewStepDegrees = 0.0;
            profile.depth = depth;
            profile.proxy = proxy;
            profile.view = variant++ % 2 == 0 ? ViewRule::towardEntity : ViewRule::cameraForward;
            // More than a group of vertices, and not a whole number of them.
            const Scene scene = colourful(43, profile);
            const Camera view = camera(-8.0, 27.0, 11.0);
            const Picture buffered = draw(scene, view, profile);
            const Picture single = draw(scene, view, profile, SpriteMode::singlePass);
            EXPECT_EQ(buffered.stats.drawCalls, 1);
            EXPECT_EQ(single.stats.drawCalls, 1);
            EXPECT_GT(single.stats.drawn, 32);
            EXPECT_EQ(mismatches(buffered.colour, oneByOne(scene, view, profile)), 0U) << variant;
            EXPECT_EQ(mismatches(buffered.colour, single.colour), 0U) << variant;
            EXPECT_TRUE(buffered.depth == single.depth) << variant;
            // Again, from what is held.
            const Picture heldSingle = draw(scene, view, profile, SpriteMode::singlePass);
            EXPECT_EQ(mismatches(heldSingle.colour, single.colour), 0U);
            EXPECT_EQ(heldSingle.stats.rays, single.stats.rays);
            EXPECT_EQ(mismatches(draw(scene, view, profile).colour, single.colour), 0U);
        }
    }
}

// A change of anything that a picture depends on shows in the next frame, in either mode.
TEST_F(CrowdMemory, WhatChangesIsDrawnAnew) {
    GameProfile profile = plainProfile();
    profile.viewStepDegrees = 0.0;
    Scene scene = colourful(20, profile);
    Camera view = camera(12.0, 21.0, 9.0);
    LiveOctree live;
    ASSERT_TRUE(live.rebuild(test::figure()));
    const IBox bounds{{0, 0, 0}, figure_->octree.size};
    GpuOctree edited;
    edited.update(live.view(bounds), live.takeChanges());

    using Change = std::function<void()>;
    const std::vector<std::pair<std::string, Change>> changes{
        {"nothing", [] {}},
        {"an entity moves", [&] { scene.entities[3].placed.anchorMetres.x += 0.31; }},
        {"an entity turns",
         [&] {
             scene.entities[4].placed.worldFromVoxelAxes =
                 figure_->placedAt({}, profile, 17.0).worldFromVoxelAxes;
         }},
        {"a colour of a palette",
         [&] {
             palettes_[1].colours.fill({250, 10, 90, 255});
         }},
        {"another palette", [&] { scene.entities[3].palette = &palettes_[2]; }},
        {"another model",
         [&] {
             SceneEntity& entity = scene.entities[1];
             entity = test::Scenes::entity(*figure_, entity.placed.anchorMetres, profile);
             entity.octree = &edited;
         }},
        {"its voxels",
         [&] {
             std::vector<LiveOctree::Edit> edits;
             for (int z = 12; z < 30; ++z) edits.push_back({{3, 0, z}, 77});
             ASSERT_TRUE(live.apply(edits));
             edited.update(live.view(bounds), live.takeChanges());
         }},
        {"sigma", [&] { profile.sigma = 3.0; }},
        {"the outline",
         [&] {
             profile.outline.colour = {200, 180, 20, 255};
         }},
        {"the light", [&] { profile.light.ambient = 0.2; }},
        {"occlusion", [&] { profile.light.occlusion = 0.8; }},
        {"shadow", [&] { profile.light.shadow = 0.9; }},
        {"where the light is",
         [&] {
             profile.light.towardLight = {-0.7, 0.5, 0.4};
         }},
        {"the depth rule", [&] { profile.depth = DepthRule::perPixel; }},
        {"the proxy", [&] { profile.proxy = ProxyShape::box; }},
        {"the camera", [&] { view = camera(14.0, 21.0, 9.0); }},
        {"the picture's size",
         [&] {
             view.viewportPx = {190, 170};
         }},
        {"the order", [&] { std::swap(scene.entities[2], scene.entities[10]); }},
        {"an entity less", [&] { scene.entities.erase(scene.entities.begin() + 5); }},
        {"an entity more",
         [&] {
             scene.entities.push_back(scene.entities[3]);
             scene.entities.back().placed.anchorMetres.z += 2.0;
         }},
        {"the new one moves", [&] { scene.entities.back().placed.anchorMetres.x -= 0.7; }},
        {"nobody", [&] { scene.entities.clear(); }},
        {"somebody", [&] { scene = colourful(7, profile); }},
    };
    Image before = draw(scene, view, profile).colour;
    int seen = 0;
    for (const auto& [name, change] : changes) {
        change();
        for (const SpriteMode mode : {SpriteMode::spriteBuffer, SpriteMode::singlePass}) {
            const Picture next = draw(scene, view, profile, mode);
            const Picture expected = afresh(scene, view, profile, mode);
            EXPECT_EQ(mismatches(next.colour, expected.colour), 0U) << name;
            EXPECT_TRUE(next.depth == expected.depth) << name;
            EXPECT_EQ(next.stats.drawn, expected.stats.drawn) << name;
            if (mode == SpriteMode::singlePass) continue;
            seen += next.colour.pixels != before.pixels;
            before = next.colour;
        }
    }
    // All but "nothing", and perhaps who stands before whom.
    EXPECT_GE(seen, static_cast<int>(changes.size()) - 3);
}

TEST_F(CrowdMemory, AHistoryThatWasTakenAwayIsBegunAnew) {
    GameProfile profile = plainProfile();
    profile.viewStepDegrees = 5.0;
    ViewHistory history;
    Scene scene = rows(5, profile);
    scene.entities[2].history = &history;
    const Camera view = camera(12.0, 21.0, 9.0);
    const Image first = draw(scene, view, profile).colour;
    ASSERT_TRUE(history.snappedSteps);
    const glm::ivec3 steps = *history.snappedSteps;
    EXPECT_EQ(mismatches(draw(scene, view, profile).colour, first), 0U);
    EXPECT_EQ(*history.snappedSteps, steps);
    history = {};
    EXPECT_EQ(mismatches(draw(scene, view, profile).colour, first), 0U);
    EXPECT_EQ(history.snappedSteps, steps);
    // And one that says otherwise is followed: near the middle between two steps the band of
    // hysteresis holds the neighbour.
    bool followed = false;
    for (double pitch = 20.0; pitch < 25.0 && !followed; pitch += 0.5) {
        const Camera between = camera(12.0, pitch, 9.0);
        history = {};
        (void)draw(scene, between, profile);
        ASSERT_TRUE(history.snappedSteps);
        const glm::ivec3 nearest = *history.snappedSteps;
        for (const int side : {-1, 1}) {
            const glm::ivec3 neighbour = nearest + glm::ivec3(0, side, 0);
            history.snappedSteps = neighbour;
            const Image shown = draw(scene, between, profile).colour;
            if (history.snappedSteps == nearest) continue;
            followed = true;
            EXPECT_EQ(history.snappedSteps, neighbour);
            SceneRenderer fresh = must(SceneRenderer::create());
            ViewHistory other;
            other.snappedSteps = neighbour;
            Scene same = scene;
            same.entities[2].history = &other;
            Frame frame(between.viewportPx);
            (void)must(fresh.draw(frame, same, between, profile, SpriteMode::spriteBuffer));
            EXPECT_EQ(other.snappedSteps, neighbour);
            EXPECT_EQ(mismatches(shown, frame.readColour()), 0U);
        }
    }
    EXPECT_TRUE(followed);
}

TEST_F(CrowdMemory, AFrameThatFailsLeavesNothingBehind) {
    GameProfile profile = plainProfile();
    profile.sigma = 1.0;
    const test::GpuModel rod(test::solidBox({40'000, 1, 1}, 3));
    const Camera view = camera(0, 0, 9000.0);
    Scene good;
    good.background = kBackground;
    good.entities = {entity(*figure_, {0.0, 0.0, 8990.0}, profile, 30.0)};
    Scene bad = good;
    bad.entities.push_back(entity(rod, {0.0, 0.0, 0.0}, profile));
    Frame frame(view.viewportPx);
    for (int turn = 0; turn < 2; ++turn) {
        EXPECT_FALSE(renderer_->draw(frame, bad, view, profile, SpriteMode::spriteBuffer));
        const Picture picture = draw(good, view, profile);
        EXPECT_EQ(picture.stats.casts, turn == 0 ? 1U : 0U);
        const Picture single = draw(good, view, profile, SpriteMode::singlePass);
        EXPECT_EQ(mismatches(picture.colour, single.colour), 0U);
        EXPECT_GT(std::ranges::count_if(picture.depth, [](float d) { return d > 0.0f; }), 1000);
    }
}

TEST_F(CrowdMemory, EvictionWhileMovingChangesNothing) {
    GameProfile profile = plainProfile();
    profile.viewStepDegrees = 0.0;
    for (const DepthRule depth : {DepthRule::groundSafe, DepthRule::perPixel}) {
        profile.depth = depth;
        // Room for about half of a frame's sprites; and a single page that new ones must empty.
        for (const AtlasLimits limits : {AtlasLimits{256, 2}, AtlasLimits{640, 1}}) {
            renderer_.emplace(must(SceneRenderer::create(limits)));
            const Scene scene = colourful(24, profile);
            for (int step = 0; step < 6; ++step) {
                const Camera view = camera(3.0 * step, 21.0, 9.0 - 0.2 * step);
                const Picture picture = draw(scene, view, profile);
                const Picture single = draw(scene, view, profile, SpriteMode::singlePass);
                EXPECT_EQ(mismatches(picture.colour, single.colour), 0U) << step;
                EXPECT_TRUE(picture.depth == single.depth) << step;
                EXPECT_LE(picture.stats.atlasBytes,
                          8ULL * limits.pages * limits.pageEdgePx * limits.pageEdgePx);
            }
        }
    }
}

// Of sprites that are larger than a page there is room for few; and always for one.
TEST_F(CrowdMemory, LargeSpritesKeepToTheirRoom) {
    GameProfile profile = plainProfile();
    profile.viewStepDegrees = 0.0;
    constexpr std::uint64_t kPage = 8ULL * 16 * 16;
    for (const std::uint64_t room : {std::uint64_t{1}, std::uint64_t{300'000}}) {
        renderer_.emplace(must(SceneRenderer::create({16, 1, room})));
        const Scene scene = colourful(24, profile);
        std::uint64_t most = 0;
        for (int step = 0; step < 3; ++step) {
            const Camera view = camera(3.0 * step, 21.0, 9.0 - 0.2 * step);
            const Picture picture = draw(scene, view, profile);
            const Picture single = draw(scene, view, profile, SpriteMode::singlePass);
            EXPECT_EQ(mismatches(picture.colour, single.colour), 0U) << step;
            most = std::max(most, picture.stats.atlasBytes);
        }
        EXPECT_GT(most, kPage);
        // One is up to 192 pixels wide and high.
        EXPECT_LE(most, kPage + std::max<std::uint64_t>(room, 8ULL * 192 * 192));
    }
}

// More lit palettes than the GPU is given at a time: what is gathered is drawn, and then the rest.
TEST_F(CrowdMemory, AnyNumberOfPalettes) {
    GameProfile profile = plainProfile();
    profile.view = ViewRule::cameraForward;
    profile.sigma = 1.0;
    profile.outline.enabled = false;
    const test::GpuModel dot(test::solidBox({2, 2, 2}, 1));
    constexpr int kEdge = 47;
    std::vector<Palette> palettes(kEdge * kEdge);
    ASSERT_GT(palettes.size(), static_cast<std::size_t>(LitRows::kMostRows / 3));
    Scene scene;
    scene.background = kBackground;
    for (int k = 0; k < kEdge * kEdge; ++k) {
        Palette& palette = palettes[static_cast<std::size_t>(k)];
        palette.colours.fill({4 * (k % 61) + 10, 6 * (k / 61), 100, 255});
        const glm::dvec3 at((k % kEdge - kEdge / 2) * 0.3, (k / kEdge - kEdge / 2) * 0.3, 0.0);
        scene.entities.push_back(entity(dot, at, profile));
        scene.entities.back().palette = &palette;
    }
    Camera view = parallel(0, 0);
    view.viewportPx = {320, 320};
    view.orthographicHeightMetres = 16.0;
    view.eyeMetres = {0.0, 0.1, 30.0};
    for (const SpriteMode mode : {SpriteMode::spriteBuffer, SpriteMode::singlePass}) {
        const Picture picture = draw(scene, view, profile, mode);
        EXPECT_EQ(picture.stats.drawCalls, 2);
        std::set<std::tuple<int, int, int>> seen;
        for (const Rgba8 pixel : picture.colour.pixels) {
            if (pixel != kBackground) seen.emplace(pixel.x, pixel.y, pixel.z);
        }
        std::set<std::tuple<int, int, int>> expected;
        for (const SceneEntity& each : scene.entities) {
            const SpriteView sprite = *must(viewSprite(each.placed, view, profile)).view;
            const Rgba8 lit = litPalette(*each.palette, sprite.light8, profile.outline).shade(1, 1);
            expected.emplace(lit.x, lit.y, lit.z);
        }
        EXPECT_GT(expected.size(), 1500U);
        EXPECT_EQ(seen, expected);
    }
}

TEST_F(CrowdMemory, AHundredThousandAreOneDraw) {
    GameProfile profile = plainProfile();
    profile.view = ViewRule::cameraForward;
    profile.sigma = 0.25;
    Camera view = parallel(0, 0);
    view.viewportPx = {128, 128};
    view.orthographicHeightMetres = 700.0;
    view.eyeMetres = {0.0, 0.0, 30.0};
    Scene scene;
    scene.background = kBackground;
    const auto add = [&](int count) {
        for (int k = 0; k < count; ++k) {
            const glm::dvec3 at(k % 400 - 200.0, k / 400 - 165.0, 0.0);
            scene.entities.push_back(entity(k % 2 == 0 ? *ball_ : *letters_, at, profile));
        }
    };
    add(100'000);
    const Picture first = draw(scene, view, profile);
    EXPECT_EQ(first.stats.drawn, 100'000);
    EXPECT_EQ(first.stats.drawCalls, 1);
    EXPECT_EQ(first.stats.casts, 2U);
    const Picture still = draw(scene, view, profile);
    EXPECT_EQ(still.stats.drawCalls, 1);
    EXPECT_EQ(still.stats.castsReused, 100'000U);
    EXPECT_EQ(still.stats.rays, 0U);
    EXPECT_EQ(mismatches(still.colour, first.colour), 0U);
    // As many as go to the GPU at a time; they stand where others stand already.
    add(31'072);
    EXPECT_EQ(draw(scene, view, profile).stats.drawCalls, 1);
    const Picture full = draw(scene, view, profile);
    EXPECT_EQ(full.stats.drawCalls, 1);
    EXPECT_EQ(mismatches(full.colour, first.colour), 0U);
    // And more.
    add(8'928);
    const Picture more = draw(scene, view, profile);
    EXPECT_EQ(more.stats.drawCalls, 2);
    EXPECT_EQ(more.stats.drawn, 140'000);
    EXPECT_EQ(mismatches(more.colour, first.colour), 0U);
}

TEST_F(CrowdMemory, EveryEntityHasItsShadow) {
    const GameProfile profile = plainProfile();
    Scene scene = crowd(profile);
    scene.ground = Ground{};
    scene.shadowBlobs = true;
    const Camera view = camera(15.0, 35.0);
    const Picture all = draw(scene, view, profile);
    for (const SceneEntity& each : scene.entities) {
        Scene alone = scene;
        alone.entities = {each};
        const Image shaded = draw(alone, view, profile).colour;
        alone.shadowBlobs = false;
        const Picture bare = draw(alone, view, profile);
        Scene sprites = scene;
        sprites.shadowBlobs = false;
        const Picture unshaded = draw(sprites, view, profile);
        std::size_t checked = 0;
        for (std::size_t i = 0; i < shaded.pixels.size(); ++i) {
            // The ground, where this entity alone shades it and no other one stands before it.
            const bool ground = all.depth[i] == bare.depth[i];
            if (!ground || shaded.pixels[i].x + 3 > bare.colour.pixels[i].x) continue;
            EXPECT_LT(all.colour.pixels[i].x, unshaded.colour.pixels[i].x);
            ++checked;
        }
        EXPECT_GT(checked, 100U);
    }
}

TEST_F(CrowdMemory, AShadowMayFallElsewhere) {
    const GameProfile profile = plainProfile();
    Scene scene;
    scene.ground = Ground{};
    scene.shadowBlobs = true;
    scene.entities = {entity(*figure_, {-1.0, 0.0, 0.0}, profile)};
    const PlacedEntity elsewhere = entity(*figure_, {1.0, 0.0, 0.0}, profile).placed;
    const Camera view = camera(0.0, 35.0);
    const Picture here = draw(scene, view, profile);
    scene.entities[0].shadow = &elsewhere;
    const Picture there = draw(scene, view, profile);
    EXPECT_TRUE(here.depth == there.depth);
    std::uint64_t left = 0;
    std::uint64_t right = 0;
    for (int y = 0; y < kViewport.y; ++y) {
        for (int x = 0; x < kViewport.x; ++x) {
            const int gained = here.colour.at(x, y).x - there.colour.at(x, y).x;
            if (gained == 0) continue;
            EXPECT_EQ(gained < 0, x < kViewport.x / 2);
            ++(x < kViewport.x / 2 ? left : right);
        }
    }
    EXPECT_GT(left, 100U);
    EXPECT_GT(right, 100U);
}

TEST_F(CrowdMemory, AtlasesBeyondTheDriverAreRefused) {
    const auto wide = SceneRenderer::create({1 << 20, 1});
    ASSERT_FALSE(wide);
    EXPECT_NE(wide.error().message.find("1048576"), std::string::npos) << wide.error().message;
    EXPECT_FALSE(SceneRenderer::create({64, 1 << 20}));
    EXPECT_FALSE(SceneRenderer::create({0, 1}));
    EXPECT_FALSE(SceneRenderer::create({64, 0}));
}

}  // namespace
}  // namespace voxprite
