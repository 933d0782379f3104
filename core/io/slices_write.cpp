#include <algorithm>
#include <set>

#include "core/io/grid_layers.h"
#include "core/io/png.h"
#include "core/io/png_text.h"
#include "core/io/slice_names.h"
#include "core/io/slice_text.h"
#include "core/io/slices.h"
#include "core/model/entity_voxels.h"

namespace voxprite {
namespace {

Rgba8 pixelOf(const Palette& palette, std::uint8_t index) {
    if (index == 0) return Rgba8(0);
    Rgba8 colour = palette.colours[index];
    if (colour.w == 0) colour.w = 255;
    return colour;
}

std::string numbered(const SliceName& name, std::size_t layer, const std::string& ending) {
    std::string number = std::to_string(static_cast<std::size_t>(name.number) + layer);
    if (number.size() < name.digits) number.insert(0, name.digits - number.size(), '0');
    return name.beginning + number + ending;
}

}  // namespace

std::vector<std::string> sliceNames(const std::filesystem::path& name, const Document& document) {
    const std::optional<SliceName> stack = sliceNameOf(name);
    if (!stack || !isSurelyNumbered(*stack)) return {name.string()};
    const IBox box = flatten(document, 0).bounds();
    const int layers = box.empty() ? 1 : box.size().z;
    std::vector<std::string> names;
    for (int layer = layers - 1; layer >= 0; --layer) {
        names.push_back(
            numbered(*stack, static_cast<std::size_t>(layer), name.extension().string()));
    }
    return names;
}

Result<std::vector<SlicePicture>> writeSlices(const Document& document,
                                              const std::filesystem::path& name) {
    if (Status s = validate(document); !s) return Failure(s.error());
    const VoxelGrid voxels = flatten(document, 0);
    IBox box = voxels.bounds();
    if (box.empty()) box = {glm::ivec3(0), glm::ivec3(1)};
    const glm::ivec3 size = box.size();
    const std::optional<SliceName> stack = sliceNameOf(name);
    const bool strip = !stack || !isSurelyNumbered(*stack);
    const std::int64_t rows = strip ? std::int64_t{size.y} * size.z : size.y;
    if (size.x > kMaxPngEdge || rows > kMaxPngEdge) {
        return fail("the layers make a picture of " + std::to_string(size.x) + " x " +
                    std::to_string(rows) + " pixels; at most " + std::to_string(kMaxPngEdge) +
                    " an edge can be written" +
                    (strip ? " (a name like hut_000.png writes a picture a layer)" : ""));
    }
    if (!strip && static_cast<std::size_t>(size.z) > kMaxSlices) {
        return fail("at most " + std::to_string(kMaxSlices) + " layers can be written");
    }
    const std::string told = textOf({size.z, box.min});
    const auto append = [&](std::vector<SlicePicture>& pictures, const std::string& file,
                            const Image& image) -> Status {
        const Result<Bytes> png = writePng(image);
        if (!png) return Failure(png.error());
        // One picture tells for all.
        pictures.push_back(
            {file, pictures.empty() ? withPngText(*png, kSliceTextKey, told) : *png});
        return {};
    };
    std::vector<SlicePicture> pictures;
    Image image(size.x, static_cast<int>(rows));
    const Status done =
        forEachLayer(voxels, box, 2, [&](int z, std::span<const std::uint8_t> cells) -> Status {
            const int firstRow = strip ? (z - box.min.z) * size.y : 0;
            for (int y = 0; y < size.y; ++y) {
                for (int x = 0; x < size.x; ++x) {
                    const auto cell =
                        static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
                        static_cast<std::size_t>(x);
                    image.at(x, firstRow + size.y - 1 - y) = pixelOf(document.palette, cells[cell]);
                }
            }
            if (strip) return {};
            return append(pictures,
                          numbered(*stack, static_cast<std::size_t>(z - box.min.z),
                                   name.extension().string()),
                          image);
        });
    if (!done) return Failure(done.error());
    if (strip) {
        if (Status s = append(pictures, name.string(), image); !s) return Failure(s.error());
    }
    // The file that was asked for comes last.
    std::rotate(pictures.begin(), pictures.begin() + 1, pictures.end());
    return pictures;
}

std::vector<std::string> sliceLosses(const Document& document) {
    std::set<std::uint8_t> invisible;
    flatten(document, 0).forEachSolid([&](glm::ivec3, std::uint8_t value) {
        if (document.palette.colours[value].w == 0) invisible.insert(value);
    });
    if (invisible.empty()) return {};
    return {".png has no voxels of full transparency: " + std::to_string(invisible.size()) +
            (invisible.size() == 1 ? " colour becomes opaque" : " colours become opaque")};
}

}  // namespace voxprite
