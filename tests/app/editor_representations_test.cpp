// The scene drawn by what was chosen for each entity: levels and figures that come by themselves,
// the budget kept in the picture, the tint, and everything side by side.
#include <chrono>
#include <set>
#include <thread>

#include "app/editor/views/representation_cells.h"
#include "app/editor/views/scene_representations.h"
#include "app/editor/views/sprite_scene.h"
#include "core/io/formats.h"
#include "core/measure/compare.h"
#include "tests/render/gl_test.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/voxels.h"

namespace voxprite::editor {
namespace {

class EditorRepresentations : public test::GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        ASSERT_TRUE(saveDocument(folder_ / "m.vox", test::documentOf(test::figure()), {}));
        ASSERT_TRUE(session_.open(folder_ / "m.vox"));
        edited_.emplace();
        edited_->upload(session_.octree().view(session_.bounds()));
        renderer_.emplace(test::must(SceneRenderer::create()));
        scene_.emplace();
        library_ = std::make_unique<LevelLibrary>();
        settings_.copies.pattern = CopyPattern::crowd;
        settings_.copies.count = 40;
        settings_.copies.spacing = 2.0;
        settings_.representations.rule = DrawRule::automatic;
    }
    void TearDown() override {
        library_.reset();
        scene_.reset();
        renderer_.reset();
        edited_.reset();
        GlTest::TearDown();
    }
    // As the editor does it, a frame after the other.
    void follow(bool measured = true) {
        now_ += 1.0;
        library_->follow(scene_->levelSources(session_, *edited_), settings_.representations,
                         session_.profile(), measured, now_);
        library_->work(*renderer_);
    }
    void finish(bool measured = true) {
        follow(measured);
        follow(measured);
        for (int frame = 0; library_->busy() && frame < 20'000; ++frame) {
            follow(measured);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        ASSERT_FALSE(library_->busy());
    }
    Scene made() {
        EXPECT_TRUE(scene_->follow(session_, settings_).empty());
        histories_.assign(scene_->entityCount(), ViewHistory());
        Scene scene =
            scene_->make(session_, *edited_, ViewSettings{}, session_.profile(), histories_);
        scene.sky = false;
        scene.ground.reset();
        scene.shadowBlobs = false;
        scene.background = Rgba8(0);
        return scene;
    }
    RepresentationShares choose(Scene& scene, const Camera& camera) {
        before_.resize(scene.entities.size());
        return representations_.choose(scene, camera, settings_.representations, *library_,
                                       before_);
    }
    Image picture(const Scene& scene, const Camera& camera) {
        Frame frame(camera.viewportPx);
        stats_ = test::must(
            renderer_->draw(frame, scene, camera, session_.profile(), SpriteMode::spriteBuffer));
        return frame.readColour();
    }
    static Camera from(double metres) {
        return orbitCamera({25, 30, 0}, {0, 1, 0}, metres, 40.0, {360, 240});
    }
    RepresentationCells::Subject subject() {
        return {&*edited_,   &session_.shownPalette(), session_.placedInGame(), session_.profile(),
                {30, 20, 0}, session_.revision()};
    }

    test::TemporaryFolder folder_;
    Session session_;
    SceneSettings settings_;
    std::optional<GpuOctree> edited_;
    std::optional<SceneRenderer> renderer_;
    std::optional<SpriteScene> scene_;
    std::unique_ptr<LevelLibrary> library_;
    SceneRepresentations representations_;
    std::vector<ViewHistory> histories_;
    std::vector<std::optional<RepresentationChoice>> before_;
    SceneStats stats_;
    double now_ = 0.0;
};

TEST_F(EditorRepresentations, LevelsAndFiguresComeByThemselvesAndGoWithAnEdit) {
    EXPECT_EQ(library_->levelsOf(&*edited_), nullptr);
    follow(false);
    EXPECT_TRUE(library_->busy());
    finish(false);
    ASSERT_NE(library_->levelsOf(&*edited_), nullptr);
    EXPECT_EQ(library_->levelsOf(&*edited_)->coarse.size(), 3u);
    EXPECT_TRUE(library_->tableOf(&*edited_).empty());
    finish();
    EXPECT_EQ(library_->tableOf(&*edited_).size(), 6u);
    EXPECT_EQ(library_->progress(), "");
    const std::uint64_t revision = library_->revision();
    follow();
    EXPECT_EQ(library_->revision(), revision);
    // Another profile: the levels stay, the figures do not.
    settings_.representations.views = "octahedral:8";
    follow();
    EXPECT_NE(library_->levelsOf(&*edited_), nullptr);
    EXPECT_TRUE(library_->tableOf(&*edited_).empty());
    EXPECT_EQ(library_->views().count(), 64);
    ASSERT_TRUE(session_.open(folder_ / "m.vox"));
    follow();
    EXPECT_EQ(library_->levelsOf(&*edited_), nullptr);
    EXPECT_GT(library_->revision(), revision);
}

TEST_F(EditorRepresentations, NothingIsBuiltOfAModelThatHasJustChanged) {
    const auto at = [&](double now) {
        library_->follow(scene_->levelSources(session_, *edited_), settings_.representations,
                         session_.profile(), true, now);
    };
    at(10.0);
    at(10.1);
    EXPECT_EQ(library_->progress(), "Building levels");
    EXPECT_EQ(library_->levelsOf(&*edited_), nullptr);
    ASSERT_TRUE(session_.open(folder_ / "m.vox"));
    at(10.4);
    at(10.5);
    EXPECT_EQ(library_->levelsOf(&*edited_), nullptr);
    now_ = 11.0;
    finish(false);
    EXPECT_NE(library_->levelsOf(&*edited_), nullptr);
}

TEST_F(EditorRepresentations, AnEmptyModelHasNothingToWaitFor) {
    finish(false);
    ASSERT_TRUE(session_.startNew());
    follow();
    EXPECT_FALSE(library_->busy());
    EXPECT_EQ(library_->levelsOf(&*edited_), nullptr);
}

// Frames that are stepped through and played have levels each, and the model's figures for all.
TEST_F(EditorRepresentations, LevelsComeWhileAnAnimationPlaysAndFiguresStay) {
    const Document animation = test::animationOf({test::figure(), test::asymmetric()});
    ASSERT_TRUE(saveDocument(folder_ / "moves.voxprite", animation, {}));
    ASSERT_TRUE(session_.open(folder_ / "moves.voxprite"));
    const auto show = [&](int frame) {
        ASSERT_TRUE(session_.setFrame(frame));
        edited_->upload(session_.octree().view(session_.bounds()));
    };
    show(0);
    finish();
    ASSERT_NE(library_->levelsOf(&*edited_), nullptr);
    const std::size_t figures = library_->tableOf(&*edited_).size();
    EXPECT_GT(figures, 0u);
    const auto step = [&](double seconds) {
        now_ += seconds;
        library_->follow(scene_->levelSources(session_, *edited_), settings_.representations,
                         session_.profile(), false, now_);
    };
    show(1);
    step(0.01);
    EXPECT_EQ(library_->levelsOf(&*edited_), nullptr);
    EXPECT_EQ(library_->tableOf(&*edited_).size(), figures);
    // It goes on before anything comes to rest.
    for (int frame = 2; library_->busy() && frame < 20'000; ++frame) {
        show(frame % 2);
        step(0.1);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    for (const int frame : {0, 1}) {
        show(frame);
        step(0.1);
        EXPECT_NE(library_->levelsOf(&*edited_), nullptr) << frame;
        EXPECT_EQ(library_->tableOf(&*edited_).size(), figures);
    }
}

// What the budget promises, seen in the pictures of a whole crowd.
TEST_F(EditorRepresentations, AnAutomaticSceneStaysWithinTheBudget) {
    static_cast<void>(made());
    finish();
    std::set<Representation> chosen;
    for (const double budget : {0.1, 0.3, 0.45, 0.6}) {
        settings_.representations.errorBudget = budget;
        before_.clear();
        for (const double metres : {70.0, 140.0}) {
            const Camera camera = from(metres);
            const Image exact = picture(made(), camera);
            Scene scene = made();
            const RepresentationShares shares = choose(scene, camera);
            const Image drawn = picture(scene, camera);
            EXPECT_LE(test::must(flipInside(exact, drawn)), budget) << metres;
            int entities = 0;
            for (std::size_t k = 0; k < shares.size(); ++k) {
                entities += shares[k].entities;
                EXPECT_EQ(shares[k].entities, stats_.drawnBy[k]);
                EXPECT_EQ(shares[k].microseconds > 0.0, shares[k].entities > 0);
                if (shares[k].entities > 0) chosen.insert(static_cast<Representation>(k));
            }
            EXPECT_EQ(entities, stats_.drawn);
        }
    }
    EXPECT_GE(chosen.size(), 2u);
}

TEST_F(EditorRepresentations, AForcedOneIsDrawnOnceItIsThere) {
    settings_.representations.rule = DrawRule::clusters;
    const Camera camera = from(40.0);
    Scene early = made();
    static_cast<void>(choose(early, camera));
    for (const SceneEntity& entity : early.entities) {
        EXPECT_EQ(entity.representation, Representation::sprite);
    }
    finish(false);
    for (const DrawRule rule :
         {DrawRule::exact, DrawRule::snapshot, DrawRule::clusters, DrawRule::coarse}) {
        settings_.representations.rule = rule;
        settings_.representations.coarserLevels = 2;
        Scene scene = made();
        static_cast<void>(choose(scene, camera));
        const RepresentationChoice forced = *settings_.representations.forced();
        for (const SceneEntity& entity : scene.entities) {
            EXPECT_EQ(entity.representation, forced.kind);
        }
        if (rule == DrawRule::coarse) {
            EXPECT_EQ(scene.entities.front().octree, &library_->levelsOf(&*edited_)->coarse[1]);
        }
    }
}

TEST_F(EditorRepresentations, ModelsOfOtherFilesHaveTheirOwnLevels) {
    ASSERT_TRUE(saveDocument(folder_ / "ball.vox", test::documentOf(test::shellSphere(21)), {}));
    settings_.extras = {{folder_ / "ball.vox", true}};
    settings_.representations.rule = DrawRule::coarse;
    static_cast<void>(made());
    finish(false);
    Scene scene = made();
    std::set<const GpuModelLevels*> levels;
    for (const SceneEntity& entity : scene.entities) {
        levels.insert(library_->levelsOf(entity.octree));
    }
    EXPECT_EQ(levels.size(), 2u);
    EXPECT_FALSE(levels.contains(nullptr));
    static_cast<void>(choose(scene, from(40.0)));
    std::set<const GpuOctree*> drawn;
    for (const SceneEntity& entity : scene.entities) {
        EXPECT_EQ(entity.representation, Representation::coarse);
        drawn.insert(entity.octree);
    }
    std::set<const GpuOctree*> coarser;
    for (const GpuModelLevels* each : levels) coarser.insert(&each->coarse.front());
    EXPECT_EQ(drawn, coarser);
}

TEST_F(EditorRepresentations, TheTintTellsWhatWasChosen) {
    finish(false);
    settings_.representations.tint = true;
    const Camera camera = from(25.0);
    for (const auto& [rule, kind] : {std::pair(DrawRule::exact, Representation::sprite),
                                     std::pair(DrawRule::snapshot, Representation::snapshot),
                                     std::pair(DrawRule::clusters, Representation::clusters),
                                     std::pair(DrawRule::coarse, Representation::coarse)}) {
        settings_.representations.rule = rule;
        Scene scene = made();
        static_cast<void>(choose(scene, camera));
        const Image drawn = picture(scene, camera);
        glm::dvec3 sum(0.0);
        for (const Rgba8& pixel : drawn.pixels) {
            const Rgba8 black(0, 0, 0, 255);
            if (pixel.w == 255 && pixel != black) sum += glm::dvec3(pixel.x, pixel.y, pixel.z);
        }
        const Rgba8 tint = tintOf(kind);
        ASSERT_GT(sum.x + sum.y + sum.z, 0.0);
        // The tint's strongest channel is that of the picture, and its weakest, too.
        const auto most = [](auto v) { return v.x >= v.y && v.x >= v.z ? 0 : v.y >= v.z ? 1 : 2; };
        EXPECT_EQ(most(sum), most(glm::dvec3(tint.x, tint.y, tint.z))) << nameOf(kind);
        const auto mean = [&](double share) { return share / (sum.x + sum.y + sum.z); };
        const double all = tint.x + tint.y + tint.z;
        EXPECT_NEAR(mean(sum.x), tint.x / all, 0.17) << nameOf(kind);
        EXPECT_NEAR(mean(sum.z), tint.z / all, 0.17) << nameOf(kind);
    }
    // The document's own palette is not touched, and comes back.
    settings_.representations.tint = false;
    Scene plain = made();
    static_cast<void>(choose(plain, camera));
    EXPECT_EQ(plain.entities.front().palette, &session_.shownPalette());
    EXPECT_EQ(session_.history().position(), 0u);
}

// A palette that is tinted may be gone by the next picture.
TEST_F(EditorRepresentations, TheTintForgetsModelsThatWent) {
    ASSERT_TRUE(saveDocument(folder_ / "ball.vox", test::documentOf(test::shellSphere(21)), {}));
    settings_.representations.rule = DrawRule::exact;
    settings_.representations.tint = true;
    const auto palettes = [&] {
        Scene scene = made();
        static_cast<void>(choose(scene, from(40.0)));
        std::set<const Palette*> all;
        for (const SceneEntity& entity : scene.entities) all.insert(entity.palette);
        return all.size();
    };
    settings_.extras = {{folder_ / "ball.vox", true}};
    EXPECT_EQ(palettes(), 2u);
    settings_.extras.clear();
    EXPECT_EQ(palettes(), 1u);
}

TEST(TintedPalette, MixesColoursAndLeavesIndicesAlone) {
    const Palette palette = Palette::standard();
    const Palette red = tinted(palette, Rgba8(255, 0, 0, 255));
    EXPECT_EQ(red.colours[0], palette.colours[0]);
    EXPECT_EQ(red.displayOrder, palette.displayOrder);
    for (std::size_t k = 1; k < 256; ++k) {
        EXPECT_GE(red.colours[k].x, palette.colours[k].x);
        EXPECT_LE(red.colours[k].y, palette.colours[k].y);
        EXPECT_EQ(red.colours[k].w, palette.colours[k].w);
    }
}

TEST_F(EditorRepresentations, CellsShowEachWithItsOwnError) {
    finish();
    RepresentationCells cells;
    RepresentationSettings& settings = settings_.representations;
    settings.compared = true;
    settings.comparedSizePx = 20.0;
    const auto render = [&] {
        return test::must(cells.render(*renderer_, subject(), *library_, settings, {400, 300}, 2));
    };
    EXPECT_TRUE(render());
    EXPECT_TRUE(cells.pending());
    EXPECT_FALSE(cells.errorOf(1).has_value());
    for (int frame = 0; frame < 20 && cells.pending(); ++frame) render();
    EXPECT_FALSE(cells.pending());
    EXPECT_FALSE(render());
    EXPECT_EQ(cells.errorOf(0), 0.0);
    for (std::size_t k = 1; k < RepresentationCells::kCells; ++k) {
        ASSERT_TRUE(cells.errorOf(k).has_value());
        EXPECT_GT(*cells.errorOf(k), 0.0);
        EXPECT_LT(*cells.errorOf(k), 1.0);
    }
    // Without a budget the exact one is chosen; with all of it the cheapest.
    settings.errorBudget = kLeastErrorBudget;
    EXPECT_TRUE(render());
    EXPECT_EQ(cells.chosen(), 0u);
    EXPECT_TRUE(cells.pending());
    settings.errorBudget = 1.0;
    EXPECT_TRUE(render());
    const RepresentationChoice cheapest =
        voxprite::choose(library_->tableOf(&*edited_), 20.0, {.errorBudget = 1.0}, std::nullopt);
    EXPECT_EQ(cells.chosen(), static_cast<std::size_t>(cheapest.kind));
    // Of a document that is gone nothing is shown, nor waited for.
    EXPECT_TRUE(cells.pending());
    cells.clear();
    EXPECT_FALSE(cells.pending());
    EXPECT_EQ(cells.errorOf(0), std::nullopt);
    EXPECT_TRUE(render());
}

TEST(RepresentationFlight, GoesFromNearToFarAndBack) {
    RepresentationCells cells;
    RepresentationSettings settings;
    settings.compared = true;
    settings.comparedSizePx = kMostComparedPx;
    cells.advance(settings, 0.1);
    EXPECT_EQ(settings.comparedSizePx, kMostComparedPx);
    settings.flying = true;
    double least = kMostComparedPx, most = kLeastComparedPx, before = kMostComparedPx;
    int turns = 0;
    bool farther = true;
    for (int frame = 0; frame < 600; ++frame) {
        cells.advance(settings, 1.0 / 30.0);
        least = std::min(least, settings.comparedSizePx);
        most = std::max(most, settings.comparedSizePx);
        EXPECT_LT(std::abs(std::log2(settings.comparedSizePx / before)), 0.06);
        if ((settings.comparedSizePx < before) != farther) {
            farther = !farther;
            ++turns;
        }
        before = settings.comparedSizePx;
    }
    EXPECT_NEAR(least, kLeastComparedPx, 0.2);
    EXPECT_NEAR(most, kMostComparedPx, 3.0);
    EXPECT_EQ(turns, 3);  // 20 seconds, 6 a way
}

}  // namespace
}  // namespace voxprite::editor
