// Copies around the edited model, values of sigma side by side, and the sprite as a picture.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "app/editor/views/scene_copies.h"
#include "app/editor/views/sprite_picture.h"
#include "core/edit/make_action.h"
#include "core/io/formats.h"
#include "core/sprite/camera.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/voxels.h"

namespace voxprite::editor {
namespace {

CopySettings settingsOf(CopyPattern pattern, int count, double spacing = 1.0) {
    CopySettings settings;
    settings.pattern = pattern;
    settings.count = count;
    settings.spacing = spacing;
    return settings;
}

double distance(const SceneCopy& a, const SceneCopy& b) {
    return std::hypot(a.acrossMetres - b.acrossMetres, a.aheadMetres - b.aheadMetres);
}

// Everyone, the edited model first.
std::vector<SceneCopy> everyone(const Formation& formation) {
    std::vector<SceneCopy> all{{0, 0.0, 0.0, 0.0}};
    all.insert(all.end(), formation.copies.begin(), formation.copies.end());
    return all;
}

void expectRoomForAll(const std::vector<SceneCopy>& all, const std::vector<CopySubject>& subjects) {
    const auto reach = [&](const SceneCopy& copy) {
        return subjects[static_cast<std::size_t>(copy.subject)].reachMetres;
    };
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            ASSERT_GE(distance(all[i], all[k]), 0.999 * (reach(all[i]) + reach(all[k])))
                << i << " and " << k;
        }
    }
}

const std::vector<CopySubject> kMixed{{1.0, true}, {0.4, true}, {5.0, true}, {0.05, true}};

TEST(SceneCopies, AreAsManyAsAskedForAndStandInNobodysWay) {
    for (const CopyPattern pattern : {CopyPattern::grid, CopyPattern::crowd, CopyPattern::march}) {
        for (const int count : {1, 2, 7, 100, 700}) {
            for (const double spacing : {kLeastSpacing, 1.0, 3.0}) {
                const Formation made = arrangeCopies(settingsOf(pattern, count, spacing), kMixed);
                ASSERT_EQ(made.copies.size(), static_cast<std::size_t>(count));
                ASSERT_NO_FATAL_FAILURE(expectRoomForAll(everyone(made), kMixed))
                    << static_cast<int>(pattern) << " x " << count;
            }
        }
    }
}

TEST(SceneCopies, TenThousandComeInAnInstantAndFillTheirDisc) {
    const std::vector<CopySubject> one{{1.0, true}};
    const Formation made = arrangeCopies(settingsOf(CopyPattern::crowd, kMostCopies), one);
    ASSERT_EQ(made.copies.size(), static_cast<std::size_t>(kMostCopies));
    // Nothing is scattered far out: the discs cover a fair share of the crowd's.
    const double covered = kMostCopies / (made.radiusMetres * made.radiusMetres);
    EXPECT_GT(covered, 0.3);
    EXPECT_LT(covered, 1.0);
}

TEST(SceneCopies, OnlyModelsInUseAppearAndAllOfThemDo) {
    std::vector<CopySubject> subjects = kMixed;
    subjects[0].used = false;
    subjects[2].used = false;
    std::set<int> seen;
    for (const SceneCopy& copy :
         arrangeCopies(settingsOf(CopyPattern::crowd, 60), subjects).copies) {
        seen.insert(copy.subject);
    }
    EXPECT_EQ(seen, (std::set<int>{1, 3}));
    for (CopySubject& subject : subjects) subject.used = false;
    EXPECT_TRUE(arrangeCopies(settingsOf(CopyPattern::grid, 9), subjects).copies.empty());
    EXPECT_TRUE(arrangeCopies(settingsOf(CopyPattern::grid, 9), {}).copies.empty());
}

bool same(const SceneCopy& a, const SceneCopy& b) {
    return a.subject == b.subject && distance(a, b) == 0.0 && a.turnDegrees == b.turnDegrees;
}

TEST(SceneCopies, TheSeedAloneDecidesAndMoreCopiesMoveNobody) {
    CopySettings settings = settingsOf(CopyPattern::crowd, 200);
    const Formation first = arrangeCopies(settings, kMixed);
    EXPECT_TRUE(std::ranges::equal(first.copies, arrangeCopies(settings, kMixed).copies, same));
    settings.count = 300;
    const Formation more = arrangeCopies(settings, kMixed);
    EXPECT_TRUE(std::ranges::equal(first.copies, std::span(more.copies).first(200), same));
    settings.seed = 2;
    EXPECT_FALSE(std::ranges::equal(more.copies, arrangeCopies(settings, kMixed).copies, same));
}

TEST(SceneCopies, TurnsAreStepsOf45DegreesAndCanBeSwitchedOff) {
    CopySettings settings = settingsOf(CopyPattern::grid, 300);
    std::set<double> turns;
    for (const SceneCopy& copy : arrangeCopies(settings, kMixed).copies)
        turns.insert(copy.turnDegrees);
    EXPECT_EQ(turns, (std::set<double>{0, 45, 90, 135, 180, 225, 270, 315}));
    settings.turned = false;
    for (const SceneCopy& copy : arrangeCopies(settings, kMixed).copies) {
        EXPECT_EQ(copy.turnDegrees, 0.0);
    }
}

TEST(SceneCopies, TheMarchKeepsItsRanksAndComesRoundAgain) {
    const Formation made = arrangeCopies(settingsOf(CopyPattern::march, 90), kMixed);
    ASSERT_GT(made.loopMetres, 0.0);
    for (const double metres : {0.0, 3.7, made.loopMetres * 0.5, made.loopMetres * 12.25}) {
        std::vector<SceneCopy> all{{0, 0.0, 0.0, 0.0}};
        for (const SceneCopy& copy : made.copies) {
            all.push_back(walked(copy, made, metres));
            EXPECT_EQ(all.back().acrossMetres, copy.acrossMetres);
            // So far ahead, but for whole rounds.
            const double rounds =
                (copy.aheadMetres + metres - all.back().aheadMetres) / made.loopMetres;
            EXPECT_NEAR(rounds, std::round(rounds), 1e-9);
            EXPECT_LE(std::abs(all.back().aheadMetres), made.loopMetres * 0.5);
        }
        expectRoomForAll(all, kMixed);
    }
}

// Where a copy stands and what it looks like there, by hand.
TEST(SceneCopies, StandInTheFormationAsTheEditedModelFaces) {
    Entity entity;
    entity.positionMetres = {10.0, 2.0, -3.0};
    entity.yawDegrees = 90.0;
    entity.scale = 2.0;
    const PlacedEntity edited = placeEntity(entity, {{0, 0, 0}, {4, 6, 8}}, GameProfile{});
    // Turned by 90 degrees, the model's -Y side faces +X, its +X side faces -Z.
    const PlacedEntity ahead = standing(edited, {0, 0.0, 5.0, 0.0}, 90.0);
    EXPECT_EQ(ahead.anchorMetres, glm::dvec3(15.0, 2.0, -3.0));
    const PlacedEntity across = standing(edited, {0, 1.5, 0.0, 180.0}, 90.0);
    EXPECT_EQ(across.anchorMetres, glm::dvec3(10.0, 2.0, -4.5));
    // Turned round: what pointed along +X of the voxels points the other way, up stays up.
    EXPECT_EQ(across.worldFromVoxelAxes[0], -edited.worldFromVoxelAxes[0]);
    EXPECT_EQ(across.worldFromVoxelAxes[1], -edited.worldFromVoxelAxes[1]);
    EXPECT_EQ(across.worldFromVoxelAxes[2], edited.worldFromVoxelAxes[2]);
    // A turn is the same as the entity's own yaw.
    entity.yawDegrees = 90.0 + 45.0;
    const PlacedEntity turned = placeEntity(entity, {{0, 0, 0}, {4, 6, 8}}, GameProfile{});
    const PlacedEntity copy = standing(edited, {0, 0.0, 0.0, 45.0}, 90.0);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LT(glm::length(copy.worldFromVoxelAxes[axis] - turned.worldFromVoxelAxes[axis]),
                  1e-15);
    }
    EXPECT_TRUE(validate(copy));
    // Bottom centre to a corner, at scale 2 and 0.1 m a voxel.
    EXPECT_NEAR(reachMetres(edited), std::hypot(2.0, 3.0) * 0.2, 1e-12);
}

TEST(SceneSettings, AnExtraModelJoinsOnce) {
    SceneSettings settings;
    settings.add({.file = "a.vox"});
    EXPECT_EQ(settings.copies.pattern, CopyPattern::crowd);
    settings.copies.pattern = CopyPattern::grid;
    settings.add({"set.svo", true, 0, "oak"});
    settings.add({"set.svo", true, 1, "elm"});
    settings.add({.file = "a.vox"});
    ASSERT_EQ(settings.extras.size(), 3u);
    EXPECT_EQ(settings.copies.pattern, CopyPattern::grid);
    settings.extras[1].used = false;
    settings.add({"set.svo", true, 0, "oak"});
    ASSERT_EQ(settings.extras.size(), 3u);
    EXPECT_TRUE(settings.extras.back().used);
    EXPECT_EQ(settings.extras.back().entityName, "oak");
}

TEST(SceneSettings, AreKeptAndBroughtIntoRange) {
    SceneSettings settings;
    settings.copies = settingsOf(CopyPattern::march, 1234, 2.5);
    settings.copies.editedUsed = false;
    settings.extras = {{"/models/oak.vox", false},
                       {"/models/hut.voxprite", true},
                       {"/models/set.svo", true, 3, "guard"}};
    settings.pace = 1.25;
    settings.pictureScale = 8;
    settings.comparison.cells = 4;
    settings.comparison.sigmas = {1.0, 2.0, 3.0, 4.0};
    EXPECT_EQ(sceneSettingsFrom(toJson(settings)), settings);
    settings.comparison.cells = 0;
    settings.representations = {.rule = DrawRule::coarse,
                                .errorBudget = 0.07,
                                .coarserLevels = 3,
                                .views = "hemisphere:12",
                                .clusterBudgetPx = 2.5,
                                .tint = true,
                                .compared = true,
                                .comparedSizePx = 40.0};
    EXPECT_EQ(sceneSettingsFrom(toJson(settings)), settings);
    const RepresentationSettings range =
        sceneSettingsFrom(nlohmann::json::parse(
                              R"({"representations": {"rule": 9, "error_budget": -1,
                                  "coarser_levels": 8, "views": "cube:3", "cluster_budget_px": 99,
                                  "compared_size_px": 1e9}})"))
            .representations;
    EXPECT_EQ(range.rule, DrawRule::coarse);
    EXPECT_EQ(range.errorBudget, kLeastErrorBudget);
    EXPECT_EQ(range.coarserLevels, kMostCoarserLevels);
    EXPECT_EQ(range.views, RepresentationSettings{}.views);
    EXPECT_EQ(range.clusterBudgetPx, kMostClusterBudgetPx);
    EXPECT_EQ(range.comparedSizePx, kMostComparedPx);
    const SceneSettings odd = sceneSettingsFrom(nlohmann::json::parse(
        R"({"pattern": 77, "copies": -4, "spacing": 0, "picture_scale": 99, "compared": 3,
            "sigmas": [0, 1e9, 1, 2]})"));
    EXPECT_EQ(odd.copies.pattern, CopyPattern::march);
    EXPECT_EQ(odd.copies.count, 1);
    EXPECT_EQ(odd.copies.spacing, kLeastSpacing);
    EXPECT_EQ(odd.pictureScale, kMostPictureScale);
    EXPECT_EQ(odd.comparison.cells, 0);
    EXPECT_EQ(odd.comparison.sigmas, (std::array{1.0 / 64.0, 64.0, 1.0, 2.0}));
    EXPECT_EQ(sceneSettingsFrom(nlohmann::json::object()), SceneSettings{});
}

TEST(SigmaComparison, OneCellIsAlwaysThatOfTheProfile) {
    for (const int cells : {2, 4}) {
        for (const double sigma : {1.0 / 64.0, 3.0, 4.0, 64.0}) {
            SigmaComparison comparison;
            comparison.open(cells, sigma);
            ASSERT_LT(comparison.inForce, cells);
            EXPECT_EQ(comparison.sigmas[static_cast<std::size_t>(comparison.inForce)], sigma);
            for (const double each : comparison.sigmas) {
                EXPECT_GE(each, 1.0 / 64.0);
                EXPECT_LE(each, 64.0);
            }
        }
    }
}

TEST(SigmaComparison, UsingAValueAndTakingItBackMovesTheMark) {
    SigmaComparison comparison;
    comparison.open(4, 4.0);
    const SigmaComparison start = comparison;
    comparison.follow(comparison.sigmas[1]);  // "use this"
    EXPECT_EQ(comparison.inForce, 1);
    EXPECT_EQ(comparison.sigmas, start.sigmas);
    comparison.follow(4.0);  // undone
    EXPECT_EQ(comparison, start);
    comparison.follow(5.5);  // set elsewhere: the cell in force shows it, the others stay
    EXPECT_EQ(comparison.inForce, start.inForce);
    EXPECT_EQ(comparison.sigmas, (std::array{1.0, 2.0, 3.0, 5.5}));
}

// Two pictures are there when four are asked for.
TEST(SigmaComparison, TheCellInForceIsOneThatIsThere) {
    SigmaComparison comparison;
    comparison.open(4, 4.0);
    ASSERT_EQ(comparison.inForce, 3);
    EXPECT_EQ(comparison.inForceAmong(4), 3U);
    EXPECT_EQ(comparison.inForceAmong(2), 1U);
    EXPECT_EQ(comparison.inForceAmong(1), 0U);
    EXPECT_EQ(comparison.inForceAmong(0), 0U);
}

TEST(SigmaComparison, CellsTileTheView) {
    for (const glm::ivec2 view : {glm::ivec2(455, 742), glm::ivec2(801, 300), glm::ivec2(3, 2)}) {
        for (const int cells : {0, 2, 4}) {
            constexpr int kGap = 2;
            const std::vector<CellArea> areas = cellAreas(view, cells, kGap);
            ASSERT_EQ(areas.size(), static_cast<std::size_t>(std::max(cells, 1)));
            for (const CellArea& area : areas) {
                EXPECT_GE(area.size.x, 1);
                EXPECT_GE(area.size.y, 1);
            }
            if (view.x < 10) continue;
            std::vector<int> covered(static_cast<std::size_t>(view.x * view.y));
            for (const CellArea& area : areas) {
                for (int y = 0; y < area.size.y; ++y) {
                    for (int x = 0; x < area.size.x; ++x) {
                        ++covered.at(
                            static_cast<std::size_t>((area.min.y + y) * view.x + area.min.x + x));
                    }
                }
            }
            const int gaps = cells == 0   ? 0
                             : cells == 4 ? kGap * (view.x + view.y - kGap)
                                          : kGap * std::min(view.x, view.y);
            EXPECT_EQ(std::ranges::count(covered, 0), gaps);
            EXPECT_EQ(std::ranges::count(covered, 1), view.x * view.y - gaps);
        }
    }
}

class SpritePicture : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(saveDocument(folder_ / "m.vox", test::documentOf(test::asymmetric()), {}));
        ASSERT_TRUE(session_.open(folder_ / "m.vox"));
        camera_ = orbitCamera({35.0, 25.0, 0.0}, session_.placedInGame().centreMetres(), 6.0, 40.0,
                              {400, 500});
        GameProfile profile = session_.profile();
        profile.sigma = 3.0;
        profile.viewStepDegrees = 0.0;
        ASSERT_TRUE(session_.perform(makeAction("", ProfileEdit{session_.profile(), profile})));
    }
    test::TemporaryFolder folder_;
    Session session_;
    Camera camera_;
};

TEST_F(SpritePicture, IsTheSpriteOfTheViewWithoutItsEmptyEdges) {
    const Result<Image> picture = spritePicture(session_, session_.profile(), camera_, {}, 1);
    ASSERT_TRUE(picture) << picture.error().describe();
    // Cast apart from it.
    const GameProfile& profile = session_.profile();
    const Result<SpriteViewResult> seen = viewSprite(session_.placedInGame(), camera_, profile);
    ASSERT_TRUE(seen && seen->view);
    const SpriteBuffer buffer =
        castSprite(session_.octree().view(session_.bounds()), seen->view->lattice,
                   litPalette(session_.document().palette, seen->view->light8, profile.outline));
    const Image whole = buffer.image();
    const auto solid = [](Rgba8 pixel) { return pixel.w != 0; };
    EXPECT_EQ(std::ranges::count_if(picture->pixels, solid),
              std::ranges::count_if(whole.pixels, solid));
    // The cut lies where every pixel agrees, and each of its four edges holds something.
    int column = 0, row = 0;
    while (row < whole.height &&
           std::ranges::none_of(std::span(whole.pixels)
                                    .subspan(static_cast<std::size_t>(row * whole.width),
                                             static_cast<std::size_t>(whole.width)),
                                solid)) {
        ++row;
    }
    const auto columnEmpty = [&](int x) {
        for (int y = 0; y < whole.height; ++y) {
            if (solid(whole.at(x, y))) return false;
        }
        return true;
    };
    while (column < whole.width && columnEmpty(column)) ++column;
    bool right = false, bottom = false;
    for (int y = 0; y < picture->height; ++y) {
        for (int x = 0; x < picture->width; ++x) {
            ASSERT_EQ(picture->at(x, y), whole.at(x + column, y + row)) << x << ", " << y;
            right = right || (x == picture->width - 1 && solid(picture->at(x, y)));
            bottom = bottom || (y == picture->height - 1 && solid(picture->at(x, y)));
        }
    }
    EXPECT_TRUE(right && bottom);
}

// The game's occlusion and shadow are in the picture at once, and go with undo.
TEST_F(SpritePicture, FollowsTheGamesLight) {
    const auto pixels = [&] {
        return spritePicture(session_, session_.profile(), camera_, {}, 1).value().pixels;
    };
    const std::vector<Rgba8> plain = pixels();
    std::vector<std::vector<Rgba8>> shaded;
    for (double Light::*strength : {&Light::occlusion, &Light::shadow}) {
        GameProfile profile = session_.profile();
        profile.light.*strength = 0.75;
        ASSERT_TRUE(session_.perform(makeAction("", ProfileEdit{session_.profile(), profile})));
        shaded.push_back(pixels());
    }
    EXPECT_NE(shaded[0], plain);
    EXPECT_NE(shaded[1], shaded[0]);
    ASSERT_TRUE(session_.undo());
    EXPECT_EQ(pixels(), shaded[0]);
    ASSERT_TRUE(session_.undo());
    EXPECT_EQ(pixels(), plain);
    ASSERT_TRUE(session_.redo());
    EXPECT_EQ(pixels(), shaded[0]);
}

TEST_F(SpritePicture, IsMagnifiedPixelByPixel) {
    const Result<Image> small = spritePicture(session_, session_.profile(), camera_, {}, 1);
    const Result<Image> large = spritePicture(session_, session_.profile(), camera_, {}, 4);
    ASSERT_TRUE(small && large);
    ASSERT_EQ(glm::ivec2(large->width, large->height), 4 * glm::ivec2(small->width, small->height));
    for (int y = 0; y < large->height; ++y) {
        for (int x = 0; x < large->width; ++x) {
            ASSERT_EQ(large->at(x, y), small->at(x / 4, y / 4));
        }
    }
}

TEST_F(SpritePicture, SaysWhenThereIsNothingToSee) {
    camera_.forward = -camera_.forward;
    camera_.right = -camera_.right;
    EXPECT_FALSE(spritePicture(session_, session_.profile(), camera_, {}, 1));
    EXPECT_EQ(colourUnder(session_, camera_, {}, {200, 250}), 0);
    const Session empty;
    EXPECT_FALSE(spritePicture(empty, empty.profile(), camera_, {}, 1));
    EXPECT_TRUE(trimmed(Image(5, 4)).pixels.empty());
}

TEST_F(SpritePicture, TheEyedropperFindsTheVoxelThatIsDrawn) {
    const GameProfile& profile = session_.profile();
    const Result<SpriteViewResult> seen = viewSprite(session_.placedInGame(), camera_, profile);
    ASSERT_TRUE(seen && seen->view);
    const SpriteBuffer buffer =
        castSprite(session_.octree().view(session_.bounds()), seen->view->lattice,
                   litPalette(session_.document().palette, seen->view->light8, profile.outline));
    const glm::ivec3 size = session_.bounds().size();
    int hits = 0;
    for (int y = 0; y < 500; y += 7) {
        for (int x = 0; x < 400; x += 7) {
            const glm::dvec2 at(x + 0.5, y + 0.5);
            const auto pixel = pixelUnder(*seen->view, camera_, at);
            std::uint8_t expected = 0;
            if (pixel) {
                const glm::ivec2 in = *pixel - buffer.first;
                if (in.x >= 0 && in.y >= 0 && in.x < buffer.size.x && in.y < buffer.size.y) {
                    const int rowFromTop = buffer.size.y - 1 - in.y;
                    const std::uint32_t id =
                        buffer.ids[static_cast<std::size_t>(rowFromTop * buffer.size.x + in.x)];
                    if (id >= kIdFirstVoxel) {
                        const int voxel = static_cast<int>(id - kIdFirstVoxel);
                        expected =
                            session_.octree().at(session_.bounds().min +
                                                 glm::ivec3(voxel % size.x, voxel / size.x % size.y,
                                                            voxel / (size.x * size.y)));
                    }
                }
            }
            ASSERT_EQ(colourUnder(session_, camera_, {}, at), expected) << x << ", " << y;
            hits += expected != 0;
        }
    }
    EXPECT_GT(hits, 50);
}

}  // namespace
}  // namespace voxprite::editor
