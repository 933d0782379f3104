// Crowds for tests of what is shared and remembered, and the picture that nothing shared gives.
#pragma once

#include <random>

#include "tests/render/scene_support.h"

namespace voxprite::test {

class Crowds : public Scenes {
  protected:
    // Entities in rows, of the three models in turn, every one turned by one of four angles.
    Scene rows(int count, const GameProfile& profile) const {
        const GpuModel* models[] = {figure_.get(), letters_.get(), ball_.get()};
        std::mt19937 random(5);
        const auto below = [&](unsigned n) { return static_cast<double>(random() % n); };
        Scene scene;
        scene.background = kBackground;
        for (int k = 0; k < count; ++k) {
            const double x = (k % 8 - 3.5) * 1.9 + 0.001 * below(500);
            const double z = -(k / 8) * 2.3 + 0.001 * below(500);
            scene.entities.push_back(entity(*models[k % 3], {x, groundClearanceMetres(profile), z},
                                            profile, 90.0 * below(4)));
        }
        return scene;
    }

    Scene onlyModel(int count, const GameProfile& profile) const {
        Scene scene;
        scene.background = kBackground;
        for (int k = 0; k < count; ++k) {
            const glm::dvec3 at((k % 40 - 19.5) * 1.7, 0.0, -(k / 40) * 2.0);
            scene.entities.push_back(entity(*figure_, at, profile, 30.0));
        }
        return scene;
    }

    // Far enough to see all of a crowd's forty columns.
    static Camera far() { return orbitCamera({0, 25, 0}, {0, 1, -20}, 110.0, 45.0, {400, 300}); }

    // Every entity drawn alone by a renderer of its own; the nearest one on top, as its depth has
    // it, the first of equals.
    Image oneByOne(const Scene& scene, const Camera& view, const GameProfile& profile) {
        SceneRenderer alone = must(SceneRenderer::create());
        Image image(view.viewportPx.x, view.viewportPx.y);
        std::ranges::fill(image.pixels, scene.background);
        std::vector<float> nearest(image.pixels.size(), 0.0f);
        for (const SceneEntity& each : scene.entities) {
            Scene single;
            single.background = scene.background;
            single.entities = {each};
            Frame frame(view.viewportPx);
            (void)must(alone.draw(frame, single, view, profile, SpriteMode::spriteBuffer));
            const Image colour = frame.readColour();
            const std::vector<float> depth = frame.readDepth();
            for (std::size_t i = 0; i < depth.size(); ++i) {
                if (depth[i] <= nearest[i]) continue;
                nearest[i] = depth[i];
                image.pixels[i] = colour.pixels[i];
            }
        }
        return image;
    }
};

}  // namespace voxprite::test
