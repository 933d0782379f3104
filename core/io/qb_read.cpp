#include <algorithm>
#include <array>

#include "core/io/colour_reduction.h"
#include "core/io/grid_budget.h"
#include "core/io/qb.h"
#include "core/io/qb_runs.h"
#include "core/io/vox_fields.h"

namespace voxprite {
namespace {

struct QbHeader {
    bool blueFirst = false;
    bool rightHanded = false;
    bool runs = false;
    std::uint32_t matrices = 0;
};

struct QbMatrix {
    std::string name;
    std::uint64_t offset = 0;  // of the size, for errors
    std::array<std::uint32_t, 3> size{};
    std::array<std::int32_t, 3> position{};
    ByteReader colours{ByteView()};

    [[nodiscard]] std::uint64_t sliceCells() const {
        return static_cast<std::uint64_t>(size[0]) * size[1];
    }
    // A layer that was empty: it has no cells, and some programs give it no place that counts.
    [[nodiscard]] bool hasNoSize() const { return std::ranges::count(size, 0u) > 0; }
};

Result<bool> readChoice(ByteReader& reader, const std::string& what) {
    const std::uint64_t offset = reader.offset();
    const Result<std::uint32_t> value = reader.u32("the " + what);
    if (!value) return Failure(value.error());
    if (*value > 1) {
        return failAtByte(offset,
                          "the " + what + " is " + std::to_string(*value) + "; 0 and 1 are known");
    }
    return *value == 1;
}

Result<QbHeader> readQbHeader(ByteReader& reader) {
    const Result<std::uint32_t> version = reader.u32("the version");
    if (!version) return Failure(version.error());
    if ((*version & 0xFF) != 1) {
        return failAtByte(0, "not a Qubicle file of version 1 (it begins with the version " +
                                 std::to_string(*version & 0xFF) + "." +
                                 std::to_string(*version >> 8 & 0xFF) + ")");
    }
    QbHeader header;
    const Result<bool> blueFirst = readChoice(reader, "colour format");
    if (!blueFirst) return Failure(blueFirst.error());
    const Result<bool> rightHanded = readChoice(reader, "direction of the z axis");
    if (!rightHanded) return Failure(rightHanded.error());
    const Result<bool> runs = readChoice(reader, "compression");
    if (!runs) return Failure(runs.error());
    const Result<bool> mask = readChoice(reader, "visibility mask");
    if (!mask) return Failure(mask.error());
    const Result<std::uint32_t> matrices = reader.u32("the number of matrices");
    if (!matrices) return Failure(matrices.error());
    header.blueFirst = *blueFirst;
    header.rightHanded = *rightHanded;
    header.runs = *runs;
    header.matrices = *matrices;
    return header;
}

// Calls cells(first index in the slice, count, colour) for all that a matrix says, slice by slice.
template <class Cells>
Status forEachRun(const QbHeader& header, const QbMatrix& matrix, ByteReader& reader,
                  const Cells& cells) {
    if (matrix.hasNoSize()) return {};
    const std::uint64_t sliceCells = matrix.sliceCells();
    for (std::uint32_t slice = 0; slice < matrix.size[2]; ++slice) {
        std::uint64_t index = 0;
        for (;;) {
            if (!header.runs && index == sliceCells) break;
            const std::uint64_t offset = reader.offset();
            const Result<std::uint32_t> word = reader.u32("the voxels");
            if (!word) return Failure(word.error());
            std::uint32_t colour = *word;
            std::uint64_t count = 1;
            if (header.runs && *word == qb::kNextSlice) break;
            if (header.runs && *word == qb::kRun) {
                const Result<std::uint32_t> length = reader.u32("the length of a run");
                if (!length) return Failure(length.error());
                const Result<std::uint32_t> value = reader.u32("the colour of a run");
                if (!value) return Failure(value.error());
                count = *length;
                colour = *value;
            }
            if (count > sliceCells - index) {
                return failAtByte(offset, "the voxels go beyond slice " + std::to_string(slice) +
                                              " of " + std::to_string(matrix.size[0]) + " x " +
                                              std::to_string(matrix.size[1]) + " cells");
            }
            if (colour >> 24 != 0 && count > 0) {
                if (Status s = cells(slice, index, count, colour, offset); !s) return s;
            }
            index += count;
        }
    }
    return {};
}

Rgba8 rgbFrom(const QbHeader& header, std::uint32_t word) {
    const auto first = static_cast<std::uint8_t>(word);
    const auto green = static_cast<std::uint8_t>(word >> 8);
    const auto third = static_cast<std::uint8_t>(word >> 16);
    return header.blueFirst ? Rgba8(third, green, first, 255) : Rgba8(first, green, third, 255);
}

// The space that a matrix takes, its corner where the file's axes have it brought to ours.
Result<IBox> placeOf(const QbHeader& header, const QbMatrix& matrix) {
    if (matrix.hasNoSize()) return IBox{glm::ivec3(0), glm::ivec3(1)};
    std::array<std::int64_t, 3> low{}, high{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = matrix.position[axis];
        high[axis] = low[axis] + matrix.size[axis];
    }
    if (header.rightHanded) {
        const std::int64_t lowest = -high[2];
        high[2] = -low[2];
        low[2] = lowest;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (low[axis] < -kMaxCoordinate || high[axis] > kMaxCoordinate) {
            return failAtByte(matrix.offset, "the matrix \"" + matrix.name +
                                                 "\" lies outside the range of voxels, +-" +
                                                 std::to_string(kMaxCoordinate));
        }
    }
    const auto ours = [](const std::array<std::int64_t, 3>& v) {
        return glm::ivec3(static_cast<int>(v[0]), static_cast<int>(v[2]), static_cast<int>(v[1]));
    };
    return IBox{ours(low), ours(high)};
}

Result<QbMatrix> readMatrixHead(ByteReader& reader) {
    QbMatrix matrix;
    const Result<std::uint8_t> length = reader.u8("the name of a matrix");
    if (!length) return Failure(length.error());
    const Result<ByteView> name = reader.take(*length, "the name of a matrix");
    if (!name) return Failure(name.error());
    matrix.name = utf8FromBytes({reinterpret_cast<const char*>(name->data()), name->size()});
    matrix.offset = reader.offset();
    for (std::uint32_t& edge : matrix.size) {
        const Result<std::uint32_t> value = reader.u32("the size of a matrix");
        if (!value) return Failure(value.error());
        edge = *value;
    }
    for (std::int32_t& coordinate : matrix.position) {
        const Result<std::int32_t> value = reader.i32("the position of a matrix");
        if (!value) return Failure(value.error());
        coordinate = *value;
    }
    return matrix;
}

// Where each matrix is and which colours there are. A file may end where a matrix would begin.
Result<std::vector<QbMatrix>> scan(const QbHeader& header, ByteReader& reader,
                                   ColourCount& colours) {
    std::vector<QbMatrix> matrices;
    for (std::uint32_t k = 0; k < header.matrices && !(k > 0 && reader.atEnd()); ++k) {
        Result<QbMatrix> matrix = readMatrixHead(reader);
        if (!matrix) return Failure(matrix.error());
        if (const Result<IBox> place = placeOf(header, *matrix); !place) {
            return Failure(place.error());
        }
        matrix->colours = reader;
        const auto count = [&](std::uint32_t, std::uint64_t, std::uint64_t cells,
                               std::uint32_t colour, std::uint64_t) -> Status {
            colours.add(rgbFrom(header, colour), cells);
            return {};
        };
        if (Status s = forEachRun(header, *matrix, reader, count); !s) return Failure(s.error());
        matrices.push_back(std::move(*matrix));
    }
    return matrices;
}

// Centred about the object's origin, unless that counts as out of range (validate() adds the
// largest components of where the object and its voxels are): then the origin is the space's own.
IBox canvasOf(const IBox& place) {
    const glm::ivec3 size = place.max - place.min;
    const IBox centred{-(size / 2), size - size / 2};
    const glm::ivec3 origin = glm::abs(place.min - centred.min);
    const int reach = std::max({origin.x, origin.y, origin.z}) +
                      std::max({centred.max.x, centred.max.y, centred.max.z});
    return reach <= kMaxCoordinate ? centred : place;
}

Result<Model> modelOf(const QbHeader& header, QbMatrix& matrix, const IBox& canvas,
                      const ReducedColours& colours, GridBudget& budget) {
    const glm::ivec3 corner = canvas.min;
    const glm::ivec3 size = canvas.max - canvas.min;
    BudgetedGrid grid(budget);
    const auto put = [&](std::uint32_t slice, std::uint64_t index, std::uint64_t count,
                         std::uint32_t colour, std::uint64_t offset) -> Status {
        const std::uint8_t value = colours.indexOf(rgbFrom(header, colour));
        const auto depth = static_cast<int>(slice);
        const int y = corner.y + (header.rightHanded ? size.y - 1 - depth : depth);
        // A block holds 64 cells of a slice.
        bool fits = budget.has(count / 64);
        const auto width = static_cast<std::uint64_t>(size.x);
        for (std::uint64_t cell = index; fits && cell < index + count; ++cell) {
            const auto x = static_cast<int>(cell % width);
            const auto z = static_cast<int>(cell / width);
            fits = grid.set({corner.x + x, y, corner.z + z}, value);
        }
        if (!fits) return failAtByte(offset, GridBudget::refusal());
        return {};
    };
    if (Status s = forEachRun(header, matrix, matrix.colours, put); !s) return Failure(s.error());
    return Model{grid.release(), canvas};
}

}  // namespace

Result<QbImport> readQb(ByteView bytes) {
    ByteReader reader(bytes);
    const Result<QbHeader> header = readQbHeader(reader);
    if (!header) return Failure(header.error());
    ColourCount count;
    Result<std::vector<QbMatrix>> matrices = scan(*header, reader, count);
    if (!matrices) return Failure(matrices.error());
    const ReducedColours colours = reduceColours(count);

    QbImport import;
    Document& document = import.document;
    document.palette = colours.palette;
    if (matrices->size() < header->matrices) {
        import.warnings.push_back("the file announces " + std::to_string(header->matrices) +
                                  " matrices and ends after " + std::to_string(matrices->size()));
    }
    if (const auto none = std::ranges::count_if(*matrices, &QbMatrix::hasNoSize); none > 0) {
        import.warnings.push_back("matrices without size are read as empty objects: " +
                                  std::to_string(none));
    }
    GridBudget budget(bytes.size());
    for (QbMatrix& matrix : *matrices) {
        const Result<IBox> place = placeOf(*header, matrix);
        if (!place) return Failure(place.error());
        Result<Model> model = modelOf(*header, matrix, canvasOf(*place), colours, budget);
        if (!model) return Failure(model.error());
        SceneNode object;
        object.name = matrix.name;
        object.parent = 0;
        object.placements[0].placement.translation = place->min - model->canvas.min;
        object.models = {{0, static_cast<int>(document.models.size())}};
        document.nodes[0].children.push_back(static_cast<int>(document.nodes.size()));
        document.nodes.push_back(std::move(object));
        document.models.push_back(std::move(*model));
    }
    if (document.models.empty()) {
        import.warnings.emplace_back("the file has no matrix");
        document = Document::withEmptyModel();
    }
    if (const auto warning = colours.warning()) import.warnings.push_back(*warning);
    if (!reader.atEnd()) {
        import.warnings.push_back(std::to_string(reader.remaining()) +
                                  " bytes after the last matrix are passed over");
    }
    if (Status s = validate(document); !s) return Failure(s.error());
    return import;
}

}  // namespace voxprite
