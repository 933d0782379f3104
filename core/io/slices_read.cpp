#include <functional>

#include "core/base/file.h"
#include "core/io/colour_reduction.h"
#include "core/io/grid_budget.h"
#include "core/io/png.h"
#include "core/io/png_text.h"
#include "core/io/slice_names.h"
#include "core/io/slice_text.h"
#include "core/io/slices.h"

namespace voxprite {
namespace {

// Hands on the layers one after the other, from the lowest, as rows of pictures.
struct Slice {
    const Image& image;
    int firstRow = 0;
    int rows = 0;
};
using VisitSlices = std::function<Status(const std::function<Status(const Slice&)>&)>;

struct Stack {
    glm::ivec3 size{0};
    glm::ivec3 corner{0};
    std::uint64_t fileBytes = 0;
    VisitSlices forEach;
};

Result<SlicesImport> modelFrom(const Stack& stack) {
    ColourCount count;
    Status looked = stack.forEach([&](const Slice& slice) -> Status {
        for (int row = 0; row < slice.rows; ++row) {
            for (int x = 0; x < stack.size.x; ++x) {
                const Rgba8 colour = slice.image.at(x, slice.firstRow + row);
                if (colour.w != 0) count.add(colour);
            }
        }
        return {};
    });
    if (!looked) return Failure(looked.error());
    const ReducedColours colours = reduceColours(count);

    const glm::ivec3 pivot = stack.size / 2;
    GridBudget budget(stack.fileBytes);
    BudgetedGrid grid(budget);
    int z = 0;
    Status filled = stack.forEach([&](const Slice& slice) -> Status {
        for (int row = 0; row < slice.rows; ++row) {
            for (int x = 0; x < stack.size.x; ++x) {
                const Rgba8 colour = slice.image.at(x, slice.firstRow + row);
                if (colour.w == 0) continue;
                const glm::ivec3 v(x, slice.rows - 1 - row, z);
                if (!grid.set(v - pivot, colours.indexOf(colour))) {
                    return fail(GridBudget::refusal());
                }
            }
        }
        ++z;
        return {};
    });
    if (!filled) return Failure(filled.error());

    SlicesImport import;
    import.document = Document::withEmptyModel();
    import.document.palette = colours.palette;
    import.document.models[0] = {grid.release(), { -pivot, stack.size - pivot }};
    import.document.nodes[1].placements[0].placement.translation = stack.corner + pivot;
    if (const auto warning = colours.warning()) import.warnings.push_back(*warning);
    if (Status s = validate(import.document); !s) return Failure(s.error());
    return import;
}

struct Rows {
    int ofLayer = 0;
    std::optional<std::string> warning;
};

Result<Rows> rowsOfLayer(const Image& image, const std::optional<SliceText>& told,
                         const SliceReadOptions& options) {
    if (told) {
        if (told->layers < 1 || image.height % told->layers != 0) {
            return fail("the picture tells of " + std::to_string(told->layers) +
                        " layers, which its " + std::to_string(image.height) +
                        " rows cannot be divided into");
        }
        return Rows{image.height / told->layers, {}};
    }
    if (options.layerRows > 0) {
        if (image.height % options.layerRows != 0) {
            return fail("the picture's " + std::to_string(image.height) +
                        " rows cannot be divided into layers of " +
                        std::to_string(options.layerRows));
        }
        return Rows{options.layerRows, {}};
    }
    const bool squares = image.height % image.width == 0;
    const int rows = squares ? image.width : image.height;
    return Rows{rows, "the picture does not tell its layers: taken as " +
                          std::to_string(image.height / rows) + " of " +
                          std::to_string(image.width) + " x " + std::to_string(rows)};
}

Result<SlicesImport> readStack(const SliceFiles& files) {
    Stack stack;
    const auto failsIn = [](const std::filesystem::path& file, const Error& error) {
        return Failure(inFile(Status(Failure(error)), file.string()).error());
    };
    const auto pictureOf = [](const std::filesystem::path& file) {
        return inFile(readFile(file).and_then([](const Bytes& b) { return readPng(b); }),
                      file.string());
    };
    const Result<Bytes> first = readFile(files.files[0]);
    if (!first) return failsIn(files.files[0], first.error());
    const Result<Image> lowest = readPng(*first);
    if (!lowest) return failsIn(files.files[0], lowest.error());
    stack.size = {lowest->width, lowest->height, static_cast<int>(files.files.size())};
    stack.fileBytes = first->size() * files.files.size();
    const std::optional<SliceText> told = sliceTextIn(*first);
    if (told) stack.corner = told->corner;
    stack.forEach = [&](const std::function<Status(const Slice&)>& visit) -> Status {
        for (const std::filesystem::path& file : files.files) {
            const Result<Image> image = pictureOf(file);
            if (!image) return Failure(image.error());
            if (image->width != stack.size.x || image->height != stack.size.y) {
                return failInFile(file.string(), "has another size than the lowest layer, " +
                                                     std::to_string(stack.size.x) + " x " +
                                                     std::to_string(stack.size.y));
            }
            if (Status s = visit({*image, 0, image->height}); !s) return s;
        }
        return {};
    };
    Result<SlicesImport> import = modelFrom(stack);
    if (import && told && told->layers != stack.size.z) {
        import->warnings.push_back("the pictures were written as " + std::to_string(told->layers) +
                                   " layers; here are " + std::to_string(stack.size.z));
    }
    return import;
}

}  // namespace

Result<SlicesImport> readStrip(ByteView png, const SliceReadOptions& options) {
    const Result<Image> image = readPng(png);
    if (!image) return Failure(image.error());
    const std::optional<SliceText> told = sliceTextIn(png);
    const Result<Rows> rows = rowsOfLayer(*image, told, options);
    if (!rows) return Failure(rows.error());
    Stack stack;
    stack.size = {image->width, rows->ofLayer, image->height / rows->ofLayer};
    stack.fileBytes = png.size();
    if (told) stack.corner = told->corner;
    stack.forEach = [&](const std::function<Status(const Slice&)>& visit) -> Status {
        for (int z = 0; z < stack.size.z; ++z) {
            if (Status s = visit({*image, z * rows->ofLayer, rows->ofLayer}); !s) return s;
        }
        return {};
    };
    Result<SlicesImport> import = modelFrom(stack);
    if (import && rows->warning) import->warnings.insert(import->warnings.begin(), *rows->warning);
    return import;
}

Result<SlicesImport> readSlices(const std::filesystem::path& path,
                                const SliceReadOptions& options) {
    const Result<SliceFiles> files = sliceFilesOf(path);
    if (!files) return Failure(files.error());
    std::error_code error;
    const bool folder = std::filesystem::is_directory(path, error);
    const std::optional<SliceName> name = sliceNameOf(path);
    if (folder || (!files->strip && name && isSurelyNumbered(*name))) return readStack(*files);
    const Result<Bytes> bytes = readFile(path);
    if (!bytes) return Failure(bytes.error());
    // Strips of voxprite's may be numbered by chance: hut1.png, hut2.png.
    return files->strip || sliceTextIn(*bytes) ? readStrip(*bytes, options) : readStack(*files);
}

}  // namespace voxprite
