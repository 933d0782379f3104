// Rows 7, 12 and 15: which pixels of the sprite reach the screen, and how many rays that takes.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <set>

#include "app/cli/conformance/conformance.h"
#include "app/cli/conformance/outline_lost.h"
#include "app/cli/conformance/subjects.h"
#include "core/trace/lattice_caster.h"

namespace voxprite::conformance {
namespace {

// Row 7.
void compareProxy(Comparisons& all) {
    LitPalette lit;
    lit.outline.colour = kInk;
    double outlines = 0.0;
    double boxLost = 0.0;
    double quadLost = 0.0;
    double worst = 0.0;
    for (const Subject& subject : {solidBox({16, 16, 16}), letters(), solidBox({10, 20, 6})})
        for (const ViewRule rule : {ViewRule::towardEntity, ViewRule::cameraForward})
            for (const double yaw : {0.0, 45.0, 70.0})
                for (const double pitch : {0.0, 35.26, 60.0}) {
                    GameProfile profile = plainProfile();
                    profile.view = rule;
                    const Camera camera = orbit(yaw, pitch, 4.5);
                    const PlacedEntity entity =
                        subject.centredAt(camera.right * 0.3 - camera.up * 0.2, profile);
                    SpriteView view = seen(entity, camera, profile);
                    const SpriteBuffer buffer =
                        castSprite(subject.octree.view(), view.lattice, lit);
                    quadLost += outlineLost(view, buffer, camera);
                    view.proxy = ProxyShape::box;
                    const double lost = outlineLost(view, buffer, camera);
                    const auto count = static_cast<double>(buffer.outlineCount());
                    boxLost += lost;
                    outlines += count;
                    worst = std::max(worst, 100.0 * lost / count);
                }
    const std::string how = "16 cubed, letters and 10x20x6 from 18 views each, sigma 4, 4.5 m away";
    all.push_back({7, "proxy_box", "outline pixels that the proxy cuts away, on average",
                   100.0 * boxLost / outlines, 100.0 * quadLost / outlines, 0.0, "%", how});
    all.push_back({7, "proxy_box_worst", "the same in the worst view", worst,
                   100.0 * quadLost / outlines, 0.0, "%", how});
}

// Row 12: columns of the outline under no screen pixel's centre, while a virtual pixel is between
// half and a whole screen pixel wide.
Comparison compareMinification() {
    const Subject subject = cube32();
    const auto unsampledPercent = [&](bool minification) {
        double columns = 0.0;
        double never = 0.0;
        for (double width = 0.51; width < 1.0; width += 0.03) {
            GameProfile profile = plainProfile();
            profile.minification = minification;
            Camera camera = orbit(0, 0, 1.0);
            const double distance = 0.025 / width / camera.metresPerScreenPx(1.0);
            camera = orbit(0, 0, distance);
            const PlacedEntity entity = subject.centredAt({0.013, 0.007, 0.0}, profile);
            const SpriteView view = seen(entity, camera, profile);
            const SpriteBuffer buffer = cast(subject.octree, view.lattice);
            std::set<int> sampled;
            const double row = camera.project(entity.centreMetres()).screenPx.y;
            for (int x = 0; x < camera.viewportPx.x; ++x)
                if (const auto pixel = pixelUnder(view, camera, {x + 0.5, row}))
                    sampled.insert(pixel->x);
            for (int column = 0; column < buffer.size.x; ++column) {
                bool outline = false;
                for (int r = 0; r < buffer.size.y; ++r)
                    outline = outline ||
                              buffer.ids[static_cast<std::size_t>(r * buffer.size.x + column)] ==
                                  kIdOutline;
                columns += outline ? 1.0 : 0.0;
                never += outline && sampled.count(buffer.first.x + column) == 0 ? 1.0 : 0.0;
            }
        }
        return 100.0 * never / columns;
    };
    return {12,
            "minification",
            "outline columns that no screen pixel samples",
            unsampledPercent(false),
            unsampledPercent(true),
            0.0,
            "%",
            "cube from the front, a vpx 0.51 ... 0.99 screen pixels wide at sigma 4"};
}

// Row 15: the seed casts a ray for every fragment of the box, and up to four more on a miss.
Comparison compareRays() {
    const Subject subject = figure();
    GameProfile profile = plainProfile();
    const double screenPxPerPx = 8.0;
    Camera camera = orbit(30, 20, 1.0, 1024);
    camera = orbit(30, 20, 0.025 / screenPxPerPx / camera.metresPerScreenPx(1.0), 1024);
    const SpriteView view = seen(subject.centredAt(glm::dvec3(0.0), profile), camera, profile);
    const LatticeView visible = visibleLattice(view, camera);
    const LatticeCaster caster(subject.octree.view(), view.lattice);
    const auto hit = [&](glm::ivec2 pixel) { return caster.cast(pixel).material != 0; };
    double literal = 0.0;
    for (int y = 0; y < camera.viewportPx.y; ++y)
        for (int x = 0; x < camera.viewportPx.x; ++x) {
            const glm::dvec2 screenPx = glm::dvec2(x, y) + 0.5;
            if (!meetsProxyBox(view, camera.rayFromEye(screenPx))) continue;
            const auto pixel = pixelUnder(view, camera, screenPx);
            if (!pixel) continue;
            ++literal;
            if (hit(*pixel)) continue;
            for (const glm::ivec2 step : {glm::ivec2(-1, 0), {1, 0}, {0, 1}, {0, -1}}) {
                ++literal;
                if (hit(*pixel + step)) break;
            }
        }
    const double ours =
        static_cast<double>(castSprite(subject.octree.view(), visible, LitPalette{}).ids.size());
    // Samples over the projected box and under the screen, and one more all round.
    const auto across = [&](glm::dvec3 axis, int screenPx) {
        const double box =
            view.sigmaInForce * glm::dot(glm::abs(axis), glm::dvec3(subject.octree.size));
        return std::floor(std::min(box, screenPx / screenPxPerPx)) + 3.0;
    };
    const double promised =
        across(view.ortho.right, camera.viewportPx.x) * across(view.ortho.up, camera.viewportPx.y);
    return {15,
            "rays",
            "rays cast for one frame of one sprite",
            literal,
            ours,
            promised,
            "rays",
            "figure, 1024x1024, 8 screen pixels a vpx: one pass against one ray a vpx; at most one "
            "for each vpx of the projected box that is on the screen, and one all round"};
}

}  // namespace

void compareScreen(Comparisons& all) {
    compareProxy(all);
    all.push_back(compareMinification());
    all.push_back(compareRays());
}

}  // namespace voxprite::conformance
