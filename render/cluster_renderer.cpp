#include "render/cluster_renderer.h"

#include <glad/gl.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/sprite/lit_palette.h"
#include "render/cluster_pass.h"
#include "render/gl/draw_state.h"
#include "render/gl/program.h"
#include "render/palette_texture.h"

namespace voxprite {

namespace {

// A row of colours for each palette and light that some face has.
class FaceRows {
  public:
    explicit FaceRows(const GameProfile& profile) : profile_(profile) {}

    std::array<std::uint16_t, kFaces> of(const Palette& palette, const PlacedEntity& placed) {
        const glm::dvec3 toward =
            glm::transpose(placed.worldFromVoxelAxes) * profile_.light.towardLight;
        std::array<std::uint16_t, kFaces> rows{};
        for (const int side : {0, 1}) {
            // Rays that run down an axis see the face that looks up it.
            const auto light8 =
                faceLight(glm::ivec3(side == 0 ? -1 : 1), toward, profile_.light.ambient);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                rows[static_cast<std::size_t>(3 * side) + axis] = rowOf(palette, light8[axis]);
            }
        }
        return rows;
    }
    [[nodiscard]] std::vector<Rgba8> take() { return std::move(colours_); }

  private:
    std::uint16_t rowOf(const Palette& palette, std::uint8_t light) {
        const auto [row, isNew] =
            rows_.try_emplace({&palette, light}, static_cast<std::uint16_t>(colours_.size() / 256));
        if (isNew) {
            auto& shader = shaders_[&palette];
            if (!shader) shader.emplace(palette);
            const ShadedColours& lit = shader->inLight(light, profile_.shading);
            colours_.insert(colours_.end(), lit.begin(), lit.end());
        }
        return row->second;
    }

    const GameProfile& profile_;
    std::map<const Palette*, std::optional<PaletteShader>> shaders_;
    std::map<std::pair<const Palette*, std::uint8_t>, std::uint16_t> rows_;
    std::vector<Rgba8> colours_;
};

}  // namespace

struct ClusterRenderer::Impl {
    ClusterPass pass;
    gl::Program program;
    PaletteTexture palette;
    GLint mostRows = 0;
};

Result<ClusterStats> ClusterRenderer::draw(Frame& frame, const Camera& camera,
                                           const GameProfile& profile,
                                           std::span<const ClusterInstance> instances,
                                           const ClusterOptions& options) {
    if (instances.empty()) return ClusterStats{};
    FaceRows rows(profile);
    std::vector<ClusterPass::Instance> items;
    for (const ClusterInstance& instance : instances) {
        items.push_back(
            {instance.clusters, instance.placed, rows.of(*instance.palette, instance.placed)});
    }
    std::vector<Rgba8> colours = rows.take();
    if (static_cast<GLint>(colours.size() / 256) > impl_->mostRows) {
        return fail("the scene's meshes have more palettes in more lights than there is room for");
    }
    impl_->palette.set(std::move(colours));
    impl_->pass.choose(
        items, camera,
        {.budgetPx = options.budgetPx, .levelTint = options.tintLevels ? kLevelTint : 0.0f});
    frame.bind();
    gl::apply(
        {.depthTest = gl::DepthTest::nearer, .depthWrite = true, .cull = gl::Cull::backFaces});
    bindTexture(TextureUnit::palette, impl_->palette.texture());
    gl::useProgram(impl_->program);
    impl_->pass.draw();
    return ClusterStats{static_cast<int>(items.size()), impl_->pass.drawCalls()};
}

Result<ClusterRenderer> ClusterRenderer::create() {
    Result<ClusterPass> pass = ClusterPass::create();
    if (!pass) return Failure(pass.error());
    Result<gl::Program> program = gl::compileProgram("cluster.vert", "cluster.frag");
    if (!program) return Failure(program.error());
    auto impl = std::make_unique<Impl>(Impl{std::move(*pass), std::move(*program), {}, 0});
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &impl->mostRows);
    return ClusterRenderer(std::move(impl));
}

ClusterRenderer::ClusterRenderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ClusterRenderer::~ClusterRenderer() = default;
ClusterRenderer::ClusterRenderer(ClusterRenderer&&) noexcept = default;
ClusterRenderer& ClusterRenderer::operator=(ClusterRenderer&&) noexcept = default;

}  // namespace voxprite
