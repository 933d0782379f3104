#include "core/sheet/sheet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <set>

#include "core/model/entity_voxels.h"
#include "core/sprite/sprite_view.h"
#include "core/svo/bake.h"
#include "tests/support/must.h"
#include "tests/support/voxels.h"

namespace voxprite::test {
namespace {

// The sprite of one view, cast here: an orthographic camera far away.
struct Cast {
    SpriteBuffer buffer;
    OrthoView axes;
};
Cast castFrom(const Document& document, int frame, const GameProfile& profile, double yaw,
              double pitch) {
    const IBox bounds = entityBounds(document);
    const Octree octree = must(bake(flatten(document, frame), bounds));
    const PlacedEntity placed = placeEntity(document.entity, bounds, profile);
    Camera camera = orbitCamera({yaw, pitch, 0.0}, placed.centreMetres(), 500.0, 45.0, {99, 77});
    camera.orthographic = true;
    const SpriteView view = *must(viewSprite(placed, camera, profile)).view;
    const LitPalette lit =
        litPalette(document.palette, view.light8, profile.outline, profile.shading);
    return {castSprite(octree.view(), view.lattice, lit), view.ortho};
}

GameProfile plainProfile(double sigma = 2.0) {
    GameProfile profile;
    profile.sigma = sigma;
    profile.minification = false;
    return profile;
}

// Without the empty rows and columns around.
Image trimmed(const Image& image) {
    glm::ivec2 low(image.width, image.height);
    glm::ivec2 high(0);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (image.at(x, y).w != 0) {
                low = {std::min(low.x, x), std::min(low.y, y)};
                high = {std::max(high.x, x + 1), std::max(high.y, y + 1)};
            }
    Image part(high.x - low.x, high.y - low.y);
    for (int y = 0; y < part.height; ++y)
        for (int x = 0; x < part.width; ++x) part.at(x, y) = image.at(low.x + x, low.y + y);
    return part;
}

Image spriteOf(const Sheet& sheet, const SheetSprite& sprite, std::size_t picture = 0) {
    const Image& from = sheet.pictures[picture].image;
    Image image(sprite.size.x, sprite.size.y);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            image.at(x, y) = from.at(sprite.at.x + x, sprite.at.y + y);
    return image;
}

Document walking() {
    Document document = animationOf({figure(), asymmetric(), figure()});
    document.entity.yawDegrees = 20.0;
    document.sockets.push_back({"hand", {{0, {12.5, 3.25, 18.0}}, {1, {2.0, -4.0, 9.0}}}});
    return document;
}

TEST(Sheets, SpritesAreTheVeryBuffersOfTheirViews) {
    const Document document = walking();
    GameProfile profile = plainProfile();
    profile.light.shadow = 0.5;
    SheetOptions options;
    options.directions = 5;
    options.firstYawDegrees = 7.0;
    options.pitchesDegrees = {0.0, 40.0};
    const Sheet sheet = must(makeSheet(document, profile, options));
    ASSERT_EQ(sheet.sprites.size(), 5u * 2u * 3u);
    std::size_t k = 0;
    for (const double pitch : options.pitchesDegrees)
        for (int direction = 0; direction < 5; ++direction)
            for (int frame = 0; frame < 3; ++frame, ++k) {
                const SheetSprite& sprite = sheet.sprites[k];
                EXPECT_EQ(sprite.direction, direction);
                EXPECT_EQ(sprite.frame, frame);
                EXPECT_EQ(sprite.pitchDegrees, pitch);
                EXPECT_DOUBLE_EQ(sprite.yawDegrees, 7.0 + 72.0 * direction);
                const Cast cast = castFrom(document, frame, profile, sprite.yawDegrees, pitch);
                ASSERT_EQ(spriteOf(sheet, sprite), trimmed(cast.buffer.image())) << k;
            }
}

TEST(Sheets, TheAnchorsPixelIsTheSameInAll) {
    const Document document = walking();
    SheetOptions options;
    options.directions = 16;
    const Sheet sheet = must(makeSheet(document, plainProfile(3.0), options));
    for (const SheetSprite& sprite : sheet.sprites) {
        EXPECT_EQ(glm::ivec2(glm::floor(sprite.anchorPx + 0.25)), sheet.anchorPixel);
        EXPECT_TRUE(sprite.inCell.x >= 0 && sprite.inCell.y >= 0 &&
                    sprite.inCell.x + sprite.size.x <= sheet.cellPx.x &&
                    sprite.inCell.y + sprite.size.y <= sheet.cellPx.y);
    }
}

TEST(Sheets, SocketsLieWhereTheyProject) {
    const Document document = walking();
    const GameProfile profile = plainProfile(2.0);
    SheetOptions options;
    options.directions = 7;
    options.pitchesDegrees = {25.0};
    const Sheet sheet = must(makeSheet(document, profile, options));
    const glm::dvec3 anchor = anchorVoxels(document.entity, entityBounds(document));
    for (const SheetSprite& sprite : sheet.sprites) {
        const OrthoView axes =
            castFrom(document, sprite.frame, profile, sprite.yawDegrees, 25.0).axes;
        const glm::dvec3 from = positionAt(document.sockets[0], sprite.frame) - anchor;
        const glm::dvec2 expected =
            sprite.anchorPx +
            profile.sigma * glm::dvec2(glm::dot(from, axes.right), -glm::dot(from, axes.up));
        ASSERT_EQ(sprite.sockets.size(), 1u);
        EXPECT_LT(glm::distance(sprite.sockets[0].px, expected), 0.02);
    }
}

TEST(Sheets, EqualSpritesShareAPlace) {
    // A cube in one colour looks the same from its four sides, but for the light.
    GameProfile profile = plainProfile();
    profile.light.ambient = 1.0;
    SheetOptions options;
    options.directions = 8;
    options.pitchesDegrees = {0.0};
    const Sheet sheet = must(makeSheet(documentOf(solidBox({6, 6, 6}, 3)), profile, options));
    std::set<std::pair<int, int>> places;
    for (const SheetSprite& sprite : sheet.sprites) places.insert({sprite.at.x, sprite.at.y});
    EXPECT_EQ(places.size(), 2u);
}

TEST(Sheets, WhatCannotFitIsNotMadeFirst) {
    SheetOptions options;
    options.directions = 360;
    options.largestEdgePx = 64;
    for (const bool trim : {true, false}) {
        options.trim = trim;
        int made = 0;
        const auto sheet = makeSheet(documentOf(figure()), plainProfile(), options,
                                     [&](int done, int) { made = done; });
        ASSERT_FALSE(sheet);
        EXPECT_EQ(sheet.error().message, "360 sprites do not fit a picture of 64x64");
        EXPECT_LT(made, 360);
    }
    // Sprites that are seen many times take the place of one.
    const Document still = animationOf(std::vector<VoxelGrid>(40, figure()));
    options.directions = 1;
    options.largestEdgePx = 128;
    for (const bool trim : {true, false}) {
        options.trim = trim;
        const Sheet sheet = must(makeSheet(still, plainProfile(), options));
        EXPECT_EQ(sheet.sprites.size(), 40u);
        EXPECT_GT(40 * sheet.sprites[0].size.x * sheet.sprites[0].size.y, 128 * 128);
    }
}

TEST(Sheets, UntrimmedSpritesAreWholeCells) {
    const Document document = walking();
    SheetOptions options;
    options.directions = 4;
    const Sheet trimmedSheet = must(makeSheet(document, plainProfile(), options));
    options.trim = false;
    const Sheet whole = must(makeSheet(document, plainProfile(), options));
    EXPECT_EQ(whole.cellPx, trimmedSheet.cellPx);
    EXPECT_EQ(whole.anchorPixel, trimmedSheet.anchorPixel);
    for (const SheetSprite& sprite : whole.sprites) EXPECT_EQ(sprite.size, whole.cellPx);
    EXPECT_EQ(cellsOf(whole, whole.pictures[0]), cellsOf(trimmedSheet, trimmedSheet.pictures[0]));
    const Image once = cellsOf(whole, whole.pictures[0])[2];
    const Image thrice = cellsOf(whole, whole.pictures[0], 3)[2];
    ASSERT_EQ(thrice.width, 3 * once.width);
    for (int y = 0; y < thrice.height; ++y)
        for (int x = 0; x < thrice.width; ++x) ASSERT_EQ(thrice.at(x, y), once.at(x / 3, y / 3));
}

TEST(Sheets, VariantsAndLayersHaveOneLayout) {
    Document document = walking();
    PaletteVariant red{"red", {}};
    for (int index = 1; index < 256; ++index) {
        red.overrides[static_cast<std::uint8_t>(index)] = Rgba8(255, 0, 0, 255);
    }
    document.palette.variants.push_back(red);
    GameProfile profile = plainProfile();
    profile.outline.colour = Rgba8(0, 0, 255, 255);
    SheetOptions options;
    options.directions = 3;
    options.normals = options.depths = options.indices = true;
    const Sheet sheet = must(makeSheet(document, profile, options));
    std::vector<std::string> names;
    for (const SheetPicture& picture : sheet.pictures) names.push_back(picture.name);
    EXPECT_EQ(names, (std::vector<std::string>{"", "variant-red", "normals", "depths", "indices"}));
    const Image& colours = sheet.pictures[0].image;
    for (const SheetPicture& picture : sheet.pictures) {
        ASSERT_EQ(picture.image.pixels.size(), colours.pixels.size());
        for (std::size_t k = 0; k < colours.pixels.size(); ++k)
            ASSERT_EQ(picture.image.pixels[k].w, colours.pixels[k].w) << picture.name;
    }
    for (std::size_t k = 0; k < colours.pixels.size(); ++k) {
        const bool outline = colours.pixels[k] == profile.outline.colour;
        if (colours.pixels[k].w == 0) continue;
        const Rgba8 variant = sheet.pictures[1].image.pixels[k];
        ASSERT_TRUE(outline ? variant == profile.outline.colour : variant.y == 0 && variant.z == 0);
        ASSERT_EQ(sheet.pictures[4].image.pixels[k].x == 0, outline);
    }
    options.variants = std::vector<std::string>{"blue"};
    const auto unknown = makeSheet(document, profile, options);
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().message, "there is no palette variant \"blue\"");
}

TEST(Sheets, LayersTellNormalDepthAndIndex) {
    // From straight above a slab shows its top: as deep as half its height lies before the centre.
    const Document document = documentOf(solidBox({8, 8, 4}, 9));
    GameProfile profile = plainProfile(1.0);
    profile.outline.enabled = false;
    SheetOptions options;
    options.directions = 1;
    options.pitchesDegrees = {90.0, 0.0};
    options.normals = options.depths = options.indices = true;
    const Sheet sheet = must(makeSheet(document, profile, options));
    const double radius = 0.1 * std::sqrt(4.0 * 4.0 + 4.0 * 4.0 + 2.0 * 2.0);
    EXPECT_NEAR(sheet.depthRangeMetres, radius, 1e-12);
    for (const SheetSprite& sprite : sheet.sprites) {
        const double before = sprite.pitchDegrees == 90.0 ? 0.2 : 0.4;
        const auto grey = static_cast<int>(std::lround(255.0 * (0.5 + 0.5 * before / radius)));
        for (const Rgba8 pixel : spriteOf(sheet, sprite, 1).pixels)
            ASSERT_EQ(pixel, Rgba8(128, 128, 255, 255));
        for (const Rgba8 pixel : spriteOf(sheet, sprite, 2).pixels) ASSERT_EQ(pixel.x, grey);
        for (const Rgba8 pixel : spriteOf(sheet, sprite, 3).pixels)
            ASSERT_EQ(pixel, Rgba8(9, 9, 9, 255));
    }
}

TEST(Sheets, AFrameWithoutVoxelsIsOneTransparentPixel) {
    const Document document = animationOf({figure(), VoxelGrid()});
    SheetOptions options;
    options.directions = 1;
    const Sheet sheet = must(makeSheet(document, plainProfile(), options));
    EXPECT_EQ(sheet.sprites[1].size, glm::ivec2(1));
    EXPECT_EQ(spriteOf(sheet, sheet.sprites[1]).pixels[0], Rgba8(0));
}

TEST(Sheets, SayWhatIsOutOfRange) {
    const Document document = documentOf(figure());
    const auto refused = [&](auto change) {
        SheetOptions options;
        change(options);
        const auto sheet = makeSheet(document, plainProfile(), options);
        return sheet ? std::string("made") : sheet.error().message;
    };
    EXPECT_EQ(refused([](SheetOptions& o) { o.directions = 0; }), "directions must be 1 to 360");
    EXPECT_EQ(refused([](SheetOptions& o) { o.pitchesDegrees = {}; }),
              "pitches must be at least one");
    EXPECT_EQ(refused([](SheetOptions& o) { o.pitchesDegrees = {90.5}; }),
              "pitch must be -90 to 90 degrees");
    EXPECT_EQ(refused([](SheetOptions& o) { o.paddingPx = -1; }), "padding must be 0 to 64");
    EXPECT_EQ(refused([](SheetOptions& o) { o.frames = {{1}}; }),
              "there is no frame 1; the document has 1, counted from 0");
    EXPECT_EQ(refused([](SheetOptions& o) { o.largestEdgePx = 64; }),
              "8 sprites do not fit a picture of 64x64");
    EXPECT_EQ(refused([](SheetOptions& o) { o.firstYawDegrees = std::nan(""); }),
              "the first yaw must be finite");
    EXPECT_EQ(makeSheet(documentOf(VoxelGrid()), plainProfile(), {}).error().message,
              "there are no voxels to show");
    std::stop_source stop;
    stop.request_stop();
    EXPECT_EQ(makeSheet(document, plainProfile(), {}, {}, stop.get_token()).error().message,
              "cancelled");
}

}  // namespace
}  // namespace voxprite::test
