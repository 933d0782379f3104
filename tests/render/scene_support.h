// A scene of three models for the tests of scenes, drawn by the GPU and by the CPU alone.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <optional>

#include "render/scene_renderer.h"
#include "tests/render/gl_test.h"
#include "tests/support/voxels.h"

namespace voxprite::test {

inline constexpr glm::ivec2 kViewport{260, 200};
inline constexpr Rgba8 kBackground{10, 20, 200, 255};

inline GameProfile plainProfile() {
    GameProfile profile;
    profile.minification = false;
    return profile;
}

inline std::uint64_t mismatches(const Image& a, const Image& b) {
    EXPECT_EQ(a.pixels.size(), b.pixels.size());
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) count += a.pixels[i] != b.pixels[i];
    return count;
}

// The scene by the CPU alone.
inline Image composed(const Scene& scene, const std::vector<const GpuModel*>& models,
                      const Camera& camera, const GameProfile& profile) {
    std::vector<SpriteView> views;
    std::vector<SpriteBuffer> buffers;
    std::vector<std::vector<float>> depths;
    for (std::size_t i = 0; i < scene.entities.size(); ++i) {
        const SpriteViewResult seen = must(viewSprite(scene.entities[i].placed, camera, profile));
        if (!seen.view) continue;
        const OctreeView octree = models[i]->octree.view();
        views.push_back(*seen.view);
        buffers.push_back(
            castSprite(octree, seen.view->lattice,
                       litPalette(models[i]->palette, seen.view->light8, profile.outline)));
        depths.push_back(pixelDepths(views.back(), octree, buffers.back()));
    }
    std::vector<CompositeSprite> sprites;
    for (std::size_t i = 0; i < views.size(); ++i) {
        sprites.push_back(
            {&views[i], &buffers[i], profile.depth == DepthRule::perPixel ? &depths[i] : nullptr});
    }
    return composite(sprites, camera, scene.background, scene.ground);
}

class Scenes : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        renderer_.emplace(must(SceneRenderer::create()));
        figure_ = std::make_unique<GpuModel>(figure());
        letters_ = std::make_unique<GpuModel>(asymmetric());
        ball_ = std::make_unique<GpuModel>(shellSphere(21));
    }
    void TearDown() override {
        figure_.reset();
        letters_.reset();
        ball_.reset();
        renderer_.reset();
        GlTest::TearDown();
    }

    struct Picture {
        Image colour;
        std::vector<float> depth;
        SceneStats stats;
    };
    Picture draw(const Scene& scene, const Camera& camera, const GameProfile& profile,
                 SpriteMode mode = SpriteMode::spriteBuffer) {
        Frame frame(camera.viewportPx);
        const SceneStats stats = must(renderer_->draw(frame, scene, camera, profile, mode));
        return {frame.readColour(), frame.readDepth(), stats};
    }

    // Three entities that overlap on the screen.
    Scene crowd(const GameProfile& profile) const {
        Scene scene;
        scene.background = kBackground;
        const double float_ = groundClearanceMetres(profile);
        scene.entities = {entity(*figure_, {-0.9, float_, 0.3}, profile, 20.0),
                          entity(*letters_, {0.2, float_, 0.7}, profile, -75.0),
                          entity(*ball_, {0.7, float_, -0.9}, profile, 33.0)};
        return scene;
    }
    std::vector<const GpuModel*> crowdModels() const {
        return {figure_.get(), letters_.get(), ball_.get()};
    }
    static SceneEntity entity(const GpuModel& model, glm::dvec3 anchorMetres,
                              const GameProfile& profile, double yawDegrees = 0.0) {
        return {&model.gpu, &model.palette, model.placedAt(anchorMetres, profile, yawDegrees),
                nullptr};
    }
    static Camera camera(double yaw, double pitch, double distance = 7.0, double roll = 0.0) {
        return orbitCamera({yaw, pitch, roll}, {0.0, 1.1, 0.0}, distance, 45.0, kViewport);
    }
    static Camera parallel(double yaw, double pitch) {
        Camera result = camera(yaw, pitch);
        result.orthographic = true;
        result.orthographicHeightMetres = 5.3;
        return result;
    }

    std::optional<SceneRenderer> renderer_;
    std::unique_ptr<GpuModel> figure_, letters_, ball_;
};

}  // namespace voxprite::test
