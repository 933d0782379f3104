#include "core/sheet/sheet.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "core/base/bytes.h"
#include "core/base/hash.h"
#include "core/base/parallel.h"
#include "core/model/entity_voxels.h"
#include "core/sheet/pack.h"
#include "core/sheet/sheet_layers.h"
#include "core/sprite/placed_entity.h"
#include "core/sprite/sprite_point.h"
#include "core/sprite/sprite_view.h"
#include "core/svo/bake.h"

namespace voxprite {
namespace {

constexpr int kMostSprites = 1 << 16;

Status outOfRange(const std::string& field, const std::string& range) {
    return fail(field + " must be " + range);
}

Status checkOptions(const SheetOptions& options, int frames) {
    if (options.directions < 1 || options.directions > 360) {
        return outOfRange("directions", "1 to 360");
    }
    if (!std::isfinite(options.firstYawDegrees)) return outOfRange("the first yaw", "finite");
    if (options.pitchesDegrees.empty()) return outOfRange("pitches", "at least one");
    for (const double pitch : options.pitchesDegrees) {
        if (!(pitch >= -90.0 && pitch <= 90.0)) return outOfRange("pitch", "-90 to 90 degrees");
    }
    if (options.paddingPx < 0 || options.paddingPx > 64) return outOfRange("padding", "0 to 64");
    if (options.largestEdgePx < 16 || options.largestEdgePx > 16384) {
        return outOfRange("the sheet's largest edge", "16 to 16384");
    }
    if (options.frames) {
        if (options.frames->empty()) return outOfRange("frames", "at least one");
        for (const int frame : *options.frames) {
            if (frame < 0 || frame >= frames) {
                return fail("there is no frame " + std::to_string(frame) + "; the document has " +
                            std::to_string(frames) + ", counted from 0");
            }
        }
    }
    return {};
}

std::vector<std::string> variantsOf(const Palette& palette, const SheetOptions& options) {
    if (options.variants) return *options.variants;
    std::vector<std::string> names;
    for (const PaletteVariant& variant : palette.variants) names.push_back(variant.name);
    return names;
}

// The palette itself, then the variants that were asked for.
Result<std::vector<Palette>> palettesOf(const Palette& palette, const SheetOptions& options) {
    std::vector<Palette> palettes{palette};
    for (const std::string& name : variantsOf(palette, options)) {
        const std::optional<std::size_t> variant = palette.variantNamed(name);
        if (!variant) return fail("there is no palette variant \"" + name + "\"");
        palettes.push_back(palette.withVariant(*variant));
    }
    return palettes;
}

// Of one sprite, all of one size.
using Pictures = std::vector<Image>;
using SharedPictures = std::shared_ptr<const Pictures>;

// A sprite before it has its place: its pictures, cut, and where they lie about the anchor.
struct Cut {
    SheetSprite sprite;    // sockets and anchor from the anchor's pixel
    glm::ivec2 corner{0};  // of the pictures, from the anchor's pixel
    SharedPictures pictures;
};

std::string contentOf(const Pictures& pictures) {
    const Image& first = pictures.front();
    std::string content = std::to_string(first.width) + "," + std::to_string(first.height);
    for (const Image& picture : pictures) content += " " + sha256Hex(asBytes(picture.pixels));
    return content;
}

// Keeps what several sprites show once, on any thread, and knows when there is more of it than a
// sheet has room for: it is not to take all memory first.
class DistinctPictures {
  public:
    explicit DistinctPictures(int largestEdgePx)
        : room_(static_cast<std::int64_t>(largestEdgePx) * largestEdgePx) {}

    SharedPictures keep(Pictures pictures) {
        std::string content = contentOf(pictures);
        const std::scoped_lock lock(mutex_);
        SharedPictures& kept = known_[std::move(content)];
        if (kept == nullptr) {
            kept = std::make_shared<const Pictures>(std::move(pictures));
            area_ += static_cast<std::int64_t>(kept->front().width) * kept->front().height;
        }
        return kept;
    }
    [[nodiscard]] bool fit() const {
        const std::scoped_lock lock(mutex_);
        return area_ <= room_;
    }

  private:
    mutable std::mutex mutex_;
    std::map<std::string, SharedPictures> known_;
    std::int64_t area_ = 0;
    std::int64_t room_;
};

Failure tooLarge(std::size_t sprites, int largestEdgePx) {
    const std::string edge = std::to_string(largestEdgePx);
    return fail(std::to_string(sprites) + " sprites do not fit a picture of " + edge + "x" + edge);
}

// The smallest rectangle around what is not empty: left, top, and the size.
struct Rectangle {
    glm::ivec2 corner{0};
    glm::ivec2 size{0};
};
Rectangle occupied(const SpriteBuffer& buffer) {
    glm::ivec2 low = buffer.size;
    glm::ivec2 high{0};
    std::size_t at = 0;
    for (int row = 0; row < buffer.size.y; ++row)
        for (int column = 0; column < buffer.size.x; ++column, ++at) {
            if (buffer.ids[at] == kIdEmpty) continue;
            low = glm::min(low, glm::ivec2(column, row));
            high = glm::max(high, glm::ivec2(column, row) + 1);
        }
    if (high.x == 0) return {{0, 0}, {0, 0}};
    return {low, high - low};
}

void paste(const Image& from, Image& to, glm::ivec2 corner, int magnified = 1) {
    for (int y = 0; y < from.height * magnified; ++y)
        for (int x = 0; x < from.width * magnified; ++x)
            to.at(corner.x + x, corner.y + y) = from.at(x / magnified, y / magnified);
}

Image cutOut(const Image& image, const Rectangle& part) {
    Image cut(part.size.x, part.size.y);
    for (int y = 0; y < part.size.y; ++y)
        for (int x = 0; x < part.size.x; ++x)
            cut.at(x, y) = image.at(part.corner.x + x, part.corner.y + y);
    return cut;
}

// What all sprites of a sheet share.
struct Maker {
    const Document& document;
    const SheetOptions& options;
    GameProfile profile;
    IBox bounds;
    PlacedEntity placed;
    std::vector<Palette> palettes;

    [[nodiscard]] double rangeMetres() const { return placed.radiusMetres(); }
    [[nodiscard]] Result<SpriteView> viewFrom(double yaw, double pitch) const;
    [[nodiscard]] Result<Cut> cut(const OctreeView& octree, double yaw, double pitch, int frame,
                                  DistinctPictures& distinct) const;
};

Result<SpriteView> Maker::viewFrom(double yaw, double pitch) const {
    const double away = 2.0 * placed.radiusMetres() + 8.0 * profile.voxelSizeMetres / profile.sigma;
    Camera camera = orbitCamera({yaw, pitch, 0.0}, placed.centreMetres(), away, 45.0, {64, 64});
    camera.orthographic = true;
    camera.orthographicHeightMetres = away;
    camera.nearMetres = away * 1e-3;
    const Result<SpriteViewResult> seen = viewSprite(placed, camera, profile);
    if (!seen) return Failure(seen.error());
    if (!seen->view) return fail("the model cannot be seen");
    return *seen->view;
}

Result<Cut> Maker::cut(const OctreeView& octree, double yaw, double pitch, int frame,
                       DistinctPictures& distinct) const {
    const Result<SpriteView> view = viewFrom(yaw, pitch);
    if (!view) return Failure(view.error());
    const LatticeView& lattice = view->lattice;
    Pictures pictures;
    Rectangle part;
    SpriteBuffer buffer;
    for (const Palette& palette : palettes) {
        buffer = castSprite(octree, lattice,
                            litPalette(palette, view->light8, profile.outline, profile.shading), 1);
        part = occupied(buffer);
        pictures.push_back(cutOut(buffer.image(), part));
    }
    if (options.normals) pictures.push_back(cutOut(normalsOf(buffer, *view, octree), part));
    if (options.depths) {
        pictures.push_back(cutOut(depthsOf(buffer, *view, octree, rangeMetres()), part));
    }
    if (options.indices) pictures.push_back(cutOut(indicesOf(buffer, *view, octree), part));
    Cut cut;
    cut.pictures = distinct.keep(std::move(pictures));

    const glm::dvec2 anchor = locateInSprite(lattice, octree, placed.anchor).px;
    // An anchor on a corner of the lattice (that of an even model) must not fall to one side here
    // and to the other there.
    const glm::dvec2 anchorPixel = glm::floor(anchor + 0.25);
    cut.corner = part.corner - glm::ivec2(anchorPixel);
    cut.sprite.size = part.size;
    cut.sprite.yawDegrees = yaw;
    cut.sprite.pitchDegrees = pitch;
    cut.sprite.frame = frame;
    cut.sprite.anchorPx = anchor - anchorPixel;
    for (const Socket& socket : document.sockets) {
        const glm::dvec3 position = positionAt(socket, frame) - glm::dvec3(bounds.min);
        const SpritePoint point = locateInSprite(lattice, octree, position);
        cut.sprite.sockets.push_back({socket.name, point.px - anchorPixel, point.visible});
    }
    return cut;
}

// Puts all sprites on one cell: the smallest that holds them.
void placeInCell(std::vector<Cut>& cuts, Sheet& sheet) {
    glm::ivec2 low(0);
    glm::ivec2 high(1);  // the anchor's own pixel belongs to it
    for (const Cut& cut : cuts) {
        if (cut.sprite.size.x == 0) continue;
        low = glm::min(low, cut.corner);
        high = glm::max(high, cut.corner + cut.sprite.size);
    }
    SharedPictures nothing;
    for (Cut& cut : cuts) {
        cut.sprite.anchorPx -= glm::dvec2(low);
        for (SheetSocket& socket : cut.sprite.sockets) socket.px -= glm::dvec2(low);
        if (cut.sprite.size.x == 0) {  // nothing to see: one transparent pixel
            cut.sprite.size = {1, 1};
            if (nothing == nullptr) {
                nothing = std::make_shared<const Pictures>(cut.pictures->size(), Image(1, 1));
            }
            cut.pictures = nothing;
            continue;
        }
        cut.sprite.inCell = cut.corner - low;
    }
    sheet.cellPx = high - low;
    sheet.anchorPixel = -low;
}

Pictures widened(const Pictures& pictures, glm::ivec2 corner, glm::ivec2 cellPx) {
    Pictures cells;
    for (const Image& picture : pictures) {
        cells.emplace_back(cellPx.x, cellPx.y);
        paste(picture, cells.back(), corner);
    }
    return cells;
}

Status widenToCells(std::vector<Cut>& cuts, glm::ivec2 cellPx, int largestEdgePx) {
    DistinctPictures distinct(largestEdgePx);
    for (Cut& cut : cuts) {
        cut.pictures = distinct.keep(widened(*cut.pictures, cut.sprite.inCell, cellPx));
        cut.sprite.inCell = {0, 0};
        cut.sprite.size = cellPx;
        if (!distinct.fit()) return tooLarge(cuts.size(), largestEdgePx);
    }
    return {};
}

Status pack(std::vector<Cut>& cuts, const SheetOptions& options,
            const std::vector<std::string>& pictures, Sheet& sheet) {
    std::map<SharedPictures, std::size_t> places;  // equal sprites have one
    std::vector<std::size_t> placeOf;
    std::vector<const Cut*> distinct;
    std::vector<glm::ivec2> sizes;
    for (const Cut& cut : cuts) {
        const auto [place, added] = places.try_emplace(cut.pictures, distinct.size());
        placeOf.push_back(place->second);
        if (!added) continue;
        distinct.push_back(&cut);
        sizes.push_back(cut.sprite.size);
    }
    const Result<Packing> packing = packRectangles(sizes, options.paddingPx, options.largestEdgePx);
    if (!packing) return Failure(packing.error());
    for (std::size_t p = 0; p < pictures.size(); ++p) {
        Image image(packing->size.x, packing->size.y);
        for (std::size_t k = 0; k < distinct.size(); ++k) {
            paste((*distinct[k]->pictures)[p], image, packing->corners[k]);
        }
        sheet.pictures.push_back({pictures[p], std::move(image)});
    }
    for (std::size_t k = 0; k < cuts.size(); ++k) {
        cuts[k].sprite.at = packing->corners[placeOf[k]];
        sheet.sprites.push_back(std::move(cuts[k].sprite));
    }
    return {};
}

}  // namespace

std::vector<std::string> picturesOfSheet(const Palette& palette, const SheetOptions& options) {
    std::vector<std::string> names{""};
    for (const std::string& variant : variantsOf(palette, options)) {
        names.push_back("variant-" + variant);
    }
    if (options.normals) names.emplace_back("normals");
    if (options.depths) names.emplace_back("depths");
    if (options.indices) names.emplace_back("indices");
    return names;
}

Result<Sheet> makeSheet(const Document& document, const GameProfile& profile,
                        const SheetOptions& options, const SheetProgress& progress,
                        std::stop_token stop) {
    const int frameTotal = frameCount(document);
    if (Status valid = checkOptions(options, frameTotal); !valid) return Failure(valid.error());
    std::vector<int> frames = options.frames.value_or(std::vector<int>{});
    if (!options.frames) {
        for (int frame = 0; frame < frameTotal; ++frame) frames.push_back(frame);
    }
    const std::size_t views =
        options.pitchesDegrees.size() * static_cast<std::size_t>(options.directions);
    if (views * frames.size() > kMostSprites) {
        return fail(std::to_string(views * frames.size()) + " sprites are more than the " +
                    std::to_string(kMostSprites) + " that a sheet may hold");
    }
    Result<std::vector<Palette>> palettes = palettesOf(document.palette, options);
    if (!palettes) return Failure(palettes.error());

    Maker maker{document, options, profile, entityBounds(document), {}, std::move(*palettes)};
    if (maker.bounds.empty()) return fail("there are no voxels to show");
    maker.profile.minification = false;
    maker.profile.viewStepDegrees = 0.0;
    maker.profile.depth = DepthRule::perPixel;  // what the picture of depths is made of
    maker.placed = placeEntity(document.entity, maker.bounds, maker.profile);
    if (Status valid = validate(maker.placed); !valid) return Failure(valid.error());

    DistinctPictures distinct(options.largestEdgePx);
    std::vector<Cut> cuts(views * frames.size());
    const int all = static_cast<int>(cuts.size());
    int done = 0;
    std::mutex telling;
    for (std::size_t f = 0; f < frames.size(); ++f) {
        const Result<Octree> octree = bake(flatten(document, frames[f]), maker.bounds);
        if (!octree) return Failure(octree.error());
        std::vector<std::optional<Error>> failures(views);
        parallelFor(static_cast<int>(views), 0, [&](int first, int last) {
            for (int v = first; v < last && !stop.stop_requested() && distinct.fit(); ++v) {
                const int direction = v % options.directions;
                const double yaw = options.firstYawDegrees + 360.0 * direction / options.directions;
                const double pitch =
                    options.pitchesDegrees[static_cast<std::size_t>(v / options.directions)];
                Result<Cut> cut = maker.cut(octree->view(), yaw, pitch, frames[f], distinct);
                if (!cut) {
                    failures[static_cast<std::size_t>(v)] = cut.error();
                    continue;
                }
                cut->sprite.direction = direction;
                cuts[static_cast<std::size_t>(v) * frames.size() + f] = std::move(*cut);
                const std::scoped_lock lock(telling);
                if (progress) progress(++done, all);
            }
        });
        if (stop.stop_requested()) return fail("cancelled");
        for (const std::optional<Error>& failure : failures) {
            if (failure) return Failure(*failure);
        }
        if (!distinct.fit()) return tooLarge(cuts.size(), options.largestEdgePx);
    }

    Sheet sheet;
    sheet.metresPerPx = maker.profile.voxelSizeMetres / maker.profile.sigma;
    sheet.depthRangeMetres = maker.rangeMetres();
    placeInCell(cuts, sheet);
    if (!options.trim) {
        Status fits = widenToCells(cuts, sheet.cellPx, options.largestEdgePx);
        if (!fits) return Failure(fits.error());
    }
    const std::vector<std::string> pictures = picturesOfSheet(document.palette, options);
    if (Status packed = pack(cuts, options, pictures, sheet); !packed) {
        return Failure(packed.error());
    }
    return sheet;
}

std::vector<Image> cellsOf(const Sheet& sheet, const SheetPicture& picture, int magnified) {
    std::vector<Image> cells;
    for (const SheetSprite& sprite : sheet.sprites) {
        Image cell(sheet.cellPx.x * magnified, sheet.cellPx.y * magnified);
        paste(cutOut(picture.image, {sprite.at, sprite.size}), cell, sprite.inCell * magnified,
              magnified);
        cells.push_back(std::move(cell));
    }
    return cells;
}

}  // namespace voxprite
